// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_INTERLEVEL_FEATURES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_INTERLEVEL_FEATURES_H

#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/Measured_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/comparison/Weighted_values.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/graph/Arc_list.h>
#include <CGAL/Surface_mesh_Reeb_graph/internal/util/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// How many numbers describe a graph. All are part of the format of signatures.
constexpr std::size_t number_of_function_quantiles = 32;
constexpr std::size_t number_of_levels = 9; // the least value, 7 quantiles, the largest value
constexpr std::size_t number_of_quantiles = 16;
constexpr std::size_t number_of_branches = 24;
// of the components whose sizes are asked for, and of those that count as branches
constexpr std::array<double, 12> component_masses = {
    {.02, .05, .1, .2, .3, .4, .5, .6, .7, .8, .9, .95}};
constexpr std::array<double, 8> branch_masses = {{0, .002, .005, .01, .02, .05, .1, .2}};

constexpr std::size_t number_of_component_quantiles =
    number_of_levels * (1 + component_masses.size()) * number_of_quantiles;
constexpr std::size_t number_of_branch_persistences =
    number_of_levels * branch_masses.size() * (1 + number_of_branches);

// The components of the sublevel sets {h <= t} of a function h on a measured graph, while t grows:
// when they reach certain masses, and the persistence of those that have certain masses. If h is the
// distance of the values to a level, sublevel sets are interlevel sets. Components of the graph that
// no edge joins are taken to meet at the largest value of h.
class Growing_components
{
public:
  Growing_components(const Measured_graph& graph, const std::vector<double>& h)
    : m_graph(graph)
    , m_h(h)
    , m_components(h.size())
    , m_masses(graph.masses)
    , m_births(h.size(), no_births())
  {
    const std::size_t n = h.size();
    CGAL_precondition(n > 0);
    for (std::size_t x = 0; x < n; ++x) {
      for (std::size_t k = 0; k < branch_masses.size(); ++k)
        if (reaches(m_masses[x], branch_masses[k]))
          m_births[x][k] = h[x];
      for (std::size_t k = 0; k < component_masses.size(); ++k)
        if (reaches(m_masses[x], component_masses[k]))
          m_reached[k].add(h[x], m_masses[x]);
      m_met.add(h[x], m_masses[x] * m_masses[x]);
    }
    run();
  }

  // The means of quantiles of the values t at which a pair of points, drawn by the measure, lies in
  // one component; then for each of `component_masses` of those at which a point lies in a component
  // that large.
  void append_component_quantiles(std::vector<double>& result)
  {
    append(m_met.mean_quantiles(number_of_quantiles), result);
    for (Weighted_values& reached : m_reached)
      append(reached.mean_quantiles(number_of_quantiles), result);
  }

  // For each of `branch_masses` the persistence of the component that lasts, then the largest ones
  // of the others in decreasing order.
  void append_branch_persistences(std::vector<double>& result)
  {
    for (std::size_t k = 0; k < branch_masses.size(); ++k) {
      result.push_back(m_lasting[k]);
      std::vector<double>& persistences = m_persistences[k];
      std::sort(persistences.begin(), persistences.end(), std::greater<double>());
      persistences.resize(number_of_branches, 0.);
      append(persistences, result);
    }
  }

private:
  using Births = std::array<double, branch_masses.size()>;

  static Births no_births()
  {
    Births births;
    births.fill(std::numeric_limits<double>::infinity());
    return births;
  }

  // Sums of equal masses in another order must not be told apart.
  static bool reaches(double mass, double least) { return mass >= least - 1e-9; }

  static void append(const std::vector<double>& values, std::vector<double>& result)
  {
    result.insert(result.end(), values.begin(), values.end());
  }

  void run()
  {
    const auto height = [this](const Arc_ends& e) {
      return (std::max)(m_h[e.lower], m_h[e.upper]);
    };
    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(m_graph.edges.size());
    for (const Arc_ends& e : m_graph.edges)
      order.emplace_back(height(e), static_cast<std::uint32_t>(order.size()));
    std::sort(order.begin(), order.end());
    for (const auto& next : order)
      join(m_graph.edges[next.second].lower, m_graph.edges[next.second].upper, next.first);

    const double top = *std::max_element(m_h.begin(), m_h.end());
    for (std::uint32_t x = 1; x < m_h.size(); ++x)
      join(0, x, top);
    const std::uint32_t root = m_components.root(0);
    for (std::size_t k = 0; k < branch_masses.size(); ++k) {
      CGAL_assertion(m_births[root][k] <= top);
      m_lasting[k] = top - m_births[root][k];
    }
  }

  void join(std::uint32_t x, std::uint32_t y, double t)
  {
    const std::uint32_t u = m_components.root(x), w = m_components.root(y);
    if (u == w)
      return;
    const double mass = m_masses[u] + m_masses[w];
    m_met.add(t, 2 * m_masses[u] * m_masses[w]);
    for (std::size_t k = 0; k < component_masses.size(); ++k) {
      const double least = component_masses[k];
      if (!reaches(mass, least))
        break; // they increase
      for (const double part : {m_masses[u], m_masses[w]})
        if (!reaches(part, least))
          m_reached[k].add(t, part);
    }
    for (std::size_t k = 0; k < branch_masses.size(); ++k) {
      const double older = (std::min)(m_births[u][k], m_births[w][k]);
      const double younger = (std::max)(m_births[u][k], m_births[w][k]);
      if (younger < t)
        m_persistences[k].push_back(t - younger);
      if (reaches(mass, branch_masses[k]))
        m_births[w][k] = (std::min)(older, t);
    }
    m_masses[w] = mass;
    m_components.join(u, w);
  }

  const Measured_graph& m_graph;
  const std::vector<double>& m_h;
  Disjoint_sets m_components;
  std::vector<double> m_masses; // of roots
  std::vector<Births> m_births; // of roots
  Weighted_values m_met;
  std::array<Weighted_values, component_masses.size()> m_reached;
  std::array<std::vector<double>, branch_masses.size()> m_persistences;
  std::array<double, branch_masses.size()> m_lasting;
};

struct Interlevel_features
{
  std::vector<double> function_quantiles;
  std::vector<double> component_quantiles;
  std::vector<double> branch_persistences;
};

inline Interlevel_features interlevel_features(const Measured_graph& graph)
{
  Interlevel_features result;
  Weighted_values values;
  for (std::size_t x = 0; x < graph.values.size(); ++x)
    values.add(graph.values[x], graph.masses[x]);
  result.function_quantiles = values.mean_quantiles(number_of_function_quantiles);

  const auto ends = std::minmax_element(graph.values.begin(), graph.values.end());
  std::vector<double> levels = {*ends.first};
  // means, as of all quantiles, around the fractions 1/8, ..., 7/8
  const std::vector<double> means = values.mean_quantiles(2 * (number_of_levels - 1));
  for (std::size_t j = 1; j + 1 < number_of_levels; ++j)
    levels.push_back((means[2 * j - 1] + means[2 * j]) / 2);
  levels.push_back(*ends.second);
  for (const double level : levels) {
    std::vector<double> h;
    for (const double value : graph.values)
      h.push_back(std::abs(value - level));
    Growing_components components(graph, h);
    components.append_component_quantiles(result.component_quantiles);
    components.append_branch_persistences(result.branch_persistences);
  }
  CGAL_assertion(result.component_quantiles.size() == number_of_component_quantiles);
  CGAL_assertion(result.branch_persistences.size() == number_of_branch_persistences);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_COMPARISON_INTERLEVEL_FEATURES_H
