#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Times `make demo` on a fresh Debian 12 that has git and make alone: packages, build, run. As root, with debootstrap; it
# loads about 400 MB. By hand, on a quiet machine.
#
#   scripts/try_demo.sh [ROOT]
#
# ROOT is the folder of the system: made anew, and kept. Two processors are used, however many there are.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "error: this needs root and debootstrap (apt-get install debootstrap)" >&2
  exit 2
fi
root=${1:-/var/tmp/ionskin-demo}
if [ -e "$root" ]; then
  echo "error: $root is there already; name a folder that is not" >&2
  exit 2
fi
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | sort -u | head -1)

debootstrap --variant=minbase --include=git,make,ca-certificates bookworm "$root" \
  "${mirror:-http://deb.debian.org/debian}" >/dev/null
mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
cp /etc/resolv.conf "$root/etc/resolv.conf"
[ ! -d /etc/apt/apt.conf.d ] || cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
git clone -q . "$root/root/ionskin"
processors=$(taskset -cp $$ | sed 's/.*: //' | tr ',' '\n' | sed 's/-/\n/' | head -2 | paste -sd,)
inside() {
  taskset -c "$processors" chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root \
    bash -c "cd /root/ionskin && TIMEFORMAT='$1: %R s, %U + %S s of processor' && time { $2; }"
}
before=$(chroot "$root" dpkg-query -W | wc -l)
inside Packages "make setup-demo >/root/packages.log 2>&1"
echo "$(($(chroot "$root" dpkg-query -W | wc -l) - before)) packages, $(grep -h 'Need to get' "$root/root/packages.log")"
inside "Build and run" "make demo JOBS=2"
awk -F'\t' 'NR > 1 && $2 > last { last = $2 } END { printf "Build: %.0f s\n", last / 1000 }' \
  "$root/root/ionskin/build/.ninja_log"
