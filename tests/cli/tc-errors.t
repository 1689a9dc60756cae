# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every way for a problem of `tc' to be wrong, to the byte, and its warnings.
#
# shellcheck disable=SC2154
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

errors_of tc

# The record of one error, wherever it stands; the rest in one run below.
bad zero-tangent 'tangents[1]' 'must not be zero' \
  '{"points":[[0,0],[3,0]],"tangents":[[1,0],[0,-0.0]]}'

# wrong CODE FIELD MESSAGE PROBLEM: a line of the problems, and what is said
: >wrong.jsonl
: >want
wrong() {
  printf '%s\n' "$4" >>wrong.jsonl
  printf '%s%s [%s]\n' "${2:+$2: }" "$3" "$1" >>want
}

two='"points":[[0,0],[3,0]]'
three='"points":[[0,0],[3,0],[4,2]]'
t2='"tangents":[[1,0],[0,1]]'
d2='"derivatives":[[1,0],[0,1]]'
chord='"mode":"g1-pair","joint":"chord"'
bezier='"curve":[[0,0],[1,1],[2,0]]'

# ---- what is needed ----------------------------------------------------------

wrong missing-field points 'or curve or path must be given' '{"lambda":0.5}'
wrong missing-field points 'or curve or path must be given' "{$t2}"
wrong too-few-points points 'must be at least 2, found 1' \
  '{"points":[[1,2]]}'
wrong too-few-points points \
  'must be at least 3 different points for a closed curve, found 2' \
  "{$two,\"closed\":true}"
for mode in g1 g1-auto; do
  wrong missing-field tangents "is required by the mode $mode" \
    "{$two,\"mode\":\"$mode\"}"
done
wrong missing-field derivatives 'is required by the mode c1' \
  "{$two,\"mode\":\"c1\"}"
wrong missing-field derivatives 'is required by the mode c1' \
  "{$two,$t2,\"mode\":\"c1\"}"
wrong missing-field curve 'is required by the mode approximate' \
  '{"mode":"approximate","tolerance":1}'
wrong missing-field tolerance 'or pieces is required by the mode approximate' \
  "{$bezier}"

# ---- what excludes what ------------------------------------------------------

wrong bad-value tangents 'excludes derivatives: give one of them' \
  "{$two,$t2,$d2}"
wrong bad-value points 'excludes curve: give one of them' \
  "{$two,$bezier,\"tolerance\":1}"
wrong bad-value pieces 'excludes tolerance: give one of them' \
  "{$bezier,\"tolerance\":1,\"pieces\":3}"
wrong bad-value tangents 'are for the modes g1, g1-pair, g1-auto, g1-fair' \
  "{$two,$t2,\"mode\":\"spline\"}"
wrong bad-value derivatives 'are for the mode c1' \
  "{$two,$d2,\"mode\":\"spline\"}"
wrong bad-value curve 'is for the mode approximate' \
  "{$two,$bezier,\"mode\":\"spline\"}"
wrong bad-value tolerance 'is for the mode approximate' "{$two,\"tolerance\":1}"
wrong bad-value pieces 'is for the mode approximate' "{$two,$t2,\"pieces\":1}"
wrong bad-value solutions 'must not be all in the modes approximate and g2' \
  "{$bezier,\"tolerance\":1,\"solutions\":\"all\"}"
for rest in "$d2" "$t2,\"mode\":\"g1\""; do
  wrong bad-value lambda 'is for the modes spline, g1-pair, g1-auto, g1-fair' \
    "{$two,$rest,\"lambda\":0.5}"
done
wrong bad-value lambda 'is for joints that are free' \
  "{$two,$t2,$chord,\"lambda\":0.5}"
wrong bad-value joint 'is for the mode g1-pair' \
  "{$two,$t2,\"joint\":\"chord\"}"
for field in joint_angle joint_position; do
  for rest in '' ',"joint":"free"'; do
    wrong bad-value $field 'is for "joint":"chord"' \
      "{$two,$t2,\"mode\":\"g1-pair\",\"$field\":0.5$rest}"
  done
