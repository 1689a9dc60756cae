# SPDX-License-Identifier: GPL-3.0-or-later
#
# Offsets as loops: options, joins, warnings, tables, paths, samples, and what
# verify says of loops that are not what they claim.
. "$srcdir/tests/cli/lib.sh"

plate='"closed":true,"tolerance":0.01,"curve":[[[0,0],[10,0]],[[10,0],[10,4]],'
plate="{$plate"'[[10,4],[0,4]],[[0,4],[0,0]]]}'
angle='{"tolerance":0.01,"curve":[[[0,0],[6,0]],[[6,0],[6,6]]]}'
bone='{"closed":true,"tolerance":0.01,"curve":[[[0,0],[8,0]],[[8,0],[8,3]],'
bone="$bone"'[[8,3],[20,3]],[[20,3],[20,0]],[[20,0],[28,0]],[[28,0],[28,8]],'
bone="$bone"'[[28,8],[20,8]],[[20,8],[20,5]],[[20,5],[8,5]],[[8,5],[8,8]],'
bone="$bone"'[[8,8],[0,8]],[[0,8],[0,0]]]}'
eight='{"closed":true,"points":[[0,0],[7,5],[10,0],[7,-5],[0,0],[-7,5],[-10,0],[-7,-5]]}'
spiral=$srcdir/data/spiral.csv

# ---- options -------------------------------------------------------------------

# refused NAME MESSAGE ARGUMENT...
refused() {
  name=$1
  message=$2
  shift 2
  feed "$plate" tc "$@"
  expect "$name" 2 "phspline: $message
Try 'phspline tc --help'." ''
}

refused 'no such mode' "--offset-mode must be raw|joined|trimmed, found 'trim'; did you mean \"trimmed\"?" \
  --offset=1 --offset-mode=trim
refused 'no such join' "--offset-join must be round, miter or miter:LIMIT with \
a number of 1 or more, found 'bevel'" --offset=1 --offset-join=bevel
refused 'a limit below 1' "--offset-join must be round, miter or miter:LIMIT \
with a number of 1 or more, found 'miter:0.5'" \
  --offset=1 --offset-mode=joined --offset-join=miter:0.5
refused 'ends without loops' \
  '--offset-ends needs --offset-mode=joined or trimmed' \
  --offset=1 --offset-ends=round
refused 'a mode without offsets' '--offset-mode needs --offset' \
  --offset-mode=trimmed

feed '{"points":[[1,0,0],[0,1,0],[0,0,1]]}' sphere --offset=0.1 \
  --offset-mode=trimmed
expect 'on a sphere' 1 "phspline: -:1: record 1: only curves in the plane have \
joined and trimmed offsets; --offset-mode=raw is for all [bad-value]
phspline: 1 of 1 records failed"

for option in join=miter sides=both touching=keep; do
  refused "$option without loops" \
    "--offset-${option%=*} needs --offset-mode=joined or trimmed" \
    --offset=1 --offset-$option
done

for mode in joined trimmed; do
  feed "$plate" tc --offset=1e-14 --offset-mode=$mode
  expect "$mode: too small" 1 "phspline: -:1: record 1: the distance 1e-14 of a \
joined or trimmed offset is too small beside the size of the curve [bad-value]
phspline: 1 of 1 records failed"
  for d in 1e160 1e308; do
    feed "$plate" tc --offset=-$d --offset-mode=$mode
    expect "$mode: too large, $d" 1 "phspline: -:1: record 1: the area of \
the offset at distance -1e+${d#1e} exceeds the range of a double [too-large]
phspline: 1 of 1 records failed"
  done
  feed "$plate" tc -q --offset=-1e150 --offset-mode=$mode
  equal "$mode: large" 0 "$status"
done

# ---- joins ---------------------------------------------------------------------


