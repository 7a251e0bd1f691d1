# shellcheck shell=bash
# Sourced by quickstart.sh and tests/run.sh (bash). Makes sure the packages are there and the release build
# folder is configured. MORE_PACKAGES are required too, OPTIONAL_PACKAGES are only tried. Sets ROOT and BUILD; logs go to
# $ROOT/build. Does nothing twice.

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
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf '%s ' "$package"
  done
}

# as_root COMMAND...: as root, or by sudo.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}

install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this script installs with apt-get (Debian 12); elsewhere install these yourself and build with CMake: $PACKAGES"
  fi
  local missing
  # The lists are meant to be split into words.
  # shellcheck disable=SC2086
  missing=$(missing_packages $PACKAGES)
  [ -z "$missing" ] && return
  [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null ||
    fail "packages are missing and neither root nor sudo is there to install them; as root run: apt-get install $missing"
  echo "Installing: $missing"
  quietly apt_update as_root env DEBIAN_FRONTEND=noninteractive apt-get update
  # shellcheck disable=SC2086
  quietly apt_install apt_install $missing
}

# Without these some tests are skipped; nothing fails.
install_optional() {
  local missing
  # shellcheck disable=SC2086
  missing=$(missing_packages ${OPTIONAL_PACKAGES:-})
  [ -z "$missing" ] && return
  echo "Installing: $missing"
  # shellcheck disable=SC2086
  { as_root apt-get update && apt_install $missing; } >"$ROOT/build/apt_optional.log" 2>&1 </dev/null ||
    echo "Not installed, so their tests are skipped: $missing"
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
install_optional
cd "$ROOT" || fail "cannot enter $ROOT"
configure
