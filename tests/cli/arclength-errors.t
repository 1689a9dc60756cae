# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every error and warning that `arclength' can give about its fields: the line
# on standard error and the record, to the byte.  (What all commands share, such
# as syntax errors: errors.t.)
. "$srcdir/tests/cli/lib.sh"
# shellcheck disable=SC2034  # errors.sh uses it
good='{"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]]}'
. "$srcdir/tests/cli/errors.sh"
errors_of arclength

points='"points":[[0,0,0],[1,1,0],[2,0,1]]'
derivatives='"derivatives":[[1,0,0],[0,1,0],[0,0,1]]'
tangents='"tangents":[[1,0,0],[0,1,0],[0,0,1]]'
lengths='"lengths":[2,2]'
triangle='"points":[[0,0],[1,0],[0,1]],"closed":true'

# with MEMBERS: good points, and more
with() {
  printf '{%s,%s}' "$points" "$1"
}

# unknown NAME [NEAR]
unknown() {
  bad unknown-field "$1" \
    "is not a field of arclength${2:+; did you mean \"$2\"?}" "\"$1\":1"
}

unknown length lengths
unknown lenghts lengths
unknown sigma
unknown tangent tangents
unknown derivative derivatives
unknown Knots knots
unknown refin refine
unknown magnitude magnitudes
unknown planer planar
unknown random_starts
unknown minima
unknown basis
unknown end_derivatives
unknown alpha

# ---- types and words ---------------------------------------------------------

bad bad-type '' 'a problem must be an object, found an array' '[[0,0,0]]'
bad bad-type points \
  'must be an array of points [x,y] or [x,y,z], found a string' \
  '{"points":"abc"}'
for given in derivatives tangents; do
  bad bad-type $given \
    'must be an array of vectors [x,y] or [x,y,z], found a number' \
    "{\"$given\":1}"
  bad bad-shape "${given}[1]" \
    "must have 3 numbers as ${given}[0] has, found 2" \
    "{\"$given\":[[1,0,0],[1,0]]}"
  bad not-finite "${given}[1][2]" 'is 1e999, which overflows a double' \
    "{\"$given\":[[1,0,0],[1,0,1e999]]}"
done
bad bad-type closed 'must be true or false, found a number' '"closed":1'
numbers='must be a number or an array of numbers, found'
bad bad-type lengths "$numbers a string" '"lengths":"chordal"'
bad bad-type lengths "$numbers null" '"lengths":null'
bad bad-type lengths "$numbers an array of arrays" '"lengths":[[1.5],[1.8]]'
bad bad-type 'lengths[1]' 'must be a number, found null' '"lengths":[1.5,null]'
bad not-finite 'lengths[0]' 'is 1e999, which overflows a double' \
  '"lengths":[1e999,1]'
knots='must be "lengths", "chordal", "uniform" or an array of numbers, found'
bad bad-value knots "$knots \"length\"; did you mean \"lengths\"?" \
  '"knots":"length"'
bad bad-value knots "$knots \"centripetal\"" '"knots":"centripetal"'
bad bad-type knots "$knots a number" '"knots":1'
bad bad-value refine 'must be "auto" or a number, found "two"' '"refine":"two"'
bad bad-type refine 'must be "auto" or a number, found an array' \
  '"refine":[2,2]'
bad bad-type length_sigma 'must be a number, found a string' \
  '"length_sigma":"1%"'
bad bad-value magnitudes \
  'must be "free" or "mean", found "Mean"; did you mean "mean"?' \
  '{"tangents":[[1,0,0],[0,1,0]],"lengths":[1],"magnitudes":"Mean"}'
bad bad-type planar 'must be "keep" or "free", found true' '"planar":true'
bad bad-value planar 'must be "keep" or "free", found "yes"' '"planar":"yes"'
bad bad-type starts 'must be a number, found a string' '"starts":"5"'
bad bad-type all_minima 'must be true or false, found a number' '"all_minima":1'
bad bad-type start 'must be an array of numbers, found a number' \
  '{"tangents":[[1,0,0],[0,1,0]],"lengths":[1],"start":0}'
bad bad-type start 'must be an array of numbers, found an array of arrays' \
  '{"tangents":[[1,0,0],[0,1,0]],"lengths":[1],"start":[[0,0,0]]}'
run arclength --start=1,two,3 /dev/null
expect 'an option that is no JSON' 2 \
  'phspline: --start: start must be an array of numbers, found "1,two,3"
Try '\''phspline arclength --help'\''.' ''

# ---- what is given -----------------------------------------------------------