# sums NAME LENGTH AREA: of the first offset
sums() {
  printf '%s\n%s\n' "$2" "$3" >wanted
  printf '%s\n%s\n' "$(get 'offsets[0].length')" "$(get 'offsets[0].area')" \
    >found
  numbers "$1" 1e-12 wanted found
}

feed "$plate" tc --offset=-3 --offset-mode=joined
expect 'round joins' 0 ''
sums 'round joins: sums' 46.84955592153876 152.27433388230813
equal 'round joins: 4 segments and 4 joins' '4 4' \
  "$(grep -o '"segment":[0-9]*,"interval"' out | wc -l | tr -d ' ') \
$(grep -o '"join":[0-9]*,"angle"' out | wc -l | tr -d ' ')"
feed "$plate" tc --offset=-3 --offset-mode=joined --offset-join=miter
sums 'miters' 52 160
feed "$plate" tc --offset=-3 --offset-mode=joined --offset-join=miter:1.2
sums 'too far for a miter' 46.84955592153876 152.27433388230813
feed "$angle" tc --offset=1 --offset-mode=joined
equal 'nothing is joined inside' 12 "$(get 'offsets[0].length')"
equal 'nothing is joined inside: no area' absent "$(get 'offsets[0].area')"
feed "$angle" tc --offset=1 --offset-mode=trimmed --offset-ends=round
expect 'round ends' 0 ''
cp out record
run verify record
expect 'round ends: verified' 0

# what is left is to the right, though the distance is to the left
feed '{"tolerance":0.01,"curve":[[[-4,-5],[-5,-5]],[[-5,-5],[0,-9]],
  [[0,-9],[3,10]],[[3,10],[-3,-7]]]}' tc --offset=7 --offset-mode=trimmed \
  --offset-ends=round
expect 'one side of both' 0 ''
equal 'one side of both: all along the curve' 0 \
  "$(grep -o '"interval":\[[0-9.]*,0\],"control' out | wc -l | tr -d ' ')"
cp out record
run verify record
expect 'one side of both: verified' 0

# ---- parts that run on each other ------------------------------------------------

# a line and half of it back, whose end is within; its outline is that of the line
feed '{"tolerance":0.01,"curve":[[[4,6],[6,4]],[[6,4],[5,5]]]}' tc \
  --offset=0.5 --offset-mode=trimmed --offset-ends=round
sums 'there and half of it back' 8.798446903082173 3.613825288143639
# the same with a way off; a T with an end on each side of it
feed '{"tolerance":0.01,"curve":[[[0,0],[10,0]],[[10,0],[3,0]],[[3,0],[3,4]]]}' \
  tc --offset=0.5 --offset-mode=trimmed --offset-ends=round
sums 'there, some of it back, and off' 30.712388980384695 14.678097245096172
# sides that run on one another in part, closed: areas by GEOS
feed '{"closed":true,"tolerance":0.01,"curve":[[[3,1],[-6,-1]],[[-6,-1],[-6,0]],
  [[-6,0],[-6,-4]],[[-6,-4],[6,-6]],[[6,-6],[3,1]]]}' tc \
  --offset=0.739681 --offset-mode=trimmed --offset-sides=both
equal 'a spike on a side: closed' '0 2' "$status \
$(grep -o '{"closed":true' out | wc -l | tr -d ' ')"

# a corner that is on another line, and one that another one is at: the ends of
# parts that touch there are 1e-9 of the size apart, or beyond each other
certified() {
  equal "$1" '0 true' "$status $(get 'offsets[0].diagnostics.certified')"
  cp out record
  run verify record
  expect "$1: verified" 0
}
feed '{"tolerance":0.01,"closed":true,"curve":[[[-13,16],[-9,-5]],
  [[-9,-5],[-9,20]],[[-9,20],[0,-11]],[[0,-11],[-11,17]],[[-11,17],[14,-8]],
  [[14,-8],[-17,17]],[[-17,17],[2,4]],[[2,4],[-13,16]]]}' tc -q \
  --offset=5.21457 --offset-mode=trimmed --offset-sides=both
