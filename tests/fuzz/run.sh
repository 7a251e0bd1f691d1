#!/bin/bash
# run.sh BUILD SECONDS [TARGET...]: gives every fuzz target of a build folder (or those named) SECONDS of processor
# time, and prints a table of what came of it. Inputs that were worth keeping stay in BUILD/fuzzing for the next run.
# Ends with status 1 when a target found something.
set -u
build=$1
seconds=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
folder=$build/fuzzing
mkdir -p "$folder"
[ $# -gt 0 ] || set -- $(cd "$build/tests/fuzz" && ls -d fuzz_*)
TIMEFORMAT='%0U %0S'
status=0
printf '%-28s %8s %12s %s\n' target 'cpu s' executions findings
for target in "$@"; do
  mkdir -p "$folder/$target"
  cpu=0 executions=0 findings=0
  while [ "$cpu" -lt "$seconds" ] && [ "$findings" = 0 ]; do
    { time "$build/tests/fuzz/$target" -max_total_time=$((seconds - cpu + 5)) -timeout=60 -rss_limit_mb=2048 \
        -max_len=20000 -dict="$here/words.dict" -print_final_stats=1 -artifact_prefix="$folder/found_$target-" "$folder/$target" \
        "$here/../corpus/cl" "$here/../corpus/apt" > "$folder/$target.log" 2>&1 || findings=1; } 2> "$folder/time"
    read -r user system < <(tail -1 "$folder/time")
    cpu=$((cpu + user + system))
    done_now=$(sed -n 's/^stat::number_of_executed_units: //p' "$folder/$target.log" | tail -1)
    executions=$((executions + ${done_now:-0}))
  done
  [ "$findings" = 0 ] || status=1
  printf '%-28s %8d %12d %s\n' "$target" "$cpu" "$executions" "$findings"
done
exit $status
