#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tries a Debian package in a fresh Debian 12: installs it, runs a case, draws the report, imports the Python
# package, opens the Studio's page, builds the example against the library, removes it, and looks whether anything is left. As root, with
# debootstrap; it loads about 1 GB. By hand, not a part of `make check`.
#
#   scripts/try_package.sh PACKAGE.deb [ROOT] [CASE]
#
# ROOT is the folder of the system, made where it is missing and kept; CASE is paper (default), quick or finger.
set -euo pipefail
if [ $# -lt 1 ] || [ ! -f "$1" ]; then
  echo "usage: scripts/try_package.sh PACKAGE.deb [ROOT] [CASE]" >&2
  exit 2
fi
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "error: this needs root and debootstrap (apt-get install debootstrap)" >&2
  exit 2
fi
package=$(realpath "$1")
root=${2:-/var/tmp/ionskin-trial}
case=${3:-paper}
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | sort -u | head -1)

[ -x "$root/usr/bin/apt-get" ] || debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}"
mkdir -p "$root/proc"
mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
cp /etc/resolv.conf "$root/etc/resolv.conf"
[ ! -d /etc/apt/apt.conf.d ] || cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive HOME=/root "$@"; }
as_user() { echo "\$ $1"; inside su tester -s /bin/bash -c "cd && $1"; }
step() { printf '\n== %s\n' "$1"; }
# What packages leave: not what dpkg, apt and their logs write about themselves.
files() {
  (cd "$root" && find . -xdev \( -path ./proc -o -path ./tmp -o -path ./home -o -path ./var/lib/dpkg -o -path ./var/lib/apt \
    -o -path ./var/cache -o -path ./var/log -o -path ./etc/ld.so.cache \) -prune -o -print | sort)
}

step "Dependencies and a user"
inside apt-get update -q
inside apt-get purge -yq ionskin 2>/dev/null || true
depends=$(dpkg-deb -f "$package" Depends)
inside apt-get satisfy -yq --no-install-recommends "$depends" g++ cmake make
inside id tester >/dev/null 2>&1 || inside useradd -m tester
rm -rf "$root/home/tester/trial"
files > "$root/tmp/before"

step "Install"
cp "$package" "$root/tmp/ionskin.deb"
inside apt-get install -yq --no-install-recommends /tmp/ionskin.deb

step "Use"
as_user "mkdir -p trial && ionskin --version && ionskin doctor"
as_user "cd trial && ionskin init case.toml --from $case && time ionskin run case.toml -o out --overwrite"
as_user "cd trial && ionskin report out --figure fig05_shear && ls -l out/report.html"
as_user "cd trial && python3 -c 'import ionskin; print(ionskin.__file__); print(ionskin.open_results(\"out\"))'"
as_user "cd trial && python3 -c 'import ionskin; case = ionskin.Case.from_file(\"case.toml\"); case[\"numerics.preset\"] = \"coarse\"; print(ionskin.run(case, \"from_python\"))'"
as_user "cd trial && cp -r /usr/share/doc/ionskin/examples/embed . && cmake -S embed -B embed/build >/dev/null && cmake --build embed/build && embed/build/embed /usr/share/ionskin/cases/quick.toml embedded"
as_user "cd trial && { ionskin studio . --no-browser > link & } && sleep 3 && python3 -c 'import re, urllib.request as web; page = web.build_opener(web.HTTPCookieProcessor()).open(re.search(r\"http\S+\", open(\"link\").read())[0]); print(\"studio\", page.status, len(page.read()), \"bytes\")'; kill \$!"
as_user "ls -l /usr/share/man/man1/ionskin.1.gz /usr/share/bash-completion/completions/ionskin"

step "Remove"
inside apt-get remove -yq ionskin
files > "$root/tmp/after"
if diff "$root/tmp/before" "$root/tmp/after"; then
  echo "Nothing is left."
else
  echo "error: the files above differ from those before the package was installed" >&2
  exit 1
fi
