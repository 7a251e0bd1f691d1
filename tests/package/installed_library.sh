#!/usr/bin/env bash
# installed_library.sh BUILD VERSION: installs the library of a build folder into a folder of its own, moves that, and
# uses it as others do: every header alone, the examples by find_package and by pkg-config, the symbols it exports.
# Exit status 77, skipped, where pkg-config is absent.
set -eu
build=$1 version=$2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "failed: $*" >&2
  exit 1
}

for component in library development; do
  cmake --install "$build" --component "$component" --prefix "$work/first" >"$work/install.log" || fail "cmake --install"
done
mv "$work/first" "$work/prefix" # nothing in it may know where it was made
prefix="$work/prefix"
library=$(find "$prefix" -name 'libgougecheck.so' -print -quit)
[ -n "$library" ] || fail "no libgougecheck.so is installed"
folder=$(dirname "$library")

# The Python module finds the library by itself.
if compgen -G "$build/cli/python/gougecheck/_core*.so" >/dev/null; then
  cmake --install "$build" --component python --prefix "$prefix" >>"$work/install.log" || fail "cmake --install"
  module=$(find "$prefix" -path '*/gougecheck/__init__.py' -print -quit)
  PYTHONPATH=$(dirname "$(dirname "$module")") /usr/bin/python3 -c "
import gougecheck
assert gougecheck.Tool.ball(diameter=10, length=30).height == 30" || fail "import gougecheck"
fi
export LD_LIBRARY_PATH="$folder"

grep -rl "$source" "$prefix" && fail "the files above name the source folder"
soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\].*/\1/p')
[ "$soname" = "libgougecheck.so.${version%.*}" ] || fail "SONAME is $soname"
foreign=$(nm -D --defined-only "$library" | awk '{ print $3 }' |
  grep -Ev '^(_ZNK?10gougecheck|_ZT[ISV]N10gougecheck|GOUGECHECK_)' || true)
[ -z "$foreign" ] || fail "exports more than namespace gougecheck: $foreign"

headers=$(cd "$prefix/include" && find gougecheck -name '*.h' | sort)
[ "$(echo "$headers" | wc -l)" -ge 9 ] || fail "headers are missing: $headers"
for header in $headers; do
  printf '#include <%s>\n#include <%s>\nint main() {}\n' "$header" "$header" >"$work/header.cpp"
  g++ -std=c++20 -Wall -Wextra -Wpedantic -Werror -I "$prefix/include" -fsyntax-only "$work/header.cpp" ||
    fail "$header alone"
done

# The examples: expected output and exit status of each.
run() {
  local status=0
  "$@" >"$work/out.txt" 2>&1 || status=$?
  echo "$status"
}
check_examples() {
  [ "$(run "$1/check_path")" = 1 ] && grep -q '^move 4: gouge of 0.250 mm at ' "$work/out.txt" &&
    grep -q '^4 of 5 moves are clean$' "$work/out.txt" || fail "check_path: $(cat "$work/out.txt")"
  [ "$(run "$1/haptic_loop")" = 0 ] && grep -q ' poses a second' "$work/out.txt" ||
    fail "haptic_loop: $(cat "$work/out.txt")"
  [ "$(run "$1/two_bodies")" = 1 ] && grep -q '^penetrating: ' "$work/out.txt" &&
    grep -q '^free after a shift of B by ' "$work/out.txt" || fail "two_bodies: $(cat "$work/out.txt")"
}
cmake -G Ninja -S "$source/samples/library" -B "$work/examples" -DCMAKE_PREFIX_PATH="$prefix" >"$work/cmake.log" 2>&1 ||
  fail "find_package: $(cat "$work/cmake.log")"
cmake --build "$work/examples" >"$work/build.log" 2>&1 || fail "the examples: $(cat "$work/build.log")"
check_examples "$work/examples"
for example in "$source"/samples/library/*.cpp; do
  [ "$(wc -l <"$example")" -le 60 ] || fail "$example has more than 60 lines"
done

if ! command -v pkg-config >/dev/null; then
  echo "skipped: pkg-config is not installed, so the library was used by find_package alone"
  exit 77
fi
export PKG_CONFIG_PATH="$folder/pkgconfig"
[ "$(pkg-config --modversion gougecheck)" = "$version" ] || fail "pkg-config has another version"
mkdir "$work/by_pkg_config"
for example in check_path haptic_loop two_bodies; do
  # shellcheck disable=SC2046
  g++ "$source/samples/library/$example.cpp" -o "$work/by_pkg_config/$example" \
    $(pkg-config --cflags --libs gougecheck) || fail "pkg-config: $example"
done
check_examples "$work/by_pkg_config"
echo "installed, moved and used by find_package and pkg-config"
