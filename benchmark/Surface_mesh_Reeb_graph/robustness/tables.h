// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of the robustness benchmark as tables in Markdown, which the manual includes, and as
// one table of all single results.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_TABLES_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_TABLES_H

#include "Analysis.h"
#include "changes.h"
#include "scalar_functions.h"

#include <CGAL/version_macros.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace Robustness {

using Analyses = std::vector<Analysis>; // by function

struct Analyzed_shape
{
  Shape shape;
  Analyses analyses;
};

// A changed shape beside what it was.
struct Comparison
{
  std::size_t shape = 0, change = 0;
  // by function
  std::vector<std::array<bool, threshold_names.size()>> are_counts_equal, are_isomorphic;
  std::vector<double> bottleneck, difference, repeated_maxima;
};

class Mean
{
public:
  void add(const double value)
  {
    m_sum += value;
    ++m_number;
  }

  bool is_empty() const { return m_number == 0; }
  double value() const { return m_sum / double(m_number); }

private:
  double m_sum = 0;
  std::size_t m_number = 0;
};

inline std::string fixed(const double value, const int digits)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

inline std::string percent(const Mean& mean)
{
  return mean.is_empty() ? "-" : fixed(100 * mean.value(), 0) + " %";
}

inline std::string number(const Mean& mean)
{
  return mean.is_empty() ? "-" : fixed(mean.value(), 3);
}

inline void write_row(std::ostream& out, const std::vector<std::string>& cells)
{
  for (const std::string& cell : cells)
    out << "| " << cell << ' ';
  out << "|\n";
}

inline void write_header(std::ostream& out, const std::vector<std::string>& cells)
{
  out << '\n';
  write_row(out, cells);
  out << "|---|";
  for (std::size_t i = 1; i < cells.size(); ++i)
    out << "--:|";
  out << '\n';
}

inline std::vector<std::string> header(const std::string& first)
{
  std::vector<std::string> result = {first};
  for (const Scalar_function& function : scalar_functions)
    result.emplace_back(function.name);
  return result;
}

// Calls `visit(a, b)` for all pairs of shapes of the same family, or of different ones.
template <class Visit>
void for_pairs(const std::vector<Analyzed_shape>& shapes,
               const bool same_family,
               const Visit& visit)
{
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
      if ((shapes[i].shape.family == shapes[j].shape.family) == same_family)
        visit(shapes[i], shapes[j]);
}

// How many shapes have the numbers of minima, maxima and loops that are most frequent in their
// family.
inline std::size_t number_of_frequent_counts(const std::vector<Analyzed_shape>& shapes,
                                             const std::size_t function,
                                             const std::size_t threshold)
{
  std::map<std::string, std::map<Counts, std::size_t>> numbers;
  for (const Analyzed_shape& shape : shapes)
    ++numbers[shape.shape.family][shape.analyses[function].levels[threshold].counts()];
  std::size_t result = 0;
  for (const auto& family : numbers)
    result += std::max_element(family.second.begin(),
                               family.second.end(),
                               [](const auto& a, const auto& b) { return a.second < b.second; })
                  ->second;
  return result;
}

