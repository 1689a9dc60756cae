# SPDX-License-Identifier: GPL-3.0-or-later
#
# Cubics with continuous curvature: tc --mode=g2.
#
# A problem of tests/vectors/tc-g2.jsonl brings in `meta' what an independent
# program has found: how many segments, joints where the curvature jumps and
# points that were added, lengths, and the angles of the tangents where segments
# begin; or the error.  Tolerances: lengths 1e-10, angles 1e-9.
# shellcheck disable=SC2016  # programs of jq
. "$srcdir/tests/cli/lib.sh"

# ---- reference cases -----------------------------------------------------------

cat >judge.jq <<'EOF'
def distance: (. + 3.141592653589793) as $x |
  $x - 6.283185307179586 * ($x / 6.283185307179586 | floor) -
    3.141592653589793 | fabs;
def largest: if length > 0 then max else 0 end;
.meta as $m |
if $m.error then .error.code == $m.error
else
  (.segments | length) == $m.segments and
  (.joints // [] | length) == $m.joints and
  (.auxiliary // [] | length) == $m.auxiliary_points and
  ((.length / $m.length - 1) | fabs) < 1e-10 and
  ([range($m.segments) as $i | .segments[$i].length - $m.lengths[$i] | fabs] |
    largest) < 1e-10 * $m.length and
  ([range($m.segments) as $i | .segments[$i].control_points |
    atan2(.[1][1] - .[0][1]; .[1][0] - .[0][0]) - $m.tangent_angles[$i] |
    distance] | largest) < 1e-9 and
  .diagnostics.g2_error < 1e-10
end | if . then "right" else "wrong" end
EOF
while read -r problem; do
  id=$(printf '%s' "$problem" | jq -r .id)
  feed "$problem" tc --quiet
  equal "$id" '"right"' "$(jq -f judge.jq out)"
done <"$srcdir/tests/vectors/tc-g2.jsonl"
run tc -q "$srcdir/tests/vectors/tc-g2.jsonl"
mv out all
run verify --problems="$srcdir/tests/vectors/tc-g2.jsonl" all
equal 'verify agrees' 'ok' "$(jq -r .status out | sort -u)"

# ---- the record ----------------------------------------------------------------

zigzag='{"points":[[0,0],[2,1],[3,0],[5,0.5],[6,0]],"mode":"g2"}'
feed "$zigzag" tc
expect 'joints are told' 0 'phspline: -:1: record 1: warning: the curvature jumps at 2 joints, where the curve turns to the other side or is straight; the first is before segment 2 [g1-joints]'
equal 'joints' '[[2,"inflection",true],[4,"inflection",true]]' \
  "$(jq -c '[.joints[] | [.segment, .kind, .curvature[0] * .curvature[1] < 0]]' out)"
equal 'intervals' '[[0,0],[1,2],[3,4],[5,5]]' \
  "$(jq -c '[.intervals[].segments]' out)"
cp out good
run verify good
expect 'a record alone is verified' 0
feed '{"points":[[0,0],[1,0],[2,0],[3,1],[3,2]]}' tc -q --mode=g2
equal 'a line and a curve' '[[2,"straight",0]]' \
  "$(jq -c '[.joints[] | [.segment, .kind, .curvature[0]]]' out)"
feed '{"points":[[0,0],[1,0],[0.5,0.1]]}' tc --mode=g2
expect 'points are added' 0 'phspline: -:1: record 1: warning: 2 points were added where the data turn too much for one cubic, the first before segment 1 [auxiliary-points]'

# tamper NAME FILTER WANTED
tamper() {
  jq -c "$2" good >bad
  run verify -q bad
  equal "$1" "$3" "$(jq -r '.error.message' out | cut -c 1-"${#3}")"
}
tamper 'a joint that is not told' 'del(.joints[0])' \
  'segments[2].control_points let the curvature jump'
tamper 'no joint is told' 'del(.joints)' \
  'segments[4].control_points let the curvature jump'
tamper 'a curvature' '.joints[1].curvature[0] *= 1.001' \
  'joints[1] has a curvature'
tamper 'a place' '.joints[1].point[0] += 1e-6' 'joints[1] is not where'
tamper 'one joint too many' '.joints += [.joints[1] | .segment = 5]' \
  'joints[2] is not where'
tamper 'their order' '.joints |= [.[1], .[0]]' 'joints are not segments in their order'
tamper 'a point that was not added' '.auxiliary += [5, 5]' 'auxiliary'

# ---- ends ----------------------------------------------------------------------

arc='{"points":[[1,0],[0.8,0.6],[0.28,0.96],[-0.352,0.936]],"mode":"g2"}'
feed "$arc" tc -q
cp out circle
feed "$arc" tc -q --ends=smooth
true_that 'ends of a circle are smooth' jq -e --slurpfile c circle \
  'def uneven: .segments[0].length - .segments[1].length | fabs;
   uneven < 0.5 * ($c[0] | uneven)' out
feed '{"points":[[0,0],[1,0]],"end_tangents":[[1,1],[1,-1]]}' tc -q --mode=g2
equal 'two points, one cubic' '[[1,1]]' \
  "$(jq -c '[.segments[].control_points | [.[1][1] / .[1][0],
    .[2][1] / (1 - .[2][0])] | map(. * 1e12 | round / 1e12)]' out)"
feed '{"points":[[0,0],[1,0]],"end_tangents":[[1,1],[1,1]]}' tc -q --mode=g2
equal 'two points, a bend' '[2,[[1,"inflection"]]]' \
  "$(jq -c '[(.segments | length), [.joints[] | [.segment, .kind]]]' out)"
feed '{"points":[[0,0],[1,0],[2,0]],"end_tangents":[[1,1],[1,0]]}' tc -q \
  --mode=g2
equal 'a line that a tangent leaves' '[[1,"inflection"],[2,"straight"]]' \
  "$(jq -c '[.joints[] | [.segment, .kind]]' out)"
# curvatures that are no numbers any more
echo '{"points":[[0,0],[2e-310,1e-310],[3e-310,0],[5e-310,5e-311],[6e-310,0]],
"mode":"g2"}' | tr -d '\n' >in
run tc -q in
mv out tiny
run verify -q --problems=in tiny
equal 'a curvature beyond all numbers' '[[null,null],"ok"]' \
  "$(cat tiny out | jq -cs '[[.[0].joints[].curvature], .[1].status]')"

