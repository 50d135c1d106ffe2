/*!
\ingroup PkgSurfaceMeshReebGraphConcepts
\cgalConcept

The concept `LaplaceBeltramiEigensolver` describes what computes the eigenpairs of
`Laplace_Beltrami_eigenbasis`: the smallest solutions of *L psi = lambda M psi* for two sparse
matrices. Nothing else of a mesh is known to it, and the basis knows nothing of how it works. So a
library of iterative solvers, one for graphics processors, or one for many computers takes the place
of `Block_Lanczos_eigensolver` by a class with one constructor and one function.

For every connected component with area, one object is made, asked once or several times, and
destroyed before the next one is made. It is used by one thread. What it returns is verified: the
residual of every pair is computed from the matrices and compared with the tolerance.

Components may be tiny, down to three vertices, so that all their eigenpairs are wanted. A model
whose method needs larger matrices can leave these to a `Block_Lanczos_eigensolver`, which treats
them as dense matrices.

A model is free to ignore the shift, the seed and the callback.

\cgalHasModelsBegin
\cgalHasModels{Block_Lanczos_eigensolver}
\cgalHasModels{Spectra_eigensolver}
\cgalHasModelsEnd

\sa `Laplace_Beltrami_eigenbasis`
*/
class LaplaceBeltramiEigensolver
{
public:
  /*!
  prepares the computation.

  \param stiffness *L*, n x n: symmetric, all entries stored, positive semi-definite with the
         constant vectors as null space. The object outlives the eigensolver.
  \param mass the diagonal of *M*, not negative; single entries may be zero. The object outlives the
         eigensolver.
  \param shift a positive number of the order of the smallest non-zero eigenvalue: `stiffness +
         shift * M` is positive definite and well suited to find the smallest eigenvalues by its
         inverse
  \param options the accuracy wanted, a seed, and the callback of the user, which
         `Eigensolver_options::report_progress()` calls

  \throws Numerical_error if that fails; the message need not name the component
  */
  LaplaceBeltramiEigensolver(const Eigen::SparseMatrix<double>& stiffness,
                             const Eigen::VectorXd& mass,
                             double shift,
                             const Eigensolver_options& options);

  /*!
  returns the `number` smallest eigenpairs, with the one of eigenvalue zero, in increasing order and
  with *M*-orthonormal eigenvectors; all that there are, if there are fewer. A multiple eigenvalue
  counts as many times as its multiplicity says: if one is left out, the basis is wrong and nothing
  can tell.

  It may be called again, usually with a somewhat larger number because the last eigenvalue was
  found to be multiple. A model should then use what it has.

  If the method does not converge, the pairs before the first one that did not are returned, with
  `Eigenpairs::have_converged == false`.

  \pre `number > 0`

  \throws Numerical_error if anything else fails
  */
  Eigenpairs smallest(Eigen::Index number);
};
