#include <CGAL/Surface_mesh_Reeb_graph/Block_Lanczos_eigensolver.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

// A string of n beads of mass 1, tied to each other and to nothing else: it oscillates with the
// frequencies 2 sin(pi k / 2 n), the squares of which are the eigenvalues.
int main()
{
  const int n = 1000;
  Eigen::SparseMatrix<double> stiffness(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    stiffness.coeffRef(i, i) += 1;
    stiffness.coeffRef(i + 1, i + 1) += 1;
    stiffness.coeffRef(i, i + 1) = stiffness.coeffRef(i + 1, i) = -1;
  }
  const Eigen::VectorXd mass = Eigen::VectorXd::Ones(n);
  const double shift = 1e-5; // of the order of the smallest eigenvalue that is not zero

  CGAL::Surface_mesh_Reeb_graph::Block_Lanczos_eigensolver<> solver(stiffness, mass, shift);
  const CGAL::Surface_mesh_Reeb_graph::Eigenpairs pairs = solver.smallest(10);

  double largest_error = 0;
  for (int k = 0; k < 10; ++k) {
    const double expected = std::pow(2 * std::sin(std::acos(-1.) * k / (2 * n)), 2);
    std::cout << pairs.values[k] << ", expected " << expected << '\n';
    largest_error = (std::max)(largest_error, std::abs(pairs.values[k] - expected));
  }
  return pairs.have_converged && largest_error < 1e-12 ? EXIT_SUCCESS : EXIT_FAILURE;
}
