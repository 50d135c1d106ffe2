#ifndef RETRIEVAL_TOOL_EVALUATION_H
#define RETRIEVAL_TOOL_EVALUATION_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

// How well the shapes of the class of a query come first (Shilane et al. 2004).
struct Scores
{
  double nearest_neighbor = 0; // whether the first shape is of the class
  double first_tier = 0;  // of the class, how many are among the first k, k those that there are
  double second_tier = 0; // the same among the first 2 k
  double discounted_gain = 0; // discounted cumulative gain, 1 if all of the class come first
  std::size_t number_of_queries = 0;

  void add(const Scores& other)
  {
    nearest_neighbor += other.nearest_neighbor;
    first_tier += other.first_tier;
    second_tier += other.second_tier;
    discounted_gain += other.discounted_gain;
    number_of_queries += other.number_of_queries;
  }
};

// The other shapes from the nearest to the farthest; equally far ones in their order.
inline std::vector<std::size_t> ranking(const std::vector<double>& distances, std::size_t query)
{
  std::vector<std::size_t> result(distances.size());
  std::iota(result.begin(), result.end(), 0);
  result.erase(result.begin() + static_cast<std::ptrdiff_t>(query));
  std::stable_sort(result.begin(), result.end(), [&](std::size_t i, std::size_t j) {
    return distances[i] < distances[j];
  });
  return result;
}

// `ranked` are the other shapes. A query that is alone in its class has no scores.
inline Scores scores_of_query(const std::vector<std::size_t>& ranked,
                              const std::vector<std::string>& classes,
                              std::size_t query)
{
  std::vector<std::size_t> positions; // of the shapes of the class, from 0
  for (std::size_t i = 0; i < ranked.size(); ++i)
    if (classes[ranked[i]] == classes[query])
      positions.push_back(i);
  Scores scores;
  if (positions.empty())
    return scores;
  const auto gain = [](std::size_t position) {
    return position < 2 ? 1. : 1 / std::log2(static_cast<double>(position + 1));
  };
  const auto k = static_cast<double>(positions.size());
  double best_gain = 0;
  scores.number_of_queries = 1;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    scores.nearest_neighbor += positions[i] == 0 ? 1 : 0;
    scores.first_tier += positions[i] < positions.size() ? 1 / k : 0;
    scores.second_tier += positions[i] < 2 * positions.size() ? 1 / k : 0;
    scores.discounted_gain += gain(positions[i]);
    best_gain += gain(i);
  }
  scores.discounted_gain /= best_gain;
  return scores;
}

// By class, in the alphabetical order of the classes; and over all queries, under the name "all".
inline std::vector<std::pair<std::string, Scores>>
evaluate(const std::vector<std::vector<double>>& distances, const std::vector<std::string>& classes)
{
  std::map<std::string, Scores> by_class;
  Scores all;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const Scores scores = scores_of_query(ranking(distances[i], i), classes, i);
    by_class[classes[i]].add(scores);
    all.add(scores);
  }
  std::vector<std::pair<std::string, Scores>> result(by_class.begin(), by_class.end());
  result.emplace_back("all", all);
  return result;
}

#endif // RETRIEVAL_TOOL_EVALUATION_H
