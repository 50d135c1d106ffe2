#!/usr/bin/env bash
# Computes the Reeb graph of a mesh, from nothing: installs what is missing, builds the command-line
# tool and runs it. The results go to the folder reeb_graph_output in the current folder.
#
#   examples/run.sh [MESH [OPTION]...]
#
# MESH is an OFF, OBJ, PLY, STL or VTK file; CGAL's camel if it is not given. The options are those of
# the tool, "--simplify 0.1" if none is given.
set -euo pipefail

# shellcheck source=examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [[ "${1:-}" == -* ]]; then
  echo "usage: ${0##*/} [MESH [OPTION]...]" >&2
  exit 2
fi
if [ "$#" -ge 1 ] && [ ! -r "$1" ]; then
  echo "${0##*/}: cannot read '$1'" >&2
  exit 1
fi

start_log "$root/build/examples_run.log"
install_missing g++ cmake make libcgal-dev libeigen3-dev libboost-dev \
  libboost-graph-dev libboost-program-options-dev nlohmann-json3-dev zlib1g-dev
# For the page (23 MB). The tool is built without it, too.
install_missing npm 2> /dev/null || true
options=(--simplify 0.1)
if [ "$#" -ge 1 ]; then
  mesh=$1
  if [ "$#" -ge 2 ]; then
    options=("${@:2}")
  fi
else
  find_cgal_data
  mesh=$CGAL_DATA_DIR/meshes/camel.off
fi

if [ -e "$root/build/release/CMakeCache.txt" ]; then
  configure release
else
  # The tests ask for more packages than the tool.
  configure release -D SURFACE_MESH_REEB_GRAPH_BUILD_TESTS=OFF
fi
progress "Building the tool (a minute or two the first time) ..."
build release --target reeb_graph

mkdir -p reeb_graph_output
name=${mesh##*/}
prefix=reeb_graph_output/${name%.*}
tool=$root/build/release/examples/Surface_mesh_Reeb_graph/reeb_graph
rm -f "$prefix.html" # of a tool that had the page
"$tool" "$mesh" --output "$prefix" "${options[@]}"

cat <<END

Files, and what opens them:
  $prefix.ply            the mesh, colored by the function    MeshLab, Blender
  $prefix.vtp            the mesh, its values and arcs        ParaView
  $prefix.polylines.txt  the skeleton                         CGAL Polyhedron demo
  $prefix.swc            the same, if there are no loops      navis, skeletor, neuTube
  $prefix.graphml        the graph                            Gephi, yEd
  $prefix.dot            the graph                            Graphviz: dot -Tsvg $prefix.dot > $prefix.svg
  $prefix.values.txt     the function, a value per vertex     the tool: --values $prefix.values.txt

The tool: $tool (--help shows its options)
END
if [ -e "$prefix.html" ]; then
  cat <<END

To see mesh, function and graph, open this page in a web browser:
  $(realpath "$prefix.html")
END
fi
