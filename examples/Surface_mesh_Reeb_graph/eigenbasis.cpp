#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);

  const CGAL::Surface_mesh_Reeb_graph::Laplace_Beltrami_eigenbasis<Mesh> basis(
      mesh, CGAL::Surface_mesh_Reeb_graph::parameters::number_of_eigenpairs(3));

  // the smallest eigenvalue of a sphere has three eigenfunctions, the coordinates, and so it is here
  const auto first = *vertices(mesh).begin();
  for (std::size_t k = 1; k <= basis.number_of_eigenpairs(0); ++k)
    std::cout << "eigenvalue " << basis.eigenvalue(0, k) << ", eigenfunction at the first vertex "
              << basis.eigenfunction(k, first) << '\n';

  double largest = 0;
  for (auto v : vertices(mesh))
    largest = (std::max)(largest, basis.commute_time_distance(first, v));
  std::cout << "commute-time distance of opposite vertices " << largest << '\n';

  const bool is_as_expected = basis.number_of_eigenpairs(0) == 3 && basis.residual() < 1e-8;
  return is_as_expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
