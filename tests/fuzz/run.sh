#!/bin/bash
# run.sh [SECONDS [TARGET...]]: gives every fuzz target (or those named) SECONDS of processor time (600), and prints a
# table of what came of it. The build folder is build/fuzz, or GOUGE_FUZZ_BUILD. Seeds are the small corpora of the
# repository; inputs that were worth keeping stay in the build folder for the next run. Status 1: a target found something.
set -u
seconds=${1:-600}
shift
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${GOUGE_FUZZ_BUILD:-$here/../../build/fuzz}" && pwd) || exit 2
folder=$build/fuzzing
mkdir -p "$folder"
[ $# -gt 0 ] || set -- $(cd "$build/tests/fuzz" && ls -d fuzz_* | grep -v '\.')
TIMEFORMAT='%0U %0S'
status=0

# The dictionary, the greatest length of an input and the seeds of a target.
choose() {
  words=$here/words.dict most=20000 seeds=("$here/../corpus/cl" "$here/../corpus/apt")
  case $1 in
    fuzz_stl_*) words=$here/stl.dict most=8000 seeds=() ;;
    fuzz_tool_library) words=$here/tools.dict most=4000 seeds=() ;;
    fuzz_import_nx) words=$here/tools.dict most=8000 seeds=("$here/../corpus/tool/nx/metric") ;;
    fuzz_import_freecad) words=$here/tools.dict most=8000 seeds=("$here/../corpus/tool/freecad") ;;
    fuzz_import_fusion) words=$here/tools.dict most=8000 seeds=("$here/../corpus/tool") ;;
    fuzz_siemens) words=$here/siemens.dict most=4000 seeds=() ;;
    fuzz_heidenhain) words=$here/heidenhain.dict most=4000 seeds=() ;;
    fuzz_linuxcnc | fuzz_haas | fuzz_fanuc) words=$here/iso.dict most=4000 seeds=() ;;
    fuzz_job_list) words=$here/jobs.dict most=2000 seeds=() ;;
    fuzz_result | fuzz_project) words=$here/results.dict most=9000 seeds=() ;;
    fuzz_certificate) words=$here/results.dict most=3000 seeds=() ;;
    fuzz_options | fuzz_command_line) words=$here/options.dict most=1000 seeds=() ;;
  esac
  [ ! -d "$here/corpus/$1" ] || seeds+=("$here/corpus/$1")
}

printf '%-28s %8s %12s %s\n' target 'cpu s' executions findings
for target in "$@"; do
  choose "$target"
  mkdir -p "$folder/$target"
  cpu=0 executions=0 findings=0
  while [ "$cpu" -lt "$seconds" ] && [ "$findings" = 0 ]; do
    { time "$build/tests/fuzz/$target" -max_total_time=$((seconds - cpu + 5)) -timeout=300 -rss_limit_mb=2048 \
        -max_len="$most" -dict="$words" -print_final_stats=1 -artifact_prefix="$folder/found_$target-" \
        "$folder/$target" "${seeds[@]}" > "$folder/$target.log" 2>&1 || findings=1; } 2> "$folder/$target.time"
    read -r user system < <(tail -1 "$folder/$target.time")
    cpu=$((cpu + user + system))
    done_now=$(sed -n 's/^stat::number_of_executed_units: //p' "$folder/$target.log" | tail -1)
    executions=$((executions + ${done_now:-0}))
  done
  [ "$findings" = 0 ] || status=1
  printf '%-28s %8d %12d %s\n' "$target" "$cpu" "$executions" "$findings"
done
exit $status