done
for rest in "\"closed\":true" "\"tangents\":[[1,0],[0,1],[1,1]]"; do
  wrong bad-value end_tangents 'are for the modes spline and g2 of open curves' \
    "{$three,$rest,\"end_tangents\":[[1,0],[1,0]]}"
  wrong bad-value end_derivatives \
    'are for the mode spline of open curves, without end_tangents' \
    "{$three,$rest,\"end_derivatives\":[[1,0],[1,0]]}"
  wrong bad-value ends \
    'is for the modes spline and g2 of open curves whose ends are not given' \
    "{$three,$rest,\"ends\":\"circle\"}"
done
wrong bad-value end_derivatives \
  'are for the mode spline of open curves, without end_tangents' \
  "{$three,\"end_tangents\":[[1,0],[1,0]],\"end_derivatives\":[[1,0],[1,0]]}"
wrong bad-value ends \
  'is for the modes spline and g2 of open curves whose ends are not given' \
  "{$three,\"end_derivatives\":[[1,0],[1,0]],\"ends\":\"chord\"}"

# ---- shapes, types -----------------------------------------------------------

wrong bad-shape tangents 'must have 2 vectors, one for each point, found 3' \
  "{$two,\"tangents\":[[1,0],[0,1],[1,1]]}"
wrong bad-shape derivatives 'must have 3 vectors, one for each point, found 2' \
  "{$three,$d2}"
wrong bad-shape 'tangents[0]' 'must have 2 numbers, found 3' \
  "{$two,\"tangents\":[[1,0,0],[0,1,0]]}"
wrong bad-shape 'points[0]' 'must have 2 numbers, found 3' \
  '{"points":[[0,0,0],[1,1,1]]}'
for field in end_tangents end_derivatives; do
  wrong bad-shape $field 'must have 2 vectors, one for each end, found 3' \
    "{$three,\"$field\":[[1,0],[1,0],[1,0]]}"
done
round='"points":[[0,0],[3,0],[4,2],[0,0]],"closed":true'
wrong bad-value 'tangents[3]' 'must equal tangents[0], as the point does' \
  "{$round,\"tangents\":[[1,0],[1,0],[1,1],[0,1]]}"
wrong bad-value 'derivatives[3]' \
  'must equal derivatives[0], as the point does' \
  "{$round,\"derivatives\":[[1,0],[1,0],[1,1],[2,0]]}"
wrong bad-type points 'must be an array of points [x,y], found a string' \
  '{"points":"here"}'
wrong bad-type lambda 'must be a number, found a string' \
  "{$two,\"lambda\":\"long\"}"
wrong bad-type blaschke 'must be true or false, found a number' \
  "{$two,\"blaschke\":1}"
wrong bad-value mode 'must be "g1", "g1-pair", "g1-auto", "g1-fair", "c1", '\
'"spline", "g2" or "approximate", found "g1-pairs"; did you mean "g1-pair"?' \
  "{$two,$t2,\"mode\":\"g1-pairs\"}"
wrong bad-value solutions \
  'must be "best", "standard" or "all", found "every"' \
  "{$two,\"solutions\":\"every\"}"
wrong unknown-field lamda 'is not a field of tc; did you mean "lambda"?' \
  "{$two,\"lamda\":1}"

# ---- numbers -----------------------------------------------------------------

for value in 0 -1; do
  wrong bad-value lambda "must be between 1e-12 and 1e12, found $value" \
    "{$two,\"lambda\":$value}"
  wrong bad-value tolerance "must be greater than 0, found $value" \
    "{$bezier,\"tolerance\":$value}"
done
for value in 6.5 -7; do
  wrong bad-value joint_angle "must be between -2 pi and 2 pi, found $value" \
    "{$two,$t2,$chord,\"joint_angle\":$value}"
done
for value in 0 1; do
  wrong bad-value joint_position "must be between 0 and 1, found $value" \
    "{$two,$t2,$chord,\"joint_position\":$value}"
done
for value in 0 2.5 1e9; do
  shown=$value
  [ "$value" != 1e9 ] || shown=1000000000
  wrong bad-value pieces \
    "must be a whole number from 1 to 1000000, found $shown" \
    "{$bezier,\"pieces\":$value}"
