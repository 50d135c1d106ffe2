#!/usr/bin/env bash
# Checks the tool on a folder of real meshes: pose families, closed meshes of known genus, bad input.
# The last line is "N passed, N failed"; what fails is shown.
#
#   test/check_data.sh FOLDER TOOL     needs jq
set -euo pipefail

if [ "$#" -ne 2 ]; then
  echo "usage: ${0##*/} FOLDER TOOL" >&2
  exit 2
fi
data=$1
tool=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

passed=0
failed=0

# expect NAME CONDITION...
expect()
{
  if "${@:2}"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED $1"
  fi
}

# counts MESH [OPTION]...: minima/maxima/loops
counts()
{
  "$tool" "$@" --report json | jq -r '"\(.minima)/\(.maxima)/\(.loops)"'
}

expect_counts()
{
  local expected=$1 found
  found=$(counts "${@:2}") || found="an error"
  expect "${*:2}: $found instead of $expected" [ "$found" = "$expected" ]
}

# ---- pose families: the same graph in every pose --------------------------------------------------

for mesh in "$data"/camel_gallop/*.off; do
  expect_counts 1/9/0 "$mesh" --simplify 0.03
  expect_counts 1/6/0 "$mesh" --simplify 0.1
done
for mesh in "$data"/wolf_tosca/*.off; do
  expect_counts 1/9/0 "$mesh" --simplify 0.03
  expect_counts 1/9/0 "$mesh" --simplify 0.1
done
same=0
for mesh in "$data"/cat_sumner/*.off; do
  expect_counts 1/8/0 "$mesh" --simplify 0.03
  if [ "$(counts "$mesh" --simplify 0.1)" = 1/6/0 ]; then
    same=$((same + 1))
  fi
done
expect "cats with 1/6/0 at 0.1: $same instead of 6 or 7" [ "$same" -ge 6 ]
expect_counts 1/8/1 "$data/topology_derived/cat-01_handle1.off" --simplify 0.03

# ---- loops = genus on closed meshes ---------------------------------------------------------------

# expect_genus MESH GENUS: also for the height along an axis that no face is orthogonal to
expect_genus()
{
  local options found
  for options in "--function commute_time" "--function height --axis 0.31,0.77,0.52"; do
    # shellcheck disable=SC2086  # several words
    found=$("$tool" "$1" $options --report json | jq .loops) || found="an error"
    expect "$1 $options: $found loops instead of $2" [ "$found" = "$2" ]
  done
}

expect_genus "$data/genus/eight.off" 2
expect_genus "$data/genus/elephant.off" 3
expect_genus "$data/genus/anchor_dense.off" 4
expect_genus "$data/genus/turbine.off" 11
expect_genus "$data/genus/knot1.off" 1
expect_genus "$data/genus/rotor_small.off" 1
expect_genus "$data/genus/pipe.off" 1
expect_genus "$data/genus/3holes.off" 3
expect_genus "$data/genus/fertility.off" 4
expect_genus "$data/genus/skull_low.off" 2
expect_genus "$data/genus/torus.off" 1

# ---- any input gives a graph, or one line of error ------------------------------------------------

has_report()
{
  jq -e '.nodes >= 0' "$work/out" > /dev/null
}

# expect_clean NAME OPTION...
expect_clean()
{
  local name=$1 status=0
  timeout 300 "$tool" "${@:2}" --output "$work/result" --report json \
    > "$work/out" 2> "$work/error" || status=$?
  if [ "$status" -eq 0 ]; then
    expect "$name: no report" has_report
    expect "$name: a number of the function is not finite" \
      [ "$(grep -ciE 'nan|inf' "$work/result.values.txt")" -eq 0 ]
  else
    # 1: the file is bad, 3: numbers do not suffice; lines on repairs may stand before the error
    expect "$name: status $status" [ $((status == 1 || status == 3)) -eq 1 ]
    expect "$name: a line that does not name the file" [ "$(grep -cvF "reeb_graph: $name" "$work/error")" -eq 0 ]
    expect "$name: no error" [ "$(wc -l < "$work/error")" -ge 1 ]
  fi
}

# Not shrec07/: 198 models take too long here.
for mesh in "$data"/*/*.off "$data"/readers/*.{obj,ply,stl}; do
  case $mesh in
    */shrec07/*) ;;
    *) expect_clean "$mesh" "$mesh" --simplify 0.05 ;;
  esac
done

mesh=$data/genus/eight.off
"$tool" "$mesh" --output "$work/good" > /dev/null
values=$work/good.values.txt
expect_clean "$work/none.off" "$work/none.off"
expect_clean "$work/none.txt" "$mesh" --values "$work/none.txt"
: > "$work/empty.txt"
expect_clean "$work/empty.txt" "$mesh" --values "$work/empty.txt"
head -n 100 "$values" > "$work/truncated.txt"
expect_clean "$work/truncated.txt" "$mesh" --values "$work/truncated.txt"
sed '17s/.*/nan/' "$values" > "$work/nan.txt"
expect_clean "$work/nan.txt" "$mesh" --values "$work/nan.txt"
sed '17s/.*/seventeen/' "$values" > "$work/word.txt"
expect_clean "$work/word.txt" "$mesh" --values "$work/word.txt"
head -c 1001 "$values" > "$work/truncated.f64"
expect_clean "$work/truncated.f64" "$mesh" --values "$work/truncated.f64"
expect "the function read back gives the same graph" \
  [ "$(counts "$mesh")" = "$(counts "$mesh" --values "$values")" ]

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
