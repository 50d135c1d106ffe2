// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A target of libFuzzer: whatever the mesh and the function, the algorithms give one and the same
// graph, which is that of the brute-force oracle and obeys the topology of the surface, and
// simplification leaves no small pair.
//
// Usage: fuzz_compute_Reeb_graph [-runs=N] [-max_total_time=SECONDS] [-seed=N] [FILE of a failure]

#include "mesh_from_bytes.h"

#include <CGAL/Surface_mesh_Reeb_graph/compute_Reeb_graph.h>
#include <CGAL/Surface_mesh_Reeb_graph/persistence_pairs.h>
#include <CGAL/Surface_mesh_Reeb_graph/simplify_Reeb_graph.h>
#include <CGAL/exceptions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

using namespace Reeb_graph_test;

namespace {

using Algorithm = SMRG::Reeb_graph_algorithm;
using Pair = SMRG::Persistence_pair<Graph>;

void require(const bool condition, const char* const what)
{
  if (!condition) {
    std::fprintf(stderr, "This does not hold: %s\n", what);
    std::abort();
  }
}

// The mesh for the oracles, which know no removed vertices. The numbers of both increase together.
struct Dense_mesh
{
  Index_mesh mesh;
  std::vector<Vertex> vertex;      // of the fuzzed mesh, by number
  std::vector<std::size_t> number; // by vertex of the fuzzed mesh

  explicit Dense_mesh(const Mesh& fuzzed)
    : number(fuzzed.number_of_vertices() + fuzzed.number_of_removed_vertices())
  {
    for (const Vertex v : fuzzed.vertices()) {
      number[v] = vertex.size();
      vertex.push_back(v);
    }
    mesh.points.resize(vertex.size());
    for (const Mesh::Face_index f : fuzzed.faces()) {
      std::array<std::size_t, 3> triangle;
      std::size_t i = 0;
      for (const Vertex v : fuzzed.vertices_around_face(fuzzed.halfedge(f)))
        triangle[i++] = number[v];
      mesh.triangles.push_back(triangle);
    }
  }
};

// A graph with the arcs of all vertices and faces.
struct Output
{
  Graph graph;
  std::vector<std::size_t> arc_of_vertex; // by number in the dense mesh
  std::vector<std::size_t> arc_of_face;
};

bool is_same(const Output& a, const Output& b)
{
  if (a.arc_of_vertex != b.arc_of_vertex || a.arc_of_face != b.arc_of_face ||
      num_vertices(a.graph) != num_vertices(b.graph) || num_edges(a.graph) != num_edges(b.graph))
    return false;
  for (std::size_t node = 0; node < num_vertices(a.graph); ++node) {
    const auto& m = a.graph[node];
    const auto& n = b.graph[node];
    if (m.id != n.id || m.vertex != n.vertex || m.value != n.value || m.type != n.type)
      return false;
  }
  auto other = edges(b.graph).first;
  for (const auto arc : CGAL::make_range(edges(a.graph))) {
    if (source(arc, a.graph) != source(*other, b.graph) ||
        target(arc, a.graph) != target(*other, b.graph) || a.graph[arc].id != b.graph[*other].id ||
        a.graph[arc].vertices != b.graph[*other].vertices)
      return false;
    ++other;
  }
  return true;
}

std::size_t number_of_loops(const Graph& graph, const Index_mesh& mesh)
{
  return num_edges(graph) + number_of_components(mesh) - num_vertices(graph);
}

// The graph of an unfolded one: nodes of one vertex become one, which is none if one arc goes in
// and one comes out. To be compared with that of the oracle.
std::vector<Comparable_arc> folded_arcs(const Graph& graph)
{
  std::vector<Comparable_arc> arcs;
  for (const Comparable_arc& arc : comparable_arcs(graph))
    if (std::get<0>(arc) != std::get<1>(arc))
      arcs.push_back(arc);

  for (const auto node : CGAL::make_range(vertices(graph))) {
    const std::size_t v = graph[node].vertex;
    std::vector<std::size_t> below, above;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (std::get<1>(arcs[i]) == v)
        below.push_back(i);
      if (std::get<0>(arcs[i]) == v)
        above.push_back(i);
    }
    if (below.size() == 1 && above.size() == 1) {
      const Comparable_arc lower = arcs[below.front()], upper = arcs[above.front()];
      std::vector<std::size_t> regular = std::get<2>(lower);
      regular.push_back(v);
      regular.insert(regular.end(), std::get<2>(upper).begin(), std::get<2>(upper).end());
      arcs[below.front()] = comparable_arc(std::get<0>(lower), std::get<1>(upper), regular);
      arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(above.front()));
    }
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

class Checks
{
public:
  Checks(Mesh& mesh, const std::vector<double>& values) : m_mesh(mesh), m_dense(mesh)
  {
    m_values = mesh.add_property_map<Vertex, double>("v:value").first;
    m_ranks = mesh.add_property_map<Vertex, double>("v:rank").first;
    m_arcs = mesh.add_property_map<Vertex, std::size_t>("v:arc").first;
    m_face_arcs = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:arc").first;
    for (std::size_t i = 0; i < values.size(); ++i)
      m_values[m_dense.vertex[i]] = values[i];
    rank();
  }

