#ifndef REEB_GRAPH_TOOL_GRAPH_RECORDER_H
#define REEB_GRAPH_TOOL_GRAPH_RECORDER_H

#include "Page.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Records in a page which nodes and arcs go and come in a sequence of ever coarser graphs.
class Graph_recorder
{
public:
  using Ends = std::pair<std::uint32_t, std::uint32_t>; // lower and upper node

  // One of the graphs; its nodes are those of the finest graph, by their numbers there.
  struct Snapshot
  {
    std::vector<std::uint32_t> nodes; // increasing
    std::vector<Ends> arcs;
    std::vector<std::uint32_t> arc_of_group;
  };

  // A new arc, and those groups that lie along it rather than on branches that it has taken in.
  struct New_arc
  {
    std::uint32_t arc;
    std::vector<std::uint32_t> groups;
  };

  // The page has the nodes already.
  explicit Graph_recorder(Page& page) : m_page(page) {}

  // The numbers of the arcs of the last graph in the page.
  const std::vector<std::uint32_t>& arcs() const { return m_lives; }

  // Adds the next graph, and returns the arcs that are new in it.
  std::vector<New_arc> add(Snapshot&& next)
  {
    const std::vector<std::uint32_t> targets = find_targets(next);
    std::vector<std::uint32_t> lives = continued_lives(next, targets);
    std::vector<New_arc> new_arcs;
    for (std::size_t j = 0; j < lives.size(); ++j) {
      if (lives[j] != Page::none)
        continue;
      lives[j] = static_cast<std::uint32_t>(m_page.arcs.size());
      m_page.arcs.push_back(
          {next.arcs[j].first, next.arcs[j].second, m_number_of_graphs, Page::none});
      m_groups_along.emplace_back();
      new_arcs.push_back({lives[j], {}});
    }
    end_lives(next, targets, lives);
    if (m_number_of_graphs == 0)
      m_page.arc_of_group = next.arc_of_group;
    find_groups_along(next, lives, new_arcs);
    std::vector<std::uint32_t> gone;
    std::set_difference(m_last.nodes.begin(),
                        m_last.nodes.end(),
                        next.nodes.begin(),
                        next.nodes.end(),
                        std::back_inserter(gone));
    for (const std::uint32_t node : gone)
      m_page.nodes[node].end = m_number_of_graphs;
    m_last = std::move(next);
    m_lives = std::move(lives);
    ++m_number_of_graphs;
    return new_arcs;
  }

private:
  static constexpr std::uint32_t several = Page::none - 1;

  // By arc of the last graph: the arc that all its groups are in now, or `several`, or `none` if it
  // has no groups.
  std::vector<std::uint32_t> find_targets(const Snapshot& next) const
  {
    std::vector<std::uint32_t> targets(m_last.arcs.size(), Page::none);
    for (std::size_t g = 0; g < m_last.arc_of_group.size(); ++g) {
      std::uint32_t& target = targets[m_last.arc_of_group[g]];
      if (target == Page::none)
        target = next.arc_of_group[g];
      else if (target != next.arc_of_group[g])
        target = several;
    }
    return targets;
  }

