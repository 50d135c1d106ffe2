#ifndef MESH_INPUT_DISJOINT_SETS_H
#define MESH_INPUT_DISJOINT_SETS_H

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

// The least element of each set represents it.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t size) : m_parent(size)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  void unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    if (j < i)
      std::swap(i, j);
    m_parent[j] = i;
  }

private:
  std::vector<std::size_t> m_parent;
};

#endif // MESH_INPUT_DISJOINT_SETS_H
