# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every error and warning that `sphere' can give about its fields: the line on
# standard error and the record, to the byte.  (What all commands share, such as
# syntax errors: errors.t; its CSV: sphere-csv.t.)
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

good='{"lonlat":[[0,0],[10,20],[40,30]]}'
errors_of sphere

# with MEMBERS: three points and more
with() {
  printf '{"points":[[1,0,0],[0,1,0],[0,0,1]],%s}' "$1"
}

# ---- fields ------------------------------------------------------------------

# unknown NAME [NEAR]
unknown() {
  bad unknown-field "$1" \
    "is not a field of sphere${2:+; did you mean \"$2\"?}" "\"$1\":1"
}

unknown point points
unknown lonlats lonlat
unknown centre center
unknown radii radius
unknown modl model
unknown knot knots
unknown end ends
unknown end_tangent end_tangents
unknown tensions tension
unknown shapes shape
unknown increas increase
unknown criteria criterion
unknown Epsilon epsilon
unknown tangents
unknown basis
unknown lengths

# ---- points ------------------------------------------------------------------

points='must be an array of points [x,y,z], found'
pairs='must be an array of pairs [lon,lat], found'

bad missing-field points 'or lonlat must be given' '{}'
bad missing-field points 'or lonlat must be given' '{"radius":2,"closed":true}'
bad bad-value lonlat 'excludes points: give one of them' \
  '"lonlat":[[0,0],[90,0],[0,90]]'
bad bad-type points "$points a number" '{"points":5}'
bad bad-type points "$points an array of numbers" '{"points":[1,0,0]}'
bad bad-type lonlat "$pairs a string" '{"lonlat":"0,0"}'
bad bad-type lonlat "$pairs an array of numbers" '{"lonlat":[0,90]}'
bad bad-type 'points[1][2]' 'must be a number, found a string' \
  '{"points":[[1,0,0],[0,1,"0"]]}'
bad bad-shape 'points[0]' 'must have 3 numbers, found 2' \
  '{"points":[[1,0],[0,1]]}'
bad bad-shape 'points[1]' 'must have 3 numbers, found 2' \
  '{"points":[[1,0,0],[0,1]]}'
bad bad-shape 'lonlat[0]' 'must have 2 numbers, found 3' \
  '{"lonlat":[[1,0,0],[0,1,0]]}'
bad not-finite 'points[1][2]' 'is -1e309, which overflows a double' \
  '{"points":[[1,0,0],[0,1,-1e309]]}'
bad not-finite 'lonlat[1][0]' 'is 1e999, which overflows a double' \
  '{"lonlat":[[0,0],[1e999,0]]}'
for given in points lonlat; do
  bad too-few-points $given 'must be at least 2, found 0' "{\"$given\":[]}"
done
bad too-few-points points 'must be at least 2, found 1' '{"points":[[1,0,0]]}'
bad too-few-points lonlat 'must be at least 2, found 1' '{"lonlat":[[1,0]]}'
for more in '' ',[0,0]' ',[360,0]'; do
  bad too-few-points lonlat \
    'must be at least 3 different points for a closed curve, found 2' \
    "{\"closed\":true,\"lonlat\":[[0,0],[10,20]$more]}"
done

for degrees in 360.5 -361 1e300; do
  shown=$degrees
  [ "$degrees" != 1e300 ] || shown=1.0000000000000001e+300
  bad bad-value 'lonlat[1][0]' \
    "must be between -360 and 360 degrees, found $shown" \
    "{\"lonlat\":[[0,0],[$degrees,0]]}"
done
for degrees in 90.5 -91; do
  bad bad-value 'lonlat[0][1]' \
    "must be between -90 and 90 degrees, found $degrees; the longitude comes first" \
    "{\"lonlat\":[[0,$degrees],[10,0]]}"
done
feed '{"lonlat":[[360,0],[-360,90],[0,-89]]}' sphere -q
expect 'the largest longitudes and latitudes' 0

# ---- neighbours --------------------------------------------------------------

