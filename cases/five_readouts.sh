#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# One strain history read out five ways: short circuit, open circuit, a load of 1 MOhm, an amplifier of
# 1 kHz, and four taxels. Run it from the repository:
#
#     cases/five_readouts.sh cases/paper/coarse.toml out/readouts
#
# The contact is solved once; the other runs take its strain history from results.h5.
set -eu

case_file=$1
output=$2
program=${IONSKIN_PROGRAM:-build/ionskin}
mkdir -p "$output"

"$program" run "$case_file" -o "$output/short" --quiet
strain="$(cd "$output" && pwd)/short/results.h5"

read_out() {
  name=$1
  shift
  "$program" run "$case_file" -o "$output/$name" --quiet --set strain.source=file --set "strain.file=$strain" "$@"
}
taxel() {
  printf '{name="%s", lower=["%s mm", "0 mm"], upper=["%s mm", "2 mm"]}' "$1" "$2" "$3"
}
read_out open --set readout.circuit=open
read_out load --set readout.circuit=load --set "readout.load_resistance=1 MOhm"
read_out amplifier --set readout.circuit=amplifier --set "readout.amplifier_bandwidth=1 kHz" \
  --set "readout.amplifier_noise_density=1 nA/sqrt(Hz)"
read_out taxels --set "readout.taxels=[$(taxel a 0 3.75), $(taxel b 3.75 7.5), $(taxel c 7.5 11.25), $(taxel d 11.25 15)]"

PYTHONPATH="$(dirname "$0")/../python" /usr/bin/python3 -m ionskin.readouts "$output/short" "$output/open" \
  "$output/load" "$output/amplifier" "$output/taxels" -o "$output/readouts.png"
echo "figure: $output/readouts.png"
