#!/usr/bin/env bash
# Measures the engine and its peers on the same generated work and prints the table of ratios. Run it on an idle
# machine, as root or with sudo at hand for missing packages.
#
#   run.sh [--quick] [--out FOLDER] [program...]
#
# --quick        one repetition and smaller samples: to see that everything works, not for figures
# --out FOLDER   where the JSON files and the table go (default build/bench/results)
# program...     only these: engine loading embree bullet fcl ode cgal
#
# GOUGE_BENCH_BUILD names a build folder that is configured already; GOUGE_BENCH_CACHE where generated work is
# kept; GOUGE_BENCH_SIZES (2400,20000,200000,2000000) and GOUGE_BENCH_PARTS (wavy,unseen) narrow the cases.
set -u
PEER_PACKAGES="libbenchmark-dev libembree-dev libbullet-dev libfcl-dev libode-dev libcgal-dev pkg-config"
TOP=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

is_quick=""
OUT="$TOP/build/bench/results"
programs=()
while [ $# -gt 0 ]; do
  case $1 in
    --quick) is_quick=1 ;;
    --out) OUT=${2:?--out needs a folder}; shift ;;
    --help) sed -n '2,14s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    -*) echo "$0: there is no option $1 (see --help)" >&2; exit 2 ;;
    *) programs+=("$1") ;;
  esac
  shift
done
[ ${#programs[@]} -gt 0 ] || programs=(engine loading embree bullet ode fcl cgal)

if [ -z "${GOUGE_BENCH_BUILD:-}" ]; then
  # shellcheck source=samples/setup.sh
  . "$TOP/samples/setup.sh"
  PACKAGES="$PEER_PACKAGES"
  install_missing
  GOUGE_BENCH_BUILD="$ROOT/build/bench"
  quietly configure cmake -S "$ROOT" -B "$GOUGE_BENCH_BUILD" -G Ninja -DGOUGE_BENCHMARKS=ON -DGOUGE_BUILD_TESTS=OFF
fi
export GOUGE_BENCH_CACHE="${GOUGE_BENCH_CACHE:-$TOP/build/bench_cache}"
mkdir -p "$OUT" "$GOUGE_BENCH_CACHE" || exit 1

repetitions=5 min_time=0.5
if [ -n "$is_quick" ]; then
  export GOUGE_BENCH_QUICK=1
  export GOUGE_BENCH_SIZES="${GOUGE_BENCH_SIZES:-2400,200000,2000000}"
  repetitions=1 min_time=0.05
fi

missing=()
for name in "${programs[@]}"; do
  if ! cmake --build "$GOUGE_BENCH_BUILD" --target "measure_$name" >"$OUT/build_$name.log" 2>&1; then
    missing+=("$name")
    continue
  fi
  # One processor for all but the engine, which is also asked for two threads.
  pinned="taskset -c 0"
  [ "$name" = engine ] && pinned=""
  echo "measuring $name" >&2
  # The pinning is meant to be split into words.
  # shellcheck disable=SC2086
  if ! $pinned "$GOUGE_BENCH_BUILD/tests/bench/measure_$name" --benchmark_repetitions=$repetitions \
    --benchmark_min_time=$min_time --benchmark_enable_random_interleaving=false \
    --benchmark_out="$OUT/$name.json" --benchmark_out_format=json >"$OUT/$name.log" 2>&1; then
    missing+=("$name")
  fi
done
cmake --build "$GOUGE_BENCH_BUILD" --target bench_table >"$OUT/build_table.log" 2>&1 || exit 1
{
  echo "# Measured $(date -u +%Y-%m-%d), commit $(git -C "$TOP" rev-parse --short HEAD 2>/dev/null || echo unknown)"
  echo
  echo "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) processors, load $(cut -d' ' -f1 /proc/loadavg)${is_quick:+, quick: not for figures}"
  "$GOUGE_BENCH_BUILD/tests/bench/bench_table" "$OUT"/*.json
} | tee "$OUT/table.md"
if [ ${#missing[@]} -gt 0 ]; then
  echo "not measured: ${missing[*]} (logs in $OUT; peers need: $PEER_PACKAGES)" >&2
  exit 1
fi
