# shellcheck shell=bash
# Functions of examples/run.sh, test/run.sh and .ci/run, which source this file. They set `log`, the
# file that receives the output of everything that runs quietly.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

requirements="a C++17 compiler, CMake >= 3.22, make, CGAL >= 5.5, Eigen >= 3.4, \
Boost >= 1.74 (with Program_options) and nlohmann-json >= 3; for the tests Boost.Test and Spectra >= 1.0"

start_log()
{
  log=$1
  mkdir -p "$(dirname "$log")"
  : > "$log"
}

# Says what takes its time, to people only.
progress()
{
  if [ -t 2 ]; then
    echo "$*" >&2
  fi
}

# Runs a command; its output is shown only if it fails.
quietly()
{
  local status=0 size
  size=$(wc -c < "$log")
  echo "+ $*" >> "$log"
  "$@" >> "$log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    tail -c "+$((size + 1))" "$log" | tail -n 200 >&2
    echo "(all output: $log)" >&2
  fi
  return "$status"
}

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    echo "There is no sudo here to run as root: $*"
    return 1
  fi
}

has_apt()
{
  command -v apt-get > /dev/null && command -v dpkg-query > /dev/null
}

is_installed()
{
  # A package named after its program is not missed if the program comes from somewhere else.
  command -v "$1" > /dev/null ||
    dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2> /dev/null | grep -q '^.i'
}

# Installs the Debian packages among the given ones that are missing. On systems without apt, CMake
# finds out what is missing.
install_missing()
{
  local package missing=()
  if ! has_apt; then
    if ! command -v cmake > /dev/null; then
      echo "Please install $requirements." >&2
      return 1
    fi
    return 0
  fi
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if [ "${#missing[@]}" -gt 0 ]; then
    progress "Installing ${missing[*]} ..."
    if ! { quietly as_root apt-get -qq -o DPkg::Lock::Timeout=300 update &&
      quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y \
        -o DPkg::Lock::Timeout=300 install --no-install-recommends "${missing[@]}"; }; then
      echo "Please install: ${missing[*]}" >&2
      return 1
    fi
  fi
}

# Sets CGAL_DATA_DIR to the folder of CGAL's example data, unpacked from Debian's package
# libcgal-demo if the variable is not set.
find_cgal_data()
{
  if [ -z "${CGAL_DATA_DIR:-}" ]; then
    if [ ! -d "$root/build/cgal_data" ]; then
      progress "Unpacking the example data of CGAL ..."
      quietly unpack_cgal_data "$root/build/cgal_data" || return
    fi
    export CGAL_DATA_DIR=$root/build/cgal_data
  fi
}

unpack_cgal_data()
{
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz part=$1.part
  rm -rf "$part"
  mkdir -p "$part"
  if [ -r "$archive" ]; then
    tar -xzf "$archive" -C "$part" || return
  elif has_apt; then
    # The archive is documentation, which many containers leave out when they install a package: take
    # it from the package itself, without installing that.
    (
      cd "$part" || exit
      apt-get -qq download libcgal-demo ||
        { as_root apt-get -qq -o DPkg::Lock::Timeout=300 update &&
          apt-get -qq download libcgal-demo; } || exit
      dpkg-deb --fsys-tarfile libcgal-demo_*.deb | tar -xO ".$archive" | tar -xz
    ) || return
  else
    echo "Please set the environment variable CGAL_DATA_DIR to the folder Data/data of CGAL's sources."
    return 1
  fi
  mv "$part/data" "$1" && rm -rf "$part"
}

# configure PRESET [OPTION]...
configure()
{
  if ! quietly cmake -S "$root" --preset "$@"; then
    echo "This needs $requirements." >&2
    return 1
  fi
}

# build FOLDER [OPTION]...
build()
{
  quietly cmake --build "$root/build/$1" --parallel "$(number_of_jobs)" "${@:2}"
}

# One for every processor that has 2 GB of memory: CGAL and Eigen ask much of a compiler.
number_of_jobs()
{
  local jobs gigabytes
  jobs=$(getconf _NPROCESSORS_ONLN)
  if [ -r /proc/meminfo ]; then
    gigabytes=$(awk '/^MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
    if [ "$((gigabytes / 2))" -lt "$jobs" ]; then
      jobs=$((gigabytes / 2))
    fi
  fi
  echo "$((jobs > 0 ? jobs : 1))"
}

# run_tests FOLDER [OPTION]...: prints what failed, and a last line "N passed, N failed".
run_tests()
{
  local status=0 failed total
  # Some tests build something.
  CMAKE_BUILD_PARALLEL_LEVEL=$(number_of_jobs) quietly ctest --test-dir "$root/build/$1" \
    --parallel "$(number_of_jobs)" --output-on-failure --no-tests=error "${@:2}" || status=$?
  read -r failed total < <(sed -nE 's/^.* ([0-9]+) tests failed out of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1)
  echo "$((${total:-1} - ${failed:-1})) passed, ${failed:-1} failed"
  return "$status"
}