bad missing-field points 'or derivatives or tangents must be given' '{}'
bad missing-field points 'or derivatives or tangents must be given' "{$lengths}"
bad bad-value derivatives 'excludes points: give one of them' "$derivatives"
bad bad-value tangents 'excludes points: give one of them' "$tangents"
bad bad-value tangents 'excludes derivatives: give one of them' \
  "{$tangents,$derivatives}"
bad bad-value closed \
  'needs points: derivatives do not say where the curve comes back' \
  "{$derivatives,$lengths,\"closed\":true}"
bad bad-value closed \
  'needs points: tangents do not say where the curve comes back' \
  "{$tangents,$lengths,\"closed\":true}"
bad bad-value start 'is the first of the points' '"start":[0,0,0]'
bad bad-value magnitudes 'needs tangents: points have theirs' \
  '"magnitudes":"free"'
bad bad-value magnitudes 'needs tangents: derivatives have theirs' \
  "{$derivatives,$lengths,\"magnitudes\":\"mean\"}"
bad missing-field lengths 'must be given with derivatives' "{$derivatives}"
bad missing-field lengths 'must be given with tangents' "{$tangents}"
bad bad-value length_sigma 'needs lengths: without them they are free' \
  '"length_sigma":0.01'
bad bad-value length_sigma \
  'needs points or derivatives, or tangent_sigma: exact tangents '\
'contradict no lengths' \
  "{$tangents,$lengths,\"length_sigma\":0.01}"
bad bad-value knots 'chordal needs points: derivatives have no chords' \
  "{$derivatives,$lengths,\"knots\":\"chordal\"}"
bad bad-value knots 'chordal needs points: tangents have no chords' \
  "{$tangents,$lengths,\"knots\":\"chordal\"}"
bad bad-value knots 'lengths needs lengths, which are not given' \
  '"knots":"lengths"'
feed "{$tangents,$lengths,\"length_sigma\":0.01,\"magnitudes\":\"mean\"}" \
  arclength -q
expect 'tangents with magnitudes may contradict lengths' 0

# ---- how many ----------------------------------------------------------------

bad too-few-points points 'must be at least 2, found 0' '{"points":[]}'
bad too-few-points points 'must be at least 2, found 1' '{"points":[[1,2,3]]}'
for more in '' ',[1,2,3]'; do
  bad too-few-points points \
    'must be at least 3 different points for a closed curve, found 2' \
    "{\"closed\":true,\"points\":[[1,2,3],[3,4,5]$more]}"
done
for given in derivatives tangents; do
  bad too-few-points $given 'must be at least 2, found 0' \
    "{\"$given\":[],\"lengths\":[]}"
  bad too-few-points $given 'must be at least 2, found 1' \
    "{\"$given\":[[1,0,0]],\"lengths\":[]}"
done
for n in 0 1 3; do
  bad bad-shape lengths "must have 2 numbers, one from datum to datum, found $n" \
    "$(with "\"lengths\":[$(printf %s '2,2,2' | cut -c "1-$((2 * n - 1))" \
      2>/dev/null)]")"
done
bad bad-shape lengths 'must have 3 numbers, one from datum to datum, found 2' \
  "{$triangle,$lengths}"
bad bad-shape knots 'must have 3 numbers, one for each point, found 2' \
  '"knots":[0,1]'
closes='one for each point and one that closes the period'
bad bad-shape knots "must have 4 numbers, $closes, found 3" \
  "{$triangle,\"knots\":[0,1,2]}"
for start in '0 ' '1 1' '4 1,2,3,4'; do
  bad bad-shape start "must have 2 or 3 numbers, found ${start%% *}" \
    "{$tangents,$lengths,\"start\":[${start#* }]}"
done

# ---- values ------------------------------------------------------------------

bad bad-value 'lengths[1]' 'must be greater than 0, found 0' '"lengths":[2,0]'
bad bad-value 'lengths[0]' 'must be greater than 0, found -2' '"lengths":[-2,2]'
bad bad-value lengths 'must be greater than 0, found -1' '"lengths":-1'
bad too-large lengths 'must be within 1e+12 of the coordinates' \
  '{"points":[[0,0,0],[1,0,0],[2,1,0]],"lengths":1e300}'
bad too-large 'lengths[0]' \
  'must be above 1e-12 of the largest, 2, found 9.9999999999999998e-13' \
  "{$tangents,\"lengths\":[1e-12,2]}"
for sigma in 0 -1 1001; do
  bad bad-value length_sigma "must be between 1e-09 and 1000, found $sigma" \
    "$lengths,\"length_sigma\":$sigma"
