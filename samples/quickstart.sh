#!/usr/bin/env bash
# Builds gougecheck and shows its main job on the samples: check, correct, report. Run it from any folder, as root or
# with sudo at hand. A second run builds and installs nothing again.
set -u
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
build gougecheck gouge_make_samples

OUT="$ROOT/samples/out"
GOUGECHECK="$BUILD/cli/gougecheck"
"$BUILD/samples/make_samples" "$OUT" || fail "the samples could not be written to $OUT"

bad=0
# expect WANTED COMMAND...: shows the command, runs it, and compares its exit status with the expected one.
expect() {
  local wanted=$1 got
  shift
  printf '\n$ %s\n' "${*/#$GOUGECHECK/gougecheck}"
  "$@" </dev/null >"$ROOT/build/sample.txt" 2>&1
  got=$?
  tail -n "${LINES_SHOWN:-14}" "$ROOT/build/sample.txt"
  if [ "$got" -eq "$wanted" ]; then
    echo "[exit $got, as expected]"
  else
    echo "[exit $got, but $wanted was expected]"
    bad=$((bad + 1))
  fi
}

# forget FOLDER: removes a report that an earlier version wrote, for which no manifest says that it may be replaced.
forget() {
  [ -e "$1/manifest.json" ] || rm -f "$1"/{report.html,result.json,moves.csv} "$1"/*.png
}

while read -r name check_exit correct_exit toolpath options; do
  cd "$OUT/$name" || fail "cannot enter $OUT/$name"
  forget report/check
  forget report/correct
  # The options of a sample are separate words without blanks in them.
  # shellcheck disable=SC2086
  expect "$check_exit" "$GOUGECHECK" check "$toolpath" $options --report report/check
  # shellcheck disable=SC2086
  expect "$correct_exit" "$GOUGECHECK" correct "$toolpath" $options -o "corrected_$toolpath" --report report/correct
done <"$OUT/index.txt"

# A fixture that reaches into its part: a warning of the check above, and what clash proves of it.
cd "$OUT/sunk_jaw" || fail "cannot enter $OUT/sunk_jaw"
expect 1 "$GOUGECHECK" clash part.stl jaw.stl --json clash.json
expect 0 "$GOUGECHECK" clash part.stl jaw.stl --place-b 0,-2.001,0

printf '\nPictures:\n'
find "$OUT" -name '*.png' | LC_ALL=C sort
printf '\n'
if [ "$bad" -ne 0 ]; then
  fail "$bad commands ended otherwise than expected"
fi
echo "Every sample ended as expected. Exit 1 of check means that gouges were found, as docs/exit_codes.md says."