# near FIELD I K POINTS [MEMBERS], far FIELD I K POINTS [MEMBERS]
near() {
  bad coincident-points "$1[$2]" \
    "coincides with $1[$3]: they are less than 1e-10 rad apart$joins" \
    "{\"$1\":$4${5-}}"
}

far() {
  bad antipodal-points "$1[$2]" "is opposite to $1[$3] on the sphere, to \
1e-06 rad: every direction leads from one to the other" "{\"$1\":$4${5-}}"
}

near points 1 0 '[[1,0,0],[1,0,0],[0,0,1]]'
near points 1 0 '[[1,0,0],[1,9e-11,0]]'
near points 1 0 '[[1e6,0,0],[1e6,9e-5,0]]' ',"radius":1e6'
near points 2 1 '[[0,0,1],[1,0,0],[1.0005,0,0]]'
near points 0 3 '[[1,0,0],[0,1,0],[0,0,1],[1,0,0],[1,0,0]]' ',"closed":true'
near lonlat 1 0 '[[0,0],[360,0]]'
near lonlat 2 1 '[[0,0],[180,5],[-180,5]]'
near lonlat 1 0 '[[0,90],[50,90]]'
feed '{"points":[[1,0,0],[1,1.1e-10,0]]}' sphere
expect 'a little farther apart' 0

far points 1 0 '[[1,0,0],[-1,0,0]]'
far points 2 1 '[[1,0,0],[0,1,0],[0,-1,0]]'
far points 0 2 '[[1,0,0],[0,1,0],[-1,9e-7,0]]' ',"closed":true'
far points 1 0 '[[9,2,3],[5,2,3]]' ',"center":[7,2,3],"radius":2'
far lonlat 1 0 '[[0,90],[100,-90]]'
far lonlat 2 1 '[[0,0],[70,20],[-110,-20]]'

# ---- the sphere --------------------------------------------------------------

# off I DISTANCE RADIUS POINTS [MEMBERS]
off() {
  bad not-on-sphere "points[$1]" "is $2 from the center, and the radius is $3: \
they may differ by radius_tolerance, ${6-0.001} of the radius" \
    "{\"points\":$4${5-}}"
}

off 2 1.01 1 '[[1,0,0],[0,1,0],[0,0,1.01]]'
off 0 0 1 '[[0,0,0],[0,1,0]]'
off 0 6371 1 '[[6371,0,0],[0,6371,0]]'
off 1 1 6371 '[[6371,0,0],[0,1,0]]' ',"radius":6371'
off 0 3 1 '[[1,0,0],[0,1,0]]' ',"center":[-2,0,0]'
off 1 1e+308 1 '[[1,0,0],[0,1e308,0]]'
off 1 1e-308 1 '[[1,0,0],[0,1e-308,0]]'
off 0 1e+308 1.7e+308 '[[1e308,0,0],[-1e308,1e308,0]]' ',"radius":1.7e308'
off 1 0.9 1 '[[1,0,0],[0,0.9,0]]' ',"radius_tolerance":0.0625' 0.0625
feed '{"points":[[1,0,0],[0,0.9,0]],"radius_tolerance":0.125}' sphere -q
expect 'a larger tolerance' 0

bad bad-type center 'must be an array of numbers, found a number' '"center":5'
bad bad-type center 'must be an array of numbers, found an array of arrays' \
  '"center":[[0,0,0]]'
bad bad-shape center 'must have 3 numbers, found 2' '"center":[0,0]'
bad bad-shape center 'must have 3 numbers, found 4' '"center":[0,0,0,0]'
bad not-finite 'center[2]' 'is 1e999, which overflows a double' \
  '"center":[0,0,1e999]'
for value in 0 -1 -0; do
  bad bad-value radius "must be at least 1e-300, found $value" \
    "\"radius\":$value"
done
bad bad-type radius 'must be a number, found a string' '"radius":"6371"'
bad not-finite radius 'is 1e999, which overflows a double' '"radius":1e999'
for value in 0 1 -1 1.5; do
  bad bad-value radius_tolerance \
    "must be greater than 0 and less than 1, found $value" \
    "\"radius_tolerance\":$value"
done
bad bad-type closed 'must be true or false, found a string' '"closed":"yes"'

