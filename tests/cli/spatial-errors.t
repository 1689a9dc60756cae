# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every error and warning that `spatial-hermite' can give about its fields: the
# line on standard error and the record, to the byte.  (What all commands share,
# such as syntax errors: errors.t.)
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

# ---- problems ----------------------------------------------------------------

errors_of spatial-hermite

# with MEMBERS: three points and more
with() {
  printf '{"points":[[0,0,0],[1,1,0],[2,0,1]],%s}' "$1"
}

# unknown NAME [NEAR]
unknown() {
  bad unknown-field "$1" \
    "is not a field of spatial-hermite${2:+; did you mean \"$2\"?}" "\"$1\":1"
}

unknown tangent tangents
unknown derivative derivatives
unknown criteria criterion
unknown Criterion criterion
unknown angle angles
unknown axes axis
unknown tensoin tension
unknown shapes shape
unknown end_derivatives
unknown minimize
unknown solutions
unknown lambda

points='must be an array of points [x,y] or [x,y,z], found'
vectors='must be an array of vectors [x,y] or [x,y,z], found'
criteria='must be "cc", "hc", "bv", "zero", "F1", "F2" or "F3", found'
axes='must be "chord", "x" or "bisector", found'

bad missing-field points \
  'is missing: it must be an array of points [x,y] or [x,y,z]' '{}'
bad bad-type points "$points a number" '{"points":5}'
bad bad-type points "$points an array of numbers" '{"points":[0,0,0]}'
bad bad-type 'points[1][2]' 'must be a number, found a string' \
  '{"points":[[0,0,0],[1,1,"1"]]}'
bad bad-shape 'points[1]' 'must have 3 numbers as points[0] has, found 2' \
  '{"points":[[0,0,0],[1,1]]}'
bad bad-shape 'points[1]' 'must have 2 numbers as points[0] has, found 3' \
  '{"points":[[0,0],[1,1,1]]}'
bad bad-shape 'points[0]' 'must have 2 or 3 numbers, found 4' \
  '{"points":[[0,0,0,0],[1,1,1,1]]}'
bad bad-shape 'points[0]' 'must have 2 or 3 numbers, found 1' \
  '{"points":[[0],[1]]}'
bad not-finite 'points[1][2]' 'is -1e309, which overflows a double' \
  '{"points":[[0,0,0],[1,1,-1e309]]}'
bad too-few-points points 'must be at least 2, found 0' '{"points":[]}'
bad too-few-points points 'must be at least 2, found 1' '{"points":[[1,2,3]]}'
for more in '' ',[1,2,3]'; do
  bad too-few-points points \
    'must be at least 3 different points for a closed curve, found 2' \
    "{\"closed\":true,\"points\":[[1,2,3],[3,4,5]$more]}"
done

# Four units in the last place of the largest coordinate are one point, five are
# two; so it is at every scale.
bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[1,2,3],[1,2,3]]}'
bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[0,0,0],[0,0,0]]}'
bad coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[0,0,0],[1,0.5,0],[1.0000000000000009,0.5,0],[2,0,0]]}'
bad coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[0,0,0],[1e300,0,0],[1.0000000000000007e300,0,0],[2e300,0,0]]}'
bad coincident-points 'points[0]' "coincides with points[3]$joins" \
  '{"closed":true,"points":[[1,2,3],[2,2,3],[5,6,7],[1,2,3],[1,2,3]]}'
feed '{"points":[[0,0,0],[1,0.5,0],[1.0000000000000012,0.5,0],[2,0,0]]}' \
  spatial-hermite
expect 'five units in the last place are two points' 0

bad bad-type closed 'must be true or false, found a string' '"closed":"yes"'

