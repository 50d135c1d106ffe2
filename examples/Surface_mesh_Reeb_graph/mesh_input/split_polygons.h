#ifndef MESH_INPUT_SPLIT_POLYGONS_H
#define MESH_INPUT_SPLIT_POLYGONS_H

#include "Polygon_soup.h"

// Splits the polygons of an oriented 2-manifold into triangles that are one, too: no diagonal joins
// two vertices that another edge joins. Where the corners of a polygon are about in a plane, its
// triangles do not overlap; where they are not, any split is as good as another. The time is linear,
// except for polygons with some hundred corners between which most diagonals are taken already. Throws
// Content_error for a polygon all of whose splits need a diagonal that is taken.
void split_polygons(Polygon_soup& soup);

#endif // MESH_INPUT_SPLIT_POLYGONS_H
