// Shape retrieval: a signature for every mesh of a folder, distances of all, and queries.

#include "reeb_graph_tool/input.h"
#include "reeb_graph_tool/types.h"
#include "retrieval_tool/evaluation.h"
#include "retrieval_tool/functions.h"
#include "retrieval_tool/processes.h"
#include "retrieval_tool/retrieval_options.h"

#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_Reeb_graph/IO/shape_signature_file.h>
#include <CGAL/Surface_mesh_Reeb_graph/Shape_signature.h>
#ifdef RETRIEVAL_WITH_HERA
#include <CGAL/Surface_mesh_Reeb_graph/bottleneck_distance.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <locale>
#include <map>
#include <mutex>
#include <numeric>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace {

namespace fs = std::filesystem;

// Protects the error stream: the reader of meshes redirects it for a while.
std::mutex error_stream_mutex;

void show_progress(const std::string& text)
{
#if defined(__unix__) || defined(__APPLE__)
  if (isatty(STDERR_FILENO))
    std::cerr << "\r\033[K" << text << std::flush;
#else
  static_cast<void>(text);
#endif
}

// What is added to the name of a mesh.
std::string suffix(const std::string& function)
{
  return '.' + function + ".signature";
}

// The files of the signatures of a mesh, by function.
std::vector<fs::path> signature_files(const Retrieval_options& options, const std::string& mesh)
{
  std::vector<fs::path> result;
  for (const std::string& function : options.functions)
    result.push_back(fs::path(options.signatures) / (mesh + suffix(function)));
  return result;
}

// The names of the files in a folder that `is_wanted`, sorted.
template <class Predicate>
std::vector<std::string> files_in(const std::string& folder, const Predicate& is_wanted)
{
  std::error_code error;
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file() && is_wanted(entry.path()))
      result.push_back(entry.path().filename().string());
  if (error)
    throw File_error(folder, "cannot be read as a folder");
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> meshes_in(const std::string& folder)
{
  const std::vector<std::string> result =
      files_in(folder, [](const fs::path& path) { return has_readable_format(path.string()); });
  if (result.empty())
    throw File_error(folder, "holds no file in one of the formats " + readable_formats());
  return result;
}

// What a shape is compared by: a signature for every function.
using Signatures = std::vector<SMRG::Shape_signature>;

Signatures signatures_of(const std::string& mesh_file, const std::vector<std::string>& functions)
{
  Mesh mesh;
  Mesh_input input;
  read_mesh(mesh_file, Mesh_input_options(), mesh, input);
  {
    const std::lock_guard<std::mutex> lock(error_stream_mutex);
    print_findings(std::cerr, "retrieval: " + mesh_file, input);
  }
  try {
    const Basis basis(mesh);
    const Value_map values = mesh.add_property_map<vertex_descriptor, double>("v:value").first;
    Signatures result;
    for (const std::string& function : functions) {
      compute_function(function, mesh, basis, values);
      result.push_back(SMRG::compute_shape_signature(basis, values));
    }
    return result;
  } catch (const SMRG::Error& error) {
    throw File_error(mesh_file, error.what());
  }
}