done
for refine in 0 4 -1 1.5 1e300; do
  shown=$refine
  [ $refine != 1e300 ] || shown=1.0000000000000001e+300
  bad bad-value refine "must be 1, 2, 3 or auto, found $shown" \
    "\"refine\":$refine"
done
bad bad-value refine 'must be 2 or 3 for a closed curve with exact lengths: '\
'with 1 it has as many equations as unknowns' \
  "{$triangle,\"lengths\":[1.2,1.7,1.2],\"refine\":1}"
for more in '' ',"lengths":[1.2,1.7,1.2],"length_sigma":0.1'; do
  feed "{$triangle,\"refine\":1$more}" arclength -q
  expect "closed, one segment each $more" 0
done
for starts in -1 0.5 1001; do
  bad bad-value starts "must be a whole number from 0 to 1000, found $starts" \
    "\"starts\":$starts"
done
bad bad-value 'knots[2]' 'must be greater than the knot before, 1, found 1' \
  '"knots":[0,1,1]'
bad too-large 'knots[1]' \
  'must be more than 1e-12 of the mean spacing after the knot before' \
  '"knots":[0,1e-13,1]'
bad too-large 'knots[1]' \
  'differs from the knot before by more than a double can hold' \
  '"knots":[-1.7e308,1e307,1.7e308]'
bad too-large knots 'their range is more than a double can hold' \
  '"knots":[-1e308,0,1e308]'
for given in derivatives tangents; do
  bad zero-tangent "${given}[1]" 'must not be zero' \
    "{\"$given\":[[1,0,0],[0,-0.0,0],[0,0,1]],$lengths}"
  bad zero-tangent "${given}[0]" 'must not be zero' \
    "{\"$given\":[[0,0],[0,0]],\"lengths\":[1]}"
done
bad too-large 'derivatives[1]' 'is too small beside the other numbers' \
  '{"derivatives":[[1,0,0],[0,1e-17,0]],"lengths":[1]}'

for start in '1e300,0' '0,-1e13'; do
  bad too-large start 'must be within 1e+12 mean lengths of the origin' \
    "{$tangents,$lengths,\"start\":[$start]}"
done

# Points are one within 4 units in the last place of 1 times the largest number;
# so it is at every scale.
bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[1,2,3],[1,2,3]]}'
bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[0,0,0],[0,0,0]]}'
bad coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[0,0,0],[1,0.5,0],[1.0000000000000016,0.5,0],[2,0,0]]}'
bad coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[0,0,0],[1e300,0,0],[1.0000000000000007e300,0,0],[2e300,0,0]]}'
bad coincident-points 'points[0]' "coincides with points[3]$joins" \
  '{"closed":true,"points":[[1,2,3],[2,2,3],[5,6,7],[1,2,3],[1,2,3]]}'
feed '{"points":[[0,0,0],[1,0.5,0],[1.000000000000002,0.5,0],[2,0,0]]}' \
  arclength -q
expect 'points that are hardly two' 0

# ---- no curve ----------------------------------------------------------------

hint='length_sigma allows for lengths that were measured'
bad infeasible 'lengths[0]' "is 4.9, below the chord 5 of interval 0; $hint" \
  '{"points":[[0,0,0],[3,4,0],[3,5,0]],"lengths":[4.9,2]}'
bad infeasible 'lengths[2]' "is 0.5, below the chord 1 of interval 2; $hint" \
  '{"points":[[0,0],[0,1],[1,1],[1,0]],"lengths":[2,2,0.5]}'
bad infeasible 'lengths[2]' "is 0.5, below the chord 1 of interval 2; $hint" \
  "{\"points\":[[0,0],[1,1],[0,1]],\"closed\":true,\"lengths\":[2,2,0.5]}"
straight='that would have to be straight and others not, which is not looked for'
bad bad-value 'lengths[0]' "is 1, the chord of interval 0: $straight; $hint" \
  '{"points":[[0,0,0],[1,0,0],[1,1,0]],"lengths":[1,1.5]}'
bad bad-value 'lengths[1]' "is 3, the chord of interval 1: $straight; $hint" \
  '{"points":[[1,0,0],[0,0,0],[1,2,2]],"lengths":[1.5,3]}'
bad bad-value 'lengths[0]' "is 2, the chord of interval 0: $straight; $hint" \
  '{"points":[[0,0,0],[2,0,0],[1,0,0]],"lengths":[2,1]}'

# ---- warnings ----------------------------------------------------------------

