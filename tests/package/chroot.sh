#!/usr/bin/env bash
# chroot.sh DEBS SAMPLES: installs the packages of the folder DEBS in a clean Debian 12 (debootstrap), runs program and
# Python module on the samples that make_samples wrote into SAMPLES, removes the packages, and looks for what they left.
# Needs root, the network and debootstrap; MIRROR names another mirror. Exit status 77, skipped, without them.
set -eu
debs=$1 samples=$2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}

fail() {
  echo "failed: $*" >&2
  exit 1
}
skip() {
  echo "skipped: $*"
  exit 77
}
[ "$(id -u)" -eq 0 ] || skip "a chroot needs root"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"

root=$(mktemp -d)
chmod 755 "$root"
cleanup() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap cleanup EXIT
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { tail "$root.log" && skip "debootstrap"; }
rm -f "$root.log"
mount -t proc proc "$root/proc"
inside() { chroot "$root" env -i PYTHONDONTWRITEBYTECODE=1 PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
mkdir "$root/debs"
cp "$debs"/*.deb "$root/debs"
inside apt-get update >/dev/null
inside sh -c 'apt-get install -y --no-install-recommends /debs/*.deb' >"$root/install.log" 2>&1 ||
  { cat "$root/install.log" && fail "apt-get install"; }
packages=$(for deb in "$debs"/*.deb; do dpkg-deb -f "$deb" Package; done | sort)
for compiler in cc c++ gcc g++ clang; do
  inside sh -c "command -v $compiler" >/dev/null && fail "there is a compiler in the chroot: $compiler"
done

# The program on the samples: exit statuses as samples/quickstart.sh expects them.
cp -r "$samples" "$root/samples"
begin=$(date +%s)
count=0
run_sample() { # FOLDER WANTED ARGUMENT...
  local folder=$1 wanted=$2 status=0
  shift 2
  inside sh -c 'cd "/samples/$0" && exec gougecheck "$@"' "$folder" "$@" >"$root/out.txt" 2>&1 </dev/null || status=$?
  [ "$status" = "$wanted" ] || { cat "$root/out.txt" && fail "$folder: exit status $status, expected $wanted: $*"; }
  count=$((count + 1))
}
while read -r name check_exit correct_exit toolpath options; do
  # The options of a sample are separate words without blanks in them.
  # shellcheck disable=SC2086
  run_sample "$name" "$check_exit" check "$toolpath" $options --report report
  # shellcheck disable=SC2086
  run_sample "$name" "$correct_exit" correct "$toolpath" $options -o "corrected_$toolpath"
done <"$samples/index.txt"
[ "$count" -gt 10 ] || fail "too few samples in $samples"
seconds=$(($(date +%s) - begin))
echo "program: $count commands on the samples as expected in $seconds s, no compiler there"
inside gougecheck --version
inside test -e /usr/share/man/man1/gougecheck.1.gz || echo "note: this build has no manual pages"

# The Python module: the first check of the documentation, as written.
sed -n '/^```python$/,/^```$/p' "$source/docs/guide/python.md" | sed '/^```/d' >"$root/first.py"
sed -n '/^```text$/,/^```$/p' "$source/docs/guide/python.md" | sed '/^```/d' >"$root/wanted.txt"
inside python3 /first.py >"$root/out.txt" 2>&1 || { cat "$root/out.txt" && fail "docs/guide/python.md"; }
cmp "$root/wanted.txt" "$root/out.txt" || fail "docs/guide/python.md prints something else"
for script in lead_angle sampling_misses; do
  inside python3 "/usr/share/doc/python3-gougecheck/examples/$script.py" >"$root/out.txt" 2>&1 ||
    { cat "$root/out.txt" && fail "$script.py"; }
done
echo "python: the first check of docs/guide/python.md and the examples run"

# The development package, by a compiler that is installed for it alone.
inside sh -c 'apt-get install -y --no-install-recommends g++ cmake make pkg-config' >"$root/install.log" 2>&1 ||
  { cat "$root/install.log" && fail "apt-get install g++"; }
inside sh -c 'cp -r /usr/share/doc/libgougecheck-dev/examples /examples && cmake -S /examples -B /built &&
  cmake --build /built && /built/haptic_loop && pkg-config --exists gougecheck' >"$root/out.txt" 2>&1 ||
  { cat "$root/out.txt" && fail "the development package"; }
echo "development: $(grep 'poses a second' "$root/out.txt")"

# Removed without a trace.
# shellcheck disable=SC2086
inside apt-get purge -y $packages >"$root/install.log" 2>&1 || { cat "$root/install.log" && fail "apt-get purge"; }
left=$(cd "$root" && find etc usr opt var/lib/dpkg/info -xdev -name '*gougecheck*')
[ -z "$left" ] || fail "left behind: $left"
echo "removed: nothing is left"