for given in tangents derivatives; do
  bad bad-type $given "$vectors a string" "\"$given\":\"auto\""
  bad bad-type $given "$vectors an array of numbers" "\"$given\":[1,0,0]"
  bad bad-shape $given 'must have 3 vectors, one for each point, found 0' \
    "\"$given\":[]"
  bad bad-shape $given 'must have 3 vectors, one for each point, found 2' \
    "\"$given\":[[1,0,0],[1,0,0]]"
  bad bad-shape $given 'must have 3 vectors, one for each point, found 4' \
    "\"$given\":[[1,0,0],[1,0,0],[1,0,0],[1,0,0]]"
  bad bad-shape $given 'must have vectors of 3 numbers, as the points have' \
    "\"$given\":[[1,0],[1,0],[1,0]]"
  bad bad-shape "${given}[2]" \
    "must have 3 numbers as ${given}[0] has, found 2" \
    "\"$given\":[[1,0,0],[1,0,0],[1,0]]"
  bad not-finite "${given}[1][2]" 'is 1e999, which overflows a double' \
    "\"$given\":[[1,0,0],[1,0,1e999],[1,0,0]]"
  bad zero-tangent "${given}[2]" 'must not be zero' \
    "\"$given\":[[1,0,0],[1,0,0],[0,-0.0,0]]"
  bad bad-value "${given}[3]" "must equal ${given}[0], as the point does" \
    "{\"points\":[[0,0],[1,1],[2,0],[0,0]],\"closed\":true,\
\"$given\":[[1,0],[1,0],[0,1],[0,1]]}"
done
bad bad-value tangents 'excludes derivatives: give one of them' \
  "$(with '"tangents":[[1,0,0],[1,0,0],[1,0,0]],
"derivatives":[[1,0,0],[1,0,0],[1,0,0]]' | tr -d '\n')"
bad bad-value basis 'must be "ph" or "atph", found "ATPH"; did you mean "atph"?' \
  '"basis":"ATPH"'
bad bad-type basis 'must be "ph" or "atph", found a number' '"basis":5'
bad bad-value criterion "$criteria \"CC\"; did you mean \"cc\"?" \
  '"criterion":"CC"'
bad bad-value criterion "$criteria \"F0\"; did you mean \"F1\"?" \
  '"criterion":"F0"'
bad bad-value criterion "$criteria \"length\"" '"criterion":"length"'
bad bad-type criterion "$criteria an array" '"criterion":["cc","hc"]'
bad bad-value axis "$axes \"bisectr\"; did you mean \"bisector\"?" \
  '"axis":"bisectr"'
bad bad-value axis "$axes \"y\"" '"axis":"y"'
bad bad-type axis "$axes an array" '"axis":[1,0,0]'

angles='must be an array of numbers or an array of pairs [theta,beta], found'
pairs='must have 2 pairs, one for each segment, or one for all, found'
bad bad-type angles "$angles a number" '"angles":0'
bad bad-type angles "$angles a string" '"angles":"zero"'
bad bad-type 'angles[0][1]' 'must be a number, found a string' \
  '"angles":[[0,"0"]]'
bad bad-shape angles "$pairs 0 vectors" '"angles":[]'
bad bad-shape angles "$pairs 1 numbers" '"angles":[0]'
bad bad-shape angles "$pairs 4 numbers" '"angles":[0,0,0,0]'
bad bad-shape angles "$pairs 3 vectors" '"angles":[[0,0],[0,0],[0,0]]'
bad bad-shape 'angles[1]' 'must have 2 numbers, found 1' '"angles":[[0,0],[0]]'
bad bad-shape 'angles[0]' 'must have 2 numbers, found 3' '"angles":[[0,0,0]]'
bad not-finite 'angles[0]' 'is 1e999, which overflows a double' \
  '"angles":[1e999,0]'
bad bad-value criterion 'excludes angles, which are given in its place' \
  '"angles":[0,0],"criterion":"cc"'

bad bad-value alpha 'is for "basis":"atph"' '"alpha":1'
between='must be between 0 and pi, found'
bad bad-value alpha "$between 0" '"basis":"atph","alpha":0'
bad bad-value alpha "$between 3.1415926535897931" \
  '"basis":"atph","alpha":3.141592653589793'
bad bad-value 'alpha[1]' "$between -1" '"basis":"atph","alpha":[1,-1]'
bad bad-shape alpha 'must have 2 numbers, one for each segment, found 3' \
  '"basis":"atph","alpha":[1,1,1]'
bad bad-shape alpha 'must have 3 numbers, one for each segment, found 2' \
  '"closed":true,"basis":"atph","alpha":[1,1]'
bad bad-type alpha 'must be a number or an array of numbers, found a string' \
  '"basis":"atph","alpha":"chordal"'