// Computes the signatures that are missing, those of this process; returns how many failed.
std::size_t compute_signatures(const Retrieval_options& options,
                               const Processes& processes,
                               const std::vector<std::string>& meshes)
{
  std::vector<std::string> mine;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (processes.has(i))
      mine.push_back(meshes[i]);
  std::atomic<std::size_t> next(0), done(0), failed(0);
  CGAL::Real_timer timer;
  timer.start();
  const auto work = [&]() {
    for (std::size_t i = next++; i < mine.size(); i = next++) {
      std::string message;
      try {
        const std::string file = (fs::path(options.argument) / mine[i]).string();
        const Signatures signatures = signatures_of(file, options.functions);
        const std::vector<fs::path> files = signature_files(options, mine[i]);
        for (std::size_t f = 0; f < files.size(); ++f)
          if (!SMRG::IO::write_shape_signature(files[f].string(), signatures[f]))
            throw File_error(files[f].string(), "cannot be written");
      } catch (const std::exception& error) {
        message = error.what();
        ++failed;
      }
      ++done;
      const std::lock_guard<std::mutex> lock(error_stream_mutex);
      show_progress("");
      if (!message.empty())
        std::cerr << "retrieval: " << message << '\n';
      if (processes.is_first())
        show_progress(std::to_string(done) + " of " + std::to_string(mine.size()) + " signatures");
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.threads; ++i)
    threads.emplace_back(work);
  work();
  for (std::thread& thread : threads)
    thread.join();
  show_progress("");
  if (processes.is_first() && !mine.empty())
    std::cout << mine.size() << (mine.size() == 1 ? " shape indexed, " : " shapes indexed, ")
              << std::setprecision(3)
              << timer.time() * options.threads / static_cast<double>(mine.size())
              << " s for each on one thread\n";
  return processes.sum(failed);
}

struct Collection
{
  std::vector<std::string> names; // of the meshes
  std::vector<Signatures> signatures;
};

Collection read_collection(const Retrieval_options& options, std::vector<std::string> names)
{
  Collection collection;
  for (std::string& name : names) {
    collection.signatures.emplace_back();
    for (const fs::path& file : signature_files(options, name))
      collection.signatures.back().push_back(SMRG::IO::read_shape_signature(file.string()));
    collection.names.push_back(std::move(name));
  }
  return collection;
}

double
distance(const std::string& name, const SMRG::Shape_signature& a, const SMRG::Shape_signature& b)
{
  if (name == "graph")
    return SMRG::Reeb_graph_distance(a.graph, b.graph);
  if (name == "spectrum")
    return SMRG::spectral_shape_distance(a, b);
  if (name == "persistence")
    return SMRG::persistence_distance(a.graph, b.graph);
#ifdef RETRIEVAL_WITH_HERA
  if (name == "bottleneck")
    return SMRG::bottleneck_distance(a.graph, b.graph);
#endif
  return SMRG::shape_distance(a, b);
}

double distance(const std::string& name, const Signatures& a, const Signatures& b)
{
  double sum = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    sum += distance(name, a[f], b[f]);
  return sum;
}

// Complete for the first process only; and the mean time per pair.
std::pair<std::vector<std::vector<double>>, double>
distances_of_all(const std::string& name, const Processes& processes, const Collection& collection)
{
  const std::size_t n = collection.names.size();
  std::vector<std::vector<double>> rows(n);
  std::size_t number_of_pairs = 0;
  CGAL::Real_timer timer;
  timer.start();
  for (std::size_t i = 0; i < n; ++i) {
    if (!processes.has(i))
      continue;
    for (std::size_t j = 0; j < i; ++j)
      rows[i].push_back(distance(name, collection.signatures[i], collection.signatures[j]));
    number_of_pairs += i;
  }
  const double seconds =
      timer.time() / static_cast<double>((std::max)(number_of_pairs, std::size_t(1)));
  processes.gather(rows);
  if (processes.is_first()) {
    for (std::size_t i = 0; i < n; ++i)
      rows[i].resize(n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        rows[j][i] = rows[i][j];
  }
  return {rows, seconds};
}

void write_distances(const std::string& file,
                     const std::vector<std::string>& names,
                     const std::vector<std::vector<double>>& rows)
{
  std::ofstream out(file);
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  for (std::size_t i = 0; i < names.size(); ++i)
    out << (i == 0 ? "" : " ") << names[i];
  out << '\n';
  for (const std::vector<double>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out << (i == 0 ? "" : " ") << row[i];
    out << '\n';
  }
  out.close();
  if (!out)
    throw File_error(file, "cannot be written");
}

// The class of every mesh.
std::vector<std::string>
read_classes(const std::string& file, const std::vector<std::string>& names)
{
  std::ifstream in(file);
  if (!in)
    throw File_error(file, "cannot be opened");
  std::map<std::string, std::string> class_of;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string name, class_name, rest;
    if (!(words >> name))
      continue;
    if (!(words >> class_name) || words >> rest)
      throw File_error(file, "the line '" + line + "' is not a file name and a class");
    class_of[name] = class_name;
  }
  std::vector<std::string> result;
  for (const std::string& name : names) {
    const auto entry = class_of.find(name);
    if (entry == class_of.end())
      throw File_error(file, "has no class for " + name);
    result.push_back(entry->second);
  }
  return result;
}

void print_scores(const std::string& name, const Scores& scores)
{
  const auto number = static_cast<double>((std::max)(scores.number_of_queries, std::size_t(1)));
  std::cout << "| " << std::left << std::setw(12) << name << std::right << std::fixed
            << std::setprecision(3);
  for (const double score :
       {scores.nearest_neighbor, scores.first_tier, scores.second_tier, scores.discounted_gain})
    std::cout << " | " << score / number;
}

void print_table(const Processes& processes,
                 const Collection& collection,
                 const std::vector<std::string>& classes)
{
  if (processes.is_first())
    std::cout << "| distance | nearest neighbor | first tier | second tier | DCG | time per pair "
                 "(us) |\n|---|--:|--:|--:|--:|--:|\n";
  for (const std::string name : {"shape",
                                 "graph",
                                 "spectrum",
                                 "persistence",
#ifdef RETRIEVAL_WITH_HERA
                                 "bottleneck"
#endif
       })
  {
    const auto result = distances_of_all(name, processes, collection);
    if (!processes.is_first())
      continue;
    print_scores(name, evaluate(result.first, classes).back().second);
    std::cout << " | " << std::setprecision(1) << 1e6 * result.second << " |\n";
  }
}

int index(const Retrieval_options& options, const Processes& processes)
{
  // the first one looks what there is, before anybody writes
  std::vector<std::string> meshes, missing;
  if (processes.is_first()) {
    meshes = meshes_in(options.argument);
    std::error_code error;
    fs::create_directories(options.signatures, error);
    if (!fs::is_directory(options.signatures))
      throw File_error(options.signatures, "cannot be made");
    for (const std::string& mesh : meshes) {
      const fs::path mesh_file = fs::path(options.argument) / mesh;
      const std::vector<fs::path> files = signature_files(options, mesh);
      if (std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
            return !fs::exists(file) || fs::last_write_time(file) < fs::last_write_time(mesh_file);
          }))
        missing.push_back(mesh);
    }
  }
  processes.broadcast(meshes);
  processes.broadcast(missing);
  if (compute_signatures(options, processes, missing) > 0)
    return EXIT_FAILURE;
  if (options.distances.empty() && options.classes.empty())
    return EXIT_SUCCESS;

  const Collection collection = read_collection(options, meshes);
  std::vector<std::string> classes;
  if (!options.classes.empty())
    classes = read_classes(options.classes, collection.names);
  if (options.table) {
    print_table(processes, collection, classes);
  }
  if (options.table && options.distances.empty())
    return EXIT_SUCCESS;
  const auto result = distances_of_all(options.distance, processes, collection);
  if (!processes.is_first())
    return EXIT_SUCCESS;
  if (!options.distances.empty())
    write_distances(options.distances, collection.names, result.first);
  if (!options.classes.empty() && !options.table) {
    std::cout << "| class | nearest neighbor | first tier | second tier | DCG |\n"
                 "|---|--:|--:|--:|--:|\n";
    for (const auto& row : evaluate(result.first, classes)) {
      print_scores(row.first, row.second);
      std::cout << " |\n";
    }
  }
  return EXIT_SUCCESS;
}