done
feed "{$two,\"lambda\":NaN}" tc
expect 'NaN' 3 "phspline: -:1: record 1: NaN is not JSON: numbers are finite \
[syntax]
$(failed 1 1)"
wrong not-finite 'points[1][0]' 'is 1e400, which overflows a double' \
  '{"points":[[0,0],[1e400,0]]}'
wrong not-finite 'tangents[0][1]' 'is -1e400, which overflows a double' \
  "{$two,\"tangents\":[[1,-1e400],[0,1]]}"
wrong not-finite lambda 'is 1e400, which overflows a double' \
  "{$two,\"lambda\":1e400}"

# ---- points, vectors ---------------------------------------------------------

wrong coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[1,2],[1,2]]}'
wrong coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[0,0],[1,2],[1,2],[3,3]]}'
wrong coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[1e6,1e6],[1e6,1000000.0000000001]]}'
wrong coincident-points 'points[1]' "coincides with points[0]$joins" \
  "{\"points\":[[1,2],[1,2]],$t2}"
wrong zero-tangent 'derivatives[0]' 'must not be zero' \
  "{$two,\"derivatives\":[[0,0],[1,1]]}"
wrong zero-tangent 'end_tangents[0]' 'must not be zero' \
  "{$three,\"end_tangents\":[[0,0],[1,1]]}"
wrong zero-tangent 'end_derivatives[1]' 'must not be zero' \
  "{$three,\"end_derivatives\":[[1,0],[0,0]]}"
wrong zero-tangent 'derivatives[1]' \
  'is too small beside the chord from points[0] to points[1]' \
  "{$two,\"derivatives\":[[1,0],[1e-13,0]]}"
wrong too-large 'derivatives[0]' \
  'is too large beside the chord from points[0] to points[1]' \
  "{$two,\"derivatives\":[[1e14,0],[1,0]]}"
wrong too-large 'points[0]' \
  'gets a derivative that is too large beside the chord from points[0] to points[1]' \
  "{$two,\"end_derivatives\":[[1e14,0],[1,0]]}"
wrong coincident-points 'points[1]' 'gets a derivative that is too small beside '\
"the chord from points[0] to points[1]$joins" '{"points":[[0,0],[1,0],[1,1e-12],[2,1]],"mode":"spline"}'
wrong infeasible 'points[1]' 'is where the data turn back by 180 degrees: the '\
'chords have no bisector there' '{"points":[[0,0],[2,0],[1,0],[1,1]],"mode":"spline"}'
wrong infeasible 'points[0]' 'is where the data turn back by 180 degrees: the '\
'chords have no bisector there' '{"points":[[0,0],[2,0],[5,0]],"closed":true,"mode":"spline"}'

# ---- no curve ----------------------------------------------------------------

# none K A B RANGE PROBLEM
none() {
  wrong infeasible "segments[$1]" "no Tschirnhausen cubic has angles $2 and $3 \
to the chord: for the first, the second must be between $4; \
\"mode\":\"g1-pair\" has a curve of two" "{$5,\"mode\":\"g1\"}"
}

none 0 1.5708 1.5708 '-2.61799 and 0.143348' \
  "$two,\"tangents\":[[0,1],[0,1]]"
none 0 -2.35619 0 '-0.343255 and 1.8326, and not 0' \
  "$two,\"tangents\":[[-1,-1],[1,0]]"
none 0 3.14159 0 '-1.0472 and 1.0472, and not 0' \
  "$two,\"tangents\":[[-1,0],[1,0]]"
none 1 0 3.14159 '-2.0944 and 2.0944' \
  '"points":[[0,0],[3,0],[6,0]],"tangents":[[1,0],[1,0],[-1,0]]'
wrong infeasible 'segments[0]' 'all four pairs of cubics have a cusp with '\
'these derivatives; other lengths of them do not' \
  "{$two,\"derivatives\":[[4.5,0],[4.5,0]]}"
