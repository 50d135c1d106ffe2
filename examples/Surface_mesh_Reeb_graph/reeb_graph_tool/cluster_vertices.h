#ifndef REEB_GRAPH_TOOL_CLUSTER_VERTICES_H
#define REEB_GRAPH_TOOL_CLUSTER_VERTICES_H

#include "Page.h"

#include <cstddef>

// Makes the picture of a page coarser: of the vertices in every cell of a grid one is left, that
// next to their center (Rossignac and Borrel, "Multi-resolution 3D approximations for rendering
// complex scenes", 1993). The grid is the finest of some that leave no more vertices than given.
void cluster_vertices(Page& page, std::size_t largest_number_of_vertices);

#endif // REEB_GRAPH_TOOL_CLUSTER_VERTICES_H
