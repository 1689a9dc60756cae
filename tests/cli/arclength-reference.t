# SPDX-License-Identifier: GPL-3.0-or-later
#
# The curves of [HUA14] with prescribed arc lengths, and those through the same
# data with two segments in each interval.
#
# A problem of tests/vectors/arclength*.jsonl brings what is known about it in
# `meta', which comes back with its result:
#   F, F_at_least    the least value of (19) that is known; no curve has less
#   length           of the curve
#   lengths          of its intervals, or natural_lengths where they are free
#   midpoints        of the intervals of the curve with that F, in the middle of
#                    their parameter: one list for each of the curves that the
#                    symmetry of the data makes of it; scale: what is long there
#   second_order     if it is no minimum
. "$srcdir/tests/cli/lib.sh"

# A curve of less than F is another one, which nothing is known about; there
# are some where the data have several minima.
cat >judge.awk <<'EOF'
# The middles of the intervals of so many segments, into middle[]; returns how
# many coordinates.
function middles(segments, refine, middle,   n, k, c, p, text) {
  for (k = 0; match(segments, /"control_points":[^"]*/); k++) {
    text = substr(segments, RSTART + 17, RLENGTH - 17)
    segments = substr(segments, RSTART + RLENGTH)
    if (numbers(text, p) != 18) return -1
    for (c = 1; c <= 3; c++) {
      if (refine == 2 && k % 2 == 0) middle[++n] = p[15 + c]
      if (refine == 2) continue
      middle[++n] = (p[c] + 5 * p[3 + c] + 10 * p[6 + c]) / 32
      middle[n] += (10 * p[9 + c] + 5 * p[12 + c] + p[15 + c]) / 32
    }
  }
  return n
}
# The distance from the nearest of the curves in `known'.
function away(middle, n, known,   total, i, k, d, worst, best) {
  total = numbers(known, all)
  if (n < 1 || total % n) return "of another number"
  for (i = 0; i < total; i += n) {
    worst = 0
    for (k = 1; k <= n; k++) {
      d = sqrt((middle[k] - all[i + k]) ^ 2)
      if (!(d <= worst)) worst = d
    }
    if (i == 0 || worst < best) best = worst
  }
  return best
}
# The lengths of the intervals, or segments, are the ones in `known', if any.
function compare(known, tol, parts,   n, i, m, text) {
  if (known == "absent") return
  while (match(parts, /"length":[^,}]*/)) {
    text = text " " substr(parts, RSTART + 9, RLENGTH - 9)
    parts = substr(parts, RSTART + RLENGTH)
  }
  n = numbers(known, lengths)
  m = numbers(text, found)
  if (m != n) wanted("lengths", m, n)
  for (i = 1; i <= n; i++) near("length " i, found[i], lengths[i], tol)
}
BEGIN { FS = "\t" }
{
  id = $1; F = $2; second = $3; length_ = $4; segments = $5
  intervals = $6 == "absent" ? segments : $6
  why = ""
  if (second != ($19 == "absent" ? "\"minimiser\"" : $19))
    wanted("second_order", second, $19)
  at_most("F", F, $12 * (1 + 1e-6))
  if (!(F >= $13 * (1 - 1e-9))) wanted("F", F, "at least " $13)
  at_most("interpolation_error", $7, 1e-12)
  at_most("length_error", $8, 1e-12)
  at_most("pythagorean_error", $9, 1e-12)
  at_most("continuity_error", $10, 1e-9)
  if (!($11 > 0)) wanted("min_speed", $11, "more than 0")
  if (F > $12 * (1 - 1e-6)) {
    near("length", length_, $14, 1e-7)
    n = middles(segments, refine, middle)
    if ($17 != "[]") at_most("middles are away by", away(middle, n, $17),
      1e-6 * $18)
  }
  compare($15, 1e-11, intervals)
  # natural ones are as good as the minimum
  compare($16, 1e-6, intervals)
  gsub(/"/, "", id)
  print (why == "" ? "ok " : "not ok ") id (why == "" ? "" : ": " why)
}
END { print (NR == wanted_n ? "" : "not ") "ok all of them" }
EOF

# judge FILE NUMBER REFINE: each of its curves
judge() {
  run arclength -q "$srcdir/tests/vectors/$1"
  expect "$1" 0
  table id diagnostics.F diagnostics.second_order length segments \
    intervals diagnostics.interpolation_error diagnostics.length_error \
    diagnostics.pythagorean_error diagnostics.continuity_error \
    diagnostics.min_speed meta.F meta.F_at_least meta.length meta.lengths \
    meta.natural_lengths meta.midpoints meta.scale meta.second_order |
    awk -v wanted_n="$2" -v refine="$3" -f "$srcdir/tests/cli/judge.awk" \
      -f judge.awk
}

judge arclength.jsonl 47 1
judge arclength-refine.jsonl 40 2

# ---- what has no curve -------------------------------------------------------

# refused NAME CODE SAYS PROBLEM: no curve, and why
refused() {
  feed "$4" arclength
  equal "$1" "1 \"$2\"" "$status $(get error.code)"
  true_that "$1: why" grep -q -e "$3" err
}

steps='"points":[[0,0,0],[1,0,0],[1,1,0],[1,1,1]]'
refused 'a length below its chord' infeasible 'lengths\[1\]: .*chord' \
  "{$steps,\"lengths\":[1.1,0.9,1.1]}"
refused 'one length is its chord' bad-value 'lengths\[1\]: .*chord' \
  "{$steps,\"lengths\":[1.1,1,1.1]}"
refused 'corners, 1e-4 longer than their chords' no-convergence refine=3 \
  "{$steps,\"lengths\":[1.0001,1.0001,1.0001],\"refine\":2}"
for refine in 0 4 1.5; do
  refused "refine $refine" bad-value 'refine: ' \
    "{$steps,\"lengths\":[1.1,1.1,1.1],\"refine\":$refine}"
done