  void run()
  {
    const Output ranked = compute(m_ranks, false);
    check_against_oracle(ranked.graph);
    const Output ranked_unfolded = compute(m_ranks, true);
    require(folded_arcs(ranked_unfolded.graph) == comparable_arcs(ranked.graph),
            "an unfolded graph folds back to the graph");
    check_topology(ranked_unfolded.graph);

    // The same order of the vertices, but with the pairs inside plateaus cancelled.
    const Output output = compute(m_values, false);
    require(number_of_loops(output.graph, m_dense.mesh) ==
                number_of_loops(ranked.graph, m_dense.mesh),
            "plateaus have no loops");
    check_extrema(output.graph);
    check_topology(compute(m_values, true).graph);
    for (const double threshold : {2., 5., std::numeric_limits<double>::infinity()})
      check_simplification(threshold);
  }

  // There is no right graph: an error, or any graph, but an end.
  void run_for_invalid_mesh()
  {
    for (const Algorithm algorithm : {Algorithm::SWEEP, Algorithm::CUTTING, Algorithm::AUTOMATIC}) {
      try {
        compute(m_values, false, algorithm);
      } catch (const SMRG::Error&) {
      } catch (const CGAL::Failure_exception&) { // a check may see it first
      }
    }
  }

private:
  void rank()
  {
    const auto indices = get(boost::vertex_index, m_mesh);
    const SMRG::Vertex_order<Mesh, Value_map, std::decay_t<decltype(indices)>> order(
        m_mesh, m_values, indices);
    std::vector<Vertex> sorted = m_dense.vertex;
    std::sort(sorted.begin(), sorted.end(), order);
    m_rank.resize(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      m_ranks[sorted[i]] = double(i);
      m_rank[m_dense.number[sorted[i]]] = i;
    }
  }

  // By all algorithms, which must agree.
  Output compute(const Value_map values, const bool unfold)
  {
    const Output output = compute(values, unfold, Algorithm::SWEEP);
    for (const Algorithm algorithm : {Algorithm::CUTTING, Algorithm::AUTOMATIC})
      require(is_same(compute(values, unfold, algorithm), output), "the algorithms agree");
    check_arcs_of_vertices(output);
    return output;
  }

  Output compute(const Value_map values, const bool unfold, const Algorithm algorithm)
  {
    Output output;
    SMRG::compute_Reeb_graph(m_mesh,
                             values,
                             output.graph,
                             SMRG::parameters::vertex_arc_map(m_arcs)
                                 .face_arc_map(m_face_arcs)
                                 .collect_arc_vertices(true)
                                 .unfold_multiple_saddles(unfold)
                                 .algorithm(algorithm));
    for (const Vertex v : m_dense.vertex)
      output.arc_of_vertex.push_back(m_arcs[v]);
    for (const Mesh::Face_index f : m_mesh.faces())
      output.arc_of_face.push_back(m_face_arcs[f]);
    return output;
  }

  // The pairs of extrema below half of the threshold and the loops below it are gone.
  void check_simplification(const double threshold)
  {
    Output output = compute(m_ranks, false, Algorithm::AUTOMATIC);
    const std::size_t number_of_loops_before = number_of_loops(output.graph, m_dense.mesh);
    SMRG::simplify_Reeb_graph(m_mesh,
                              m_ranks,
                              output.graph,
                              SMRG::parameters::vertex_arc_map(m_arcs)
                                  .threshold_is_absolute(true)
                                  .persistence_threshold(threshold / 2)
                                  .loop_persistence_threshold(threshold));
    output.arc_of_vertex.clear();
    for (const Vertex v : m_dense.vertex)
      output.arc_of_vertex.push_back(m_arcs[v]);
    check_arcs_of_vertices(output);
    require(number_of_loops(output.graph, m_dense.mesh) <= number_of_loops_before,
            "simplification makes no loops");
    std::vector<Pair> pairs;
    SMRG::persistence_pairs(output.graph, std::back_inserter(pairs));
    for (const Pair& pair : pairs)
      require(pair.kind == SMRG::Persistence_pair_kind::COMPONENT ||
                  pair.persistence() >=
                      (pair.kind == SMRG::Persistence_pair_kind::LOOP ? threshold : threshold / 2),
              "no small pair is left");
  }

