// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splay sequences against vectors that are cut and put together in the same way.

#define BOOST_TEST_MODULE splay_sequences
#include <boost/test/unit_test.hpp>

#include "random_Reeb_graph_cases.h"
#include "random_meshes.h"

#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Splay_sequences.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

using namespace Reeb_graph_test;
using Items = std::vector<std::uint32_t>;

namespace {

// The items of a sequence in their order; the argument is a copy.
template <class Sequences>
Items items_of(Sequences sequences, typename Sequences::Root root)
{
  Items result;
  while (root != Sequences::no_item)
    result.push_back(sequences.cut_off_first(root));
  return result;
}

template <class Sequences>
void check(const Sequences& sequences, const typename Sequences::Root root, const Items& expected)
{
  BOOST_TEST(items_of(sequences, root) == expected, boost::test_tools::per_element());
}

// The number and the sum of items.
struct Sum
{
  std::uint32_t number = 0, sum = 0;

  friend Sum operator+(const Sum& a, const Sum& b) { return {a.number + b.number, a.sum + b.sum}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(numbered_sequences_are_cut_joined_and_grow)
{
  using Sequences = SMRG::internal::Splay_sequences<SMRG::internal::Sequence_number>;
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      Sequences sequences;
      const std::uint32_t size = 1 + static_cast<std::uint32_t>(random_index(20, rng));
      std::uint32_t root = sequences.add_balanced(size);
      Items items;
      for (std::uint32_t i = 0; i < size; ++i)
        items.push_back(i);
      sequences.number(root) = seed;
      check(sequences, root, items);

      for (int step = 0; step < 20; ++step) {
        const std::size_t position = random_index(items.size(), rng);
        const auto place = items.begin() + static_cast<std::ptrdiff_t>(position);
        if (random_index(2, rng) == 0) {
          root = sequences.insert_after(items[position]);
          items.insert(place + 1, root);
        } else { // what comes before the item moves to the end
          root = items[position];
          sequences.splay(root);
          const std::uint32_t before = sequences.cut_before(root);
          if (before != Sequences::no_item) {
            BOOST_TEST(sequences.number(before) == seed);
            sequences.number(before) = seed + 1;
          }
          root = sequences.join(root, before);
          std::rotate(items.begin(), place, items.end());
        }
        BOOST_TEST(sequences.number(root) == seed);
        check(sequences, root, items);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(sums_of_reversible_sequences)
{
  using Sequences = SMRG::internal::Splay_sequences<SMRG::internal::Sum_of_items<Sum>>;
  for (unsigned seed = 0; seed < number_of_random_cases(); ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 rng(seed);
      const std::uint32_t size = 1 + static_cast<std::uint32_t>(random_index(20, rng));
      Sequences sequences(size);
      std::uint32_t root = Sequences::no_item, total = 0;
      Items items, weight;
      for (std::uint32_t i = 0; i < size; ++i) {
        weight.push_back(static_cast<std::uint32_t>(random_index(10, rng)));
        total += weight.back();
        sequences.set_summary(i, Sum{1, weight.back()});
        root = sequences.join(root, i, Sequences::no_item);
        items.push_back(i);
      }

      for (int step = 0; step < 20; ++step) {
        const std::size_t position = random_index(items.size(), rng);
        const auto place = items.begin() + static_cast<std::ptrdiff_t>(position);
        switch (random_index(3, rng)) {
        case 0: { // an item is taken out, and the others change places around it
          const std::uint32_t item = items[position];
          const auto [before, behind] = sequences.cut_out(item);
          root = sequences.join(behind, item, before);
          Items changed(place + 1, items.end());
          changed.push_back(item);
          changed.insert(changed.end(), items.begin(), place);
          items = changed;
          break;
        }
        case 1: { // the first items are turned around
          std::uint32_t rest = root;
          const std::uint32_t first = sequences.cut_off_while(
              rest, [&](std::uint32_t, const Sum& sum) { return sum.number <= position + 1; });
          BOOST_TEST(sequences.sum(first).number == position + 1);
          sequences.reverse(first);
          root = sequences.join(first, rest);
          std::reverse(items.begin(), place + 1);
          break;
        }
        default: { // the last item for which the sum up to it is not too large
          const std::uint32_t bound = static_cast<std::uint32_t>(random_index(total + 1, rng));
          const auto last = sequences.last_item(
              root, [&](std::uint32_t, const Sum& sum) { return sum.sum <= bound; });
          std::uint32_t sum = 0;
          std::size_t i = 0;
          while (i < items.size() && sum + weight[items[i]] <= bound)
            sum += weight[items[i++]];
          BOOST_TEST(last.item == (i == 0 ? Sequences::no_item : items[i - 1]));
          BOOST_TEST(last.next == (i == items.size() ? Sequences::no_item : items[i]));
        }
        }
        BOOST_TEST(sequences.sum(root).sum == total);
        check(sequences, root, items);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(only_roots_stand_for_sequences)
{
  SMRG::internal::Splay_sequences<SMRG::internal::Sequence_number> sequences;
  BOOST_TEST(sequences.add_balanced(3) == 1u);
  BOOST_CHECK_THROW(sequences.number(0), CGAL::Assertion_exception);
  BOOST_CHECK_THROW(sequences.cut_after(2), CGAL::Assertion_exception);
}