for choice in '"criterion":"cc"' '"criterion":"hc"' '"criterion":"bv"' \
  '"criterion":"zero"' '"angles":[0,0]'; do
  bad missing-field alpha 'is missing: only the criteria F1, F2 and F3 choose it' \
    "\"basis\":\"atph\",$choice"
done

knots='must be "chordal" or an array of numbers, found'
bad bad-value knots "$knots \"uniform\"" '"knots":"uniform"'
bad bad-value knots "$knots \"chordals\"; did you mean \"chordal\"?" \
  '"knots":"chordals"'
bad bad-type knots "$knots a number" '"knots":1'
bad bad-shape knots 'must have 3 numbers, one for each point, found 2' \
  '"knots":[0,1]'
bad bad-shape knots \
  'must have 4 numbers, one for each point and one that closes the period, found 3' \
  '"closed":true,"knots":[0,1,2]'
bad bad-value 'knots[2]' 'must be greater than the knot before, 1, found 1' \
  '"knots":[0,1,1]'
bad too-large 'knots[1]' \
  'differs from the knot before by more than a double can hold' \
  '"knots":[-1.7e308,1.7e308,1.75e308]'

bad bad-value tension 'must be greater than 0, found 0' '"tension":0'
bad bad-value 'tension[1]' 'must be greater than 0, found -1' '"tension":[1,-1]'
bad bad-shape tension 'must have 2 numbers, one for each segment, found 1' \
  '"tension":[1]'
bad bad-type tension 'must be a number or an array of numbers, found a string' \
  '"tension":"1"'
bad not-finite tension 'is 1e999, which overflows a double' '"tension":1e999'

bad bad-type shape 'must be true or false, found a number' '"shape":1'
bad bad-type shape 'must be true or false, found a string' '"shape":"false"'

# ---- angles that do not exist ------------------------------------------------

# opposite AXIS SEGMENT MEMBERS
opposite() {
  bad infeasible "segments[$2]" "has no angles about the axis \"$1\": a tangent \
or the vector d is opposite to it; \"axis\":\"bisector\" always has" "{$3}"
}

back='"points":[[0,0,0],[1,0,0],[2,1,0]],"tangents":[[1,0,0],[-1,0,0],[1,1,1]]'
opposite chord 0 "$back,\"criterion\":\"zero\""
opposite chord 0 "$back,\"angles\":[[0,0],[1,1]]"
opposite x 0 "$back,\"angles\":[1,1],\"axis\":\"x\""
opposite x 1 '"points":[[0,0],[1,1],[1,2]],"tangents":[[0,1],[0,1],[-2,0]],'\
'"criterion":"zero","axis":"x"'
opposite x 0 "$back,\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"zero\""
for choice in '"criterion":"cc"' '"criterion":"hc"' '"criterion":"bv"' \
  '"angles":[1,1],"axis":"bisector"'; do
  feed "{$back,$choice}" spatial-hermite -q
  expect "opposite to the chord, $choice" 0
  case $choice in
  *bisector*) wanted='[1,1]' ;;
  *) wanted=absent ;;
  esac
  equal "opposite to the chord, $choice: the angles" "$wanted" \
    "$(get 'segments[0].angles')"
done

# ---- too large, too small ----------------------------------------------------

bad too-large 'points[1]' \
  'differs from points[0] by more than a double can hold' \
  '{"points":[[-1e308,0,0],[1e308,0,0]]}'
bad too-large knots 'span more than a double can hold' \
  '{"points":[[0,0,0],[1e308,1e308,1e308],[0,1e308,0]]}'
large='too large beside the chord between points[0] and points[1]'
bad too-large 'tension[0]' "makes derivatives $large" '"tension":1e200'
bad too-large 'derivatives[0]' "is $large" \
  '"derivatives":[[1e308,1e308,1e308],[1,0,1],[1,0,0]]'
bad too-large 'knots[1]' "makes derivatives $large" '"knots":[0,1e308,1.7e308]'

bad too-large '' 'the curve exceeds the range of a double' \
  '{"points":[[1.7e308,0,0],[1.6e308,1e307,0]],"derivatives":'\
'[[1e308,0,0],[1e307,0,0]]}'

