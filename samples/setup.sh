# shellcheck shell=bash
# Sourced by quickstart.sh and tests/run.sh (bash). Makes sure the packages are there and the release build
# folder is configured. Sets ROOT and BUILD; logs go to $ROOT/build. Does nothing twice.

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
BUILD="$ROOT/build/release"
PACKAGES="g++ cmake ninja-build ccache libeigen3-dev libcgal-dev libopencv-imgproc-dev libpng-dev libfreetype-dev fonts-dejavu-core fonts-wqy-microhei libcli11-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev libzip-dev libssl-dev libsqlite3-dev zlib1g-dev libzstd-dev ${MORE_PACKAGES:-}"

fail() {
  echo "$0: $*" >&2
  exit 1
}

# Runs a command with its output in a log, which is shown only if the command fails.
quietly() {
  local log="$ROOT/build/$1.log"
  shift
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    fail "this failed: $* (the whole output is in $log)"
  fi
}

missing_packages() {
  local package
  for package in $PACKAGES; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf '%s ' "$package"
  done
}

install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this script installs with apt-get (Debian 12); elsewhere install these yourself and build with CMake: $PACKAGES"
  fi
  local missing as_root=""
  missing=$(missing_packages)
  [ -z "$missing" ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "packages are missing and neither root nor sudo is there to install them; as root run: apt-get install $missing"
    as_root="sudo"
  fi
  echo "Installing: $missing"
  quietly apt_update $as_root env DEBIAN_FRONTEND=noninteractive apt-get update
  # The list is meant to be split into words.
  # shellcheck disable=SC2086
  quietly apt_install $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
}

configure() {
  [ -f "$BUILD/build.ninja" ] && return
  echo "Configuring $BUILD"
  quietly configure cmake -S "$ROOT" --preset release
}

# build TARGET...: builds these targets, or everything when none is named.
build() {
  local target targets=()
  for target in "$@"; do targets+=(--target "$target"); done
  echo "Building ${*:-everything} (the first time takes some minutes)"
  quietly build cmake --build "$BUILD" "${targets[@]}"
}

mkdir -p "$ROOT/build" || fail "cannot write to $ROOT"
install_missing
cd "$ROOT" || fail "cannot enter $ROOT"
configure