# ---- words -------------------------------------------------------------------

# word FIELD CHOICE FOUND [NEAR]: of a field that is one of several words
word() {
  bad bad-value "$1" "must be $2, found \"$3\"${4:+; did you mean \"$4\"?}" \
    "\"$1\":\"$3\""
}

word model '"exact" or "nielson"' Exact exact
word model '"exact" or "nielson"' nielsen nielson
word model '"exact" or "nielson"' cubic
word criterion '"geodesic" or "legacy"' geodisic geodesic
word criterion '"geodesic" or "legacy"' cc
word ends '"natural", "rest" or "clamped"' clamp clamped
word ends '"natural", "rest" or "clamped"' free
word shape 'true, false or "warn"' warning
word shape 'true, false or "warn"' true
word knots '"geodesic", "uniform" or an array of numbers' chordal
word knots '"geodesic", "uniform" or an array of numbers' geodesics geodesic
for value in plus plus: plus:x 'plus: 1' 'Plus:1'; do
  word increase '"minimal", "plus:V" or "times:V"' "$value" plus:V
done
for value in times times:x; do
  word increase '"minimal", "plus:V" or "times:V"' "$value" times:V
done
for value in plus:1e999 plus:inf plus:0x10 plus:1,2 times:nan; do
  word increase '"minimal", "plus:V" or "times:V"' "$value"
done
word increase '"minimal", "plus:V" or "times:V"' minimum minimal
for value in 0 -1; do
  bad bad-value increase "must add more than 0, found $value" \
    "\"increase\":\"plus:$value\""
done
for value in 1 0.5 -2; do
  bad bad-value increase "must multiply by more than 1, found $value" \
    "\"increase\":\"times:$value\""
done
bad bad-type increase \
  'must be "minimal", "plus:V" or "times:V", found a number' '"increase":10'
bad bad-type model 'must be "exact" or "nielson", found a number' '"model":1'
bad bad-type shape 'must be true, false or "warn", found a number' '"shape":1'

# ---- numbers -----------------------------------------------------------------

for value in 0 -1 -0; do
  bad bad-value epsilon "must be at least 1e-11, found $value" \
    "\"epsilon\":$value"
done
bad bad-type epsilon 'must be a number, found an array' '"epsilon":[1]'
bad not-finite epsilon 'is 1e999, which overflows a double' '"epsilon":1e999'

bad bad-value tension 'must be between 0 and 1e+12, found -1' '"tension":-1'
bad bad-value tension 'must be between 0 and 1e+12, found 1000000000001' \
  '"tension":1000000000001'
bad bad-value 'tension[1]' 'must be between 0 and 1e+12, found -2' \
  '"tension":[1,-2,3]'
bad bad-value 'tension[2]' 'must be between 0 and 1e+12, found 1000000000001' \
  '"tension":[1,2,1000000000001]'
bad bad-type tension 'must be a number or an array of numbers, found a string' \
  '"tension":"1"'
for value in '[]' '[1,2]' '[1,2,3,4]'; do
  case $value in '[]') found=0 ;; '[1,2]') found=2 ;; *) found=4 ;; esac
  bad bad-shape tension \
    "must have 3 numbers, one for each point, found $found" "\"tension\":$value"
done
round='"points":[[1,0,0],[0,1,0],[0,0,1],[1,0,0]],"closed":true'
bad bad-shape tension 'must have 4 numbers, one for each point, found 2' \
  "{$round,\"tension\":[1,2]}"
bad bad-value 'tension[3]' 'must equal tension[0], as the point does' \
  "{$round,\"tension\":[1,2,3,4]}"

knots='must be after the knot before by more than 1e-12 of the largest spacing,
and by 1e-50 to 1e+50'
knots=$(printf %s "$knots" | tr '\n' ' ')
bad bad-type knots \
  'must be "geodesic", "uniform" or an array of numbers, found a number' \
  '"knots":1'
bad bad-shape knots 'must have 3 numbers, one for each point, found 2' \
  '"knots":[0,1]'