certified 'a corner on a line'
feed '{"tolerance":0.01,"curve":[[[6,-18],[-19,3]],[[-19,3],[8,8]],
  [[8,8],[6,-18]],[[6,-18],[8,0]]]}' tc -q --offset=-0.522114 \
  --offset-mode=trimmed --offset-ends=round
certified 'an end at a corner'
# where the curve nearly stops lengths take more places
feed '{"points":[[8,-18],[-20,-8],[-10,11],[-12,-16],[16,11],[2,-20],[4,-17]],
  "closed":true}' planar -q --offset=-1.79 --offset-mode=trimmed \
  --offset-sides=both
certified 'the curve nearly stops'

# a quarter circle there, and back 9e-9 of the size from it
feed '{"tolerance":1e-3,"curve":[
  [[1,0],[1,0.5522847],[0.5522847,1],[0,1]],[[0,1],[0,1.000000009]],
  [[0,1.000000009],[0.552284705,1.000000009],[1.000000009,0.552284705],
  [1.000000009,0]]]}' tc --offset=-0.3 --offset-mode=trimmed \
  --offset-ends=round
expect 'beside itself' 1 "phspline: -:1: record 1: the offset at distance -0.3 \
runs along itself in too many places [no-convergence]
phspline: 1 of 1 records failed"

# ---- miters beyond the curve -----------------------------------------------------

# the tip at the end of a slit is beyond the other side; areas are those of GEOS
feed '{"closed":true,"tolerance":0.01,"curve":[
  [[-9.119,-5.581],[-5.596,9.160]],[[-5.596,9.160],[-1.301,2.406]],
  [[-1.301,2.406],[-3.522,-1.316]],[[-3.522,-1.316],[5.257,6.872]],
  [[5.257,6.872],[6.106,4.305]],[[6.106,4.305],[-9.119,-5.581]]]}' tc \
  --offset=-1.16 --offset-mode=trimmed --offset-join=miter:10
expect 'a tip beyond the curve' 0 ''
sums 'a tip beyond the curve: sums' 21.379802842957446 -18.31632340369873
feed '{"closed":true,"tolerance":0.01,"curve":[[[1.24,8.193],[1.329,-2.44]],
  [[1.329,-2.44],[0.802,2.174]],[[0.802,2.174],[-2.826,-3.303]],
  [[-2.826,-3.303],[-5.434,-7.29]],[[-5.434,-7.29],[1.24,8.193]]]}' tc \
  --offset=-7.994656 --offset-mode=trimmed --offset-join=miter:10
equal 'tips beyond the curve alone' '0 []' "$status $(get 'offsets[0].loops')"

# ---- warnings ------------------------------------------------------------------

warning='phspline: -:1: record 1: warning:'
feed "$plate" tc --offset=2.5 --offset-mode=trimmed
expect 'nothing is left' 0 "$warning nothing is left of the offset at distance \
2.5: no point of it keeps that distance from the curve; something is left up \
to 2 [offset-empty]"
equal 'nothing is left: loops' '[]' "$(get 'offsets[0].loops')"
back='"closed":true,"tolerance":0.01,"curve":[[[0,0],[0,4]],[[0,4],[10,4]],'
feed "{$back"'[[10,4],[10,0]],[[10,0],[0,0]]]}' tc --offset=-1,-1e9 \
  --offset-mode=trimmed
