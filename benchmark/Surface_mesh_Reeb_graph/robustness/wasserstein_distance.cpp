// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "diagram_distances.h"

#include <wasserstein/wasserstein.h>

double Robustness::wasserstein_distance(const Diagram& a, const Diagram& b)
{
  hera::AuctionParams<double> parameters;
  parameters.wasserstein_power = 1;
  parameters.delta = 0.01;
  return hera::wasserstein_dist(a, b, parameters);
}