bad bad-shape knots \
  'must have 4 numbers, one for each point and one that closes the period, found 3' \
  '"closed":true,"knots":[0,1,2]'
bad bad-value 'knots[2]' 'must be greater than the knot before, 1, found 1' \
  '"knots":[0,1,1]'
bad bad-value 'knots[1]' 'must be greater than the knot before, 0, found -1' \
  '"knots":[0,-1,1]'
bad too-large 'knots[1]' "$knots" '"knots":[0,1e-13,1]'
bad too-large 'knots[2]' "$knots" '"knots":[0,1,1.0000000000001]'
bad too-large 'knots[2]' "$knots" '"knots":[0,1e49,2e50]'
bad too-large 'knots[1]' "$knots" '"knots":[0,1e-51,1e-50]'
bad too-large 'knots[1]' \
  'differs from the knot before by more than a double can hold' \
  '"knots":[-1.7e308,1.7e308,1.75e308]'

# ---- ends --------------------------------------------------------------------

# clamped TANGENTS: the members
clamped() {
  printf '"ends":"clamped","end_tangents":%s' "$1"
}

vectors='must be an array of vectors [x,y,z], found'
two='must be two vectors of 3 numbers, found'
bad missing-field end_tangents 'must be given with "ends":"clamped"' \
  '"ends":"clamped"'
for ends in natural rest; do
  bad bad-value end_tangents "excludes \"ends\":\"$ends\"" \
    "\"ends\":\"$ends\",\"end_tangents\":[[0,1,0],[0,1,0]]"
done
bad bad-value end_tangents 'is for open curves: a closed curve has no ends' \
  "\"closed\":true,$(clamped '[[0,1,0],[0,1,0]]')"
for ends in natural rest clamped; do
  bad bad-value ends 'is for open curves: a closed curve has no ends' \
    "\"closed\":true,\"ends\":\"$ends\""
done
bad bad-type end_tangents "$vectors a string" "$(clamped '"up"')"
bad bad-type end_tangents "$vectors an array of numbers" "$(clamped '[0,1,0]')"
bad bad-shape end_tangents "$two 0 of 3" "$(clamped '[]')"
bad bad-shape end_tangents "$two 1 of 3" "$(clamped '[[0,1,0]]')"
bad bad-shape end_tangents "$two 3 of 3" \
  "$(clamped '[[0,1,0],[0,1,0],[0,1,0]]')"
bad bad-shape 'end_tangents[0]' 'must have 3 numbers, found 2' \
  "$(clamped '[[0,1],[0,1]]')"
bad not-finite 'end_tangents[0][2]' 'is 1e999, which overflows a double' \
  "$(clamped '[[0,1,1e999],[0,1,0]]')"
bad zero-tangent 'end_tangents[0]' 'must not be zero' \
  "$(clamped '[[0,0,0],[0,1,0]]')"
bad zero-tangent 'end_tangents[1]' 'must not be zero' \
  "$(clamped '[[0,1,0],[0,0,-0.0]]')"
radial='must not be at right angles to the sphere at'
bad zero-tangent 'end_tangents[0]' "$radial points[0]" \
  "$(clamped '[[1,0,0],[0,1,0]]')"
bad zero-tangent 'end_tangents[0]' "$radial points[0]" \
  "$(clamped '[[1,1e-13,0],[0,1,0]]')"
bad zero-tangent 'end_tangents[1]' "$radial points[2]" \
  "$(clamped '[[0,1,0],[0,0,-5]]')"
bad zero-tangent 'end_tangents[1]' "$radial lonlat[1]" \
  "{\"lonlat\":[[0,0],[90,0]],$(clamped '[[0,1,0],[0,3,0]]')}"
feed "$(with "$(clamped '[[1,1e-9,0],[1e-300,1e-300,-1]]')")" sphere -q
expect 'little is left of one tangent' 1 \
  "phspline: -:1: record 1: end_tangents[1]: $radial points[2] [zero-tangent]"
feed "$(with "$(clamped '[[1e300,1e295,0],[1e-300,1e-310,0]]')")" sphere -q
expect 'directions of any length' 0

# ---- too large, too small ----------------------------------------------------

