// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors.
// All rights reserved.
//
// This file is part of Surface_mesh_Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_Reeb_graph authors

#ifndef CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_ARC_ROUTES_H
#define CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_ARC_ROUTES_H

#include <CGAL/Surface_mesh_Reeb_graph/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_Reeb_graph {
namespace internal {

// How the arcs of a simplified Reeb graph run through the Reeb graph of all details.
//
// A node of the simplified graph is one of the other, that of its critical vertex. An arc is a route
// there, through the arcs that hold its vertices: what the route leaves out are the cancelled
// branches. What hung on a cancelled branch hangs on its neighbor afterwards, so that several arcs
// of a node may begin with the same arc of the detailed graph; the node moves to where they part.
class Arc_routes
{
public:
  struct Step
  {
    std::size_t arc; // of the detailed graph
    bool is_upward;

    bool operator<(const Step& other) const
    {
      return arc != other.arc ? arc < other.arc : is_upward < other.is_upward;
    }
  };
  using Route = std::vector<Step>;
  using Ends = std::pair<std::size_t, std::size_t>; // lower and upper node

  // `shares[a]` counts the vertices of the detailed arc `a` by the simplified arcs that hold them.
  Arc_routes(std::size_t number_of_detailed_nodes,
             const std::vector<Ends>& detailed_arcs,
             const std::vector<std::map<std::size_t, std::size_t>>& shares)
    : m_arcs(detailed_arcs)
    , m_shares(shares)
    , m_is_used(detailed_arcs.size(), false)
    , m_steps(number_of_detailed_nodes)
    , m_cost(number_of_detailed_nodes, infinity)
    , m_last_step(number_of_detailed_nodes)
  {
    for (std::size_t a = 0; a < m_arcs.size(); ++a) {
      m_steps[m_arcs[a].first].push_back({a, true});
      m_steps[m_arcs[a].second].push_back({a, false});
    }
  }

  // The routes of the arcs; `place[n]`, the detailed node of node `n`, may move.
  std::vector<Route> find(const std::vector<Ends>& arcs, std::vector<std::size_t>& place)
  {
    std::vector<Route> routes;
    for (std::size_t a = 0; a < arcs.size(); ++a)
      routes.push_back(route(a, place[arcs[a].first], place[arcs[a].second]));
    move_nodes(arcs, routes, place);
    return routes;
  }

  std::size_t end(const Step& step) const
  {
    return step.is_upward ? m_arcs[step.arc].second : m_arcs[step.arc].first;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // A route is to have vertices of its own arc, and to be short. Parallel arcs are not to take the
  // same way.
  double cost(std::size_t detailed_arc, std::size_t arc) const
  {
    constexpr double of_a_step = 1e-6, without_vertices = 0.1, when_used = 4;
    std::size_t own = 0, all = 0;
    for (const auto& share : m_shares[detailed_arc]) {
      all += share.second;
      own += share.first == arc ? share.second : 0;
    }
    const double foreign =
        all == 0 ? without_vertices : 1 - static_cast<double>(own) / static_cast<double>(all);
    return of_a_step + foreign + (m_is_used[detailed_arc] ? when_used : 0);
  }

  // The cheapest route (Dijkstra). It visits little more than the route itself, which is almost for
  // nothing.
  Route route(std::size_t arc, std::size_t from, std::size_t to)
  {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<std::size_t> visited;
    const auto reach = [&](std::size_t node, double cost) {
      if (m_cost[node] == infinity)
        visited.push_back(node);
      m_cost[node] = cost;
      queue.push({cost, node});
    };
    reach(from, 0);
    while (!queue.empty() && queue.top().second != to) {
      const Entry entry = queue.top();
      queue.pop();
      if (entry.first > m_cost[entry.second])
        continue;
      for (const Step& step : m_steps[entry.second]) {
        const double there = entry.first + cost(step.arc, arc);
        if (there < m_cost[end(step)]) {
          reach(end(step), there);
          m_last_step[end(step)] = step;
        }
      }
    }
    if (queue.empty())
      throw Input_error("the Reeb graph is not that of the function");
    Route result;
    for (std::size_t node = to; node != from;) {
      const Step step = m_last_step[node];
      result.push_back(step);
      m_is_used[step.arc] = true;
      node = end({step.arc, !step.is_upward});
    }
    std::reverse(result.begin(), result.end());
    for (const std::size_t node : visited)
      m_cost[node] = infinity;
    return result;
  }

  // A node moves along a step that more than half of its arcs begin with, two at least. Every move
  // makes the routes shorter in all, so that they come to an end.
  void move_nodes(const std::vector<Ends>& arcs,
                  std::vector<Route>& routes,
                  std::vector<std::size_t>& place) const
  {
    std::vector<std::vector<std::size_t>> upward(place.size()), downward(place.size());
    for (std::size_t a = 0; a < arcs.size(); ++a) {
      upward[arcs[a].first].push_back(a);
      downward[arcs[a].second].push_back(a);
    }
    const auto first_step = [&](std::size_t a, bool is_upward, Step& step) {
      if (routes[a].empty())
        return false;
      step =
          is_upward ? routes[a].front() : Step{routes[a].back().arc, !routes[a].back().is_upward};
      return true;
    };
    const auto common_step = [&](std::size_t node, Step& result) {
      std::map<Step, std::size_t> number;
      for (const bool is_upward : {true, false})
        for (const std::size_t a : is_upward ? upward[node] : downward[node]) {
          Step step;
          if (first_step(a, is_upward, step))
            ++number[step];
        }
      for (const auto& entry : number)
        if (entry.second >= 2 && 2 * entry.second > upward[node].size() + downward[node].size()) {
          result = entry.first;
          return true;
        }
      return false;
    };
    for (std::size_t node = 0; node < place.size(); ++node) {
      Step step;
      while (common_step(node, step)) {
        const Step back = {step.arc, !step.is_upward};
        for (const std::size_t a : upward[node])
          if (!routes[a].empty() && !(routes[a].front() < step) && !(step < routes[a].front()))
            routes[a].erase(routes[a].begin());
          else
            routes[a].insert(routes[a].begin(), back);
        for (const std::size_t a : downward[node])
          if (!routes[a].empty() && !(routes[a].back() < back) && !(back < routes[a].back()))
            routes[a].pop_back();
          else
            routes[a].push_back(step);
        place[node] = end(step);
      }
    }
  }

  const std::vector<Ends>& m_arcs;
  const std::vector<std::map<std::size_t, std::size_t>>& m_shares;
  std::vector<bool> m_is_used;
  std::vector<std::vector<Step>> m_steps; // by the node that they leave
  std::vector<double> m_cost;             // infinity but while a route is being sought
  std::vector<Step> m_last_step;
};

} // namespace internal
} // namespace Surface_mesh_Reeb_graph
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_REEB_GRAPH_INTERNAL_SKELETON_ARC_ROUTES_H