# the turn at the point is rounding, or none, of either sign
for y in 0 3e-13 -3e-13; do
  # both tangents leave the line to one side, both over: one at a right angle
  echo '{"points":[[0,0],[1,0],[2,'$y']],"end_tangents":[[0,1],[1,-0.2]]}' >in
  echo '{"points":[[0,0],[1,0],[2,'$y']],"end_tangents":[[1,1],[1,2]]}' >>in
  run tc -q --mode=g2 in
  equal "a line that two tangents leave, $y" \
    '["ok",["inflection","inflection"]]
["ok",["inflection","straight","inflection"]]' \
    "$(jq -c '[.status, [.joints[]?.kind]]' out)"
done

# A road on a map: straight for 19 m, a quarter of a circle, straight.  Rounding of
# the coordinates turns the straight parts by 1e-9.
awk 'BEGIN {
  for (j = 0; j < 4; j++) {
    c = cos(0.1 + 0.7 * j); s = sin(0.1 + 0.7 * j); pi = 4 * atan2(1, 1)
    printf "%s{\"points\":[", j ? "\n" : ""
    for (i = 0; i < 70; i++) {
      x = i < 20 ? i : i < 50 ? 19 + 20 * sin((i - 19) / 60 * pi) : 39
      y = i < 20 ? 0 : i < 50 ? 20 - 20 * cos((i - 19) / 60 * pi) : i - 29
      printf "%s[%.17g,%.17g]", i ? "," : "", 691000 + c * x - s * y,
        5335000 + s * x + c * y
    }
    printf "]}"
  }
  print ""
}' >in
run tc -q in
equal 'straight but for rounding' '["straight","straight"] true' \
  "$(jq -r '([.joints[].kind] | tostring) + " " +
     (.diagnostics.rotation_index * 4 - 1 | fabs < 1e-7 | tostring)' out | sort -u)"
mv out road
run verify -q --problems=in road
equal 'straight but for rounding, verified' 'ok' "$(jq -r .status out | sort -u)"

# Lines that the curve leaves before their ends: the turns there are sharp beside
# those that follow.  The data turn to the other side twice, and the curve where it
# leaves each line.
cat >in <<'END'
{"id":"S","points":[[0,0],[1,0],[2,0],[3,0],[3.8,0.7],[4.5,0.71],[5.2,0.7],[6,0],[7,0],[8,0],[9,0]]}
END
run tc -q in
mv out lines
equal 'a line is left' '[["straight","inflection","inflection","inflection","inflection","straight"],true]' \
  "$(jq -c '[[.joints[].kind], (.auxiliary | length == 0)]' lines)"