beyond='the curve exceeds the range of a double'
bad too-large '' "$beyond" '{"lonlat":[[0,0],[90,0],[180,1]],"radius":1.7e308}'
bad too-large '' "$beyond" \
  '{"lonlat":[[0,0],[90,1]],"radius":1e308,"center":[1.7e308,0,0]}'
for size in 1e-300 1e300; do
  feed "{\"lonlat\":[[0,0],[1,1],[3,0]],\"radius\":$size}" sphere
  expect "radius $size" 0
done

# ---- shapes that no tension has ----------------------------------------------

strict='"shape":true'
corner='"lonlat":[[0,0],[20,0],[40,0],[60,0],[60,20],[60,40],[60,60]]'
bad no-convergence 'lonlat[1]' 'the criterion of co-circularity asks for '\
'tensions beyond precision here, a larger epsilon for less; with '\
'"shape":"warn" it is done without' "{$corner,\"epsilon\":1e-10,$strict}"
beyond='4 criteria of shape fail as they ask for tensions beyond precision, at '\
'the nodes 1, 2, 4, 5; the first is co-circularity at node 1'
warned unsatisfiable shape-unsatisfiable "$beyond" '' \
  "{\"id\":\"u\",$corner,\"epsilon\":1e-10}"
feed "{$corner,\"epsilon\":1e-10}" sphere
equal 'the points where the shape is not kept' '[1,2,4,5]' "$(get waived)"
warned unsatisfiable shape-unsatisfiable "$beyond" '' \
  "{\"id\":\"u\",$corner,\"epsilon\":1e-10,\"shape\":\"warn\"}"
# Between the ends there is no tension that could make the way straight.
straight='"lonlat":[[0,0],[20,0],[40,0]],"end_tangents":[[0,0,1],[0,0,-1]]'
bad infeasible 'lonlat[1]' 'no tension makes the criterion of co-circularity '\
'hold here; with "shape":"warn" it is done without' "{$straight,$strict}"
warned unsatisfiable shape-unsatisfiable '1 criterion of shape fails at any '\
'tension, at the nodes 1; the first is co-circularity at node 1' '' \
  "{\"id\":\"u\",$straight}"
feed "{$corner,\"epsilon\":1e-10,\"shape\":false}" sphere --strict
expect 'a shape that is not asked for' 0
equal 'a shape that is not asked for: it is told' false \
  "$(get diagnostics.shape_ok)"
feed "{$corner,\"shape\":\"warn\"}" sphere --strict
expect 'a shape that some tension has' 0
# A criterion that was given up on the way, and holds in the end.
fixes='"lonlat":[[11.0046,47.99909],[11.00459,47.99901],[11.00465,47.99898],
  [11.00476,47.99888],[11.00486,47.99872],[11.00487,47.99861],
  [11.00491,47.9986],[11.00507,47.99853],[11.00509,47.99837],[11.0051,47.99829],
  [11.0052,47.99824],[11.00544,47.99803]]'
feed "{$fixes}" sphere
expect 'a track whose shape is kept' 0
tensions=$(get tensions)
feed "{$fixes,$strict}" sphere
expect 'that track, where it has to be' 0
equal 'that track, where it has to be' "$tensions" "$(get tensions)"

# More steps than are taken, and fewer, but beyond the largest tension.
bad no-convergence increase \
  'the shape was not reached by 10000 increases of tensions, try larger ones' \
  "{$corner,$strict,\"increase\":\"plus:0.0009765625\"}"
feed "{$corner,\"increase\":\"times:1e300\"}" sphere
expect 'the largest tension is tried' 0

# ---- points that are moved ---------------------------------------------------

# moved NAME POINTS I BY
moved() {
  warned "$1" moved-points "points are not on the sphere and were moved onto \
it, points[$3] farthest, by $4 of the radius" '' \
    "{\"id\":\"$(printf %s "$1" | cut -c 1)\",\"points\":$2}"
}

