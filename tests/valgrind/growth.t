# SPDX-License-Identifier: GPL-3.0-or-later
#
# Where segments are cut for a tolerance, twice as many points take twice the
# instructions and little more (in `make valgrind'; counted by callgrind, as
# times depend on what else the machine does): not one segment looks at all
# others, nor at all that was cut before.
set -eu
bad=0
program=${PHSPLINE%.valgrind}

# walk N DIMENSION: a curve of so many points
walk() {
  awk -v n="$1" -v d="$2" 'BEGIN {
    for (i = 0; i < n; i++) {
      printf "%.9f,%.9f", i / 10 + 0.3 * sin(i * i / 9), 20 * sin(i / 10)
      printf "%s\n", d == 3 ? sprintf(",%.9f", 9 * cos(i / 10)) : ""
    }
  }'
}

# count ARGUMENT...: sets counted to the instructions of a run
count() {
  valgrind -q --tool=callgrind --callgrind-out-file=counts "$program" "$@" \
    -q -j 1 >out 2>err || status=$?
  counted=$(awk '/^totals:/ { print $2 }' counts)
}

# grows DIMENSION COMMAND ARGUMENT...
grows() {
  dimension=$1 status=0
  shift
  for n in 2000 4000; do
    walk $n "$dimension" >$n.csv
  done
  count "$@" 2000.csv
  few=$counted
  count "$@" 4000.csv
  many=$counted
  if [ "$status" = 0 ] &&
    awk -v few="$few" -v many="$many" 'BEGIN { exit !(many < 2.3 * few) }'; then
    echo "ok $*"
  else
    echo "not ok $*: status $status, $few and $many instructions"
    bad=1
  fi
}

grows 2 planar --format=svg-path --chord-error=1e-6
grows 2 planar --format=geojson --chord-error=1e-4
grows 2 planar --format=dxf --offset=0.1
grows 2 tc --mode=spline --format=svg-path --offset=0.1
grows 3 spatial-hermite --format=dxf --offset=0.01 --tolerance=1e-4
grows 3 spatial-hermite --convert=bezier --tolerance=1e-4
exit "$bad"
