// The eigenproblem on several processes, or machines: a model of LaplaceBeltramiEigensolver that
// gives it to SLEPc, whose matrices and factors are distributed by rows.
//
//   mpirun -n 2 slepc_eigensolver [MESH]
//
// Every process reads the mesh and gets the same basis; the first one compares its eigenvalues with
// those of the default eigensolver.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_Reeb_graph/Laplace_Beltrami_eigenbasis.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <string>
#include <type_traits>

namespace SMRG = CGAL::Surface_mesh_Reeb_graph;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void check(const PetscErrorCode error)
{
  if (error != 0)
    throw SMRG::Numerical_error("PETSc reports the error " + std::to_string(error));
}

// An object of PETSc or SLEPc, destroyed with its owner.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Owned
{
public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { destroy(&m_object); }

  operator Object() const { return m_object; }
  Object* address() { return &m_object; }

private:
  Object m_object = nullptr;
};

class Slepc_eigensolver
{
  static_assert(std::is_same_v<PetscScalar, double>, "PETSc must compute with double");

public:
  Slepc_eigensolver(const Eigen::SparseMatrix<double>& stiffness,
                    const Eigen::VectorXd& mass,
                    const double shift,
                    const SMRG::Eigensolver_options& options)
    : m_options(options), m_size(static_cast<PetscInt>(mass.size()))
  {
    m_options.report_progress(0);
    fill(m_stiffness, stiffness);
    fill(m_mass, Eigen::SparseMatrix<double>(mass.asDiagonal()));

    check(EPSCreate(PETSC_COMM_WORLD, m_solver.address()));
    check(EPSSetOperators(m_solver, m_stiffness, m_mass));
    check(EPSSetProblemType(m_solver, EPS_GHEP));
    check(EPSSetWhichEigenpairs(m_solver, EPS_TARGET_MAGNITUDE));
    check(EPSSetTarget(m_solver, -shift));
    // sharper than what is certified: the error of an eigenvector is not that of its residual
    check(EPSSetTolerances(m_solver, 1e-4 * options.residual_tolerance, PETSC_DEFAULT));

    // The shifted matrix is factored by MUMPS, on all processes together.
    ST transformation;
    KSP linear_solver;
    PC factorization;
    check(EPSGetST(m_solver, &transformation));
    check(STSetType(transformation, STSINVERT));
    check(STGetKSP(transformation, &linear_solver));
    check(KSPSetType(linear_solver, KSPPREONLY));
    check(KSPGetPC(linear_solver, &factorization));
    check(PCSetType(factorization, PCCHOLESKY));
    check(PCFactorSetMatSolverType(factorization, MATSOLVERMUMPS));

    BV basis;
    PetscRandom random;
    check(EPSGetBV(m_solver, &basis));
    check(BVGetRandomContext(basis, &random));
    check(PetscRandomSetSeed(random, static_cast<unsigned long>(options.seed)));
    check(PetscRandomSeed(random));

    // what the user says in the command line, as -eps_monitor
    check(EPSSetFromOptions(m_solver));
  }

  SMRG::Eigenpairs smallest(Eigen::Index number)
  {
    number = (std::min)(number, Eigen::Index(m_size));
    check(EPSSetDimensions(m_solver, static_cast<PetscInt>(number), PETSC_DEFAULT, PETSC_DEFAULT));
    check(EPSSolve(m_solver));
    PetscInt number_converged;
    check(EPSGetConverged(m_solver, &number_converged));

    SMRG::Eigenpairs result;
    result.have_converged = number_converged >= number;
    number = (std::min)(number, Eigen::Index(number_converged));
    result.values.resize(number);
    result.vectors.resize(m_size, number);

    // every process needs the whole vectors
    Owned<Vec, VecDestroy> part, whole;
    Owned<VecScatter, VecScatterDestroy> scatter;
    check(MatCreateVecs(m_stiffness, part.address(), nullptr));
    check(VecScatterCreateToAll(part, scatter.address(), whole.address()));
    for (Eigen::Index i = 0; i < number; ++i) {
      check(EPSGetEigenpair(
          m_solver, static_cast<PetscInt>(i), &result.values[i], nullptr, part, nullptr));
      check(VecScatterBegin(scatter, part, whole, INSERT_VALUES, SCATTER_FORWARD));
      check(VecScatterEnd(scatter, part, whole, INSERT_VALUES, SCATTER_FORWARD));
      const PetscScalar* values;
      check(VecGetArrayRead(whole, &values));
      result.vectors.col(i) = Eigen::Map<const Eigen::VectorXd>(values, m_size);
      check(VecRestoreArrayRead(whole, &values));
    }
    m_options.report_progress(1);
    return result;
  }

private:
  using Matrix = Owned<Mat, MatDestroy>;

