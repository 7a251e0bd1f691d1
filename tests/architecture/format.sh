#!/usr/bin/env bash
# Fails where clang-format would change a source. Exit status 77, skipped, where clang-format 14 (that of Debian 12) is
# absent: other versions format otherwise.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
program=clang-format
command -v clang-format-14 >/dev/null && program=clang-format-14
if ! command -v "$program" >/dev/null; then
  echo "skipped: clang-format is not installed (Debian 12: apt-get install clang-format)"
  exit 77
fi
version=$("$program" --version)
if [[ $version != *"version 14."* ]]; then
  echo "skipped: this is \"$version\", which formats otherwise than clang-format 14"
  exit 77
fi
echo "$version"
find cli lib toolmodels postproc samples tests -name '*.h' -print0 -o -name '*.cpp' -print0 |
  xargs -0 "$program" --dry-run --Werror