wrong infeasible 'segments[0]' 'the standard pair has a cusp; '\
'"solutions":"best" may have none' \
  "{$two,\"derivatives\":[[4.5,1],[4.5,-1]],\"solutions\":\"standard\"}"
wrong infeasible 'segments[0]' 'no two cubics meet on the chord at the angle '\
'2.5: it must be between -2.61799 and 0.143348 and between -5.0689 and '\
'0.00716179 modulo 2 pi, and not 0' \
  "{$two,\"tangents\":[[0,1],[1,0.1]],$chord,\"joint_angle\":2.5}"
points=$(awk 'BEGIN { for (i = 0; i < 8; i++)
  printf "%s[%d,%d]", (i ? "," : ""), i, i % 2 }')
wrong bad-value solutions \
  'must not be all with more than 4096 curves, or 65536 intervals in all of '\
'them: give fewer points' \
  "{\"points\":[$points],\"solutions\":\"all\"}"

# ---- curves to approximate ---------------------------------------------------

goal='"tolerance":1e-3'
wrong too-few-points curve 'must have at least 2 control points' \
  "{\"curve\":[],$goal}"
wrong too-few-points curve 'must have at least 2 control points' \
  "{\"curve\":[[1,2]],$goal}"
wrong too-few-points 'curve[1]' 'must have at least 2 control points' \
  "{\"curve\":[[[0,0],[1,1]],[[1,1]]],$goal}"
wrong bad-value 'curve[1]' 'must begin where curve[0] ends' \
  "{\"curve\":[[[0,0],[1,1]],[[1,2],[3,3]]],$goal}"
wrong bad-value curve 'must end where it begins if closed' \
  "{$bezier,$goal,\"closed\":true}"
wrong bad-shape 'curve[0][1]' 'must have 2 numbers, found 1' \
  "{\"curve\":[[[0,0],[1]],[[1,2],[3,3]]],$goal}"
wrong coincident-points curve 'has control points that are all the same' \
  "{\"curve\":[[1,2],[1,2],[1,2]],$goal}"
wrong bad-value pieces 'must be at least 2, one for each curve, found 1' \
  '{"curve":[[[0,0],[1,1]],[[1,1],[3,3]]],"pieces":1}'
wrong bad-value pieces 'is too few: the fewest cubics found are 2' \
  '{"curve":[[0,0],[1,1],[-1,1],[0,0]],"pieces":1}'

# ---- too large ---------------------------------------------------------------

wrong too-large '' 'the curve exceeds the range of a double' \
  '{"points":[[-1.7e308,0],[1.7e308,0],[1.7e308,1e308]]}'

# ---- all of them -------------------------------------------------------------

run tc wrong.jsonl
n=$(wc -l <wrong.jsonl | tr -d ' ')
equal 'all of them: exit status' 1 "$status"
equal 'all of them: the last line' "$(failed "$n" "$n")" "$(tail -n 1 err)"
sed 's/^phspline: wrong.jsonl:\([0-9]*\): record \1: //; $d' err >found
paste -d '\n' want found | awk 'NR % 2 { want = $0; next }
  { print ($0 == want ? "ok " want : "not ok " want ": found " $0) }
  END { if (NR != 2 * n) print "not ok all of them: " NR / 2 " of " n }' n="$n"
equal 'all of them: error records without a curve' "$n $n" \
  "$(json get status out | grep -c '^"error"$') $(json get segments out |
    grep -c '^absent$')"

# ---- warnings ----------------------------------------------------------------

loop='"tangents":[[0.5403023058681398,-0.8414709848078965],[1,0]],"mode":"g1"'
warned loop loop \
  'the curve of interval 0 has a loop or crosses itself (such intervals: 1)' 0 \
  "{\"id\":\"l\",$two,$loop}"
row='"points":[[0,0],[3,0],[6,0]]'
warned both loop \
  'the curve of interval 0 has a loop or crosses itself (such intervals: 2)' 0 \
  "{\"id\":\"b\",$row,\"derivatives\":[[6,0],[6,0],[6,0]]}"
feed "{$two,\"derivatives\":[[4,0],[0,1]]}" tc --strict
expect 'no loop' 0
