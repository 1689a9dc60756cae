#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The program's main job on real data: the outline of Sicily as one closed
# C2 Pythagorean-hodograph quintic spline with the exact line 10 km out at sea,
# trimmed.  Shows the curve, its length, its certificate and what to try next.
#
#   sh data/demo.sh [PATH/TO/phspline]     (default: build/plain/phspline)
#
# Writes the folder demo-output here.  Needs POSIX sh, awk, sed, tr.
set -eu

program=${1:-build/plain/phspline}
data=$(dirname "$0")
out=demo-output
points=$data/coastline.csv

# Braille characters where the terminal can show them.
case ${LC_ALL:-${LC_CTYPE:-${LANG:-}}} in
  *[Uu][Tt][Ff]-8* | *[Uu][Tt][Ff]8*) style=braille ;;
  *) style=ascii ;;
esac
LC_ALL=C
export LC_ALL

if ! command -v "$program" >/dev/null 2>&1; then
  echo "demo.sh: no program $program; usage: sh $0 PATH/TO/phspline" >&2
  exit 2
fi
mkdir -p "$out"

# run FILE OPTION...: the job, its result in FILE and its messages beside it.
run() {
  file=$1
  shift
  "$program" planar "$points" --closed --offset=-10 \
    --offset-mode=trimmed "$@" -o "$out/$file" \
    2>"$out/messages.txt" || {
    status=$?
    cat "$out/messages.txt" >&2
    echo "demo.sh: $program failed with exit status $status" >&2
    exit 1
  }
}
run sicily-control-points.csv --format=csv --table=control-points
run sicily-lengths.csv --format=csv --table=lengths
run sicily-offsets.csv --format=csv --table=offsets
run sicily.json

# diagnostic NAME TEXT: a number from the result, rounded.
diagnostic() {
  tr -s '{},' '[\n*]' <"$out/sicily.json" | sed -n "s/^\"$1\"://p" |
    awk -v text="$2" 'NR == 1 { printf "  %-24s %.2g\n", text, $1 }'
}

cat <<EOF
The coast of Sicily (Natural Earth, 1:50m) as one smooth closed curve, with its
exact line 10 km out at sea, nowhere nearer:

    $program planar $points \\
      --closed --offset=-10 --offset-mode=trimmed -o $out/sicily.json

EOF
awk -f "$data/picture.awk" -v style=$style -v cols=42 -v unit=km \
  "$out/sicily-control-points.csv" "$out/sicily-offsets.csv" "$points"
echo "solid: the curve; dotted: its offset"
echo

# The parametric speed |r'| of a Pythagorean-hodograph quintic is a polynomial
# of degree 4, so three Gauss-Legendre nodes a segment give its length: a check
# that shares nothing with the program but the control points.
awk -F, '
  FNR == 1 { file++; header = 1 }
  /^#/ { next }
  header { header = 0; next }
  file == 1 { exact = $6; next }
  file == 2 {
    if ($3 + 0 > 0) { dx[$3] = 5 * ($4 - x); dy[$3] = 5 * ($5 - y) }
    x = $4
    y = $5
    if ($3 + 0 == 5) {
      h = sqrt(15) / 10
      sum += (5 * speed(0.5 - h) + 8 * speed(0.5) + 5 * speed(0.5 + h)) / 18
    }
    next
  }
  { px[++n] = $1; py[n] = $2 }
  function speed(t,   s, a, b) {
    s = 1 - t
    a = s^4 * dx[1] + 4 * s^3 * t * dx[2] + 6 * s^2 * t^2 * dx[3] \
        + 4 * s * t^3 * dx[4] + t^4 * dx[5]
    b = s^4 * dy[1] + 4 * s^3 * t * dy[2] + 6 * s^2 * t^2 * dy[3] \
        + 4 * s * t^3 * dy[4] + t^4 * dy[5]
    return sqrt(a * a + b * b)
  }
  END {
    for (i = 1; i <= n; i++) {
      j = i % n + 1
      polygon += sqrt((px[j] - px[i])^2 + (py[j] - py[i])^2)
    }
    row = "  %-24s %s\n"
    printf row, "points", n
    printf row, "length of the polygon", sprintf("%.9f km", polygon)
    printf row, "length of the curve", sprintf("%.9f km, by formula", exact)
    printf row, "", sprintf("%.9f km, by quadrature in awk", sum)
  }' "$out/sicily-lengths.csv" "$out/sicily-control-points.csv" "$points"
diagnostic iterations "Newton iterations"
echo
echo "What the program finds when it checks the curve, relative to its size:"
echo
diagnostic interpolation_error "distance from the points"
diagnostic continuity_error "jumps of derivatives"
diagnostic pythagorean_error "speed not a polynomial"
diagnostic length_error "error of the length"
if [ -s "$out/messages.txt" ]; then
  echo
  echo "The program says ($out/messages.txt):"
  sed 's/^/  /;3q' "$out/messages.txt"
fi

cat <<EOF

All of it is in $out/: sicily.json and, as tables,
sicily-control-points.csv, sicily-lengths.csv and sicily-offsets.csv.

Try next: the length of every segment,

    $program planar $points \\
      --closed --format=csv --table=lengths

two offsets, the second at the limit of the territorial sea,

    $program planar $points \\
      --closed --offset=-5,-22.224 --offset-mode=trimmed -o $out/limits.json

four published problems, one after another, as indented JSON,

    $program planar $data/gonzalez-2018.jsonl --pretty

a spiral, drawn in the terminal,

    $program planar $data/spiral.csv --format=csv |
      LC_ALL=C awk -f $data/picture.awk -v style=$style - $data/spiral.csv

a spanner from its drawing as cubics, with the path of a cutter,

    $program tc $data/spanner.json \\
      --tolerance=0.01 --offset=-3 --offset-mode=trimmed -o $out/spanner.json

and all options:

    $program help planar
EOF
