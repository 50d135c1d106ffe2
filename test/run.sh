#!/usr/bin/env bash
# Runs all tests, from nothing: installs what is missing, builds everything, with assertions, and runs
# ctest. Prints what fails, and a last line "N passed, N failed".
#
#   test/run.sh [OPTION]...     options for CMake
set -euo pipefail

# shellcheck source=examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../examples/common.sh"

# Everything that a program needs to be built, in the form of a test that fails.
prepare()
{
  install_missing g++ cmake make libcgal-dev libeigen3-dev libspectra-dev libboost-dev \
    libboost-graph-dev libboost-program-options-dev libboost-test-dev nlohmann-json3-dev python3 &&
    find_cgal_data &&
    configure test -D SURFACE_MESH_REEB_GRAPH_BUILD_EXAMPLES=ON \
      -D SURFACE_MESH_REEB_GRAPH_BUILD_TESTS=ON "$@" &&
    progress "Building the tests (some minutes the first time) ..." &&
    build test
}

start_log "$root/build/test_run.log"
if ! prepare "$@"; then
  echo "0 passed, 1 failed"
  exit 1
fi
progress "Running the tests ..."
run_tests test
