#include "compute_function.h"

#include <CGAL/Surface_mesh_Reeb_graph/mapping_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace {

using Eigenbasis = SMRG::Laplace_Beltrami_eigenbasis<Mesh>;

// The vertices of an option.
std::vector<vertex_descriptor> vertices_of(const std::string& option,
                                           const std::vector<std::size_t>& numbers,
                                           const Options& options,
                                           const Mesh& mesh)
{
  std::vector<vertex_descriptor> result;
  for (const std::size_t number : numbers) {
    if (number >= mesh.number_of_vertices())
      throw Usage_error(option + ": there is no vertex " + std::to_string(number) + "; " +
                        options.mesh_file + " has " + std::to_string(mesh.number_of_vertices()) +
                        ", numbered from 0");
    result.push_back(vertex_descriptor(static_cast<vertex_descriptor::size_type>(number)));
  }
  return result;
}

// The feature points of the user.
std::vector<vertex_descriptor> read_features(const Options& options, const Mesh& mesh)
{
  std::ifstream in(options.features_file);
  if (!in)
    throw File_error(options.features_file, "cannot be opened");
  std::vector<vertex_descriptor> result;
  for (std::string word; in >> word;) {
    const bool is_number = word.size() <= 9 && std::all_of(word.begin(), word.end(), [](char c) {
                             return '0' <= c && c <= '9';
                           });
    if (!is_number || std::stoul(word) >= mesh.number_of_vertices())
      throw File_error(options.features_file,
                       "'" + word.substr(0, 20) + "' is not the number of a vertex; the mesh has " +
                           std::to_string(mesh.number_of_vertices()) + ", numbered from 0");
    result.push_back(
        vertex_descriptor(static_cast<vertex_descriptor::size_type>(std::stoul(word))));
  }
  if (result.empty() && mesh.number_of_vertices() > 0)
    throw File_error(options.features_file, "holds no vertex");
  return result;
}

// The number of eigenpairs of the component that has most of them.
std::size_t largest_index(const Eigenbasis& basis)
{
  std::size_t largest = 0;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    largest = (std::max)(largest, basis.number_of_eigenpairs(c));
  return largest;
}

void check_index(const Options& options, std::size_t largest)
{
  if (static_cast<std::size_t>(options.index) > largest)
    throw Usage_error("--index: no component of " + options.mesh_file + " has an eigenfunction " +
                      std::to_string(options.index) + "; the last one is " +
                      std::to_string(largest));
}

// log(lambda_k / lambda_1) of the first component that has so many eigenvalues.
double energy_of_eigenvalue(const Eigenbasis& basis, std::size_t k)
{
  std::size_t c = 0;
  while (basis.number_of_eigenpairs(c) < k)
    ++c;
  return std::log(basis.eigenvalue(c, k) / basis.eigenvalue(c, 1));
}

// The smallest distance of every vertex from a source. Where none is reached, the function is the
// largest distance of all others, as for geodesic distances: infinity has no color.
template <class Distances>
void write_smallest_distances(const std::vector<vertex_descriptor>& sources,
                              const Mesh& mesh,
                              const Distances& distances,
                              Value_map values)
{
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  std::vector<double> smallest(mesh.number_of_vertices(), infinity);
  for (const vertex_descriptor source : sources) {
    distances(source);
    for (const vertex_descriptor v : mesh.vertices())
      smallest[v] = (std::min)(smallest[v], values[v]);
  }
  double largest = 0;
  for (const double distance : smallest)
    if (distance < infinity)
      largest = (std::max)(largest, distance);
  for (const vertex_descriptor v : mesh.vertices())
    values[v] = smallest[v] < infinity ? smallest[v] : largest;
}

// One component that cannot be computed must not take the others with it.
void check_components(const Eigenbasis& basis, Result& result)
{
  bool is_any_complete = false;
  for (std::size_t c = 0; c < basis.number_of_components(); ++c)
    if (basis.failure(c).empty())
      is_any_complete = is_any_complete || basis.number_of_eigenpairs(c) > 0;
    else
      result.failures.push_back({c, basis.component_vertices(c).size(), basis.failure(c)});
  if (!is_any_complete && !result.failures.empty())
    throw SMRG::Numerical_error(result.failures.front().text());
}

// What needs no eigenbasis, by names.
using Function = std::function<void(const Options&, Result&)>;