inline void write_family_tables(std::ostream& out, const std::vector<Analyzed_shape>& shapes)
{
  out << "\n**Poses: numbers of nodes.** Of " << shapes.size()
      << " shapes, those with the numbers of minima, maxima and loops that are most frequent in "
         "their family; in parentheses the mean number of maxima.\n";
  write_header(out, header("threshold"));
  for (std::size_t t = 0; t < threshold_names.size(); ++t) {
    std::vector<std::string> row = {threshold_names[t]};
    for (std::size_t f = 0; f < scalar_functions.size(); ++f) {
      Mean maxima;
      for (const Analyzed_shape& shape : shapes)
        maxima.add(double(shape.analyses[f].levels[t].maxima.size()));
      row.push_back(std::to_string(number_of_frequent_counts(shapes, f, t)) + " (" +
                    fixed(maxima.value(), 1) + ')');
    }
    write_row(out, row);
  }

  out << "\n**Poses: graphs.** Pairs of shapes of a family that have isomorphic graphs, types of "
         "nodes included.\n";
  write_header(out, header("threshold"));
  for (std::size_t t = 0; t < threshold_names.size(); ++t) {
    std::vector<std::string> row = {threshold_names[t]};
    for (std::size_t f = 0; f < scalar_functions.size(); ++f) {
      Mean share;
      for_pairs(shapes, true, [&](const Analyzed_shape& a, const Analyzed_shape& b) {
        share.add(are_isomorphic(a.analyses[f].levels[t].graph, b.analyses[f].levels[t].graph));
      });
      row.push_back(percent(share));
    }
    write_row(out, row);
  }

  out << "\n**Poses: diagrams.** Mean distances of the persistence diagrams, of functions with "
         "range "
         "1, and the share of maxima that another pose has within 5 % of the diagonal, for poses "
         "with the same faces (threshold in the widest gap).\n";
  write_header(out, header("mean"));
  using Distance = double (*)(const Analysis&, const Analysis&);
  const std::vector<std::pair<std::string, Distance>> distances = {
      {"bottleneck distance", bottleneck_distance}, {"Wasserstein distance", wasserstein_distance}};
  for (const auto& [name, distance] : distances)
    for (const bool same_family : {true, false}) {
      std::vector<std::string> row = {name +
                                      (same_family ? ", in a family" : ", between families")};
      for (std::size_t f = 0; f < scalar_functions.size(); ++f) {
        Mean mean;
        for_pairs(shapes, same_family, [&](const Analyzed_shape& a, const Analyzed_shape& b) {
          mean.add(distance(a.analyses[f], b.analyses[f]));
        });
        row.push_back(number(mean));
      }
      write_row(out, row);
    }
  std::vector<std::string> row = {"repeated maxima"};
  for (std::size_t f = 0; f < scalar_functions.size(); ++f) {
    Mean share;
    for_pairs(shapes, true, [&](const Analyzed_shape& a, const Analyzed_shape& b) {
      if (!have_same_faces(a.shape.mesh, b.shape.mesh))
        return;
      const Level &one = a.analyses[f].levels[gap_threshold],
                  &other = b.analyses[f].levels[gap_threshold];
      share.add(share_of_repeated_maxima(a.shape.mesh, one, other));
      share.add(share_of_repeated_maxima(b.shape.mesh, other, one));
    });
    row.push_back(percent(share));
  }
  write_row(out, row);
}

inline Comparison
compare(const Analyzed_shape& before, const Mesh& mesh, const Analyses& after, const Change& change)
{
  Comparison result;
  const bool is_same_mesh = have_same_faces(before.shape.mesh, mesh);
  for (std::size_t f = 0; f < scalar_functions.size(); ++f) {
    const Analysis &a = before.analyses[f], &b = after[f];
    result.are_counts_equal.emplace_back();
    result.are_isomorphic.emplace_back();
    for (std::size_t t = 0; t < threshold_names.size(); ++t) {
      const auto [minima, maxima, loops] = a.levels[t].counts();
      const auto [new_minima, new_maxima, new_loops] = b.levels[t].counts();
      result.are_counts_equal[f][t] =
          minima == new_minima && maxima == new_maxima &&
          (change.number_of_new_loops == any_number ||
           loops + static_cast<std::size_t>(change.number_of_new_loops) == new_loops);
      result.are_isomorphic[f][t] = are_isomorphic(a.levels[t].graph, b.levels[t].graph);
    }
    result.bottleneck.push_back(bottleneck_distance(a, b));
    double difference = -1, repeated = -1;
    if (is_same_mesh) {
      difference = 0;
      const auto range_a = std::minmax_element(a.values.begin(), a.values.end()),
                 range_b = std::minmax_element(b.values.begin(), b.values.end());
      for (std::size_t i = 0; i < a.values.size(); ++i)
        difference = (std::max)(
            difference,
            std::abs((a.values[i] - *range_a.first) / (*range_a.second - *range_a.first) -
                     (b.values[i] - *range_b.first) / (*range_b.second - *range_b.first)));
      repeated = share_of_repeated_maxima(
          before.shape.mesh, a.levels[gap_threshold], b.levels[gap_threshold]);
    }
    result.difference.push_back(difference);
    result.repeated_maxima.push_back(repeated);
  }
  return result;
}

