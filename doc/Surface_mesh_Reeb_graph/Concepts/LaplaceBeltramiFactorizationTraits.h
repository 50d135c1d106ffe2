/*!
\ingroup PkgSurfaceMeshReebGraphConcepts
\cgalConcept

The concept `LaplaceBeltramiFactorizationTraits` describes the direct solver underneath the
eigensolvers of this package. It is \cgal's concept `SparseLinearAlgebraWithFactorTraits_d` as far
as it is used here, with `double` as number type, for one symmetric positive definite matrix;
`CGAL::Eigen_solver_traits` with any direct solver of \eigen is a model.

Some members are optional, and are used if they are there when the program is compiled. They save
most of the time of a solve, since the factor is read once for eight right-hand sides:
- `%solver()`, which returns a reference to a solver with the functions `solve(b)` of \eigen, for an
  `Eigen::MatrixXd` with eight columns, and `info()`;
- a function `solve_in_place(x)` of that solver, which overwrites the right-hand sides `x`, an
  `Eigen::Matrix<double, Eigen::Dynamic, 8, Eigen::RowMajor>&`, by the solutions;
- two functions of that solver, `permutationP()` and `solve_permuted_in_place(x)`: the first returns
  a permutation *P* of \eigen, and the second does what `solve_in_place()` does for the system *P A
  P^T X = B*, where *A* is the matrix. So no right-hand side has to be brought into the order of the
  factor and back; `Supernodal_Cholesky` has them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Eigen_solver_traits}
\cgalHasModelsEnd

\sa `Block_Lanczos_eigensolver`
*/
class LaplaceBeltramiFactorizationTraits
{
public:
  /// a sparse square matrix, constructed from its number of rows, with `set_coef(i, j, value,
  /// true)` to set an entry that was not set before; or `Eigen::SparseMatrix<double>`
  typedef unspecified_type Matrix;
  /// a vector, constructed from its number of entries, with `set(i, value)` and `operator[](i)
  /// const`
  typedef unspecified_type Vector;

  /// default constructor.
  LaplaceBeltramiFactorizationTraits();

  /// factors `matrix`, which outlives the factorization and is not changed, and returns whether
  /// this succeeded; `determinant` may be left unset.
  bool factor(const Matrix& matrix, double& determinant);

  /// solves for one right-hand side with the matrix given last to `factor()`, and returns whether
  /// this succeeded.
  bool linear_solver(const Vector& right_hand_side, Vector& solution);
};