const std::map<std::string, Function>& direct_functions()
{
  static const std::map<std::string, Function> functions = {
      {"height",
       [](const Options& options, Result& result) {
         SMRG::height_function(result.mesh,
                               Kernel::Vector_3(options.axis[0], options.axis[1], options.axis[2]),
                               result.values);
       }},
      {"barycentre",
       [](const Options&, Result& result) {
         SMRG::barycenter_distance_function(result.mesh, result.values);
       }},
      {"geodesic",
       [](const Options& options, Result& result) {
         SMRG::geodesic_distance_function(
             result.mesh,
             vertices_of("--source", options.sources, options, result.mesh),
             result.values);
       }},
      {"integral_geodesic",
       [](const Options&, Result& result) {
         SMRG::Geodesic_distances<Mesh> geodesics(result.mesh);
         SMRG::integral_geodesic_distance_function(geodesics, result.values);
       }},
      {"tierny",
       [](const Options& options, Result& result) {
         SMRG::Geodesic_distances<Mesh> geodesics(result.mesh);
         if (options.features_file.empty())
           SMRG::crossed_feature_points(geodesics, std::back_inserter(result.feature_points));
         else
           result.feature_points = read_features(options, result.mesh);
         geodesics.write_distances(result.feature_points, result.values);
       }},
      {"curvature",
       [](const Options& options, Result& result) {
         if (options.features_file.empty())
           SMRG::curvature_feature_points(result.mesh, std::back_inserter(result.feature_points));
         else
           result.feature_points = read_features(options, result.mesh);
         SMRG::geodesic_distance_function(result.mesh, result.feature_points, result.values);
       }},
      {"harmonic",
       [](const Options& options, Result& result) {
         SMRG::harmonic_function(result.mesh,
                                 vertices_of("--minima", options.minima, options, result.mesh),
                                 vertices_of("--maxima", options.maxima, options, result.mesh),
                                 result.values);
       }},
      {"shape_diameter",
       [](const Options&, Result& result) {
         SMRG::shape_diameter_function(result.mesh, result.values);
       }},
  };
  return functions;
}

void compute_spectral_function(const Options& options, const Eigenbasis& basis, Result& result)
{
  const std::string& function = options.function;
  const auto index = static_cast<std::size_t>(options.index);
  if (function == "eigenfunction") {
    SMRG::eigenfunction(basis, index, result.values);
  } else if (function == "auto_diffusion") {
    SMRG::auto_diffusion_function(basis, options.time, result.values);
  } else if (function == "heat_kernel_signature") {
    SMRG::heat_kernel_signature(basis, options.time, result.values);
  } else if (function == "wave_kernel_signature") {
    SMRG::wave_kernel_signature(basis, energy_of_eigenvalue(basis, index), result.values);
  } else if (function == "commute_time") {
    if (options.features_file.empty())
      SMRG::feature_points(
          basis,
          std::back_inserter(result.feature_points),
          SMRG::parameters::small_time(options.small_time).large_time(options.large_time));
    else
      result.feature_points = read_features(options, result.mesh);
    SMRG::commute_time_function(basis, result.feature_points, result.values);
  } else {
    const auto distances = [&](vertex_descriptor source) {
      if (function == "diffusion")
        SMRG::diffusion_distances(basis, source, options.time, result.values);
      else if (function == "biharmonic")
        SMRG::biharmonic_distances(basis, source, result.values);
      else
        SMRG::commute_time_distances(basis, source, result.values);
    };
    write_smallest_distances(vertices_of("--source", options.sources, options, result.mesh),
                             result.mesh,
                             distances,
                             result.values);
  }
}

} // namespace

void compute_function(const Options& options, Result& result, Progress& progress)
{
  const auto direct = direct_functions().find(options.function);
  if (direct != direct_functions().end()) {
    timed(result.seconds.function, progress, "computing the function", [&]() {
      direct->second(options, result);
    });
    return;
  }

  // before the eigenbasis takes its time
  vertices_of("--source", options.sources, options, result.mesh);
  const bool has_index =
      options.function == "eigenfunction" || options.function == "wave_kernel_signature";
  if (has_index && std::size_t(options.index) >= result.mesh.number_of_vertices())
    throw Usage_error("--index: " + options.mesh_file + " has " +
                      std::to_string(result.mesh.number_of_vertices()) +
                      " vertices, so that there is no eigenfunction " +
                      std::to_string(options.index));
  int number_of_eigenpairs = options.eigenpairs;
  if (options.function == "eigenfunction")
    number_of_eigenpairs = options.index;
  else if (has_index)
    number_of_eigenpairs = (std::max)(options.eigenpairs, options.index);
  std::unique_ptr<Eigenbasis> basis;
  timed(result.seconds.eigenbasis, progress, "computing the eigenbasis", [&]() {
    basis =
        std::make_unique<Eigenbasis>(result.mesh,
                                     SMRG::parameters::number_of_eigenpairs(number_of_eigenpairs)
                                         .residual_tolerance(options.residual_tolerance)
                                         .accept_converged_part(true)
                                         .callback([&progress](double part) {
                                           progress.say_part(part);
                                           return true;
                                         }));
  });
  check_components(*basis, result);
  for (std::size_t c = 0; c < basis->number_of_components(); ++c) {
    result.eigenvalues.emplace_back();
    for (std::size_t k = 1; k <= basis->number_of_eigenpairs(c); ++k)
      result.eigenvalues.back().push_back(basis->eigenvalue(c, k));
  }
  if (has_index) // components are smaller than the mesh
    check_index(options, largest_index(*basis));
  timed(result.seconds.function, progress, "computing the function", [&]() {
    compute_spectral_function(options, *basis, result);
  });
}