  // Every vertex with edges is in one arc, and the two mappings say the same.
  void check_arcs_of_vertices(const Output& output) const
  {
    std::vector<std::size_t> expected(m_dense.vertex.size(), SMRG::null_arc);
    for (const auto arc : CGAL::make_range(edges(output.graph))) {
      for (const Vertex v : output.graph[arc].vertices) {
        require(expected[m_dense.number[v]] == SMRG::null_arc, "a vertex is in one arc");
        expected[m_dense.number[v]] = output.graph[arc].id;
      }
    }
    require(expected == output.arc_of_vertex, "the vertices of the arcs are those of the map");
    for (std::size_t i = 0; i < expected.size(); ++i)
      require((expected[i] == SMRG::null_arc) == m_mesh.is_isolated(m_dense.vertex[i]),
              "a vertex with edges is in an arc");
  }

  void check_against_oracle(const Graph& graph) const
  {
    const Brute_force_Reeb_graph oracle = brute_force_Reeb_graph(m_dense.mesh, m_rank);
    require(num_vertices(graph) == oracle.nodes.size(), "as many nodes as by brute force");
    for (std::size_t i = 0; i < oracle.nodes.size(); ++i) {
      const auto& node = oracle.nodes[i];
      require(graph[i].vertex == m_dense.vertex[node.vertex], "the nodes are those by brute force");
      require(graph[i].type == SMRG::type_of_Reeb_node(node.down, node.up),
              "the types of the nodes are those by brute force");
    }
    std::vector<Comparable_arc> arcs;
    for (const auto& arc : oracle.arcs) {
      std::vector<std::size_t> regular;
      for (const std::size_t v : arc.vertices)
        regular.push_back(m_dense.vertex[v]);
      arcs.push_back(comparable_arc(
          m_dense.vertex[arc.lower_vertex], m_dense.vertex[arc.upper_vertex], regular));
    }
    std::sort(arcs.begin(), arcs.end());
    require(comparable_arcs(graph) == arcs, "the arcs are those by brute force");
  }

  // What is left from tied values are the extrema that brute force pairs with a different value.
  void check_extrema(const Graph& graph)
  {
    for (const bool minima : {true, false}) {
      const Extremum_pairs pairs =
          brute_force_extremum_pairs(m_dense.mesh, minima ? m_rank : reversed_rank(m_rank));
      std::vector<std::size_t> expected;
      for (const std::size_t v : pairs.unpaired_extrema)
        expected.push_back(m_dense.vertex[v]);
      for (const Extremum_pair& pair : pairs.pairs) {
        const Vertex extremum = m_dense.vertex[pair.extremum];
        if (m_values[extremum] != m_values[m_dense.vertex[pair.saddle]])
          expected.push_back(extremum);
      }
      std::sort(expected.begin(), expected.end());
      require(extrema(graph, minima) == expected, "the extrema are those by brute force");
    }
  }

  // With simple saddles only, a closed surface has a loop for every handle; then the numbers of the
  // nodes follow from Euler's formula.
  void check_topology(const Graph& unfolded) const
  {
    if (!CGAL::is_closed(m_mesh))
      return;
    for (const auto node : CGAL::make_range(vertices(unfolded)))
      require(unfolded[node].type != SMRG::Reeb_node_type::DEGENERATE,
              "unfolded saddles are simple");
    require(number_of_loops(unfolded, m_dense.mesh) == genus(m_dense.mesh),
            "as many loops as handles");
  }

  Mesh& m_mesh;
  Dense_mesh m_dense;
  Value_map m_values, m_ranks;
  Arc_map m_arcs;
  Mesh::Property_map<Mesh::Face_index, std::size_t> m_face_arcs;
  std::vector<std::size_t> m_rank; // by number in the dense mesh
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Bytes bytes(data, size);
  Mesh mesh;
  const bool is_manifold = Mesh_from_bytes(bytes, mesh).is_manifold();
  require(CGAL::is_triangle_mesh(mesh), "the fuzzer makes triangle meshes");
  const std::vector<double> values = values_from_bytes(bytes, mesh.number_of_vertices());
  Checks checks(mesh, values);
  if (is_manifold)
    checks.run();
  else
    checks.run_for_invalid_mesh();
  return 0;
}
