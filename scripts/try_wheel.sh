#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tries a wheel in a fresh Debian 12 or 13 with its own Python: in a virtual environment a live skin is stepped with numpy alone,
# and the program runs a case and draws its report. As root, with debootstrap; by hand, not a part of `make check`.
#
#   scripts/try_wheel.sh WHEEL SKIN.live [bookworm|trixie] [ROOT]
#
# ROOT is the folder of the system, made where it is missing and kept.
set -euo pipefail
if [ $# -lt 2 ] || [ ! -f "$1" ] || [ ! -f "$2" ]; then
  echo "usage: scripts/try_wheel.sh WHEEL SKIN.live [bookworm|trixie] [ROOT]" >&2
  exit 2
fi
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "error: this needs root and debootstrap (apt-get install debootstrap)" >&2
  exit 2
fi
suite=${3:-bookworm}
root=${4:-/var/tmp/ionskin-wheel-$suite}
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | sort -u | head -1)
[ -x "$root/usr/bin/python3" ] ||
  debootstrap --variant=minbase --include=python3,python3-venv,python3-numpy,python3-h5py,python3-matplotlib,python3-jinja2 \
    "$suite" "$root" "${mirror:-http://deb.debian.org/debian}"
mkdir -p "$root/proc" "$root/trial"
mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
rm -rf "$root/trial"
mkdir "$root/trial"
cp "$1" "$2" "$root/trial"
inside() { chroot "$root" env -i PATH=/trial/venv/bin:/usr/bin:/bin LC_ALL=C.UTF-8 HOME=/root bash -ec "cd /trial && $1"; }

# The packages of Debian bring numpy and what draws reports, so that nothing is downloaded by pip.
inside "python3 --version && python3 -m venv --system-site-packages venv && pip install --no-deps --no-index $(basename "$1")"
inside "python3 - <<'END'
import sys, ionskin.live
others = sorted({name.split('.')[0] for name in sys.modules} & {'h5py', 'matplotlib', 'jinja2', 'scipy'})
assert not others, others
skins = ionskin.live.Skins('$(basename "$2")', 8)
skin = skins.skin
place = [(low + high) / 2 for low, high in zip(skin.range.lowest, skin.range.highest)]
signals = skins.step(0.0, [place] * 8, forces=0.5 * skin.range.force)
assert not signals.flags.any() and (signals['normal_force'] > 0).all()
print('live', signals['normal_force'][0], 'N')
END"
inside "ionskin --version && ionskin run \$(dirname \$(find venv -name quick.toml))/quick.toml --set numerics.preset=coarse -o out --quiet && ls -l out/report.html"
inside "pip uninstall -yq ionskin && ! find venv -name '*ionskin*' | grep ."
