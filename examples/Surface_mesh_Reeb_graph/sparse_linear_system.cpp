#include <CGAL/Surface_mesh_Reeb_graph/Supernodal_Cholesky.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdlib>
#include <iostream>

// Poisson's equation on a grid of n x n points, by differences.
int main()
{
  using Matrix = Eigen::SparseMatrix<double>;
  const int n = 50;
  Matrix a(n * n, n * n);
  a.reserve(Eigen::VectorXi::Constant(n * n, 5));
  for (int i = 0; i < n * n; ++i) {
    a.insert(i, i) = 4;
    for (int j : {i % n == 0 ? -1 : i - 1, i % n == n - 1 ? -1 : i + 1, i - n, i + n})
      if (0 <= j && j < n * n)
        a.insert(j, i) = -1;
  }

  const CGAL::Surface_mesh_Reeb_graph::Supernodal_Cholesky<Matrix> solver(a);
  if (solver.info() != Eigen::Success)
    return EXIT_FAILURE; // the matrix is not positive definite
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(n * n);
  const Eigen::VectorXd x = solver.solve(b);

  const double residual = (a * x - b).norm() / b.norm();
  std::cout << solver.nonZeros() << " entries of the factor, relative residual " << residual
            << '\n';
  return residual < 1e-12 ? EXIT_SUCCESS : EXIT_FAILURE;
}
