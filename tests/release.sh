#!/usr/bin/env bash
# release.sh [STEP...]: makes the checks that a release needs, on the commit that is checked out. The steps are
#   laws    the laws at length        fuzz    every fuzz target for ten minutes of processor time
#   asan    the suite under the address and undefined-behaviour sanitizers
#   tsan    the suite under the thread sanitizer
#   bare    both commands of the README in a system where nothing is installed (root, network, debootstrap)
# Without arguments all are made; on two cores they take about six hours. Logs and times lie in build/release_checks,
# by commit. What has passed on this commit is not made again, so an interrupted run continues. The sanitizers run the
# suite in 32 slices, each with every 32nd test. The status is 1 if a check fails.
set -u
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$ROOT" || exit 2
[ -z "$(git status --porcelain)" ] || { echo "the checkout has changes; commit them first" >&2; exit 2; }
LOGS=$ROOT/build/release_checks/$(git rev-parse --short HEAD)
mkdir -p "$LOGS"
export ROOT LOGS

# make_check NAME COMMAND: runs a command unless it has passed before, and keeps its output and its times.
make_check() {
  local name=$1 command=$2
  [ ! -f "$LOGS/$name.passed" ] || return 0
  TIMEFORMAT='%R s, %U s user'
  if { time bash -c "$command" >"$LOGS/$name.log" 2>&1 </dev/null; } 2>"$LOGS/$name.time"; then
    mv "$LOGS/$name.time" "$LOGS/$name.passed"
    echo "passed: $name ($(cat "$LOGS/$name.passed"))"
  else
    echo "failed: $name; see $LOGS/$name.log"
    return 1
  fi
}
export -f make_check

# Makes the checks that standard input lists as lines "NAME COMMAND", one on each core.
make_each() {
  xargs -d '\n' -P "$(nproc)" -I {} bash -c 'line=$0; make_check "${line%% *}" "${line#* }"' {} || status=1
}

# build PRESET TARGET: builds a target, and keeps what the build prints.
build() {
  { cmake --preset "$1" && ninja -k 0 -C "build/$1" "$2"; } >"$LOGS/build_$1.log" 2>&1 ||
    { echo "$2 is not built; see $LOGS/build_$1.log"; return 1; }
}

list_laws() {
  local laws="build/release/tests/laws/laws_tests --gtest_brief=1" part
  for part in GreatCircle RotaryHead Law_vector Law_axis Law_documented Law_any Law_joint Law_independent KeptObstacle; do
    echo "moves_$part GOUGE_RANDOM_MOVES=112000 $laws --gtest_filter='*/RandomMoves.*/$part'"
  done
  for part in 0 1 2 3; do
    echo "corrections_$part GOUGE_FIRST_CORRECTION=$((1250 * part)) GOUGE_CORRECTIONS=1250 $laws" \
      "--gtest_filter='CorrectionLaws.HoldFor*Programs*:CorrectionLaws.HoldUnder*'"
    echo "tilts_$part GOUGE_FIRST_TILT=$((250 * part)) GOUGE_TILTS=250 $laws --gtest_filter='TiltLaw.*'"
  done
  echo "further GOUGE_FURTHER=20000 $laws --gtest_filter='FurtherLaw.*'"
  echo "overcuts_GreatCircle GOUGE_OVERCUTS=25000 $laws --gtest_filter='OvercutLaw.HoldsAgainst*'"
  echo "overcuts_joints GOUGE_OVERCUTS=25000 $laws --gtest_filter='OvercutLaw.HoldsWhere*'"
}

list_targets() {
  local target
  for target in $(cd build/fuzz/tests/fuzz && ls -d fuzz_* | grep -v '\.'); do
    echo "$target tests/fuzz/run.sh 600 $target"
  done
}

list_slices() {
  local slice
  for slice in $(seq 32); do echo "$1_$slice ctest --preset $1 -I $slice,,32"; done
}

status=0
[ $# -gt 0 ] || set -- laws fuzz asan tsan bare
for step in "$@"; do
  case $step in
    laws)
      build release laws_tests || exit 2
      make_each < <(list_laws)
      ;;
    fuzz)
      build fuzz fuzz || exit 2
      make_each < <(list_targets)
      ;;
    asan | tsan)
      build "$step" all || exit 2
      make_each < <(list_slices "$step")
      ;;
    bare) make_check bare "tests/package/bare_machine.sh" || status=1 ;;
    *)
      echo "there is no step $step; see the head of this file" >&2
      exit 2
      ;;
  esac
done
exit $status
