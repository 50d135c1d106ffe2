#ifndef REEB_GRAPH_TOOL_MAKE_PAGE_H
#define REEB_GRAPH_TOOL_MAKE_PAGE_H

#include "Page.h"
#include "progress.h"
#include "types.h"

#include <vector>

// A graph of the result, and the arcs of all vertices, before branches are cancelled.
struct Finest_graph
{
  Graph graph;
  std::vector<int> arcs;
};

// Whether the options ask for more than to cancel the branches below a threshold, which is what the
// levels of the page are. What else they ask for comes before all levels.
bool is_simplified_before_levels(const Options& options);

// Keeps what the page needs of the graph of a result.
Finest_graph finest_graph(const Result& result);

// Makes what the HTML page shows. `finest` is what result.graph was before it was simplified, or what it
// is if is_simplified_before_levels().
Page make_page(const Options& options,
               const Result& result,
               const Finest_graph& finest,
               Progress& progress);

#endif // REEB_GRAPH_TOOL_MAKE_PAGE_H
