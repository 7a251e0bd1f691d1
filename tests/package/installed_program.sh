#!/usr/bin/env bash
# installed_program.sh BUILD: installs the program of a build folder into a folder of its own, moves that, and looks at
# what comes with it: modules, manual pages of every command, completions of three shells.
set -eu
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "failed: $*" >&2
  exit 1
}

cmake --install "$build" --component program --prefix "$work/first" >"$work/install.log" 2>&1 ||
  fail "cmake --install: $(cat "$work/install.log")"
mv "$work/first" "$work/prefix" # nothing in it may know where it was made
prefix="$work/prefix"
program="$prefix/bin/gougecheck"
"$program" --version >"$work/version.txt" || fail "the program does not run where it was moved"

pages=$(find "$prefix/share/man/man1" -name '*.1.gz' | wc -l)
[ "$pages" -ge 10 ] || fail "$pages manual pages"
[ -z "$(find "$prefix/share/man" -name '*.1')" ] || fail "a manual page is not compressed"
for command in "" check correct batch compare accept config verify; do
  page="$prefix/share/man/man1/gougecheck${command:+-$command}.1.gz"
  [ -f "$page" ] || fail "no $page"
  # shellcheck disable=SC2086
  "$program" man $command | cmp - <(gzip -dc "$page") || fail "the page of '$command' is not that of the program"
  gzip -dc "$page" | grep -q '^\.TH GOUGECHECK' || fail "$page is no manual page"
  if command -v mandoc >/dev/null; then
    gzip -dc "$page" | mandoc -Tlint -Werror >"$work/lint.txt" || fail "$page: $(cat "$work/lint.txt")"
  fi
done
gzip -dc "$prefix/share/man/man1/gougecheck-check.1.gz" | grep -q 'export' || fail "the page of check lacks --export"

bash -n "$prefix/share/bash-completion/completions/gougecheck" || fail "the completion of bash"
grep -q -- '--export' "$prefix/share/bash-completion/completions/gougecheck" || fail "bash completes no --export"
grep -q '^#compdef gougecheck' "$prefix/share/zsh/vendor-completions/_gougecheck" || fail "the completion of zsh"
grep -q 'complete -c gougecheck' "$prefix/share/fish/vendor_completions.d/gougecheck.fish" || fail "that of fish"
echo "installed, moved, with $pages manual pages and three completions"