expect 'nothing is left to the right' 0 "$warning nothing is left of the offset \
at distance -1e+09: no point of it keeps that distance from the curve; \
something is left up to -2 [offset-empty]"
# ellipse N WOBBLE: points of one with half axes 2 and 1
ellipse() {
  awk -v n="$1" -v wobble="$2" 'BEGIN {
    for (i = 0; i < n; i++) {
      a = 6.283185307179586 * i / n
      r = 1 + wobble * sin(int(n / 7) * a)
      printf "%.15g,%.15g\n", 2 * r * cos(a), r * sin(a)
    }
  }'
}
ellipse 1000 0 >many.csv
run planar --closed --offset=2 --offset-mode=trimmed many.csv
expect 'nothing is left of many segments' 0 "phspline: many.csv:1: record 1: \
warning: nothing is left of the offset at distance 2: no point of it keeps that \
distance from the curve; something is left up to 1 [offset-empty]"
# where all of the curve is near the depth it would take too long
ellipse 1400 0.02 | awk -F, '{ print $1 / 2 "," $2 }' >many.csv
run planar --closed --offset=2 --offset-mode=trimmed many.csv
expect 'nothing is left, and it is not said up to where' 0 "phspline: \
many.csv:1: record 1: warning: nothing is left of the offset at distance 2: no \
point of it keeps that distance from the curve [offset-empty]"
feed "$bone" tc --offset=1 --offset-mode=trimmed
expect 'a neck of twice the distance' 0 "$warning the offset at distance 1 \
touches itself: a slightly different distance may give other loops \
[offset-touch]"
feed "$eight" planar --offset=0.5 --offset-mode=trimmed
expect 'a curve that crosses itself' 0 "$warning the curve crosses itself: the \
trimmed offset to one side is open where the other side takes over; \
--offset-sides=both closes it [self-crossing]"
feed "$eight" planar --offset=0.5 --offset-mode=trimmed --offset-sides=both
expect 'both sides' 0 ''
equal 'both sides: all closed' 3 \
  "$(grep -o '{"closed":true' out | wc -l | tr -d ' ')"

# ---- nesting -------------------------------------------------------------------

feed "$bone" tc --offset=0.5,1.5,2 --offset-mode=trimmed
expect 'nested' 0 ''
equal 'nested: parents' 'null 0 0 0 1' \
  "$(grep -o '"parent":[a-z0-9]*' out | sed 's/.*://' | tr '\n' ' ' |
    sed 's/ $//')"

# ---- where they are written ----------------------------------------------------

feed "$bone" tc --offset=1.5 --offset-mode=trimmed --table=offsets
equal 'table of offsets' 'id,distance,segment,index,x,y,weight,loop,piece' \
  "$(sed 1q out)"
equal 'table of offsets: loops' '0 1' \
  "$(sed 1d out | cut -d, -f8 | sort -u | tr '\n' ' ' | sed 's/ $//')"
feed "$bone" tc --offset=1.5 --offset-mode=trimmed --table=samples --spacing=1 \
  --format=text
equal 'table of samples' \
  '# id segment t s x y tx ty curvature distance loop' "$(sed 1q out)"
equal 'table of samples: curve and loops apart' 4 "$(grep -c '^$' out)"
feed "$bone" tc --offset=1.5 --offset-mode=trimmed --format=svg-path
equal 'paths' '3 3' "$(tr -dc M <out | wc -c | tr -d ' ') \
$(tr -dc Z <out | wc -c | tr -d ' ')"

# beside OPTION...: how far the cubics of paths are from the pieces of loops
beside() {
  run "$@"
  cp out pieces
  run "$@" --format=svg-path --chord-error=1e-3
  beside_status=0
  said=$(python3 "$srcdir/tests/cli/svg_loops.py" pieces out 1e-3 2>&1) ||
    beside_status=$?
  equal "paths beside pieces: $said" 0 "$beside_status"
}
if command -v python3 >/dev/null; then
  printf '%s\n' "$bone" >bone
  beside tc -q --offset=0.5,-1.5 --offset-mode=trimmed bone
  printf '%s\n' "$eight" >eight
  beside planar -q --offset=1.5 --offset-mode=trimmed --offset-sides=both eight
  beside planar -q --basis=atph --tolerance=1e-4 --offset=-1.5,0.4 \
    --offset-mode=trimmed eight
else
  echo 'skip paths beside pieces: no python3'
