#!/usr/bin/env bash
# build_packages.sh OUT [BUILD]: builds the Debian packages from this checkout and puts them into the folder OUT. BUILD:
# where to build; build/packages otherwise. Same sources, same bytes, wherever and whenever.
set -eu
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# -ge 1 ] || {
  sed -n '2,3p' "$0" >&2
  exit 2
}
mkdir -p "$1"
out=$(cd "$1" && pwd)
build=${2:-$source/build/packages}
mkdir -p "$build"
build=$(cd "$build" && pwd)
log="$build/packages.log"
# The date of the changelog, not of the build.
SOURCE_DATE_EPOCH=$(date -d "$(sed -n 's/^ -- .*>  //p' "$source/cli/packaging/changelog.in")" +%s)
export SOURCE_DATE_EPOCH
umask 022
cd "$source"
cmake --preset release -B "$build" -DCMAKE_INSTALL_PREFIX=/usr -DGOUGE_BUILD_TESTS=OFF \
  -DGOUGE_PYTHON=ON -DGOUGE_MPI=OFF -DPython_EXECUTABLE=/usr/bin/python3 >"$log" 2>&1 ||
  { cat "$log" >&2 && exit 1; }
cmake --build "$build" -j "${JOBS:-$(nproc)}" >"$log" 2>&1 || { tail -n 40 "$log" >&2 && exit 1; }
rm -rf "$build"/*.deb "$build/_CPack_Packages"
(cd "$build" && cpack -G DEB) >"$log" 2>&1 || { cat "$log" >&2 && exit 1; }
mv "$build"/*.deb "$out"
ls -l "$out"