moved 'digits cut off' '[[0.6,0.8,0],[0,0.707,0.707],[-1,0,0]]' 1 0.00015
moved 'outwards' '[[0.6,0.8,0],[0,0.6,0.8],[-1.0009765625,0,0]]' 2 0.00098
moved 'very little' '[[1,0,0],[0,1.0000000009313226,0]]' 1 9.3e-10
feed '{"points":[[0.6,0.8,0],[0,0.6,0.8],[-1.0000000000000002,0,0]]}' sphere \
  --strict
expect 'moved by rounding only' 0

# ---- data that turn back -------------------------------------------------------

# back NAME POINTS FIRST LONLAT
back() {
  warned "$1" reversal "the data turn back on a great circle at $2, first at \
node $3" '' "{\"id\":\"$(printf %s "$1" | cut -c 1)\",\"lonlat\":$4}"
}

back 'back to the start' '1 point' 1 '[[0,0],[10,0],[0,0]]'
back 'less than back' '1 point' 1 '[[0,0],[10,0],[5,0]]'
back 'to and fro' '2 points' 1 '[[0,0],[10,0],[0,0],[10,0]]'
back 'over a pole' '1 point' 3 '[[0,80],[40,70],[10,80],[-170,80],[10,80]]'
feed '{"lonlat":[[0,0],[10,0],[0,0.001]]}' sphere --strict
expect 'not quite back' 0

# ---- no spline ---------------------------------------------------------------

# The construction as published has none for these; the other one has.
wide='"lonlat":[[0,0],[150,60],[-20,-70],[100,10]],"closed":true,"shape":false'
# no_spline NAME MEMBERS ADVICE
no_spline() {
  feed "{$2}" sphere
  sed 's/, residual [0-9.e-]*:/:/' err >said
  mv said err
  expect "$1" 1 "phspline: -:1: record 1: tension: no spline was \
found at these tensions: $3 [no-convergence]
$(failed 1 1)"
}

no_spline 'no convergence' "$wide,\"model\":\"nielson\"" \
  '--model=exact finds one as a rule'
equal 'no convergence: the record' '"error" "no-convergence" "tension"' \
  "$(get status) $(get error.code) $(get error.field)"
feed "{$wide,\"model\":\"nielson\",\"tension\":100}" sphere
expect 'no convergence: larger tensions do help' 0
feed "{$wide}" sphere
expect 'no convergence: so does the other model' 0
# Knots that have nothing to do with the angles.
knots='"lonlat":[[30,20],[90,0],[90,-10],[60,20]],"knots":[0,1,101,101.01]'
no_spline 'no convergence: given knots' "$knots" \
  '--knots=geodesic finds one as a rule'
no_spline 'no convergence: given knots, model nielson' \
  "$knots,\"model\":\"nielson\"" \
  '--knots=geodesic with --model=exact finds one'
feed "{$knots}" sphere --override=knots=geodesic
expect 'no convergence: the knots that are advised' 0

# Global control points that would be nearly antipodal have larger tensions.
for points in '[-70,10],[-50,-60],[80,30],[-90,-70]' \
  '[140,50],[60,80],[-120,-20],[0,40],[120,0]'; do
  feed "{\"lonlat\":[$points],\"model\":\"nielson\"}" sphere --strict
  expect 'not antipodal' 0
done

# ---- offsets -----------------------------------------------------------------

# too_far DISTANCE HALF RADIUS
too_far() {
  feed "{\"lonlat\":[[0,0],[10,20]],\"radius\":$3}" sphere --offset="$1"
  expect "--offset=$1, radius $3" 1 "phspline: -:1: record 1: the offset \
distance $1 is not less than half the circumference of the sphere, $2 \
[bad-value]
$(failed 1 1)"
}

too_far 4 3.14159 1
too_far -3.5 3.14159 1
too_far 6.5 6.28319 2
too_far 1 0.314159 0.1
feed '{"lonlat":[[0,0],[10,20]],"radius":2}' sphere --offset=6.28,-6.28
expect 'an offset of nearly half the circumference' 0
feed "$good" sphere --convert=bezier
expect '--convert=bezier' 2 'phspline: --convert: the curves of sphere are no '\
"Bezier curves
Try 'phspline sphere --help'."