# warning NAME CODE SEGMENT MESSAGE MEMBERS: the only one of a curve; SEGMENT is
# empty where the warning is about the whole.
warning() {
  printf '{%s}\n' "$5" >a.json
  escape "$4"
  says=$escaped
  run arclength a.json
  expect "$1: a warning" 0 "phspline: a.json:1: record 1: warning: $4 [$2]"
  equal "$1: the record" "\"ok\" [{\"code\":\"$2\",${3:+\"segment\":$3,}\
\"message\":\"$says\"}]" "$(get status) $(get warnings)"
  run arclength -q a.json
  expect "$1: quiet" 0 ''
  equal "$1: quiet, but recorded" "\"$2\"" "$(get 'warnings[0].code')"
  run arclength --strict a.json
  expect "$1: an error under --strict" 1 \
    "phspline: a.json:1: record 1: $4 [$2]
$(failed 1 1)" "$(error_record "$2" '' "$4" a.json 1)"
}

holds_speed() {
  get diagnostics.min_speed | awk '{ exit !($1 > 0 && $1 < 0.01) }'
}

fig5='"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]],"knots":"uniform"'
warning 'a wiggle' wiggle 0 'lengths[0] is 5.1, naturally 4.91877: the curve '\
'wiggles by about 0.63 (such intervals: 3)' "$fig5,\"lengths\":[5.1,2.6,2.0]"
warning 'lengths that do not fit' inconsistent-lengths '' 'the lengths fit no '\
'smooth curve through the data: F is 17.5798, with free lengths 4.17762' \
  '"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]],"lengths":[4.9,2.5,2],
"length_sigma":1e-6'
warning 'lengths that nothing weighs' inconsistent-lengths '' 'the lengths are '\
'missed by 549 standard deviations: points that a curve hardly bends through '\
'outweigh them' \
  '"points":[[0,0,0],[1,0,0],[1,1,0]],"lengths":[3,2],"length_sigma":0.001'
tight='"points":[[0,0,0],[1,0,0],[1,1,0],[1,1,1]],"refine":3,
"lengths":[1.01,1.0001,1.01]'
feed "{$tight}" arclength
equal 'lengths near their chords: what is told' \
  '"wiggle" "inconsistent-lengths" "sharp-corners" absent' \
  "$(get 'warnings[0].code') $(get 'warnings[1].code') \
$(get 'warnings[2].code') $(get 'warnings[3]')"
equal 'lengths near their chords: the tightest' 3 "$(get 'warnings[1].segment')"
true_that 'lengths near their chords: why' grep -q \
  '; lengths\[1\] is 0.0001 above its chord, relative, where a turn of 1.57 '\
'takes 0.103 \[inconsistent-lengths\]$' err
equal 'lengths near their chords: corners' \
  "phspline: -:1: record 1: warning: the curve is nearly a polygon with sharp \
corners: its least speed is $(get diagnostics.min_speed |
    awk '{ printf "%.2g", $1 }') of the mean [sharp-corners]" \
  "$(sed -n 3p err)"
true_that 'lengths near their chords: the speed' holds_speed
feed "{$tight}" arclength --strict
equal 'lengths near their chords: strict' 1 "$status"

warning 'a saddle' saddle '' 'the curve bends least in the plane of the data, '\
'but not in space: "planar":"free" lets it leave the plane' \
  '"points":[[0,0],[1,0],[0,1],[1,1]]'
feed '{"points":[[0,0],[1,0],[0,1],[1,1]],"planar":"free"}' arclength --strict
expect 'no saddle in space' 0
equal 'no saddle in space: a minimiser' '"minimiser" false' \
  "$(get diagnostics.second_order) $(get diagnostics.planar)"

# A plane curve has a frame that turns by a multiple of 180 degrees: a closed
# one with these lengths was found in space only.
leaves='{"points":[[4,2],[-3,0],[4,2],[-4,3]],"closed":true,
"lengths":[7.7,7.7,8.53,8.53]}'
leaves_says='the data lie in a plane, in which no curve was found: this one '\
'leaves it'
feed "$leaves" arclength
equal 'out of the plane: a warning, the first' \
  "0 phspline: -:1: record 1: warning: $leaves_says [leaves-plane]" \
  "$status $(sed -n 1p err)"
equal 'out of the plane: the record' \
  "\"ok\" false {\"code\":\"leaves-plane\",\"message\":\"$leaves_says\"}" \
  "$(get status) $(get diagnostics.planar) $(get 'warnings[0]')"
get 'segments[0].control_points[2][2]' |
  holds 'out of the plane: z is not 0' 'x[1] * x[1] > 1e-4'
