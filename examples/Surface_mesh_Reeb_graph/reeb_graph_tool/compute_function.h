#ifndef REEB_GRAPH_TOOL_COMPUTE_FUNCTION_H
#define REEB_GRAPH_TOOL_COMPUTE_FUNCTION_H

#include "progress.h"
#include "types.h"

// Computes the function that the options name, and writes its values, its feature points and the
// eigenvalues that it takes to the result. It is a translation unit of its own, since the functions
// take much longer to compile than the rest of the tool.
void compute_function(const Options& options, Result& result, Progress& progress);

#endif // REEB_GRAPH_TOOL_COMPUTE_FUNCTION_H
