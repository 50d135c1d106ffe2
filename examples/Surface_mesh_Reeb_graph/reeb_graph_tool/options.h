#ifndef REEB_GRAPH_TOOL_OPTIONS_H
#define REEB_GRAPH_TOOL_OPTIONS_H

#include "types.h"

#include "../mesh_input/read_polygon_soup.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

inline std::array<double, 3> parse_axis(const std::string& text)
{
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  std::array<double, 3> axis;
  char comma_1 = 0, comma_2 = 0, rest = 0;
  if (!(in >> axis[0] >> comma_1 >> axis[1] >> comma_2 >> axis[2]) || comma_1 != ',' ||
      comma_2 != ',' || in >> rest)
    throw Usage_error("--axis: '" + text + "' is not of the form x,y,z");
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (length == 0 || !std::isfinite(length))
    throw Usage_error("--axis: '" + text + "' has no finite direction");
  return axis;
}

// A list of numbers of vertices, separated by commas.
inline std::vector<std::size_t> parse_vertices(const std::string& option, const std::string& text)
{
  std::vector<std::size_t> result;
  std::istringstream in(text);
  for (std::string number; std::getline(in, number, ',');) {
    const bool is_number =
        !number.empty() && number.size() <= 9 &&
        std::all_of(number.begin(), number.end(), [](char c) { return '0' <= c && c <= '9'; });
    if (!is_number)
      throw Usage_error(option + ": '" + number + "' is not the number of a vertex");
    result.push_back(std::stoul(number));
  }
  if (result.empty() || text.back() == ',')
    throw Usage_error(option + ": '" + text + "' is not of the form i,j,...");
  return result;
}

// The functions, and which options each one heeds.
struct Function_options
{
  std::string function;
  std::vector<std::string> options;
};

inline const std::vector<Function_options>& function_options()
{
  static const std::vector<Function_options> table = {
      {"commute_time",
       {"eigenpairs", "small-time", "large-time", "features", "residual-tolerance"}},
      {"height", {"axis"}},
      {"barycentre", {}},
      {"geodesic", {"source"}},
      {"integral_geodesic", {}},
      {"tierny", {"features"}},
      {"curvature", {"features"}},
      {"auto_diffusion", {"time", "eigenpairs", "residual-tolerance"}},
      {"harmonic", {"minima", "maxima"}},
      {"eigenfunction", {"index", "residual-tolerance"}},
      {"heat_kernel_signature", {"time", "eigenpairs", "residual-tolerance"}},
      {"wave_kernel_signature", {"index", "eigenpairs", "residual-tolerance"}},
      {"diffusion", {"source", "time", "eigenpairs", "residual-tolerance"}},
      {"commute_time_distance", {"source", "eigenpairs", "residual-tolerance"}},
      {"biharmonic", {"source", "eigenpairs", "residual-tolerance"}},
      {"shape_diameter", {}},
  };
  return table;
}

// "a", "a and b", "a, b and c"
inline std::string enumeration(const std::vector<std::string>& names)
{
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i)
    result += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return result;
}

inline std::vector<std::string> function_names()
{
  std::vector<std::string> names;
  for (const Function_options& entry : function_options())
    names.push_back(entry.function);
  return names;
}

inline bool heeds(const Function_options& entry, const std::string& option)
{
  return std::find(entry.options.begin(), entry.options.end(), option) != entry.options.end();
}

// Options without effect are errors, and so are lists of vertices that are missing. `is_given` tells
// which options the user has written.
template <class Is_given>
void check_function_options(const Options& options, const Is_given& is_given)
{
  const std::string values =
      options.values_property.empty() ? "--values" : "--values-from-property";
  if (options.has_values() && is_given("function"))
    throw Usage_error("--function has no effect with " + values + ", which is a function");
  const std::vector<Function_options>& table = function_options();
  const auto chosen = std::find_if(table.begin(), table.end(), [&](const Function_options& entry) {
    return entry.function == options.function;
  });
  if (chosen == table.end())
    throw Usage_error("--function: there is no function '" + options.function + "'; there are " +
                      enumeration(function_names()));
  for (const std::string option : {"axis",
                                   "index",
                                   "time",
                                   "source",
                                   "minima",
                                   "maxima",
                                   "features",
                                   "eigenpairs",
                                   "residual-tolerance",
                                   "small-time",
                                   "large-time"})
  {
    if (!is_given(option) || (!options.has_values() && heeds(*chosen, option)))
      continue;
    std::vector<std::string> users;
    for (const Function_options& entry : table)
      if (heeds(entry, option))
        users.push_back(entry.function);
    throw Usage_error("--" + option + " has no effect with " +
                      (options.has_values() ? values : "--function " + options.function) +
                      "; it is for " + enumeration(users));
  }
  if (!options.features_file.empty())
    for (const std::string option : {"small-time", "large-time"})
      if (is_given(option))
        throw Usage_error("--" + option + " has no effect with --features");
  if (!options.has_values())
    for (const std::string option : {"source", "minima", "maxima"})
      if (heeds(*chosen, option) && !is_given(option))
        throw Usage_error("--function " + options.function + " needs --" + option +
                          ", the numbers of vertices");
  for (const std::size_t v : options.minima)
    if (std::find(options.maxima.begin(), options.maxima.end(), v) != options.maxima.end())
      throw Usage_error("vertex " + std::to_string(v) + " is among --minima and among --maxima");
}