  // By arc of the next graph: the arc of the page that it continues. An arc goes on if one of the
  // same ends has all its groups.
  std::vector<std::uint32_t>
  continued_lives(const Snapshot& next, const std::vector<std::uint32_t>& targets) const
  {
    std::vector<std::uint32_t> lives(next.arcs.size(), Page::none);
    for (std::size_t i = 0; i < targets.size(); ++i)
      if (targets[i] < several && lives[targets[i]] == Page::none &&
          m_last.arcs[i] == next.arcs[targets[i]])
        lives[targets[i]] = m_lives[i];
    std::multimap<Ends, std::size_t> free_arcs;
    for (std::size_t j = 0; j < lives.size(); ++j)
      if (lives[j] == Page::none)
        free_arcs.emplace(next.arcs[j], j);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const auto it = targets[i] == Page::none ? free_arcs.find(m_last.arcs[i]) : free_arcs.end();
      if (it == free_arcs.end())
        continue;
      lives[it->second] = m_lives[i];
      free_arcs.erase(it);
    }
    return lives;
  }

  void end_lives(const Snapshot& next,
                 const std::vector<std::uint32_t>& targets,
                 const std::vector<std::uint32_t>& lives)
  {
    std::vector<bool> goes_on(m_page.arcs.size(), false);
    for (const std::uint32_t life : lives)
      goes_on[life] = true;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (goes_on[m_lives[i]])
        continue;
      Page::Arc& arc = m_page.arcs[m_lives[i]];
      arc.end = m_number_of_graphs;
      if (targets[i] < several)
        arc.heir = lives[targets[i]];
    }
    for (std::uint32_t g = 0; g < m_last.arc_of_group.size(); ++g) {
      const std::uint32_t i = m_last.arc_of_group[g];
      if (targets[i] == several)
        m_page.partings.push_back({m_lives[i], g, lives[next.arc_of_group[g]]});
    }
  }

  void find_groups_along(const Snapshot& next,
                         const std::vector<std::uint32_t>& lives,
                         std::vector<New_arc>& new_arcs)
  {
    std::map<std::uint32_t, std::size_t> position; // of new arcs
    for (std::size_t i = 0; i < new_arcs.size(); ++i)
      position.emplace(new_arcs[i].arc, i);
    // by new arc: the arcs that have gone into it
    std::vector<std::vector<std::uint32_t>> parts(new_arcs.size());
    for (const std::uint32_t life : m_lives) {
      const Page::Arc& arc = m_page.arcs[life];
      if (arc.end != Page::none && arc.heir != Page::none && position.count(arc.heir) != 0)
        parts[position.at(arc.heir)].push_back(life);
    }
    std::vector<std::vector<std::uint32_t>> groups(new_arcs.size());
    for (std::uint32_t g = 0; g < next.arc_of_group.size(); ++g) {
      const auto it = position.find(lives[next.arc_of_group[g]]);
      if (it != position.end())
        groups[it->second].push_back(g);
    }
    for (std::size_t i = 0; i < new_arcs.size(); ++i) {
      std::vector<std::uint32_t>& along = m_groups_along[new_arcs[i].arc];
      for (const std::uint32_t part : parts_along(m_page.arcs[new_arcs[i].arc], parts[i]))
        along.insert(along.end(), m_groups_along[part].begin(), m_groups_along[part].end());
      if (along.empty())
        along = std::move(groups[i]);
      new_arcs[i].groups = along;
    }
  }

  // Those of some arcs that ways upwards from the lower node of `arc` to its upper node are made of.
  std::vector<std::uint32_t>
  parts_along(const Page::Arc& arc, std::vector<std::uint32_t> parts) const
  {
    const std::vector<Page::Arc>& arcs = m_page.arcs;
    std::set<std::uint32_t> reached = {arc.lower};
    std::sort(parts.begin(), parts.end(), [&](std::uint32_t a, std::uint32_t b) {
      return arcs[a].lower < arcs[b].lower;
    });
    std::vector<std::uint32_t> upward, result;
    for (const std::uint32_t part : parts) {
      if (reached.count(arcs[part].lower) == 0)
        continue;
      upward.push_back(part);
      reached.insert(arcs[part].upper);
    }
    reached = {arc.upper};
    std::sort(upward.begin(), upward.end(), [&](std::uint32_t a, std::uint32_t b) {
      return arcs[a].upper > arcs[b].upper;
    });
    for (const std::uint32_t part : upward) {
      if (reached.count(arcs[part].upper) == 0)
        continue;
      result.push_back(part);
      reached.insert(arcs[part].lower);
    }
    return result;
  }

  Page& m_page;
  std::uint32_t m_number_of_graphs = 0;
  Snapshot m_last;
  std::vector<std::uint32_t> m_lives;                     // by arc of the last graph
  std::vector<std::vector<std::uint32_t>> m_groups_along; // by arc of the page
};

#endif // REEB_GRAPH_TOOL_GRAPH_RECORDER_H