  // Every process fills in its own rows; those of a symmetric matrix are its columns.
  void fill(Matrix& target, const Eigen::SparseMatrix<double>& source) const
  {
    check(MatCreate(PETSC_COMM_WORLD, target.address()));
    check(MatSetSizes(target, PETSC_DECIDE, PETSC_DECIDE, m_size, m_size));
    check(MatSetType(target, MATAIJ));
    check(MatSetOption(target, MAT_SYMMETRIC, PETSC_TRUE));
    PetscInt longest_row = 0, begin, end;
    for (PetscInt row = 0; row < m_size; ++row)
      longest_row = (std::max)(longest_row, static_cast<PetscInt>(source.col(row).nonZeros()));
    check(MatSeqAIJSetPreallocation(target, longest_row, nullptr));
    check(MatMPIAIJSetPreallocation(target, longest_row, nullptr, longest_row, nullptr));
    check(MatGetOwnershipRange(target, &begin, &end));
    for (PetscInt row = begin; row < end; ++row)
      for (Eigen::SparseMatrix<double>::InnerIterator it(source, row); it; ++it)
        check(MatSetValue(target, row, static_cast<PetscInt>(it.row()), it.value(), INSERT_VALUES));
    check(MatAssemblyBegin(target, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(target, MAT_FINAL_ASSEMBLY));
  }

  SMRG::Eigensolver_options m_options;
  PetscInt m_size;
  Matrix m_stiffness, m_mass;
  Owned<EPS, EPSDestroy> m_solver;
};

// Prints the eigenvalues of the first component and returns the largest relative difference.
double compare(const SMRG::Laplace_Beltrami_eigenbasis<Mesh, Slepc_eigensolver>& basis,
               const SMRG::Laplace_Beltrami_eigenbasis<Mesh>& default_basis)
{
  double largest_difference = 0;
  for (std::size_t k = 1; k <= default_basis.number_of_eigenpairs(0); ++k) {
    const double lambda = default_basis.eigenvalue(0, k);
    const double difference = std::abs(basis.eigenvalue(0, k) - lambda) / lambda;
    largest_difference = (std::max)(largest_difference, difference);
    std::cout << basis.eigenvalue(0, k) << ", relative difference " << difference << '\n';
  }
  return largest_difference;
}

int run(const std::string& filename)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << ": not a triangle mesh\n";
    return EXIT_FAILURE;
  }
  const auto parameters = SMRG::parameters::number_of_eigenpairs(20);
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh, Slepc_eigensolver> basis(mesh, parameters);

  int rank, number_of_processes;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  MPI_Comm_size(PETSC_COMM_WORLD, &number_of_processes);
  if (rank != 0)
    return EXIT_SUCCESS;
  std::cout << number_of_processes << " processes, residual " << basis.residual() << '\n';
  const SMRG::Laplace_Beltrami_eigenbasis<Mesh> default_basis(mesh, parameters);
  const bool are_as_many = basis.number_of_eigenpairs(0) == default_basis.number_of_eigenpairs(0);
  return are_as_many && compare(basis, default_basis) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  // without what is for PETSc
  const std::string filename =
      argc > 1 && argv[1][0] != '-' ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0)
    return EXIT_FAILURE;
  int status;
  try {
    status = run(filename);
  } catch (const std::exception& error) {
    // the other processes may wait for this one
    std::cerr << error.what() << '\n';
    MPI_Abort(PETSC_COMM_WORLD, EXIT_FAILURE);
    status = EXIT_FAILURE;
  }
  return SlepcFinalize() == 0 ? status : EXIT_FAILURE;
}