feed "$leaves" arclength --strict
expect 'out of the plane: an error under --strict' 1 \
  "phspline: -:1: record 1: $leaves_says [leaves-plane]
$(failed 1 1)"

# Several warnings: each has its line, in the order of the record, and the first
# is the failure under --strict.
feed "{$fig5,\"lengths\":[9,4.5,4]}" arclength
equal 'two warnings: the record' '"wiggle" "inconsistent-lengths" absent' \
  "$(get 'warnings[0].code') $(get 'warnings[1].code') $(get 'warnings[2]')"
equal 'two warnings: two lines' '[wiggle] [inconsistent-lengths]' \
  "$(sed 's/.*\[/[/' err | tr '\n' ' ' | sed 's/ $//')"
feed "{$fig5,\"lengths\":[9,4.5,4]}" arclength --strict
equal 'two warnings: the first fails' '1 "wiggle"' \
  "$status $(get error.code)"

# ---- no convergence ----------------------------------------------------------

# lost NAME MESSAGE PROBLEM: there is no curve.  Its numbers, which tell where the
# iteration has stopped, are written N.
lost() {
  feed "{$3}" arclength
  equal "$1" "1 phspline: -:N: record N: $2 [no-convergence]
phspline: N of N records failed" "$status $(sed 's/[0-9][0-9.e+-]*/N/g' err)"
  equal "$1: the record" '"error" "no-convergence" absent absent' \
    "$(get status) $(get error.code) $(get segments) $(get diagnostics)"
}

unmet="lengths[N]: is not met: N asked for, N attained in interval N by the best \
of N starts"
room='--refine=N gives the curve more room'
measured='--length_sigma=N allows for lengths that were measured'
again='--starts=N begins anew N times'
lost 'lengths that hardly exceed the chords' \
  "lengths[N]: is not met by N starts: it is N above its chord, relative, where \
a turn of N takes N; residual N of the mean length; $room" \
  "$fig5,\"lengths\":[4.358903,2.2360702,1.7320525],\"refine\":2"
true_that 'lengths that hardly exceed the chords: the tightest' grep -q \
  'lengths.0.: is not met by [0-9]* starts: it is 9.31e-07 above its chord, '\
'relative, where a turn of 2.11 takes 0.185; .*; --refine=3 gives the curve more' err
lost 'lengths far below the chords, hardly soft' \
  "lengths[N]: is not met by N starts: it is N below its chord, relative, where \
a turn of N takes N; residual N of the mean length; --override=length_sigma=N lets \
them differ by more" \
  '"points":[[0,0,0],[1,0,0],[1,1,0.5],[0,1,1],[0.3,0.2,2]],
   "lengths":[0.5,0.6,0.7,0.5],"length_sigma":1e-9'
feed "$(cat in)" arclength --override=length_sigma=0.0001 --quiet
expect 'lengths far below the chords: the advice' 0
lost 'no more segments to be had' \
  "$unmet, naturally N; residual N of the mean length; $measured" \
  '"derivatives":[[1e6,0,0],[0,1,0],[0,0,1]],"lengths":[1,1],"refine":3'
lost 'derivatives that are too large' \
  "$unmet, naturally N; residual N of the mean length; $measured" \
  '"derivatives":[[1e6,0,0],[0,1,0],[0,0,1]],"lengths":[1,1]'
tangents='"tangents":[[1,0,0],[0,1,0],[0,0,1]],"lengths":[1,1e-9]'
lost 'tangents whose lengths differ too much' \
  "$unmet; residual N of the mean length; $room" "$tangents,\"refine\":2"
true_that 'tangents, more segments' grep -q -e '; --refine=3 gives' err
lost 'tangents, measured' "$unmet; residual N of the mean length; \
--tangent_sigma=N allows for tangents that were measured" \
  "$tangents,\"refine\":3"
tangents="$tangents,\"tangent_sigma\":1e-9"
lost 'tangents, more starts' "$unmet; residual N of the mean length; $again" \
  "$tangents"
true_that 'tangents, more starts: how many' grep -q -e '; --starts=20 begins' err
lost 'tangents, nothing more to try' "$unmet; residual N of the mean length" \
  "$tangents,\"refine\":3,\"starts\":20"
still='tangents: have no curve that was found by N starts but some that stand '\
'still at one of them'
lost 'tangents that turn back' \
  "$still; --magnitudes=mean gives each derivative a length" \
  '"tangents":[[1,2,3],[-1,-2,-3],[1,2,3]],"lengths":[1,2]'
