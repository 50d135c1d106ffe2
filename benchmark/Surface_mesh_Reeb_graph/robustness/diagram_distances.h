// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of persistence diagrams, from Hera. Its two libraries cannot be included together: each
// has a source file.

#ifndef SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_DIAGRAM_DISTANCES_H
#define SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_DIAGRAM_DISTANCES_H

#include <utility>
#include <vector>

namespace Robustness {

using Diagram = std::vector<std::pair<double, double>>;

double bottleneck_distance(Diagram a, Diagram b);

// The sum of the distances of matched points, with a relative error of at most 1 percent.
double wasserstein_distance(const Diagram& a, const Diagram& b);

} // namespace Robustness

#endif // SURFACE_MESH_REEB_GRAPH_BENCHMARK_ROBUSTNESS_DIAGRAM_DISTANCES_H