# beside FIELD CODE SIZE CHORD MEMBERS: a speed that is nothing beside a chord,
# or beside which the chord is nothing, is blamed on what makes it so
beside() {
  case $1 in
  derivatives*) what=is ;;
  *) what='makes derivatives' ;;
  esac
  bad "$2" "$1" "$what too $3 beside the chord between points[$4] and \
points[$(($4 + 1))]" "$(with "$5")"
}

beside 'derivatives[0]' zero-tangent small 0 \
  '"derivatives":[[1e-14,0,0],[1,0,0],[1,0,0]]'
beside 'derivatives[1]' zero-tangent small 0 \
  '"derivatives":[[1,0,0],[0,5e-324,0],[1,0,0]]'
beside 'derivatives[2]' zero-tangent small 1 \
  '"derivatives":[[1,0,0],[1,0,0],[0,0,1e-15]]'
beside 'derivatives[1]' too-large large 0 \
  '"derivatives":[[1,0,0],[0,1e15,0],[1,0,0]]'
beside 'knots[1]' zero-tangent small 0 '"knots":[0,1e-16,1]'
beside 'knots[2]' too-large large 1 '"knots":[0,1,1e16]'
beside 'tension[1]' zero-tangent small 1 '"tension":[1,1e-8]'
beside 'tension[0]' too-large large 0 '"tension":[1e8,1]'
# of atph the speed is alpha times the derivative
beside 'alpha[1]' zero-tangent small 1 '"basis":"atph","alpha":[1,1e-12],'\
'"criterion":"cc","derivatives":[[1,0,0],[1e-3,0,0],[1e-3,0,0]]'
for more in '"derivatives":[[1,0,0],[1,0,0],[0,0,2e-14]]' \
  '"derivatives":[[1e13,0,0],[1,0,0],[0,0,1]]' '"tension":1e-6' \
  '"tension":1e6' '"knots":[0,1e-13,1e13]'; do
  feed "$(with "$more")" spatial-hermite -q
  expect "small or large, but not too much so: $more" 0
done

# ---- CSV ---------------------------------------------------------------------

skip='(--ignore-columns skips it)'
bad_csv 3 1:5 '' unknown-field \
  "column \"theta\" is unknown to spatial-hermite $skip" 'x,y,theta\n0,0,0\n'
bad_csv 3 1:1 '' missing-field \
  'column "x" is missing: spatial-hermite needs it for points' 'z,y\n0,0\n1,1\n'
bad_csv 3 1:1 '' missing-field \
  'column "ty" is missing: spatial-hermite needs it for tangents' \
  'x,y,z,tx,tz\n0,0,0,1,1\n1,1,1,1,1\n'
bad_csv 3 1:1 '' missing-field \
  'column "dx" is missing: spatial-hermite needs it for derivatives' \
  'x,y,dy\n0,0,0\n1,1,1\n'
bad_csv 1 3 'points[1]' bad-value \
  'needs a number in column z, found an empty cell' 'x,y,z\n0,0,0\n1,1,\n'
bad_csv 1 2 'tangents[0]' bad-value \
  'needs a number in column tx, found an empty cell' \
  'x,y,z,tx,ty,tz\n0,0,0,,,\n1,1,1,1,1,1\n'
bad_csv 1 3 'tangents[1]' not-finite \
  'needs a finite number in column tz, found "inf"' \
  'x,y,z,tx,ty,tz\n0,0,0,1,0,0\n1,1,1,1,1,inf\n'
bad_csv 1 3 'derivatives[1]' bad-type \
  'needs a number in column dy, found "fast"' \
  'x,y,dx,dy\n0,0,1,0\n1,1,1,fast\n'
bad_csv 1 3 'tangents[1]' zero-tangent 'must not be zero' \
  'x,y,z,tx,ty,tz\n0,0,0,1,0,0\n1,1,1,0,0,0\n'
bad_csv 1 2 tangents bad-shape \
  'must have vectors of 3 numbers, as the points have' \
  'x,y,z,tx,ty\n0,0,0,1,0\n1,1,1,1,0\n'
bad_csv 1 2 tangents bad-value 'excludes derivatives: give one of them' \
  'x,y,tx,ty,dx,dy\n0,0,1,0,1,0\n1,1,1,0,1,0\n'
