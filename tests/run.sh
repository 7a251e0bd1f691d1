#!/usr/bin/env bash
# Builds everything and runs all tests. Run it from any folder, as root or with sudo at hand. Ends in one line:
# N passed, N failed, N skipped. The exit status is 0 only when tests ran and none failed.
set -u
MORE_PACKAGES="clang-format pkg-config pybind11-dev python3-dev python3-numpy python3-pytest python3-matplotlib"
OPTIONAL_PACKAGES="openmpi-bin libopenmpi-dev chromium liborocos-kdl-dev"  # ranks, report page, kinematics
. "$(dirname "${BASH_SOURCE[0]}")/../samples/setup.sh"
grep -q '^GOUGE_PYTHON:BOOL=ON' "$BUILD/CMakeCache.txt" ||
  quietly configure cmake -S "$ROOT" --preset release -DGOUGE_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
build

JUNIT="$ROOT/build/tests.xml"
rm -f "$JUNIT"
ctest --test-dir "$BUILD" --parallel "$(nproc)" --output-on-failure --no-tests=error --timeout 900 \
  --output-junit "$JUNIT" </dev/null >"$ROOT/build/tests.log" 2>&1
status=$?
# What ctest says of a failing test stands before the summary.
awk '/^The following tests FAILED:/ { exit } /\*\*\*(Failed|Timeout|Exception|Not Run)/ { show = 1 }
     /^[[:space:]]*[0-9]+\/[0-9]+ Test.*Passed/ { show = 0 } /^[[:space:]]*[0-9]+\/[0-9]+ Test.*Skipped/ { show = 0 }
     show { print }' "$ROOT/build/tests.log" | grep -v '^[[:space:]]*Start ' || true
[ -f "$JUNIT" ] || { tail -n 30 "$ROOT/build/tests.log" >&2; fail "ctest wrote no results"; }

# Each skipped test with its reason.
python3 - "$JUNIT" <<'END'
import sys
import xml.etree.ElementTree as tree

for case in tree.parse(sys.argv[1]).iter("testcase"):
    skipped = case.find("skipped")
    if skipped is None or not skipped.get("message", "").startswith("SKIP_"):
        continue
    lines = [line.strip() for line in (case.findtext("system-out") or "").splitlines()]
    after = [k for k, line in enumerate(lines) if line.endswith(": Skipped")]
    said = lines[after[0] + 1:] if after else lines[::-1]
    print("skipped:", case.get("name").split("  #")[0] + ":", next((line for line in said if line), "no reason given"))
END

# One <testcase ... status="run|fail|notrun|disabled"> per test; one that was skipped on purpose says so in the line
# after it, any other that did not run counts as failed.
awk -v status="$status" '
  waiting { if (/message="SKIP_/) skipped++; else failed++; waiting = 0 }
  /^\t<testcase / {
    if (/ status="run"/) passed++
    else if (/ status="disabled"/) skipped++
    else if (/ status="notrun"/) waiting = 1
    else failed++
  }
  END {
    printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
    if (status != 0 || failed > 0 || passed == 0) exit 1
  }' "$JUNIT"