run verify -q --problems=in lines
equal 'a line is left, verified' 'ok' "$(jq -r .status out)"

# ---- pairs of the mode spline ---------------------------------------------------

# A flat point between two lines: with the same curvature on both sides it would
# be nearly a cusp.  Points that are nearly the same; the first of these, and a
# corner, have no need.
cat >in <<'EOF'
{"id":"flat","points":[[-2,0],[-1,0],[0,0],[1,0.7],[2,1.42],[3,2.1],[4,2.1],[5,2.1],[6,2.1]],"mode":"g2"}
{"id":"near","points":[[0,0],[1,0],[1,1e-7],[0.2,0.5],[1.3,0.7],[1.3000001,0.7],[0,2]],"mode":"g2"}
{"id":"uneven, closed","points":[[0,0],[1,0],[1.0000001,0.0000002],[0.9999999,0.0000003],[1,2],[3,2]],"closed":true,"mode":"g2"}
{"id":"corner","points":[[0,0],[1,0],[2,0],[2,1],[2,2]],"mode":"g2"}
EOF
run tc in
mv out pairs
run verify -q --problems=in pairs
equal 'pairs are verified' 'ok' "$(jq -r .status out | sort -u)"
jq -c 'del(.mode) | .mode = "spline"' in >spline.in
run tc -q spline.in
true_that 'none bends much more than a spline' jq -se --slurpfile g pairs \
  'def f: .diagnostics.energy * .length;
   [., $g] | transpose | all(.[]; (.[1] | f) <= 1.1 * (.[0] | f))' out
equal 'kinds of joints, and warnings' \
  '["flat",[["inflection",3],["pair",2],["straight",2],["tangent",4]],["g1-joints","spline-pairs"]]
["near",[["inflection",2]],["g1-joints","auxiliary-points","uneven-chords"]]
["uneven, closed",[["inflection",1],["pair",3],["tangent",4]],["g1-joints","auxiliary-points","spline-pairs","uneven-chords"]]
["corner",[["inflection",2]],["g1-joints"]]' \
  "$(jq -c '[.id, ([.joints[].kind] | group_by(.) | map([.[0], length])),
    [.warnings[].code]]' pairs)"
head -n 1 pairs >good
tamper 'a tangent that is called an inflection' \
  '(.joints[] | select(.kind == "tangent") | .kind) = "inflection"' 'joints['
feed "$(sed -n 2p in)" tc --auxiliary=never
expect 'no points and pairs' 1 'phspline: -:1: record near: points[2]: begins an interval whose turns are too large for one cubic: points must be added (auxiliary) [infeasible]
phspline: 1 of 1 records failed'
feed '{"points":[[0,0],[1,0],[1.0000001,0.0000002],[1.0000002,0.0000005],[1,2],[3,2]]}' tc --mode=g2
expect 'pairs are told' 0 'phspline: -:1: record 1: warning: the curvature jumps at 1 joint, where the curve turns to the other side or is straight; the first is before segment 6 [g1-joints]
phspline: -:1: record 1: warning: 1 point was added where the data turn too much for one cubic, the first before segment 7 [auxiliary-points]
phspline: -:1: record 1: warning: the curvature jumps in and beside 2 intervals with the cubics of the mode spline, which bend less there; the first cubic is segment 1 [spline-pairs]
phspline: -:1: record 1: warning: of chords beside one another one is 6.32e+06 times as long: the curves of the command planar bend less there [uneven-chords]'

# points that are near for their coordinates: a leg is rounded to nothing, and
# its curvature is not known
cat >near <<'EOF'
{"points":[[1000000.6702985318,999999.12751877],[1000000.669959239,
999999.1276145921],[1000000.6699164831,999999.1274283716],[1000000.6700726834,
999999.1276026004],[1000000.6699183949,999999.1277890798],[1000000.6698520534,
999999.1280323341],[1000000.6698797967,999999.1280278293],[1000001.3680403862,
999999.1269808151]],"mode":"g2"}
EOF
run tc -q near
equal 'a leg of nothing but rounding' ok "$(jq -r .status out)"
mv out made
run verify -q --problems=near made
equal 'a leg of nothing but rounding, verified' ok "$(jq -r .status out)"

# ---- orders of approximation ----------------------------------------------------

