#!/usr/bin/env bash
# bare_machine.sh: runs both commands of the README in a new Debian 12 (debootstrap) in which nothing is installed, on a
# clone of the commit that is checked out. Needs root, the network and debootstrap; MIRROR names another mirror.
set -eu
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}
[ "$(id -u)" -eq 0 ] || { echo "a chroot needs root" >&2; exit 1; }

root=$(mktemp -d)
chmod 755 "$root"
cleanup() {
  umount "$root/dev/shm" "$root/dev" "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap cleanup EXIT
debootstrap --variant=minbase bookworm "$root" "$mirror" >/dev/null
git clone -q "$source" "$root/gougecheck"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mount -t tmpfs tmpfs "$root/dev/shm"
inside() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root bash -c "cd /gougecheck && $1" </dev/null
}
for command in samples/quickstart.sh tests/run.sh; do
  begin=$(date +%s)
  inside "bash $command"
  echo "$command: $(($(date +%s) - begin)) s"
done
