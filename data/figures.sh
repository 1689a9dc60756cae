#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Draws the figures of the manual and of README, one command each, and prints
# the commands.
#
#   sh data/figures.sh [PATH/TO/phspline [FOLDER]]
#
# Defaults: build/plain/phspline, data/figures.  Needs a phspline with cairo.
set -eu

program=${1:-build/plain/phspline}
data=$(dirname "$0")
out=${2:-$data/figures}
mkdir -p "$out"

phspline() {
  "$program" "$@" -q -o /dev/null
}

# draw NAME COMMAND [FORMAT]: NAME.svg, or in another format; the results
# themselves are not kept
draw() {
  echo "$2 --plot=$out/$1.${3-svg}"
  eval "$2 --plot=\$out/\$1.\${3-svg}"
}

# [HUA14]: a helix with its lengths, 1 % less and 1 % more; then sweeps of one
# length
draw huard-figure4 "phspline arclength $data/huard-2014-figure4.json \
--sweep='lengths*=0.99,1,1.01'"
draw huard-figure5 "phspline arclength $data/huard-2014-figure5.json \
--sweep='lengths[1]=2.9,2.5'"
draw huard-figure6 "phspline arclength $data/huard-2014-figure6.json \
--sweep='lengths[0]=6.3,7.24,5.35'"
draw huard-figure12 "phspline arclength $data/huard-2014-figure12.json \
--sweep='lengths[0]=2:2.08120802:5:log'"
draw huard-figure13 "phspline arclength $data/huard-2014-figure13.json \
--sweep='lengths[1]=1.4:1.456845614:5:log'"

# one of each of the other commands: the path of a ship 10 km out at sea, and loops
# that clear the island; a
# segment of [GON18] by six criteria; a corridor of 637 km on either side of a
# voyage; the path of a cutter; a lampshade and its pattern; and several problems,
# pairs of cubics of [BYR11]
draw coastline "phspline planar $data/coastline.csv --closed --offset=-10 \
--offset-mode=trimmed"
draw pocket "phspline planar $data/coastline.csv --closed --offset=4:48:12 \
--offset-mode=trimmed"
draw gonzalez-criteria "sed -n 's/\"ph-2c-F1\"/\"case 2\"/p' \
$data/gonzalez-2018-spatial.jsonl | phspline spatial-hermite \
--sweep=criterion=cc,hc,bv,F1,F2,F3"
draw magellan "phspline sphere $data/magellan-elcano.csv --offset=-0.1,0.1"
draw spanner "phspline tc $data/spanner.json --tolerance=0.01 --offset=-3 \
--offset-mode=trimmed"
draw lampshade "phspline cone $data/lampshade.csv --closed --height='[0,18]'" png
draw byrtus-figure5-15 "grep figure-5.15 $data/byrtus-2011.jsonl | phspline tc"

# a synthetic jaw, laid flat: where there is Python, which makes it
if command -v python3 >/dev/null; then
  python3 "$data/jaw.py" "$out"
  echo "phspline cone $out/jaw.csv --height='[-1,24]' --volume=$out/jaw.nrrd" \
    "--resolution=8 --panorama=$out/jaw.png"
  phspline cone "$out/jaw.csv" --height='[-1,24]' --volume="$out/jaw.nrrd" \
    --resolution=8 --panorama="$out/jaw.png"
  rm "$out/jaw.csv" "$out/jaw.nrrd"
fi
