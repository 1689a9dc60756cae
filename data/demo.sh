#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The program's main job on real data: the outline of Sicily as one closed
# C2 Pythagorean-hodograph quintic spline with the exact offset 10 km out at
# sea.  Shows the curve, its length, its certificate and what to try next.
#
#   sh data/demo.sh [PATH/TO/phspline]     (default: ./phspline)
#
# Writes the folder demo-output here.  Needs POSIX sh, awk, sed, tr.
set -eu

program=${1:-./phspline}
data=$(dirname "$0")
out=demo-output
points=$data/coastline.csv
job="planar $points --closed --offset=-10"

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
  "$program" planar "$points" --closed --offset=-10 "$@" -o "$out/$file" \
    2>"$out/messages.txt" || {
    status=$?
    cat "$out/messages.txt" >&2
    echo "demo.sh: $program $job failed with exit status $status" >&2
    exit 1
  }
}
run sicily-control-points.csv --format=csv --table=control-points
run sicily-lengths.csv --format=csv --table=lengths
run sicily-offsets.csv --format=csv --table=offsets
run sicily.json

# certificate NAME TEXT: a number from the result's diagnostics.
certificate() {
  tr -s '{},' '[\n*]' <"$out/sicily.json" | sed -n "s/^\"$1\"://p" |
    awk -v text="$2" 'NR == 1 { printf "  %-24s %s\n", text, $1 }'
}

echo "The coast of Sicily (Natural Earth, 1:50m) as one C2 curve:"
echo
echo "  $program $job -o $out/sicily.json"
echo
awk -f "$data/picture.awk" -v style=$style -v unit=km \
  "$out/sicily-control-points.csv" "$out/sicily-offsets.csv" "$points"
echo "solid: the spline; dotted: its offset, 10 km out at sea"
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
    gap = sum / exact - 1
    row = "  %-24s %s\n"
    printf row, "points", n
    printf row, "length of the polygon", sprintf("%.6f km", polygon)
    printf row, "length of the curve", exact " km (closed form)"
    printf row, "  by quadrature", \
      sprintf("the same to %.1e, relative", gap < 0 ? -gap : gap)
  }' "$out/sicily-lengths.csv" "$out/sicily-control-points.csv" "$points"
certificate iterations "Newton iterations"
certificate residual "residual"
certificate interpolation_error "interpolation error"
certificate pythagorean_error "Pythagorean error"
certificate continuity_error "C2 continuity error"
certificate length_error "length error"
if [ -s "$out/messages.txt" ]; then
  echo
  echo "The program says ($out/messages.txt):"
  sed 's/^/  /;3q' "$out/messages.txt"
fi

cat <<EOF

All of it is in $out/: sicily.json, sicily-control-points.csv,
sicily-lengths.csv, sicily-offsets.csv.  Try next:

  $program planar $points --closed --spacing=10 -f csv --table=samples
  $program planar $points --closed --offset=-5,-22.224 -o $out/limits.json
  $program planar $data/gonzalez-2018.jsonl --pretty
  $program planar $data/spiral.csv -f csv --table=control-points |
    LC_ALL=C awk -f $data/picture.awk -v style=$style - $data/spiral.csv
EOF