// "gap" is the widest gap, "gap:K" the K-th widest one.
inline void parse_simplify(const std::string& text, Options& options)
{
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  char rest = 0;
  if (text == "gap") {
    options.gap = 1;
  } else if (text.rfind("gap:", 0) == 0) {
    in.ignore(4);
    if (!(in >> options.gap) || in >> rest || options.gap < 1)
      throw Usage_error("--simplify: the number in '" + text + "' must be at least 1");
  } else if (!(in >> options.simplify) || in >> rest || !(options.simplify >= 0)) {
    throw Usage_error("--simplify: '" + text +
                      "' is neither a number that is not negative nor gap or gap:K");
  }
}

// All that the functions of the library require of their arguments: a program without assertions
// would not hear of it from them.
inline void check_options(const Options& options)
{
  const auto require = [](bool condition, const std::string& message) {
    if (!condition)
      throw Usage_error(message);
  };
  const auto is_time = [](double t) { return t >= 0 && std::isfinite(t); };
  require(options.index >= 1, "--index must be at least 1");
  require(is_time(options.time), "--time must be finite and not negative");
  require(options.eigenpairs >= 1, "--eigenpairs must be at least 1");
  require(options.residual_tolerance > 0 && std::isfinite(options.residual_tolerance),
          "--residual-tolerance must be finite and positive");
  require(options.close_loops >= 0, "--close-loops must be a number that is not negative");
  require(options.leaves >= 0, "--leaves must not be negative");
  require(is_time(options.small_time), "--small-time must be finite and not negative");
  require(is_time(options.large_time), "--large-time must be finite and not negative");
}

// Options that say how other options are meant, or need a file of a certain kind.
template <class Is_given>
void check_other_options(const Options& options, const Is_given& is_given)
{
  const auto require = [](bool condition, const std::string& message) {
    if (!condition)
      throw Usage_error(message);
  };
  require(options.values_file.empty() || options.values_property.empty(),
          "--values and --values-from-property are two functions; only one can be used");
  require(options.values_property.empty() || format_has_properties(options.mesh_file),
          "--values-from-property has no effect with " + options.mesh_file +
              ", since files of this type have no properties of vertices");
  if (options.threshold_is_absolute)
    require((is_given("simplify") && options.gap == 0) || is_given("close-loops"),
            "--threshold-absolute has no effect without --simplify NUMBER or --close-loops");
  if (is_given("weld"))
    require(options.input.repair.weld_distance >= 0 &&
                std::isfinite(options.input.repair.weld_distance),
            "--weld must be finite and not negative");
}

