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

# draw NAME COMMAND OPTION...: NAME.svg; the results themselves are not kept
draw() {
  name=$1
  shift
  echo "phspline $* --plot=$out/$name.svg"
  "$program" "$@" --plot="$out/$name.svg" -q -o /dev/null
}

# [HUA14]: a helix with its lengths, 1 % less and 1 % more; then sweeps of one
# length
draw huard-figure4 arclength "$data/huard-2014-figure4.json" \
  --sweep='lengths*=0.99,1,1.01'
draw huard-figure5 arclength "$data/huard-2014-figure5.json" \
  --sweep='lengths[1]=2.9,2.5'
draw huard-figure6 arclength "$data/huard-2014-figure6.json" \
  --sweep='lengths[0]=6.3,7.24,5.35'
draw huard-figure12 arclength "$data/huard-2014-figure12.json" \
  --sweep='lengths[0]=2:2.08120802:5:log'
draw huard-figure13 arclength "$data/huard-2014-figure13.json" \
  --sweep='lengths[1]=1.4:1.456845614:5:log'

# one of each command
draw coastline planar "$data/coastline.csv" --closed --offset=-10
draw gonzalez-2018-spatial spatial-hermite \
  "$data/gonzalez-2018-spatial.jsonl"
draw magellan sphere "$data/magellan-elcano.csv" --offset=-0.1,0.1
draw byrtus-2011 tc "$data/byrtus-2011.jsonl"
