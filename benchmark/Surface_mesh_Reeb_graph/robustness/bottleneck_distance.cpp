// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "diagram_distances.h"

#include <bottleneck/bottleneck.h>

double Robustness::bottleneck_distance(Diagram a, Diagram b)
{
  return hera::bottleneckDistExact(a, b);
}
