# SPDX-License-Identifier: GPL-3.0-or-later
#
# Spatial data that formulas divide by: parallel and opposite tangents, straight
# and plane data, a vector d of 0, huge and tiny sizes.  All have a curve, whose
# certificate the program has checked itself.
. "$srcdir/tests/cli/lib.sh"

criteria='cc hc bv zero F1 F2 F3'

# curves NAME MEMBERS [CRITERION...]: there is a curve by each criterion, in each
# basis; where every step takes long, by one in five of these pairs.
curves() {
  called=$1 text=$2
  shift 2
  if [ $# -eq 0 ]; then
    # shellcheck disable=SC2086
    set -- $criteria
  fi
  for criterion; do
    for basis in ph atph; do
      one_in 5 || continue
      alpha=
      case $basis$criterion in
      atph[chbz]*) alpha=',"alpha":1.5' ;;
      esac
      feed "{$text,\"axis\":\"bisector\",\"basis\":\"$basis\",
        \"criterion\":\"$criterion\"$alpha}" spatial-hermite -q
      expect "$called, $basis, $criterion" 0
      true_that "$called, $basis, $criterion: a line of JSON" json lines out
    done
  done
}

# points_of FILE: the control points of the last run, one on a line
points_of() {
  json get segments out | sed 's/"control_points":\[\[/\n&/g' |
    sed -n 's/^"control_points":\[\[\([^"]*\)\]\],".*/\1/p' |
    sed 's/\],\[/\n/g' >"$1"
}

# flat NAME MEMBERS: the curve stays in the plane z = 0, exactly
flat() {
  feed "{$2}" spatial-hermite -q
  expect "$1" 0
  points_of flat.points
  awk -F, '$3 != "0" { bad = 1 } END { exit bad || NR < 6 || NR % 6 }' \
    flat.points
  equal "$1: z is 0" 0 $?
}

# line NAME MEMBERS: the curve is a straight line, once from end to end
line() {
  feed "{$2}" spatial-hermite -q
  expect "$1" 0
  points_of line.points
  awk -F, '
    { for (c = 1; c < 4; c++) p[NR, c] = $c }
    END {
      if (NR != 6) exit 1
      for (c = 1; c < 4; c++) {
        d[c] = p[6, c] - p[1, c]
        size += d[c] ^ 2
      }
      for (i = 2; i <= 6; i++) {
        along = 0
        away = 0
        for (c = 1; c < 4; c++) {
          leg = p[i, c] - p[i - 1, c]
          along += leg * d[c] / size
          away += (p[i, c] - p[1, c] - (sum + along) * d[c]) ^ 2 * (c == 3)
        }
        sum += along
        if (along <= 0 || away > 1e-28 * size) exit 1
      }
    }' line.points
  equal "$1: straight on" 0 $?
}

# ---- straight data -----------------------------------------------------------

for criterion in $criteria; do
  line "two points, $criterion" \
    "\"points\":[[1,2,3],[4,6,3]],\"criterion\":\"$criterion\""
  case $criterion in
  F*)
    line "two points, atph, $criterion" "\"points\":[[1,2,3],[4,6,15]],
      \"basis\":\"atph\",\"criterion\":\"$criterion\""
    get diagnostics.functional |
      holds "two points, atph, $criterion: no curvature" 'n == 1 && x[1] < 1e-20'
    ;;
  esac
done
curves 'points on a line' '"points":[[0,0,0],[1,1,1],[2,2,2],[4,4,4]]'
curves 'points on a line, then not' '"points":[[0,0,0],[1,0,0],[2,0,0],[3,1,1]]'
back='"points":[[0,0,0],[2,0,0]],"tangents":[[-1,0,0],[-1,0,0]]'
curves 'a line with both tangents backwards' "$back"
curves 'a line with one tangent backwards' \
  '"points":[[0,0,0],[2,0,0]],"tangents":[[-1,0,0],[1,0,0]]'
curves 'a line with the other tangent backwards' \
  '"points":[[0,0,0],[1,2,2]],"tangents":[[1,2,2],[-1,-2,-2]]'
curves 'a line with derivatives of 1e3 chords' \
  '"points":[[0,0,0],[1,2,2]],"derivatives":[[1e3,2e3,2e3],[1e3,2e3,2e3]]'
curves 'a line and one tangent normal to it' \
  '"points":[[0,0,0],[1,2,2]],"tangents":[[1,2,2],[2,-1,0]]'
for more in '' ',"closed":true' ',"tension":0.5'; do
  curves "data that turn back $more" \
    "\"points\":[[0,0,0],[1,2,2],[0,0,0],[0,0,1]]$more" cc hc bv F1
done
curves 'to and fro on a line' '"points":[[1,0,0],[0,0,0],[2,0,0],[0.5,0,0]]' \
  cc hc bv F1

# ---- the plane z = 0 ---------------------------------------------------------

flat 'a line in the plane' '"points":[[0,0],[2,1]]'
flat 'tangents to one side' \
  '"points":[[0,0],[2,0]],"tangents":[[1,1],[1,-1]]'
