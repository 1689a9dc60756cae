#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The completions in data/completions/ are what generate.sh makes of the help
# texts of the program, their shells can read them, and those of bash complete.
set -eu
export LC_ALL=C
cd "${srcdir:-$(dirname "$0")/../..}"
program=${PHSPLINE:-build/plain/phspline}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
bad=0

fail() {
  echo "not ok completions $1"
  bad=1
}

check() {
  shell=$1 file=data/completions/$2
  if ! sh data/completions/generate.sh "$shell" "$program" >"$tmp/new"; then
    fail "$shell: generate.sh fails"
  elif ! diff "$file" "$tmp/new" >"$tmp/diff"; then
    fail "$shell: $file is not what generate.sh prints"
    cat "$tmp/diff"
  elif ! command -v "$shell" >/dev/null; then
    echo "skip completions $shell: no $shell"
  elif ! "$shell" -n "$file"; then
    fail "$shell: cannot read $file"
  else
    echo "ok completions $shell"
  fi
}
check bash phspline.bash
check zsh _phspline
check fish phspline.fish

# offers WANTED WORD...: what bash offers for the last word, = being one
offers() {
  wanted=$1
  shift
  # the script is bash's, not ours
  # shellcheck disable=SC2016
  found=$(bash -c '. data/completions/phspline.bash
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    _phspline
    echo "${COMPREPLY[*]}"' bash "$@")
  if [ "$found" = "$wanted" ]; then
    echo "ok completions of $*"
  else
    fail "of $*: $found"
  fi
}
if command -v bash >/dev/null; then
  offers 'planar' phspline p
  offers 'verify' phspline v
  offers 'planar spatial-hermite arclength sphere tc cone bubble verify' phspline help ''
  offers 'schema' phspline sc
  offers 'sphere' phspline schema sph
  offers '--free= --format= --feed= --fields= --frame= --fail-fast' phspline planar --f
  offers '--problems= --pretty --progress' phspline verify --pr
  offers 'json csv text npy svg-path svg geojson dxf obj stl opendrive gcode' phspline planar --format =
  offers 'csv' phspline planar -f c
  offers 'uniform' phspline planar --knots = u
  offers 'E MV IES IMV' phspline planar --minimize =
  offers 'bezier' phspline planar --convert =
  offers 'true false' phspline planar --closed =
  offers 'data/README' phspline planar --closed data/R
  offers 'knots=' phspline planar --sweep k
  offers 'g1 g1-pair g1-auto g1-fair g2' phspline tc --mode = g
  offers 'curve=' phspline tc --override cu
  offers 'frenet erf rmf' phspline arclength --frame =
  offers 'data/README' phspline verify --problems = data/R
  offers '' phspline verify --set ''
  offers '' phspline planar --jobs ''
fi
exit "$bad"