// One row for every change. `cell(comparisons, function)` gives the text.
template <class Cell>
void write_change_table(std::ostream& out,
                        const std::vector<Comparison>& comparisons,
                        const Cell& cell)
{
  write_header(out, header("change"));
  for (std::size_t c = 0; c < changes().size(); ++c) {
    std::vector<const Comparison*> of_change;
    for (const Comparison& comparison : comparisons)
      if (comparison.change == c)
        of_change.push_back(&comparison);
    std::vector<std::string> row = {changes()[c].name + " (" + std::to_string(of_change.size()) +
                                    ')'};
    for (std::size_t f = 0; f < scalar_functions.size(); ++f)
      row.push_back(cell(of_change, f));
    if (std::any_of(
            row.begin() + 1, row.end(), [](const std::string& text) { return text != "-"; }))
      write_row(out, row);
  }
}

inline void write_change_tables(std::ostream& out, const std::vector<Comparison>& comparisons)
{
  constexpr std::size_t fixed_threshold = 2; // 10 %
  using List = std::vector<const Comparison*>;
  const auto shares = [&](const auto& get) {
    return [&](const List& list, const std::size_t f) {
      Mean fixed, gap;
      for (const Comparison* comparison : list) {
        fixed.add(get(*comparison)[f][fixed_threshold]);
        gap.add(get(*comparison)[f][gap_threshold]);
      }
      return list.empty() ? std::string("-") : percent(fixed) + " / " + percent(gap);
    };
  };
  const auto mean = [](const auto& get, const auto& text) {
    return [&](const List& list, const std::size_t f) {
      Mean result;
      for (const Comparison* comparison : list)
        if (get(*comparison)[f] >= 0)
          result.add(get(*comparison)[f]);
      return text(result);
    };
  };

  out << "\n**Changes: numbers of nodes.** Changed shapes (in parentheses, how many) with as many "
         "minima, maxima and loops as before, and the loop that was added (whatever loops, where "
         "there "
         "are holes or cuts): with the threshold "
      << threshold_names[fixed_threshold] << " / in the widest gap.\n";
  write_change_table(out, comparisons, shares([](const Comparison& c) -> const auto& {
                       return c.are_counts_equal;
                     }));
  out << "\n**Changes: graphs.** Changed shapes with a graph isomorphic to that of before.\n";
  std::vector<Comparison> same_topology;
  std::copy_if(comparisons.begin(),
               comparisons.end(),
               std::back_inserter(same_topology),
               [](const Comparison& c) { return changes()[c.change].number_of_new_loops == 0; });
  write_change_table(out, same_topology, shares([](const Comparison& c) -> const auto& {
                       return c.are_isomorphic;
                     }));
  out << "\n**Changes: diagrams.** Mean bottleneck distance from the diagram of before.\n";
  write_change_table(out,
                     comparisons,
                     mean(
                         [](const Comparison& c) -> const auto& { return c.bottleneck; }, number));
  out << "\n**Changes: feature points.** Share of maxima that are within 5 % of the diagonal after "
         "the change, where the vertices are the same (threshold in the widest gap).\n";
  write_change_table(
      out,
      comparisons,
      mean(
          [](const Comparison& c) -> const auto& { return c.repeated_maxima; }, percent));
  out << "\n**Scale and rigid motion.** The largest difference of a value, of functions with range "
         "1.\n";
  std::vector<Comparison> motions;
  std::copy_if(comparisons.begin(),
               comparisons.end(),
               std::back_inserter(motions),
               [](const Comparison& c) { return changes()[c.change].keeps_values; });
  write_change_table(out, motions, [](const List& list, const std::size_t f) {
    double largest = -1;
    for (const Comparison* comparison : list)
      largest = (std::max)(largest, comparison->difference[f]);
    std::ostringstream text;
    text << std::scientific << std::setprecision(0) << largest;
    return largest < 0 ? std::string("-") : text.str();
  });
}

inline void write_csv_header(std::ostream& out)
{
  out << "family,shape,change,function,threshold,minima,maxima,loops\n";
}

inline void write_csv_rows(std::ostream& out,
                           const Shape& shape,
                           const std::string& change,
                           const Analyses& analyses)
{
  for (std::size_t f = 0; f < scalar_functions.size(); ++f)
    for (std::size_t t = 0; t < threshold_names.size(); ++t) {
      const auto [minima, maxima, loops] = analyses[f].levels[t].counts();
      out << shape.family << ',' << shape.name << ',' << change << ',' << scalar_functions[f].name
          << ',' << threshold_names[t] << ',' << minima << ',' << maxima << ',' << loops << '\n';
    }
}

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_TABLES_H
