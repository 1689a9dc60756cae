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
# a curvature that is no number any more
cat >in <<'EOF'
{"points":[[0,0],[1.0856887114877295e-297,6.502109995723391e-297],
[1.4924018285761346e-297,8.937884998291382e-297],
[2.5584006089071096e-297,1.524611617655033e-296],
[3.48901275518057e-297,2.0753173645906414e-296]],"mode":"g2"}
EOF
run tc -q in
mv out tiny
run verify -q --problems=in tiny
equal 'a curvature beyond all numbers' '[[0,null],"ok"]' \
  "$(cat tiny out | jq -cs '[.[0].joints[].curvature, .[1].status]')"

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