flat 'tangents to both sides' \
  '"points":[[0,0],[2,0]],"tangents":[[1,1],[1,1]]'
flat 'equal tangents, across' '"points":[[0,0],[2,0]],"tangents":[[0,1],[0,1]]'
flat 'opposite tangents, across' \
  '"points":[[0,0],[2,0]],"tangents":[[0,1],[0,-1]]'
flat 'opposite tangents, along' \
  '"points":[[0,0],[2,1]],"tangents":[[-2,-1],[2,1]]'
flat 'equal tangents, backwards' \
  '"points":[[0,0],[2,1]],"tangents":[[-2,-1],[-2,-1]]'
flat 'd is 0' '"points":[[0,0],[1,0]],"derivatives":[[3,0],[3,0]]'
flat 'derivatives too long for d to point ahead' \
  '"points":[[0,0],[1,0]],"derivatives":[[4,0],[4,0]]'
flat 'to and fro' '"points":[[1,0],[0,0],[2,0],[0.5,0]]'
flat 'to and fro, equal steps' '"points":[[0,0],[1,1],[0,0],[1,1]]'
flat 'a square' '"points":[[0,0],[1,0],[1,1],[0,1]],"closed":true'
flat 'far from the origin' \
  '"points":[[1e6,2e6],[1000001,2000001],[1000003,2000001]]'

# ---- parallel and opposite tangents ------------------------------------------

curves 'equal tangents, not along the chord' \
  '"points":[[0,0,0],[1,0,0]],"tangents":[[1,1,1],[1,1,1]]'
curves 'equal tangents, normal to the chord' \
  '"points":[[0,0,0],[1,0,0]],"tangents":[[0,0,1],[0,0,1]]'
curves 'opposite tangents' \
  '"points":[[0,0,0],[1,0,0]],"tangents":[[1,1,1],[-1,-1,-1]]'
curves 'opposite tangents, normal to the chord' \
  '"points":[[0,0,0],[1,0,0]],"tangents":[[0,3,4],[0,-3,-4]]'
for angle in 1e-4 1e-8 1e-11 1e-12 1e-13 1e-16 1e-160 1e-300; do
  curves "tangents nearly equal, $angle" \
    "\"points\":[[0,0,0],[1,2,0]],\"tangents\":[[0,0,1],[0,$angle,1]]" \
    cc hc bv F1
  curves "tangents nearly opposite, $angle" \
    "\"points\":[[0,0,0],[1,2,0]],\"tangents\":[[0,0,1],[$angle,0,-1]]" \
    cc hc bv F1
  curves "tangents nearly along the chord, $angle" \
    "\"points\":[[0,0,0],[1,0,0]],\"tangents\":[[1,$angle,0],[1,0,$angle]]" \
    cc hc bv F1
done

# ---- d = 0 -------------------------------------------------------------------

# Derivatives that are three, or with b = 0 six, times the chord.
curves 'd is 0, as cc chooses b' \
  '"points":[[0,0,0],[1,2,2]],"derivatives":[[3,6,6],[3,6,6]]'
six='"points":[[0,0,0],[1,0,0]],"derivatives":[[6,0,0],[6,0,0]]'
for phi in 0 1; do
  feed "{$six,\"axis\":\"bisector\",\"angles\":[$phi,0]}" spatial-hermite
  expect "d is 0, with the angle $phi" 0
  points_of zero.points
  printf '%s\n' 0,0,0 1.2,0,0 -0.6,0,0 1.6,0,0 -0.2,0,0 1,0,0 >want
  numbers "d is 0, with the angle $phi: the angle is without effect" 1e-14 \
    want zero.points
done
for speed in 2.9999999 2.999999999999999 3.000000000000001 3.0000001; do
  curves "d is nearly 0, $speed" "\"points\":[[0,0,0],[1,0,0]],
    \"derivatives\":[[$speed,0,0],[$speed,0,0]]" cc hc bv F1
done

# ---- uneven data -------------------------------------------------------------

for ratio in 2e-14 1e-10 1e-5 1e5 1e10 1e13; do
  curves "one derivative of $ratio" "\"points\":[[0,0,0],[1,0,0]],
    \"derivatives\":[[$ratio,0,0],[0,1,1]]" cc hc bv
  curves "one interval of $ratio" "\"points\":[[0,0,0],[1,0,0],[1,1,0]],
    \"tangents\":[[1,1,0],[0,1,1],[0,0,1]],\"knots\":[-$ratio,0,1]" cc hc bv
done
curves 'a chord of 1e-10 among chords of 1' \
  '"points":[[0,0,0],[1,0,0],[1,1e-10,0],[1,1,1]]' cc hc bv F1

# A chord too short to make a difference to the sum of those before it.
feed '{"points":[[1,0,0],[0,0,0],[0,1e-20,0]]}' spatial-hermite -q
expect 'knots would not increase' 1 'phspline: -:1: record 1: points[2]: is so near to points[1] that their chordal knots are the same; "knots" can be given, and --merge=D joins points nearer than D [coincident-points]'