fi
run planar -q --closed --offset=-5 --offset-mode=trimmed --chord-error=0.1 \
  "$srcdir/data/coastline.csv"
cp out record
run verify record
expect 'samples by chords: verified' 0

# ---- what cannot be changed ----------------------------------------------------

# moved SCALE SHIFT: the spiral; its lengths over the scale
moved() {
  awk -F, -v s="$1" -v d="$2" 'NR == 1 { print; next }
    { printf "%.17g,%.17g\n", $1 * s + d, $2 * s - d }' "$spiral" >moved.csv
  run planar -q --offset="$(awk -v s="$1" 'BEGIN { print 0.1 * s }')" \
    --offset-mode=trimmed --offset-ends=round moved.csv
  get 'offsets[0].length' | awk -v s="$1" '{ printf "%.17g\n", $1 / s }'
}

moved 1 0 >wanted
for change in '1e-9 0' '1e9 0' '3 100' '1 -1000'; do
  # shellcheck disable=SC2086  # two numbers
  moved $change >found
  numbers "scaled and moved by $change" 1e-10 wanted found
done

# ---- what is wrong -------------------------------------------------------------

feed "$bone" tc --offset=1.5 --offset-mode=trimmed
cp out record
sed 's/"loops":\[{"closed":true,"length":[0-9.]*/"loops":[{"closed":true,"length":9/' \
  record >bad
run verify -q bad
equal 'a length that is wrong' 1 "$status"
sed 's/\("loops":.*"control_points":\[\[\)\([0-9.]*\)/\10/' record >bad
run verify -q bad
equal 'a point that is elsewhere' 1 "$status"

# false_that NAME MESSAGE FIELD CHANGE: what verify says of the record, changed by jq
if command -v jq >/dev/null; then
  false_that() {
    jq -c "$4" record >bad
    run verify bad
    equal "$1: status" 1 "$status"
    equal "$1" "offsets[0].loops[N].$3: $2" \
      "$(sed -n 's/phspline: bad:1: record 1: \(.*\) \(by \|(\)[0-9i].*/\1/p' err |
        sed 's/ by .*//; s/loops.[01]/loops[N/' | head -n 1)"
  }
  loop='.offsets[0].loops[0]'
  false_that 'a gap' 'do not begin where the one before ends' pieces \
    "$loop.pieces[1].control_points[0][0] += 1e-6"
  false_that 'a place' 'are not at the distance from the curve' pieces \
    "$loop.pieces[1].control_points[2][1] += 1e-4"
  false_that 'the distance' 'are not at the distance from the curve' pieces \
    '.offsets[0].distance += 1e-4'
  false_that 'a length' 'is not that of its pieces' length "$loop.length += 1e-7"
  false_that 'an area' 'is not what its pieces are around' area \
    "$loop.area += 1e-5 | .offsets[0].area += 1e-5"
  false_that 'twice round' 'do not turn once to one side' pieces \
    "$loop.pieces += $loop.pieces | $loop.length *= 2 | $loop.area *= 2 |
      .offsets[0].length += $loop.length / 2 | .offsets[0].area += $loop.area / 2"
else
  echo 'skip what verify says of loops: no jq'
fi

# ---- areas that are no doubles ---------------------------------------------------

# Parts of it touch; all loops were taken for thin then, and nothing was left.
for unit in e180 e-180; do
  feed "$(printf '{"points":[[64U,0],[48U,6U],[0,5U],[9U,10U],[0,6U],[0,0],
[48U,15U],[5U,20U],[0,9U],[0,0],[9U,10U],[0,6U]]}' | sed "s/U/$unit/g" |
    tr -d '\n')" planar --basis=atph --offset="1.5$unit" \
    --offset-mode=trimmed --offset-ends=round
  expect "an area beyond $unit" 1 "phspline: -:1: record 1: the area of the \
offset at distance $(printf %g "1.5$unit") exceeds the range of a double \
[too-large]
phspline: 1 of 1 records failed"
done
