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

// Keeps what the page needs of the graph of a result.
Finest_graph finest_graph(const Result& result);

// Makes what the HTML page shows. `finest` is the graph that result.graph has been made of; if loops
// have been closed, or branches cancelled beyond the threshold, it is that of the result itself.
Page make_page(const Options& options,
               const Result& result,
               const Finest_graph& finest,
               Progress& progress);

#endif // REEB_GRAPH_TOOL_MAKE_PAGE_H
