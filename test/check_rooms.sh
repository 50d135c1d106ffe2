#!/usr/bin/env bash
# Checks that the rooms of internal/ form a chain without circles, that no two files have the same name, and
# that a header with one class bears its name. Prints which room includes which, with the number of includes;
# what breaks a rule is shown, and the exit status is 1.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../include/CGAL"
package=Surface_mesh_Reeb_graph

# What a room may know beside itself: rooms, and headers of the user that stand below it.
declare -A known=(
  [util]=""
  [mesh]="util exceptions.h"
  [graph]="util exceptions.h Reeb_graph.h"
  [construction]="util mesh graph exceptions.h"
  [persistence]="util graph"
  [simplification]="util mesh graph persistence exceptions.h Reeb_graph.h Vertex_order.h parameters.h"
  [cholesky]="util"
  [spectral]="util mesh cholesky exceptions.h Eigenpairs.h Supernodal_Cholesky.h"
)

status=0
for folder in "$package"/internal/*/; do
  room=$(basename "$folder")
  if [ -z "${known[$room]+x}" ]; then
    echo "unknown room: $room"
    status=1
    continue
  fi
  includes=$(sed -nE "s|^#include <CGAL/$package/(internal/)?([^/>]*).*|\2|p" "$folder"*.h |
    sort | uniq -c | awk -v room="$room" '$2 != room { print $2 " (" $1 ")" }')
  echo "$room: ${includes//$'\n'/, }"
  while read -r name _; do
    if [ -n "$name" ] && [[ " ${known[$room]} " != *" $name "* ]]; then
      echo "  $room must not know $name"
      status=1
    fi
  done <<< "$includes"
done

same=$(find "$package" -name '*.h' -printf '%f\n' | sort -f | uniq -di)
if [ -n "$same" ]; then
  echo "several files have the same name: $same"
  status=1
fi

# A capital begins the name of a header if and only if it holds a class of that name, or an alias, or (for the
# names of formats and of proper names) none at all.
for header in "$package"/*.h "$package"/internal/*/*.h; do
  name=$(basename "$header" .h)
  if [[ "$name" == [A-Z]* ]] &&
    ! grep -qE "^((class|struct) $name\b|using $name =)" "$header"; then
    echo "$header: no class $name"
    status=1
  fi
done
exit "$status"
