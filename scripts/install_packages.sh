#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the packages of packages.txt that are missing: scripts/install_packages.sh [TIER ...]; without tiers, all. As
# root or with sudo; with neither it prints the command and stops.
set -euo pipefail
cd "$(dirname "$0")/.."

tiers=$(sed -n 's/^\[\([a-z]*\)\].*/\1/p' packages.txt)
for tier in "$@"; do
  if ! grep -qx "$tier" <<<"$tiers"; then
    echo "error: packages.txt has no tier '$tier'; it has:" $tiers >&2
    exit 2
  fi
done
wanted=$(awk -v tiers=" $* " '/^\[/ { tier = $1; gsub(/[][]/, "", tier) }
  /^[a-z0-9]/ && (tiers ~ /^ *$/ || index(tiers, " " tier " ")) { print $1 }' packages.txt)

# What other packages provide counts as there: NodeSource's nodejs brings npm.
provided=$(dpkg-query -W -f='${db:Status-Status} ${Provides}\n' | sed -n 's/^installed //p' | tr -d ' ' | tr ',' '\n' |
  sed 's/(.*//')
missing=()
for package in $wanted; do
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' &&
    ! grep -qx "$package" <<<"$provided"; then
    missing+=("$package")
  fi
done

if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

install=(apt-get install -y --no-install-recommends "${missing[@]}")
echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
if [ "$(id -u)" -eq 0 ]; then
  apt-get update -q
  "${install[@]}" -q
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
  sudo apt-get update -q
  sudo --preserve-env=DEBIAN_FRONTEND "${install[@]}" -q
else
  echo "These packages are missing and this user can install none. As root, run:" >&2
  echo "  apt-get update && ${install[*]}" >&2
  exit 1
fi
