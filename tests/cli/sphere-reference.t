# SPDX-License-Identifier: GPL-3.0-or-later
#
# The 20 cases of [IOR15, ch. 5]: the tensions of the thesis to the last digit,
# and the curves of both models as an independent program has found them.
#
# A problem of tests/vectors/sphere.jsonl brings what is known about it in
# `meta', which comes back with its result:
#   indicators   of its nodes
#   tensions     that the rule of the thesis leads to
#   tension_sum  the least sum known that keeps the shape, of the model `exact'
#                with ends at rest and epsilon 1e-3
#   MODEL_nu0, MODEL_final   the curve without and, where they are not all 0,
#                with these tensions: its length, curvatures on both sides of
#                the nodes between the ends and speeds there, of the first 6,
#                the largest jump of curvature of all, the middle of segment 1
. "$srcdir/tests/cli/lib.sh"

cat >judge-sphere.awk <<'EOF'
# The segments: points[k, 1] to points[k, 12], spacing[k]; returns how many.
function read_segments(text,   k, c, p, at) {
  for (k = 0; match(text, /"interval":[^}]*"length"/); k++) {
    at = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    gsub(/"[a-z_]*"/, "", at)
    if (numbers(at, p) != 14) return -1
    spacing[k] = p[2] - p[1]
    for (c = 1; c <= 12; c++) points[k, c] = p[2 + c]
  }
  return k
}
# The samples: curvature[k, t] and middle[1] to middle[3] of segment 1.
function read_samples(text,   at, p, c, has) {
  while (match(text, /\{"segment":[^}]*\}/)) {
    at = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    has = at ~ /"curvature"/
    gsub(/"[a-z_]*"/, "", at)
    # segment, t, s, point, tangent, curvature if it has one, lonlat
    numbers(at, p)
    if (p[1] == 1 && p[2] == 0.5)
      for (c = 1; c <= 3; c++) middle[c] = p[3 + c]
    if (has) curvature[p[1], p[2]] = p[10]
  }
}
# The angle between control points i and i + 1 of segment k.
function leg(k, i,   c, apart, sum, a, b) {
  apart = sum = 0
  for (c = 1; c <= 3; c++) {
    a = points[k, 3 * i + c]
    b = points[k, 3 * i + 3 + c]
    apart += (a - b) ^ 2
    sum += (a + b) ^ 2
  }
  return 2 * atan2(sqrt(apart), sqrt(sum))
}
function judge_curve(segments, samples,   n, i, k, jump, most, wide, sign) {
  n = read_segments(segments)
  delete curvature
  read_samples(samples)
  if (n < 3) wanted("segments", n, "3 or more")
  near("length", $6, $7, 1e-10)
  k = numbers($8, left)
  if (k != numbers($9, right) || k != numbers($10, speed) ||
      k != (n > 7 ? 6 : n - 1))
    wanted("nodes", n - 1, k)
  for (i = 1; i <= k; i++) {
    near("curvature before node " i, curvature[i - 1, 1], left[i], 1e-8)
    near("curvature after node " i, curvature[i, 0], right[i], 1e-8)
    near("speed before node " i, 3 * leg(i - 1, 2) / spacing[i - 1], speed[i],
      1e-9)
    near("speed after node " i, 3 * leg(i, 0) / spacing[i], speed[i], 1e-9)
  }
  most = wide = 0
  for (i = 1; i < n; i++) {
    jump = curvature[i, 0] - curvature[i - 1, 1]
    if (jump < 0) jump = -jump
    if (!(jump <= most)) most = jump
    sign = curvature[i, 0] < 0 ? -1 : 1
    if (!(sign * curvature[i, 0] <= wide)) wide = sign * curvature[i, 0]
  }
  if (model == "exact") at_most("jump of curvature", most, 1e-9 * (1 + wide))
  else near("jump of curvature", most, $11, 1e-6)
  numbers($12, known)
  for (i = 1; i <= 3; i++)
    close_to("middle of segment 1", middle[i], known[i], 1e-10)
}
BEGIN { FS = "\t" }
{
  why = ""
  if ($2 != $3) wanted("indicators", $2, $3)
  if (!is_number($4) || $4 != (final ? $5 : zeros($5)))
    wanted("tensions", $4, final ? $5 : zeros($5))
  if ($7 != "absent") { judge_curve($13, $14); judged++ }
  gsub(/"/, "", $1)
  name = model (final ? ", the tensions of the thesis: " : ", no tension: ") $1
  print (why == "" ? "ok " : "not ok ") name (why == "" ? "" : ": " why)
}
function zeros(list) {
  gsub(/[0-9]+/, "0", list)
  return list
}
END {
  print (NR == 20 && judged == curves ? "" : "not ") "ok " model ": " curves \
    " curves of 20 cases"
}
EOF

# judge MODEL STATE CURVES OPTION...: all cases, so many of them with a curve
judge() {
  model=$1 state=$2 curves=$3
  shift 3
  run sphere -q --model="$model" --ends=rest --sample=2 "$@" \
    "$srcdir/tests/vectors/sphere.jsonl"
  expect "$model, $state" 0
  known=meta.${model}_$state
  final=0
  if [ "$state" = final ]; then
    final=1
  fi
  table id indicators meta.indicators tensions meta.tensions length \
    "$known.length" "$known.kg_left" "$known.kg_right" \
    "$known.speed_at_nodes" "$known.max_kg_jump" "$known.midpoint_seg1" \
    segments samples |
    awk -v model="$model" -v final="$final" -v curves="$curves" \
      -f "$srcdir/tests/cli/judge.awk" -f judge-sphere.awk
}

for model in nielson exact; do
  judge "$model" nu0 20 --shape=false
  judge "$model" final 8 --criterion=legacy --increase=plus:10 --epsilon=1e-3
done

# ---- the smallest tensions ---------------------------------------------------

cat >judge-sum.awk <<'EOF'
BEGIN { FS = "\t" }
{
  why = ""
  at_most("curvature_jump", $2, 1e-10)
  if ($3 != "true") wanted("shape_ok", $3, "true")
  if ($5 != "absent") { at_most("tension_sum", $4, 1.02 * $5); sums++ }
  gsub(/"/, "", $1)
  name = title ": " $1
  print (why == "" ? "ok " : "not ok ") name (why == "" ? "" : ": " why)
}
END {
  print (NR == 20 && sums == 8 ? "" : "not ") "ok " title ": 20 cases, " \
    "8 with a sum"
}
EOF

# smallest TITLE OPTION...
smallest() {
  title=$1
  shift
  run sphere -q "$@" "$srcdir/tests/vectors/sphere.jsonl"
  expect "$title" 0
  table id diagnostics.curvature_jump diagnostics.shape_ok \
    diagnostics.tension_sum meta.tension_sum |
    awk -v title="$title" -f "$srcdir/tests/cli/judge.awk" -f judge-sum.awk
}

smallest 'by default'
smallest 'ends at rest, epsilon 1e-3' --ends=rest --epsilon=1e-3
