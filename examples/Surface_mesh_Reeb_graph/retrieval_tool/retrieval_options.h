#ifndef RETRIEVAL_TOOL_RETRIEVAL_OPTIONS_H
#define RETRIEVAL_TOOL_RETRIEVAL_OPTIONS_H

#include <boost/algorithm/string/split.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

struct Retrieval_options
{
  std::string command;                // index or query
  std::string argument;               // the folder or the mesh
  std::string signatures;             // the folder of the signatures
  std::vector<std::string> functions; // whose distances are added
  std::string distance = "shape";
  std::string distances; // a file; empty: it is not written
  std::string classes;   // a file; empty: nothing is evaluated
  bool table = false;
  int nearest = 10;
  int threads = static_cast<int>((std::max)(1U, std::thread::hardware_concurrency()));
};

inline void check_options(const Retrieval_options& options)
{
  const auto require = [](bool condition, const std::string& message) {
    if (!condition)
      throw std::runtime_error(message);
  };
  const auto is_one_of = [](const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  require(is_one_of(options.command, {"index", "query"}),
          "the command is 'index FOLDER' or 'query MESH'; --help shows all options");
  require(!options.argument.empty(),
          options.command == "index" ? "index: which folder?" : "query: which mesh?");
  require(options.command == "index" || !options.signatures.empty(),
          "query: --signatures says where the signatures are");
  for (const std::string& function : options.functions)
    require(is_one_of(function, {"commute_time", "height", "geodesic", "auto_diffusion"}),
            "--function: there is no function '" + function +
                "'; there are commute_time, height, geodesic and auto_diffusion");
  require(is_one_of(options.distance, {"shape", "graph", "spectrum", "persistence", "bottleneck"}),
          "--distance: there is no distance '" + options.distance +
              "'; there are shape, graph, spectrum, persistence and bottleneck");
#ifndef RETRIEVAL_WITH_HERA
  require(options.distance != "bottleneck",
          "--distance bottleneck: this program has been built without Hera");
#endif
  require(!options.table || !options.classes.empty(), "--table needs --classes");
  require(options.nearest >= 1, "--nearest must be at least 1");
  require(options.threads >= 1, "--threads must be at least 1");
}

// Returns false if the user has asked for help only.
inline bool parse_options(int argc, char* argv[], Retrieval_options& options)
{
  namespace po = boost::program_options;
  std::string functions = "commute_time,auto_diffusion";
  po::options_description visible("Options");
  visible.add_options()("help,h", "show this text")(
      "signatures",
      po::value(&options.signatures)->value_name("DIR"),
      "the folder of the signatures; for index, by default FOLDER/signatures")(
      "function",
      po::value(&functions)->value_name("NAME,...")->default_value(functions),
      "commute_time, height (along z), geodesic, auto_diffusion, or several of them, whose "
      "distances "
      "are added")(
      "distance",
      po::value(&options.distance)->value_name("NAME")->default_value(options.distance),
      "shape (all of the signature), graph (the Reeb graphs alone), spectrum (ShapeDNA), "
      "persistence "
      "(L1 of the diagrams) or bottleneck")(
      "nearest",
      po::value(&options.nearest)->value_name("K")->default_value(options.nearest),
      "query: how many shapes are shown")(
      "distances",
      po::value(&options.distances)->value_name("FILE"),
      "index: write the distances of all pairs: a line with the file names, then a line for every "
      "shape")("classes",
               po::value(&options.classes)->value_name("FILE"),
               "index: evaluate; a line for every mesh with the file name and its class")(
      "table",
      po::bool_switch(&options.table),
      "index: evaluate all distances, and print means only, with the time per pair")(
      "threads",
      po::value(&options.threads)->value_name("N")->default_value(options.threads),
      "how many signatures are computed at the same time");

  po::options_description all;
  all.add(visible).add_options()("command", po::value(&options.command))(
      "argument", po::value(&options.argument));
  po::positional_options_description positional;
  positional.add("command", 1).add("argument", 1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), values);
  if (values.count("help") != 0) {
    std::cout
        << "Finds similar shapes by their Reeb graphs.\n\n"
           "  retrieval index FOLDER [OPTION]...   signatures of all meshes that have none yet\n"
           "  retrieval query MESH --signatures DIR [OPTION]...   the most similar ones\n\n"
           "Meshes are OFF, OBJ, PLY or STL files. A signature is a text file named after the\n"
           "mesh and a function; a query reads signatures only. Under mpiexec the shapes and\n"
           "the rows of distances are dealt out to the processes, if built with Boost.MPI.\n\n"
        << visible;
    return false;
  }
  po::notify(values);
  boost::algorithm::split(options.functions, functions, [](char c) { return c == ','; });
  check_options(options);
  if (options.signatures.empty())
    options.signatures = options.argument + "/signatures";
  return true;
}

#endif // RETRIEVAL_TOOL_RETRIEVAL_OPTIONS_H
