#!/usr/bin/env bash
# What the headers cost a compiler, beside comparable ones of CGAL: processor seconds and peak memory,
# the least of several runs in turn.
#
#   benchmark/compile_time.sh [RUNS [COMPILER [FLAG]...]]     3 runs of g++ -O2 -DNDEBUG by default
set -euo pipefail

# shellcheck source=examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../examples/common.sh"

runs=${1:-3}
compiler=${2:-g++}
flags=("${@:3}")
if [ "${#flags[@]}" -eq 0 ]; then
  flags=(-O2 -DNDEBUG)
fi

start_log "$root/build/compile_time.log"
install_missing g++ time libcgal-dev libeigen3-dev libboost-dev libboost-graph-dev

peers=$root/benchmark/Surface_mesh_Reeb_graph/compile_time
names=("commute_time_Reeb_graph" "Mean_curvature_flow_skeletonization" "compute_Reeb_graph" "Heat_method_3")
sources=("$root/examples/Surface_mesh_Reeb_graph/commute_time_Reeb_graph.cpp"
  "$peers/mean_curvature_flow_skeleton.cpp"
  "$peers/height_Reeb_graph.cpp"
  "$peers/heat_method.cpp")

# compile SOURCE: processor seconds and kilobytes
compile()
{
  local figures
  figures=$(mktemp)
  /usr/bin/time -f '%U %S %M' -o "$figures" "$compiler" -std=c++17 "${flags[@]}" -I"$root/include" \
    -I/usr/include/eigen3 -DCGAL_EIGEN3_ENABLED -frounding-math -c "$1" -o /dev/null
  awk '{ print $1 + $2, $3 }' "$figures"
  rm "$figures"
}

seconds=()
kilobytes=()
for ((run = 0; run < runs; ++run)); do
  for i in "${!sources[@]}"; do
    read -r s k < <(compile "${sources[i]}")
    seconds[i]=$(awk -v a="$s" -v b="${seconds[i]:-1e9}" 'BEGIN { print (a < b ? a : b) }')
    kilobytes[i]=$k
  done
done

echo "$compiler -std=c++17 ${flags[*]}, least of $runs runs"
echo
echo "| program | seconds | memory [MB] | beside CGAL's |"
echo "|---|--:|--:|--:|"
for i in "${!sources[@]}"; do
  awk -v name="${names[i]}" -v s="${seconds[i]}" -v k="${kilobytes[i]}" \
    -v peer="$([ "$((i % 2))" -eq 0 ] && echo "${seconds[i + 1]}")" \
    'BEGIN { printf "| %s | %.1f | %d | %s |\n", name, s, k / 1024, peer == "" ? "" : sprintf("%.2f", s / peer) }'
done
