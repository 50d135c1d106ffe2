#!/usr/bin/env bash
# What is too long for every change: 50000 random cases in the tests of the Reeb graph, alone and
# under the sanitizers, and an hour of each fuzzer. Takes about five hours and prints what fails, and a last
# line "N passed, N failed". FUZZING_SECONDS and REEB_GRAPH_TEST_CASES in the environment change that.
set -euo pipefail

# shellcheck source=examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../examples/common.sh"

export REEB_GRAPH_TEST_CASES=${REEB_GRAPH_TEST_CASES:-50000}
fuzzing_seconds=${FUZZING_SECONDS:-3600}

passed=0
failed=0

# Runs a check and shows what it says if it fails.
check()
{
  local start=$SECONDS
  progress "$1 ..."
  if "${@:2}"; then
    passed=$((passed + 1))
    echo "ok      $1 ($((SECONDS - start)) s)"
  else
    failed=$((failed + 1))
    echo "FAILED  $1 ($((SECONDS - start)) s)"
  fi
}

# random_tests PRESET TESTS [BUILD_OPTION]...: those whose names match; the seeds that fail are in the
# output.
random_tests()
{
  configure "$1" && build "$1" "${@:3}" && run_tests "$1" -R "^test_($2)\$" --timeout 36000
}

# All programs, which .ci/run does not build; each with a few random cases.
all_tests_with_sanitizers()
(
  export REEB_GRAPH_TEST_CASES=300
  configure sanitize && build sanitize && run_tests sanitize --timeout 36000
)

# fuzz PROGRAM [OPTION]...: what the fuzzer finds interesting is kept, and the next night goes on from there.
fuzz()
(
  local folder=$root/build/fuzzing/$1
  mkdir -p "$folder/corpus" "$folder/failures"
  # In parallel it writes files to the current folder.
  configure clang && build clang --target "$1" && cd "$folder" &&
    quietly "$root/build/clang/test/fuzz/$1" \
      -max_total_time="$fuzzing_seconds" -len_control=0 -timeout=60 \
      -jobs="$(number_of_jobs)" -workers="$(number_of_jobs)" \
      -artifact_prefix="$folder/failures/" "${@:2}"
)

start_log "$root/build/nightly.log"
install_missing g++ clang libclang-rt-dev cmake jq make libcgal-dev libeigen3-dev libspectra-dev \
  libboost-dev libboost-graph-dev libboost-program-options-dev libboost-test-dev nlohmann-json3-dev

# The agreement with VTK is there where VTK is.
check "random tests" \
  random_tests test 'compute_Reeb_graph|cancel_branches|close_loops|simplify_Reeb_graph|persistence|vtk_agreement'
check "random tests (sanitizers)" \
  random_tests sanitize 'compute_Reeb_graph|cancel_branches|close_loops|simplify_Reeb_graph' \
  --target test_compute_Reeb_graph test_cancel_branches test_close_loops test_simplify_Reeb_graph
check "all tests (sanitizers)" all_tests_with_sanitizers
if [ -d "$root/../shared/data" ]; then
  check "data (sanitizers)" "$root/test/check_data.sh" "$root/../shared/data" \
    "$root/build/sanitize/examples/Surface_mesh_Reeb_graph/reeb_graph"
fi
check "fuzzing" fuzz fuzz_compute_Reeb_graph -max_len=400 corpus
for program in fuzz_mesh_readers fuzz_mesh_file_to_graph; do
  check "fuzzing of mesh files ($program)" fuzz "$program" -max_len=2000 \
    -dict="$root/test/fuzz/mesh_files.dict" corpus "$root/test/fuzz/mesh_files"
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