bad_csv 1 2 tension bad-shape \
  'must have 1 numbers, one for each segment, found 2' \
  'x,y,tension\n0,0,1\n1,1,1\n'
bad_csv 1 3 'tension[0]' bad-value 'must be greater than 0, found 0' \
  'x,y,tension\n0,0,\n1,1,0\n'
bad_csv 1 4 'alpha[1]' bad-value "$between 4" \
  'x,y,alpha\n0,0,\n1,1,1\n2,0,4\n' --basis=atph
bad_csv 1 3 'points[2]' coincident-points "coincides with points[1]$joins" \
  '0,0,0\n1,1,1\n1,1,1\n'
bad_csv 3 1:1 '' syntax \
  'the file has no header row: --columns must name its 4 columns' \
  '0,0,0,0\n1,1,1,1\n'

# ---- warnings ----------------------------------------------------------------

# Example 3 of Farouki et al. 2015: with both angles 0 its torsion has the wrong
# sign at every tension; here (ti + tf).dp is not positive.
unsat='"points":[[0,0,0],[1,1,1]],"tangents":[[0.4,-1.5,-1.2],[-2,-1,-2]]'
unsat="$unsat,\"criterion\":\"zero\""
unsat_says='segment 0 does not keep the shape of its data at any tension:
(ti + tf).dp is not positive, the condition for it fails (such segments: 1)'
warned unsatisfiable shape-unsatisfiable \
  "$(printf %s "$unsat_says" | tr '\n' ' ')" 0 "{\"id\":\"u\",$unsat}"
equal 'unsatisfiable: what the diagnostics and the segment say' 'absent absent' \
  "$(get diagnostics.shape_ok) $(get 'segments[0].shape_ok')"
feed "{$unsat}" spatial-hermite -q
equal 'unsatisfiable: the segment is left as it is' '1 false false 0' \
  "$(get 'segments[0].tension') $(get 'segments[0].shape_ok') $(
    get diagnostics.shape_ok) $(get diagnostics.reduced)"
feed "{$unsat,\"shape\":false}" spatial-hermite
expect 'unsatisfiable, but nobody asked for shape' 0
equal 'unsatisfiable: not kept all the same' 'false 1' \
  "$(get diagnostics.shape_ok) $(get 'segments[0].tension')"

# A helix: nearly half a turn in one segment, behind a straight one.
gap='"points":[[1,-2,-1],[1,0,0],[-0.9921147013144777,0.12533323356430454,'\
'1.5079644737231006]],"tangents":[[0,2,1],[0,2,1],[-0.25066646712860863,'\
'-1.9842294026289555,1]],"criterion":"zero"'
gap_says='segment 1 does not keep the shape of its data at any tension:
ti.tf is not positive, the condition for it fails (such segments: 1)'
warned gap shape-unsatisfiable "$(printf %s "$gap_says" | tr '\n' ' ')" 1 \
  "{\"id\":\"g\",$gap}"

# Neither tangent points forward: no tension helps, and many are tried.
turned='"points":[[0,0,0],[1,0,0]],"tangents":[[-1,0.4,0.2],[-0.3,0.1,1]],'\
'"basis":"atph"'
turned_says='segment 0 does not keep the shape of its data at any tension that was
tried: (ti + tf).dp is not positive, the condition for it fails (such segments: 1)'
warned 'turned, cut short without a tension' shape-unsatisfiable \
  "$(printf %s "$turned_says" | tr '\n' ' ')" 0 "{\"id\":\"t\",$turned}"
feed "{$turned}" spatial-hermite -q
equal 'turned, cut short without a tension: the curve of the data' \
  '1 absent' "$(get 'segments[0].tension') $(get 'warnings[1]')"

# Searches that begin at another tension have its minima, and not one alone,
# which kept the tension at .397 here: the functional was 34 times as large.
minima='"points":[[0,0,0],[1,-0.8073,-0.4374]],"tangents":[[0.7087,-0.5901,'\
'-0.3867],[0.9253,-0.3521,-0.1408]],"basis":"atph"'
cut_says='segment 0 took 44000 evaluations of F3, and began with the last curves
at its tension: others may be fairer, or need less of it (such segments: 1)'
warned 'minima that are followed, cut short' cut-short \
  "$(printf %s "$cut_says" | tr '\n' ' ')" 0 "{\"id\":\"m\",$minima}"