# ---- sizes -------------------------------------------------------------------

shape='0,0,0
1,2,0
3,1,1
2,-1,4'
printf '%s\n' "$shape" >1.csv
two_steps='
  BEGIN { half = int(p / 2); first = 2 ^ half; second = 2 ^ (p - half) }
  function times(x) { return x * first * second }'
for more in '--criterion=cc' '--criterion=hc' '--criterion=bv' \
  '--criterion=F1' '--criterion=zero --axis=x' \
  '--basis=atph --alpha=1 --criterion=cc' '--criterion=cc --closed'; do
  # shellcheck disable=SC2086
  run spatial-hermite -q -f csv $more 1.csv
  mv out base
  for power in -1040 -900 -302 -2 -1 1 2 302 900 1018; do
    one_in 3 || continue
    # in two steps: neither overflows
    awk -F, -v p="$power" "$two_steps"'
      { printf "%.17g,%.17g,%.17g\n", times($1), times($2), times($3) }' 1.csv \
      >s.csv
    # shellcheck disable=SC2086
    run spatial-hermite -q -f csv $more s.csv
    expect "times 2^$power, $more" 0
    for file in base out; do
      if [ "$file" = out ]; then back=$((-power)); else back=0; fi
      awk -F, -v p="$back" "$two_steps"'
        NR > 1 { printf "%.17g %.17g %.17g\n", times($4), times($5), times($6) }
        ' "$file" | sed 's/-0 /0 /g; s/-0$/0/' >"$file.numbers"
    done
    # Subnormal numbers have few digits, odd powers roots that are rounded; a
    # minimum is known to half of the digits.
    case $more,$power in
    *F1,-1040 | *F1,-1 | *F1,1) tolerance=1e-7 ;;
    *,-1040) tolerance=1e-9 ;;
    *,-1 | *,1) tolerance=1e-15 ;;
    *) tolerance=0 ;;
    esac
    numbers "times 2^$power, $more: the same curve" $tolerance base.numbers \
      out.numbers
  done
done

# Tangents almost parallel and equally long: which of two curves in the plane is
# nearer to them is told from both ends alike.
echo '{"points":[[0,0,0],[0.5762,-0.21853,0]],"criterion":"hc",
"tangents":[[0.93,-0.36,0],[0.935,-0.354577,0]]}' >in
run spatial-hermite -q in
jq -c '.segments[0].control_points[]' out >ahead
echo '{"points":[[0.5762,-0.21853,0],[0,0,0]],"criterion":"hc",
"tangents":[[-0.935,0.354577,0],[-0.93,0.36,0]]}' >in
run spatial-hermite -q in
jq -c '.segments[0].control_points | reverse | .[]' out >back
numbers 'almost symmetric data, from the other end' 1e-14 ahead back

# Points nearly on a line, whose tension is too large: to which side of it the
# curve leaves depends on no axis.
points='[[0,0,0],[-0.3425,-0.4185,-0.6837],[-7.2517,-8.861,-14.476],[-8,-10,-16]]'
for move in '[.[0],.[1],.[2]]' '[-.[0],.[1],.[2]]' '[.[1],.[2],.[0]]' \
  '[.[1],.[0],.[2]]' '[.[2],-.[1],.[0]]'; do
  jq -cn "{points: ($points | map($move)), tension: [6,0.5,1]}" >in
  run spatial-hermite -q in
  jq -c '.segments[].length' out >"lengths${move##*,}"
  numbers "nearly a line, $move" 1e-12 "lengths.[2]]" "lengths${move##*,}"
done

# A curve that passes a straight place: |kappa| is 1.5e-10 there and turns within
# 1e-7 of the segment, which is 2e-6 of F2.
accepted spatial-hermite 'almost an inflection' <<'EOF'
{"points":[[0,0,0],[0.5807,-1.3551,0]],"basis":"atph","alpha":[2],
"derivatives":[[1.18694,-2.7698,-0.00001],[0.83155850712,-1.94049411572,0]],
"criterion":"zero"}
EOF
equal 'almost an inflection: F2, by 40 digits' true \
  "$(jq '(.diagnostics.F2 / 1.02528094524131748e-5 - 1 | fabs) < 1e-9' any.result)"

# Where the least F1 keeps its shape or not by rounding, data at any size have
# the same tension: the same factors are tried.
for size in 1 3 7.7 1e-5; do
  jq -cn --argjson size "$size" '
    {points: [[1,0.898,0.765],[2,0.873,0.17]],
     derivatives: [[0.747,0.087,-0.41],[0.038,0.054,0.087]]}
    | map_values(map(map(. * $size)))
    + {shape: true, basis: "atph", criterion: "F1"}'
done >in
run spatial-hermite -q in
equal 'tensions at any size' 1 \
  "$(jq '.segments[0].tension' out | sort -u | wc -l)"