# distance N: of a closed curve through N points of an ellipse, from it
distance() {
  awk -v n="$1" 'BEGIN {
    for (i = 0; i < n; i++) {
      t = i * 8 * atan2(1, 1) / n
      printf "%.17g,%.17g\n", 2 * cos(t), sin(t)
    }
  }' >ellipse.csv
  run tc --closed -f csv --table=samples -n 9 ellipse.csv
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    {
      e = sqrt($at["x"] ^ 2 / 4 + $at["y"] ^ 2) - 1
      most = e > most ? e : -e > most ? -e : most
    }
    END { print most }' out
}

echo "$(distance 32) $(distance 64) $(distance 128)" >orders
true_that 'the fourth order' awk '{
  a = log($1 / $2) / log(2); b = log($2 / $3) / log(2)
  exit !(a > 3.9 && a < 4.1 && b > 3.9 && b < 4.1 && $3 < 1e-7)
}' orders

# off N: of curves through N + 1 points of sin(x), from it, but near its ends; the
# farthest of eight whose points lie at other places, as the distance depends on
# where the inflections are between points
off() {
  awk -v n="$1" 'BEGIN {
    for (j = 0; j < 8; j++) {
      printf "%s{\"points\":[", j ? "\n" : ""
      for (i = 0; i <= n; i++) {
        x = 12 * (i + j / 8) / n
        printf "%s[%.17g,%.17g]", i ? "," : "", x, sin(x)
      }
      printf "]}"
    }
  }' >sine
  run tc -q -f csv --table=samples -n 9 sine
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $at["x"] > 1.5 && $at["x"] < 10.5 {
      e = ($at["y"] - sin($at["x"])) / sqrt(1 + cos($at["x"]) ^ 2)
      most = e > most ? e : -e > most ? -e : most
    }
    END { print most }' out
}

echo "$(off 16) $(off 64) $(off 256)" >orders
true_that 'beside inflections the third order' awk '{
  a = log($1 / $2) / log(4); b = log($2 / $3) / log(4)
  exit !(a > 3 && b > 3 && $3 < 2e-6)
}' orders

# ---- long data -----------------------------------------------------------------

# one place is hard for Newton's method: it neither slows down nor changes others
walk 4 20000 >long.csv
walk 4 2000 >short.csv
run tc -q --fields=diagnostics.iterations,warnings,intervals long.csv
equal 'a long walk is one spline' '["ok",["g1-joints"],true]' \
  "$(jq -c '[.status, [.warnings[].code], .diagnostics.iterations < 100]' out)"
jq '.intervals[:1900][].length' out >long
run tc -q --fields=intervals short.csv
jq '.intervals[:1900][].length' out >short
numbers 'its first tenth is that of fewer points' 1e-9 short long

# About an inflection of fine data the equations hold to rounding alone, which a
# step may change for the better, but by little: it is no reason for another.
awk 'BEGIN {
  for (i = 0; i < 2000; i++) {
    t = 6.283185307179586 * (262087 + i) / 1e6
    r = 1 + 0.15 * cos(3 * t + 0.4) + 0.06 * sin(7 * t)
    printf "%.17g,%.17g\n", r * cos(t), r * sin(t)
  }
}' >fine.csv
run tc -q --fields=diagnostics.iterations,status fine.csv
equal 'fine data: few iterations' '["ok",true]' \
  "$(jq -c '[.status, .diagnostics.iterations < 40]' out)"

# ---- errors --------------------------------------------------------------------

feed '{"points":[[0,0],[1,0],[0,1]],"closed":true,"mode":"g2","auxiliary":"never"}' tc
expect 'no points may be added' 1 'phspline: -:1: record 1: points[0]: begins an interval whose turns are too large for one cubic: points must be added (auxiliary) [infeasible]
phspline: 1 of 1 records failed'
feed '{"points":[[0,0],[1,0],[0.5,0]],"mode":"g2"}' tc
expect 'the data turn back' 1 'phspline: -:1: record 1: points[1]: is where the data turn back by 180 degrees: no curve of bounded curvature does [infeasible]
phspline: 1 of 1 records failed'
feed '{"points":[[0,0],[1,0],[1,1]],"end_tangents":[[-1,0],[0,1]],"mode":"g2"}' tc
expect 'a tangent back along the chord' 1 'phspline: -:1: record 1: end_tangents[0]: points back along the chord [infeasible]
phspline: 1 of 1 records failed'