// Returns false if the user has asked for help only.
inline bool parse_options(int argc, char* argv[], Options& options)
{
  namespace po = boost::program_options;

  std::string axis = "0,0,1", simplify = "0", report = "text", sources, minima, maxima;
  const std::string functions = enumeration(function_names());
  po::options_description visible("Options");
  visible.add_options()("help,h", "show this text")(
      "function",
      po::value(&options.function)->value_name("NAME")->default_value(options.function),
      functions.c_str())("axis",
                         po::value(&axis)->value_name("X,Y,Z")->default_value(axis),
                         "the direction of increasing height")(
      "index",
      po::value(&options.index)->value_name("K")->default_value(options.index),
      "the eigenfunction of the K-th smallest eigenvalue, from 1 on; for wave_kernel_signature, "
      "the "
      "eigenvalue that is its energy")(
      "time",
      po::value(&options.time)->value_name("T")->default_value(options.time, "1"),
      "the time of auto_diffusion, heat_kernel_signature and diffusion; the heat of the first "
      "eigenfunction falls to 1/e in time 1")(
      "source",
      po::value(&sources)->value_name("I,J,..."),
      "the vertices, numbered from 0, that geodesic, diffusion, commute_time_distance and "
      "biharmonic measure distances from")(
      "minima", po::value(&minima)->value_name("I,J,..."), "the minima of harmonic")(
      "maxima", po::value(&maxima)->value_name("I,J,..."), "the maxima of harmonic")(
      "features",
      po::value(&options.features_file)->value_name("FILE"),
      "feature points of your own for commute_time, tierny and curvature: numbers of vertices")(
      "values",
      po::value(&options.values_file)->value_name("FILE"),
      "a function of your own instead: one number per vertex in the order of the mesh file (of "
      "STL files: in the order in which the points are met first), as text, or as little-endian "
      "doubles if the name ends in .f64; for VTP and VTK files also the name of an array of their "
      "points")(
      "values-from-property",
      po::value(&options.values_property)->value_name("NAME"),
      "a function that the mesh file has: a property of its vertices (PLY), or an array of its "
      "points (VTP, VTK)")(
      "simplify",
      po::value(&simplify)->value_name("FRACTION|gap[:K]")->default_value(simplify),
      "cancel branches shorter than this fraction of the function's range, or those below the "
      "widest gap between their lengths (the K-th widest one)")(
      "close-loops",
      po::value(&options.close_loops)
          ->value_name("FRACTION")
          ->default_value(options.close_loops, "0"),
      "close loops lower than this fraction of the function's range")(
      "threshold-absolute",
      po::bool_switch(&options.threshold_is_absolute),
      "both thresholds are differences of values, not fractions of the range: one value far away "
      "from all others makes the range useless")(
      "leaves",
      po::value(&options.leaves)->value_name("N"),
      "cancel more branches until no more than N minima and maxima are left")(
      "unfold",
      po::bool_switch(&options.unfold),
      "make simple saddles of multiple ones: then there is a loop for every handle")(
      "eigenpairs",
      po::value(&options.eigenpairs)->value_name("N")->default_value(options.eigenpairs),
      "how many eigenfunctions commute_time and other functions use")(
      "residual-tolerance",
      po::value(&options.residual_tolerance)
          ->value_name("R")
          ->default_value(options.residual_tolerance, "1e-8"),
      "the largest relative residual of an eigenpair that is accepted")(
      "strict",
      po::bool_switch(&options.input.is_strict),
      "refuse a mesh that would have to be repaired, or has parts that would be passed over")(
      "split-nonmanifold-edges",
      po::bool_switch(&options.input.repair.split_nonmanifold_edges),
      "separate the faces at edges that have more than two")(
      "weld",
      po::value(&options.input.repair.weld_distance)->value_name("DISTANCE"),
      "make vertices that are no farther apart one")(
      "small-time",
      po::value(&options.small_time)->value_name("T")->default_value(options.small_time, "1.5"),
      "the diffusion time at which commute_time finds the feature points")(
      "large-time",
      po::value(&options.large_time)->value_name("T")->default_value(options.large_time, "20"),
      "the diffusion time at which commute_time finds the farthest pair")(
      "output",
      po::value(&options.output)->value_name("PREFIX"),
      "write PREFIX.values.txt, .graphml, .dot, .ply and .vtp, the skeleton (of up to 1000 arcs) "
      "as "
      ".polylines.txt and, if it has no loops, .swc, and, if this build of the tool has the page, "
      ".html")(
      "html",
      po::value(&options.html)->value_name("FILE"),
      "write a page to look at mesh, function and graph at all thresholds, for a web browser")(
      "diagram",
      po::value(&options.diagram)->value_name("FILE"),
      "write the persistence diagram of the graph before it is simplified, as text that GUDHI "
      "reads")("report",
               po::value(&report)->value_name("text|json")->default_value(report),
               "what to print");
  po::options_description all;
  all.add(visible).add_options()("mesh", po::value(&options.mesh_file));
  po::positional_options_description positions;
  positions.add("mesh", 1);

  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  po::variables_map given;
  po::store(
      po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run(),
      given);
  po::notify(given);
  if (given.count("help")) {
    std::cout
        << "Computes the Reeb graph of a triangle mesh.\n\n"
           "usage: reeb_graph [options] MESH\n\n"
           "MESH is a file in one of the formats "
        << readable_formats()
        << ".\nIts faces may be any polygons. What keeps it from being an oriented 2-manifold is "
           "repaired\nwhere that can be done without guessing, and said on standard error.\n\n"
        << visible
        << "\nExit status: 0 if all is done, 1 if a file cannot be read or written or its mesh "
           "has no\nReeb graph, 2 if the options are wrong, 3 if numbers or memory do not "
           "suffice,\nwhich may concern single components only: the others are computed then.\n";
    return false;
  }
  if (options.mesh_file.empty())
    throw Usage_error("no mesh is given; see --help");
  if (report != "text" && report != "json")
    throw Usage_error("--report: '" + report + "' is neither text nor json");
  options.json = report == "json";
  options.axis = parse_axis(axis);
  const auto is_given = [&](const std::string& option) {
    return given.count(option) > 0 && !given[option].defaulted();
  };
  if (is_given("source"))
    options.sources = parse_vertices("--source", sources);
  if (is_given("minima"))
    options.minima = parse_vertices("--minima", minima);
  if (is_given("maxima"))
    options.maxima = parse_vertices("--maxima", maxima);
  parse_simplify(simplify, options);
  check_options(options);
  check_other_options(options, is_given);
  check_function_options(options, is_given);
  return true;
}

#endif // REEB_GRAPH_TOOL_OPTIONS_H
