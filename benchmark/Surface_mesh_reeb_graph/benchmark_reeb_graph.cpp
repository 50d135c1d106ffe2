// Time and memory of compute_reeb_graph() for a scalar function that is given, beside the floor: one
// pass over the faces that reads the three values of each and counts its middle vertex.
//
// The counters are: vertices, nodes of the graph, and the peak of the memory that is allocated
// meanwhile, in bytes per vertex, the output included.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_reeb_graph/compute_reeb_graph.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <new>
#include <random>
#include <utility>
#include <vector>

#include <malloc.h>

namespace SMRG = CGAL::Surface_mesh_reeb_graph;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Value_map = Mesh::Property_map<Mesh::Vertex_index, double>;

// ---- memory: all allocations are counted ----------------------------------------------------------

namespace {

std::size_t live_bytes = 0, peak_bytes = 0;

} // namespace

[[gnu::noinline]] void* operator new(std::size_t size)
{
  void* const block = std::malloc(size);
  if (block == nullptr)
    throw std::bad_alloc();
  live_bytes += malloc_usable_size(block);
  peak_bytes = (std::max)(peak_bytes, live_bytes);
  return block;
}

[[gnu::noinline]] void operator delete(void* block) noexcept
{
  live_bytes -= malloc_usable_size(block);
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  operator delete(block);
}

// ---- input ----------------------------------------------------------------------------------------

namespace {

enum Function { SMOOTH, FINE_NOISE, PURE_NOISE };

// A torus of m * m vertices, stretched so that the smooth function has a few critical points.
const Mesh& torus(int m)
{
  static std::map<int, Mesh> meshes;
  Mesh& mesh = meshes[m];
  if (mesh.number_of_vertices() != 0)
    return mesh;
  const double angle = 2 * 3.14159265358979323846 / m;
  mesh.reserve(m * m, 3 * m * m, 2 * m * m);
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) {
      const double r = 3 + std::cos(angle * j);
      mesh.add_vertex(
          Kernel::Point_3(r * std::cos(angle * i), r * std::sin(angle * i), std::sin(angle * j)));
    }
  }
  const auto vertex = [m](int i, int j) { return Mesh::Vertex_index((i % m) * m + j % m); };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return mesh;
}

std::vector<double> values_on(const Mesh& mesh, Function function)
{
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> noise(0, 1);
  std::vector<double> values;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    const double smooth = p.x() + 0.3 * p.y() + 0.1 * p.z(); // its range is about 8
    values.push_back(function == PURE_NOISE   ? noise(generator)
                     : function == FINE_NOISE ? smooth + 0.08 * noise(generator)
                                              : smooth);
  }
  return values;
}

void compute_reeb_graph(benchmark::State& state, Function function)
{
  const Mesh& mesh = torus(static_cast<int>(state.range(0)));
  const std::vector<double> values = values_on(mesh, function);
  const auto scalar_map = CGAL::make_property_map(values);
  std::size_t nodes = 0, bytes = 0;
  for (auto _ : state) {
    const std::size_t before = live_bytes;
    peak_bytes = before;
    SMRG::Reeb_graph<Mesh> graph;
    SMRG::compute_reeb_graph(mesh, scalar_map, graph);
    nodes = num_vertices(graph);
    bytes = peak_bytes - before;
  }
  state.counters["vertices"] = static_cast<double>(mesh.number_of_vertices());
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["bytes_per_vertex"] =
      static_cast<double>(bytes) / static_cast<double>(mesh.number_of_vertices());
}

void floor_pass(benchmark::State& state)
{
  const Mesh& mesh = torus(static_cast<int>(state.range(0)));
  const std::vector<double> values = values_on(mesh, SMOOTH);
  std::vector<std::uint8_t> count(mesh.number_of_vertices());
  for (auto _ : state) {
    std::fill(count.begin(), count.end(), std::uint8_t(0));
    for (Mesh::Face_index f : mesh.faces()) {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      std::array<std::size_t, 3> v = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
      if (values[v[0]] > values[v[1]])
        std::swap(v[0], v[1]);
      if (values[v[1]] > values[v[2]])
        std::swap(v[1], v[2]);
      if (values[v[0]] > values[v[1]])
        std::swap(v[0], v[1]);
      ++count[v[1]];
    }
    benchmark::DoNotOptimize(count.data());
  }
  state.counters["vertices"] = static_cast<double>(mesh.number_of_vertices());
}

const std::vector<std::int64_t> sizes = {200, 500, 1000};

BENCHMARK(floor_pass)->ArgsProduct({sizes})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compute_reeb_graph, smooth, SMOOTH)
    ->ArgsProduct({sizes})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compute_reeb_graph, fine_noise, FINE_NOISE)
    ->ArgsProduct({sizes})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compute_reeb_graph, pure_noise, PURE_NOISE)
    ->ArgsProduct({sizes})
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