int query(const Retrieval_options& options)
{
  // the other functions have files of their own
  const std::string end = suffix(options.functions.front());
  std::vector<std::string> names = files_in(options.signatures, [&](const fs::path& path) {
    const std::string name = path.filename().string();
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  });
  if (names.empty())
    throw File_error(options.signatures,
                     "holds no signature of the function " + options.functions.front());
  for (std::string& name : names)
    name.resize(name.size() - end.size());
  const Collection collection = read_collection(options, names);
  const Signatures signatures = signatures_of(options.argument, options.functions);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < collection.names.size(); ++i)
    order.emplace_back(distance(options.distance, signatures, collection.signatures[i]), i);
  std::sort(order.begin(), order.end());
  order.resize((std::min)(order.size(), static_cast<std::size_t>(options.nearest)));
  for (const auto& entry : order)
    std::cout << entry.first << ' ' << collection.names[entry.second] << '\n';
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char* argv[])
{
  int status = EXIT_FAILURE;
  try {
    const Processes processes;
    try {
      Retrieval_options options;
      if (!parse_options(argc, argv, options))
        return EXIT_SUCCESS;
      if (options.command == "index")
        status = index(options, processes);
      else if (processes.is_first())
        status = query(options);
      else
        status = EXIT_SUCCESS;
    } catch (const std::exception& error) {
      std::cerr << "retrieval: " << error.what() << '\n';
      processes.abandon();
      return EXIT_FAILURE;
    }
  } catch (const std::exception& error) {
    std::cerr << "retrieval: " << error.what() << '\n';
  }
  std::cout.flush();
  return std::cout ? status : EXIT_FAILURE;
}