feed "{$minima}" spatial-hermite -q
{ floats 'segments[0].tension'; floats diagnostics.functional; } >found
# those of a search without bound
echo '0.58336259 1329.67694' | tr ' ' '\n' >want
numbers 'minima that are followed, cut short: the tension and F3' 1e-7 want found

# What a last whole search takes, which rounding makes twice as much, is not
# taken from those that begin with its curves: turned data have the same curve.
cut_short() {
  feed "{\"points\":[[0,0,0],$1],\"tangents\":[$2],\"criterion\":\"F3\"}" \
    spatial-hermite
  floats length
}
cut_short '[-0.477,0.9,0.857]' \
  '[-0.25434929818039487,0.6812184681767384,0.6864749326305214],
   [-0.7979071153083973,0.411915959403534,0.4400789448825043]' >want
cut_short '[0.9,0.857,-0.477]' \
  '[0.6812184681767384,0.6864749326305214,-0.25434929818039487],
   [0.411915959403534,0.4400789448825043,-0.7979071153083973]' >found
numbers 'a search that is cut short: of turned data' 1e-7 want found

warned alpha large-alpha 'alpha[1] is above 2 pi/3 (such segments: 2)' 1 \
  '{"id":"a","points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]],"basis":"atph",'\
'"alpha":[2.094,2.1,3],"criterion":"cc"}'

# Derivatives of 1e11 and 1e-10: a needle at the end, that F1 still has.
needle='"points":[[0,0,0],[1,2,3],[3,1,2]],"derivatives":[[1,0,0],[1e11,0,1e10],'\
'[0,1e-10,2e-10]]'
needle_says='segment 1 has no finite F3, as far as was found, and the least F1
in its place (such segments: 1)'
warned needle infinite-functional "$(printf %s "$needle_says" | tr '\n' ' ')" 1 \
  "{\"id\":\"n\",$needle,\"criterion\":\"F3\"}"
feed "{$needle,\"criterion\":\"F3\"}" spatial-hermite -q
equal 'a needle: what is least is no sum' '"ok" absent' \
  "$(get status) $(get diagnostics.functional)"
needle='"points":[[0,0,0],[1,2,3]],"derivatives":[[1e12,0,1e10],'\
'[0,1e-12,2e-12]]'
helps='; --criterion=cc minimises nothing'
bad no-convergence 'segments[0]' \
  "has no finite F1, as far as was found$helps" \
  "{$needle,\"criterion\":\"F1\"}"
bad no-convergence 'segments[0]' \
  "has no finite F3, and no finite F1, as far as was found$helps" \
  "{$needle,\"criterion\":\"F3\"}"
feed "{$needle}" spatial-hermite
expect 'what helps does help' 0

reversal_says='the data turn back by 180 degrees at points[1] (such points: 1):
of many tangents one was taken'
reversal_says=$(printf %s "$reversal_says" | tr '\n' ' ')
warned reversal reversal "$reversal_says" 1 \
  '{"id":"r","points":[[0,0,0],[1,2,2],[0,0,0]]}'
feed '{"points":[[0,0,0],[1,2,2],[0,0,0]],
  "tangents":[[1,0,0],[0,1,0],[0,0,1]]}' spatial-hermite --strict
expect 'no reversal where tangents are given' 0
feed '{"points":[[0,0,0],[1,0,0],[0,0,0],[1,0,0],[0,0,0]]}' spatial-hermite -q
equal 'reversals are counted' "\"$(printf %s "$reversal_says" |
  sed 's/points: 1/points: 3/')\"" "$(get 'warnings[0].message')"
feed '{"points":[[0,0],[1,0],[0,0],[0,1]],"closed":true}' spatial-hermite -q
equal 'reversals of a closed curve: the first is the first point' \
  '"reversal" 1' "$(get 'warnings[0].code') $(get 'warnings[0].segment')"
# Also where the circle through the points is a line, and the tangent on it.
feed '{"points":[[1,0,0],[0,0,0],[2,0,0]]}' spatial-hermite
equal 'the data turn back on a line' '"reversal" 1' \
  "$(get 'warnings[0].code') $(get 'warnings[0].segment')"
