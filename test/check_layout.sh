#!/usr/bin/env bash
# Checks the layout of the headers and of the tests: no room of internal/ includes a later one, or a
# user header that may include it; no two headers have the same name; a header with a capital holds a
# class of its name; no file of the tests is longer than 700 lines. Shows who includes whom with the
# number of includes, and what fails; the last line is "N passed, N failed".
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
package=$root/include/CGAL/Surface_mesh_Reeb_graph

passed=0
failed=0

# expect_none NAME LINES: there must be none
expect_none()
{
  if [ -z "$2" ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED $1:"
    echo "$2"
  fi
}

# Which rooms a room may include, itself apart.
declare -A earlier_rooms=(
  [util]=""
  [mesh]="util"
  [graph]="util mesh"
  [construction]="util mesh graph"
  [persistence]="util mesh graph"
  [simplification]="util mesh graph construction persistence"
  [skeleton]="util mesh graph construction"
  [comparison]="util mesh graph"
  [cholesky]="util"
  [spectral]="util mesh cholesky"
)

# User headers with nothing but types that every room may know; and those that belong to a room
# themselves: the default direct solver to cholesky/, the level sets to mesh/.
common_headers="Eigenpairs|Eigensolver_options|Level_set_components|Reeb_graph|Supernodal_Cholesky|Vertex_order|exceptions|parameters"

unknown=""
for folder in "$package"/internal/*/; do
  room=$(basename "$folder")
  if [ -z "${earlier_rooms[$room]+set}" ]; then
    unknown+="$room"$'\n'
    continue
  fi
  allowed=${earlier_rooms[$room]// /|}
  echo "$room: $(sed -nE 's|^#include <CGAL/Surface_mesh_Reeb_graph/(internal/)?([^/>]*).*|\2|p' "$folder"*.h |
    grep -vx "$room" | sort | uniq -c | awk '{ printf "%s%s (%d)", separator, $2, $1; separator = ", " }')"
  expect_none "$room includes only what comes before" "$(
    grep -E '#include <CGAL/[Ss]urface_mesh_Reeb_graph' "$folder"*.h | sed "s|^$folder||" |
      grep -vE "<CGAL/Surface_mesh_Reeb_graph/(internal/($room${allowed:+|$allowed})/|($common_headers)\.h)" ||
      true
  )"
done
expect_none "rooms that nobody knows" "$unknown"

expect_none "headers of the same name" "$(
  find "$root/include" -name '*.h' -printf '%f\n' | tr '[:upper:]' '[:lower:]' | sort | uniq -d |
    grep -vx 'surface_mesh_reeb_graph\.h' || true
)"

expect_none "headers with a capital, and no class of that name" "$(
  for header in "$package"/*.h "$package"/internal/*/*.h; do
    name=$(basename "$header" .h)
    if [[ "$name" == [A-Z]* ]] &&
      ! grep -qE "^((class|struct|enum|enum class) $name\b|using $name =)" "$header"; then
      echo "${header#"$root"/}"
    fi
  done
)"

expect_none "test files of more than 700 lines" "$(
  find "$root/test" -name '*.cpp' -o -name '*.h' | while read -r file; do
    lines=$(wc -l < "$file")
    if [ "$lines" -gt 700 ]; then
      echo "${file#"$root"/}: $lines lines"
    fi
  done
)"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
