# SPDX-License-Identifier: GPL-3.0-or-later
#
# phspline verify: right results where curves all but stand still, turn back or
# are far from the origin, so that rounding is a large part of what they say; of
# most of them random problems had the like.
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/verify.sh"

# rounding hides where curves nearly stand still, and which way they go there
echo '{"points":[[-22730000,-51834000],[-22730000,-51834400]],
  "derivatives":[[0,-2e-9],[0,20000]]}' >still
made tc <still
verified 'a derivative below rounding' 1 --problems=still
echo '{"points":[[2229065.45617269,16031338.93436713],
  [2229078.934760216,16031336.216885017],[0,0]],
  "tangents":[[0.98027509,-0.19763792137],[0.9803,-0.1977],[0,-0.2]]}' >still
made tc --offset=9 <still
verified 'an offset beside a point at rest' 1 --problems=still

# a curve that all but stops next to an end of its segment: its normals turn
# once around there, on 1e-5 of it, and Bezier pieces must follow
echo '{"points":[[113530000,0,0],[0,114000000,-140172000]],"basis":"atph",
  "alpha":[0.00001],"derivatives":[[-109133000,109000000,-134743000],
  [-172700000,0,-213200000]],"criterion":"hc"}' >still
made spatial-hermite --offset=-2 <still
verified 'Bezier pieces of an offset beside a place of rest' 1 --problems=still

# loops whose legs are as short as 500 roundings of their points: where they
# meet, these turn them
echo '{"points":[[23117.463683140613,17638.662272387228],
  [23117.463683140835,17638.66227238275],
  [23117.463683114784,17638.662272386086]],"closed":true,"basis":"atph",
  "knots":[0,0.001984432246710496,0.957258502082726,1.0927950709388177]}' >short
made planar --offset=-2.9e-16 --offset-mode=trimmed <short
verified 'a loop with legs of a few roundings' 1 --problems=short

# to which side of the curve such a loop is, rounding would tell
echo '{"points":[[2653482246.0291743,1663516652.3456593],
  [2653482246.018706,1663516651.7907066],
  [2653482246.0171638,1663516651.7872407]],"closed":true,"basis":"atph",
  "knots":[0,0.14980688907177112,0.4500433536708387,0.6029757338131245]}' >short
made planar --offset=-4.08e-9 --offset-mode=trimmed --offset-ends=round <short
verified 'a loop nearer than rounding' 1 --problems=short

# an offset nearer than points are apart: every part of the curve is as far from
# its places, and cutting all of them for the nearest had no end
echo '{"points":[[-44978494816.67456,-12164212188.319405],
  [-44978494817.41782,-12164212187.96565],
  [-44978494818.02393,-12164212187.677002],
  [-44978494819.29208,-12164212187.073067]],"basis":"atph"}' >short
made planar --offset=2.2e-6 --offset-mode=trimmed --time-limit=20 <short
verified 'an offset nearer than points are apart' 1 --problems=short
echo '{"points":[[0,0],[-0.02049794,0.188658646],[-0.02049794,0.18865864599]],
  "basis":"atph","end_derivatives":[[0,0.09],[0,3e-9]]}' >still
made planar --offset=-0.2 <still
verified 'Bezier pieces of an offset where rounding stands still' 1 \
  --problems=still
echo '{"points":[[1,0,0],[0,1,0],[-1,0,0]],"closed":true,"basis":"atph",
  "derivatives":[[0,0.027671646892577766,0],[0,241608.12285681514,0],
  [0,0,2.0639614300918064e-8]],"criterion":"F3",
  "tension":[0.5043872332339225,0.48,0.83]}' >still
made spatial-hermite <still
verified 'an F3 that is not finite is not told' 1 --problems=still
for command in planar tc; do
  echo '{"points":[[0,0],[-0.2,-4e-9],[-0.2,0]],"solutions":"all"}' >still
  made "$command" <still
  verified "$command: solutions that turn back" 1 --problems=still
done

# an offset that turns back in a segment too short for rounding, with its cusp
for command in planar 'planar --basis=atph' tc; do
  echo '{"points":[[-71.429795,-53.856455],[-72.557943,-53.53141],
    [-73.702757,-52.835069],[-73.702757,-52.83507],[-74.946763,-52.262754],
    [-75.260026,-51.629355]]}' >short
  # shellcheck disable=SC2086 # two words
  made $command --offset=0.5,-0.5 <short
  verified "$command: a short segment" 1 --problems=short
done

# the offset moves farther than the curve, where the curve is all but at rest
echo '{"points":[[55.6928477284,-132.09986533,-123.81445894337],
  [55.6928478189,-132.09986524,-123.81445896585]],"criterion":"hc",
  "derivatives":[[4.7e-13,5e-13,-1.167e-13],[0,8e-11,0]]}' >still
made spatial-hermite --offset=-8e-7 --sample=2 <still
verified 'an offset that turns at once' 1 --problems=still

# the square of the preimage is larger than the largest double
echo '{"points":[[0,0,0],[0,0,1e299],[-2e299,2e299,0]],"closed":true,
  "basis":"atph","alpha":[3,2e-9,0.00002]}' >huge
made spatial-hermite --offset=1e300 --sample=2 <huge
verified 'an offset of a huge ATPH spline' 1 --problems=huge

# lengths of segments that run back for a moment, at points near each other and
# on a great circle
echo '{"points":[[-245.34,0,0],[-245.34,5e-10,0]],"center":[-246.34,0,0],
  "end_tangents":[[0,-1,-0.3],[0,0.2,-0.9]]}' >back
made sphere --sample=3 <back
verified 'a short segment that runs back' 1 --problems=back
echo '{"points":[[-0.0372291,0.00512297,0.0564435],
  [-0.05769593,0.019875403,0.02956793],[-0.0609783,0.02379864,0.01770275],
  [-0.0582864,0.0298604,-0.017583],[-0.0400889,0.02775815,-0.04712196]],
  "closed":true,"knots":"uniform","radius":0.0678}' >back
made sphere --sample=3 <back
verified 'data that turn back on a great circle' 1 --problems=back

# tensions where a control point is all but at its node
echo '{"points":[[0.2944,0.1291,0.947],[0.442913,0.170524,-0.8802],
  [-0.436408,-0.167847,0.88395],[0.288,0.1535,-0.945],[0.46,-0.037,0.887]],
  "closed":true,"increase":"times:1.22"}' >near
made sphere <near
verified 'tensions of 1e6' 1 --problems=near

# frames that minimise rotation, where the curve turns in a short part of the way
# from sample to sample
echo '{"points":[[0,0,0],[1.75,5.2,-3.2],[1.6,4.78,-2.9],[1.94,5.8,-3.5]],
  "tension":0.02}' >turn
made spatial-hermite --chord-error=0.2 --frame=rmf <turn
verified 'a frame past a sharp turn' 1 --problems=turn
echo '{"points":[[16100,9640,-14242],[20350,13126,-16390]],
  "derivatives":[[2000,1000,-900],[17060,13980,-8630]],"angles":[[2,0]],
  "tension":0.01}' >turn
made spatial-hermite --spacing=700 --frame=rmf <turn
verified 'a frame past a sharp turn at the end' 1 --problems=turn

echo '{"points":[[0,0],[-0.8834355200853541,-0.7551059326024923],
  [-2.212511093077798,-1.8911173643668477],
  [-3.0896721784580876,-2.6408923469520484],
  [-4.002632165849601,-3.421266601645524],
  [-4.520027557981081,-3.8635226140565004],
  [-5.364595625224037,-4.58541782617133],
  [-6.612854919821997,-5.653073400303445]],
  "angles":[[3.04,-0.13]],"shape":true}' >turn
made spatial-hermite --spacing=0.5287583267606409 --frame=rmf <turn
verified 'a frame past hairpins' 1 --problems=turn

echo '{"points":[[0.336617840065421,-0.386345475529631,3.0104345469],
  [-0.066941048,0.07650405456,-0.600556828298535]],
  "derivatives":[[-0.3041232027379,0.347565938629,-2.7283258567181],
  [-0.51751661522599,0.593549862,-4.630669997851568]],"criterion":"hc"}' >turn
made spatial-hermite --chord-error=0.05 --frame=rmf <turn
verified 'a frame past a point all but at rest' 1 --problems=turn
printf '%s' '{"points":[[0,0],[1.2690941969889147,0.09367675889563061],' \
  '[4.382300403539277,0.323474568936319],[6.25177501205922,' \
  '0.4614677317601156],[7.891621282444952,0.5825111374121904]],"knots":[0,' \
  '0.0043344230862208954,0.1237915268580709,0.13682717084583804,' \
  '0.6549447271070675]}' >turn
made arclength --spacing=0.31 --frame=rmf <turn
verified 'a frame past points at rest' 1 --problems=turn

# ... and of which points say less than tangents
echo '{"points":[[0,0,0],[-100000,300000,0],[0,500000,0]],"basis":"atph",
  "knots":[-2.1,-2.05,-2],"alpha":[2,2e-9],"angles":[[0,-2]]}' >turn
made spatial-hermite --sample=5 --frame=rmf <turn
verified 'a frame from one point at rest to the next' 1 --problems=turn
echo '{"points":[[0,0,0],[0,-0.4945,0.5],[-0.7,-1.4,0]],"tension":0.00029}' \
  >turn
made spatial-hermite --sample=3 --frame=rmf <turn
verified 'a frame that turns at once' 1 --problems=turn

# the torsion of a straight line is nothing but rounding, in offsets as well
echo '{"points":[[900000,0,0],[0,900000,-700000]]}' >straight
made spatial-hermite --offset=0.2,0 --sample=4 <straight
verified 'a torsion of a straight line' 1 --problems=straight
echo '{"points":[[0,0,0],[0.2,0.2,-0.5]],"basis":"atph"}' >straight
made spatial-hermite --offset=0 --sample=4 <straight
verified 'a torsion of a straight ATPH segment' 1 --problems=straight

# straight but for the last digits of the data
echo '{"points":[[0,0],[-0.0271615966674,0.00374874198599]],"angles":[[1.2,0]],
  "tangents":[[-0.990609698336,0.136720245623],
    [-0.990609698336,0.1367202456227]]}' >straight
made spatial-hermite <straight
verified 'energies of a straight line' 1 --problems=straight

# F3 was minimised, which cannot be found where a segment is in a plane
echo '{"points":[[0,0,0],[-1,-0.664054300770604,-1],[0,-1.06,-2]],
  "tangents":[[0,0,-1],[0,1,0],[0,1,0]],"criterion":"F3"}' |
  made spatial-hermite
verified 'a functional that cannot be found' 1

# a preimage that leaves the plane by rounding, near an inflection
echo '{"points":[[253474000,-20267320,-65570277.253426574],
  [253473960,-20267300,-65570277.253426574]],
  "derivatives":[[0,2,0],[0,0.3,8e-12]]}' >flat
made spatial-hermite <flat
verified 'the torsion of a plane curve' 1 --problems=flat

# a gap of the offset of a curve that is much larger than its points
echo '{"points":[[0,0,0],[0,-0.4,-1],[0.1,0,0],[0,0,1.4],[-0.2,0.1,0]],
  "closed":true,"derivatives":[[0,0,50],[0,0,-0.000005],[0,300,0],[0,-0.1,0],
  [14000000,0,0]],"angles":[[0,3],[0,-2.4],[0,0.6],[0,-1],[0,-1.3]]}' >loop
made spatial-hermite --offset=-0.004 <loop
verified 'a gap beside a large loop' 1 --problems=loop

# far from the origin, at the limit of what the certificate lets pass
echo '{"points":[[2495112.461302111,262810.117817,-408608.6083],
  [2495112.4613,262810.11781,-408608.6083]]}' >far
made arclength <far
verified 'three digits of a chord' 1 --problems=far

echo '{"points":[[133717.7834594217,29492.047060136585,256041.9925500446],
  [133717.78345941022,29492.047060139506,256041.99255003937]],
  "criterion":"hc"}' >far
made spatial-hermite <far
verified 'as many, but for what is between the nodes' 1 --problems=far

echo '{"points":[[-956492.01389923,-511294.8169636,-987750.968295788],
  [-956492.395295343,-511295.26818616,-987750.95221672],
  [-956493.435820385,-511296.49921179,-987750.90834983],
  [-956492.625,-511295.545,-987750.945]],"closed":true}' >far
made arclength <far
verified 'a plane but for the rounding of coordinates' 1 --problems=far

# a curve that rests at its end and turns back soon after: the speed is 0 there in
# any case, so that a quadrature does not see the turn by the value
echo '{"points":[[-75.342,0,0],[-75.37539466,0.255007,0],
  [-75.37539482,0.255008,0]],"knots":[0,0.306149112,0.306149708],
  "center":[-76.342,0,0],"ends":"rest"}' >back
made sphere <back
verified 'a turn next to an end at rest' 1 --problems=back
sed 's/"length":0.257940214/"length":0.257940314/' r >tampered
run verify tampered
equal 'its length, 1e-7 longer' '1 "not-verified"' "$status $(get error.code)"

# tensions beside a segment of which rounding is a part of 1e-8
echo '{"points":[[864.6828,-15.2619,-0.57072],[864.6828,-15.2619,-0.570723],
  [864.896,-15.18,-0.13],[864.868,-14.536,0.13],[864.59,-14.1446,0.11]],
  "center":[863.9455,-14.9,0]}' >short
made sphere <short
verified 'tensions without unit beside a short segment' 1 --problems=short

# coordinates that are known to more digits than what they are from the center
echo '{"points":[[0,0,0],[-5e-13,1e-6,0],[-1e-12,1e-6,1e-6],
  [-2.5e-12,2e-6,1e-6]],"center":[-1,0,0],"radius":1}' >near
made sphere --offset=0.1 <near
verified 'a curve on a sphere next to the origin' 1 --problems=near

# a piece of an offset that is short beside where it is
echo '{"points":[[0,0,0.8797460296266113],[1e-14,0,0.8797460296266113]]}' >short
made arclength --offset=0 <short
verified 'an offset of a chord of 45 roundings' 1 --problems=short

# a hodograph with fewer digits than its piece, which is short, from node to node
echo '{"curve":[[0,0],[8.7e-14,-1.75e-13],[0.77,0.26]],"pieces":7}' >short
made tc --offset=0.84 <short
verified 'an offset beside a leg that is rounding' 1 --problems=short

# a hairpin between two points of the grid on which the nearest one is looked for
echo '{"curve":[[0,0],[4.6,7.5],[4.5,7.2]],"tolerance":0.8}' >hairpin
made tc <hairpin
verified 'the distance from a hairpin' 1 --problems=hairpin
sed 's/"distance":0.01155/"distance":0.00955/' r >tampered
run verify --problems=hairpin tampered
equal 'its distance, less than there is' '1 "not-verified"' \
  "$status $(get error.code)"

# a cusp where the curve turns back, at distance 0
echo '{"points":[[0,-8e183,0],[-1.98e185,-5.5e183,4.4e184],
  [-2.922e184,-7.97e182,6.4504e183],[-6.8653e184,-1.901e183,1.517e184],
  [1.59e184,4.674e182,-3.523e183]],"criterion":"hc"}' >back
made spatial-hermite --offset=0 <back
verified 'a cusp where the curve all but stands still' 1 --problems=back

# an offset turns by 2 pi where its curve is 4e-19 as fast as elsewhere, which
# its preimage knows and its control points do not
echo '{"points":[[0,0],[1.0920653006e-6,-1.6866178275e-6],[3e-6,-5e-6]],
  "tangents":[[0.543505362,-0.8394056954],[0.54350536,-0.8394057],[0,-0.8]],
  "mode":"g1"}' >turn
made tc --offset=-6e-13 --sample=2 <turn
verified 'an offset that turns where its curve is slow' 1 --problems=turn
for s in 200930571611 200930171752 200929995690; do
  sed "s/\"s\":0.00000200930372681542[0-9]*/\"s\":0.00000$s/g" r >tampered
  run verify tampered
  equal "a length of it, off by 1e-6: $s" \
    '1 "not-verified" "offsets[0].samples[2].s"' \
    "$status $(get error.code) $(get error.field)"
done

# energies that have a peak where the curve nearly stops within a segment
echo '{"points":[[0,0],[-0.77,0],[-2.6,0.1],[-4.48,0.1735],[-6.17,0.24],
  [-7.473,0.2897]],"knots":"uniform","end_derivatives":[[-1.3,0.05],
  [-4.2,0.163]],"solutions":"all"}' >slow
made planar <slow
verified 'solutions that nearly stop' 1 --problems=slow

echo '{"points":[[108500709.36164,-119726663.19823],
  [108500708.75984372,-119726663.8020266],
  [108500708.09914371,-119726664.4649266],
  [108500707.32964371,-119726665.2370266]],"solutions":"all"}' >slow
made planar <slow
verified 'solutions that nearly stop next to an end' 1 --problems=slow

# as slow at an end, where its control points are on a line and its preimage is
# not quite: the line has no energy, and what rounding adds has a peak
echo '{"points":[[0,0],[-1,1],[-2,2]],"end_derivatives":[
  [-0.992956758896596,0.992956758896596],
  [-0.000002966749526734,0.0000029667495267343]]}' >slow
made planar <slow
verified 'a line that nearly stops at its end' 1 --problems=slow
sed 's/"IMV":[0-9.]*/"IMV":1e20/' r >tampered
run verify tampered
equal 'an energy that rounding does not make of it' \
  '1 "not-verified" "diagnostics.IMV"' \
  "$status $(get error.code) $(get error.field)"

# energies are as sure as the preimage is, where the curve nearly stops
echo '{"points":[[0,0],[1,2],[3,3]],"end_derivatives":[[1e-12,2e-12],[1,0]]}' \
  >slow
made planar <slow
verified 'a curve that begins at rest, or nearly' 1 --problems=slow
refuses 'such a curve, another IMV' diagnostic_error slow \
  '.diagnostics.IMV *= 1.000001'
echo '{"points":[[1e7,0,0],[10000001,2,1],[10000003,3,0]],"criterion":"cc",
  "derivatives":[[1e-5,1e-5,0],[1,1,1],[1,0,0]]}' >slow
made spatial-hermite <slow
verified 'a curve in space, as slow' 1 --problems=slow
refuses 'such a curve in space, another F2' diagnostic_error slow \
  '.diagnostics.F2 *= 1.000001'

# ... and where its points are rounded: the length that is a factor of them, too
echo '{"points":[[200972749916.89282,-225937962784.9285],
  [200972749916.94357,-225937962784.99536],
  [200972749917.0442,-225937962785.12302]]}' >slow
made planar <slow
verified 'a short curve far away' 1 --problems=slow
refuses 'a short curve far away, another IMV' diagnostic_error slow \
  '.diagnostics.IMV *= 1.000001'

# a derivative that is 1e-14 of the others, and its direction in Bezier pieces
echo '{"points":[[0,0],[-0.832038,0.554718],[-0.850496,0.552927],
  [-1.816692,0.810737],[-1.818023,0.811431],[-2.66409,1.344507]],
  "basis":"atph","end_derivatives":[[0,1.3788703114703979e-8],
  [0,-1601181.2300828213]],"solutions":"all"}' >slow
made planar --convert=bezier <slow
verified 'the direction of a derivative that is rounding' 1 --problems=slow

# all have the same energy, nearly, that of a segment which has no length
echo '{"points":[[0,-0.9],[-0.93,-2],[-0.9,-1.6],
  [-1.338440493563362,-2.0502156580440056],
  [-1.338440493528891,-2.050215658029699]],
  "end_derivatives":[[-0.11651283418269313,-0.7246172774609538],
  [-1.3325848266444351,-2.3080699242282603]],"solutions":"all"}' >alike
made planar <alike
verified 'solutions that bend alike' 1 --problems=alike

# Bezier pieces that are short beside the curve, next to a datum
echo '{"points":[[-7400000000000,1700000000000,-1300000000000],
  [-7423540000000,1673197000000,-1314710000000],
  [-7423540000000,1673200000000,-1314710000000],
  [-7400000000000,1700000000000,-1300000000000]],"basis":"atph",
  "alpha":[2,2,1],"derivatives":[[-600000000000000,0,0],[0,-0.1,0],[0,0,30000],
  [0,2000000000000,0]],"criterion":"hc"}' >short
made spatial-hermite --convert=bezier <short
verified 'short pieces at a datum' 1 --problems=short

# a hairpin, as narrow as the tolerance
echo '{"curve":[[0,0],[-0.2663,1.1335],[-0.075894,0.32304]],
  "tolerance":7e-5}' >hairpin
made tc <hairpin
verified 'a hairpin approximated' 1 --problems=hairpin

echo '{"curve":[[0,0],[0,3e-20],[0.000001,0]],"tolerance":3e-11}' >hairpin
made tc <hairpin
verified 'a curve that starts from rest approximated' 1 --problems=hairpin

# on a great circle, where the curve turns back and forth again
echo '{"points":[[1,0,0],[0.95,0.312,0],[0.796,0.605,0],[0.26,0.965,0],
  [-0.396,0.918,0],[-0.923,0.386,0],[-1,-0.02,0]],"closed":true,
  "knots":"uniform"}' >circle
made sphere --offset=0 --sample=16 <circle
verified 'a sphere, standing still within a segment' 1 --problems=circle

# what is between nearly antipodal control points is rounded as often as the
# great circle there turns with them
cat >wide <<'EOF'
{"points":[[-0.98414231,0.1288660343445101,0.12189118],
[-0.9841423091404403,0.12886603431444643,0.12189118327340183],
[-0.598506,-0.6311515811879611,-0.493394],
[0.5853458109604333,0.6427586424081055,0.494198],
[0.585346,0.6427586424081535,0.49419794536275324],
[0.5853458109602807,0.6427586424084802,0.49419794536244177]],"closed":true,
"tension":[0.0167,59.07174198779707,1.82,97.48504967626302,0.0241,0.88]}
EOF
made sphere --offset=-1.1734098997738285 --chord-error=0.031 <wide
verified 'a sphere, nearly antipodal control points' 1 --problems=wide

# what all but stands still where it turns back, has one side there and one
# direction, as far as both are known
cat >wide <<'EOF'
{"points":[[1.083,0,0],[0.8516,0.64,0],[0.624,0.84,2e-15]],"closed":true,
"tension":[75.741,0.03,0.2],"center":[0.08309,0,0]}
EOF
made sphere --offset=-0.5 --chord-error=0.009 <wide
verified 'a sphere, a parallel where the curve turns back' 1 --problems=wide
refuses 'a sphere, the other side of it' sample_error wide \
  '(.offsets[0].samples[]|select(.segment==2 and .t>0.0383573896835 and
  .t<0.0383573896836)|.point[2]) *= -1'

# ... also of a Bezier curve, at a joint
cat >wide <<'EOF'
{"points":[[0,0,0],[0,0,-40],[-300,300,0]],"closed":true,"basis":"atph",
"alpha":2e-9,"derivatives":[[0,0,-0.003],[0,-2000,0],[0,0,0.03]]}
EOF
made spatial-hermite --sample=5 --convert=bezier <wide
verified 'a Bezier curve that all but stands still' 1 --problems=wide
refuses 'a Bezier curve, between two directions' sample_error wide \
  '.samples[-1].tangent = [0.5,-0.5,-0.7071067811865476]'

# a distance below rounding, where the curve stands still
echo '{"points":[[139616.222,-95049.963],[139616.222,-95049.9628]],
"end_derivatives":[[0,-0.000004],[0,-1e-7]]}' >still
made planar --offset=1e-11 <still
verified 'an offset of no distance from a point at rest' 1 --problems=still
for factor in '(1 + 1e-10)' '(1 - 1e-10)'; do
  refuses 'a plane, beside a point at rest' offset_error still \
    ".offsets[0].segments[0].control_points[-1][1] *= $factor"
done

# where a curve stands still, an offset is at the distance, to whatever side
# aside CHECK PATH PROBLEM: a point of r that is moved by a fiftieth of that is
# refused
aside() {
  refuses "an offset at rest: $2" "$1" "$3" \
    ".offsets[0].$2[0] += 1e-6"
}
made planar --offset=0.00005 --sample=4 --nurbs <still
verified 'an offset of a plane curve at rest' 1 --problems=still
for end in 0 -1; do
  aside sample_error "samples[$end].point" still
  aside nurbs_error "nurbs[0].control_points[$end]" still
  aside offset_error "segments[0].control_points[$end]" still
done
echo '{"points":[[1,0,0],[0,1,0],[0,0.6,0.8]],"ends":"rest"}' >still
made sphere --offset=0.00005 --sample=4 <still
verified 'an offset of a spherical curve at rest' 1 --problems=still
aside sample_error 'samples[0].point' still
aside sample_error 'samples[-1].point' still

# lengths of an offset are rounded as its points are, that are far away
echo '{"points":[[0,0,0],[0,3e-102,1e-102]],"angles":[[-1.1,-1.9]]}' >tiny
made spatial-hermite --offset=2 --chord-error=0.06 <tiny
verified 'an offset much farther than the curve is long' 1 --problems=tiny

# ... and where control points know no direction, which is 1e7 from the origin,
# the preimage does
cat >tiny <<'EOF'
{"points":[[11331581.409307793,2119563.5016255705],
[11331582.109548295,2119563.4189463635],[11331582.779313032,2119563.339865509],
[11331581.888970206,2119563.444990589],[11331583.582543353,2119563.245026028]],
"mode":"g1","tangents":[[0.9931014789019631,-0.11725805986256937],
[0.993101478900852,-0.11725805987197935],
[-0.9931014789672994,0.11725805930921207],
[0.9931014789103563,-0.11725805979148378],
[0.9931014789135547,-0.11725805976439535]]}
EOF
made tc --offset=-0.097 --chord-error=0.028 <tiny
verified 'an offset that turns where the curve goes back' 1 --problems=tiny
refuses 'such an offset, too long' sample_error tiny \
  '.offsets[0].samples[26:][].s += 0.01 | .offsets[0].length += 0.01'

# ... and are in order to that
cat >tiny <<'EOF'
{"points":[[0,0],[1.528783899379346e-119,-8.645255325772053e-120],
[3.5772873890347565e-119,-2.0229518942752776e-119],
[5.033466008306408e-119,-2.846419224657585e-119]],"minimize":"MV"}
EOF
made planar --offset=2 --sample=6 <tiny
verified 'a far offset of what is all but straight' 1 --problems=tiny
refuses 'a far offset, not in order' sample_error tiny \
  '.offsets[0].samples[12].s -= 1e-14'

# beside a cusp of an offset its curvature, 1 over its speed, is known to half of
# itself
cat >cusp <<'EOF'
{"points":[[1,0,0],[-0.47722009728319736,0.878783806603772,0],
[0.5075476507628824,-0.8598282039764129,-0.05559534019839577],
[-0.5481045192920169,0.8345675012885473,0.055484427767238255]],
"knots":[-4.987754839409176,-4.9858091994007605,-4.300348013649319,
-4.245530676621145],"tension":[32.84512400805856,1.3820853593480869,50.3,17.34],
"increase":"minimal"}
EOF
made sphere --offset=0.22655400741586312 --chord-error=0.03145107175328204 <cusp
verified 'a sphere, beside a cusp of an offset' 1 --problems=cusp
refuses 'beside a cusp, another sign' sample_error cusp \
  '.offsets[0].samples[92].curvature *= -1'

# a given direction that is all but that from the centre has a direction on the
# sphere
echo '{"points":[[1.5341570831649172e-53,0,0],
  [1.5341570831649172e-53,2.8581699842317043e-60,0],
  [1.5341570831649172e-53,0,3.083547329444929e-62]],"shape":true,
  "radius":1.5341570831649172e-53,"model":"exact",
  "end_tangents":[[0,0,1],[1,0,0]],"increase":"minimal"}' >up
made sphere <up
verified 'a sphere, a direction away from it' 1 --problems=up

# a length between control points that are nearly antipodal is found to less
cat >wide <<'EOF'
{"points":[[1,0,0],[1,0.00002,0],[-0.91,0.412,0.0434],[-0.91,0.412,0.04335]],
"closed":true,"model":"nielson"}
EOF
made sphere <wide
verified 'a sphere, a length between nearly antipodal points' 1 --problems=wide
jq -c '.segments[3].length += 1e-7' r >wrong.json
run verify -q --problems=wide wrong.json
equal 'a sphere, another such length' '"segments[3].length" 1' \
  "$(jq -c .error.field out) $status"

# a tangent that turns by 88 degrees where control points are the same to
# rounding: the length of the offset knows it, and they do not
echo '{"points":[[0,0],[0.06,1.84],[0,3]],"mode":"g1",
"tangents":[[0.0325913726,0.99946876],[0.2,0],[0,0.9]]}' >sharp
made tc --offset=0.000003 --spacing=0.28 <sharp
verified 'an offset around a turn in no time' 1 --problems=sharp

# areas that are less than the least number, or a few of these
for size in e-297 e-160; do
  echo "{\"points\":[[0,0],[1$size,2$size],[3$size,1$size]],\"closed\":true}" >small
  made planar <small
  verified "an area of $size squared" 1 --problems=small
done

# data nearer to one another than pieces of the curve are to them
echo '{"points":[[0,0,0],[-8.3694e-193,-3.1797e-193,-8.0807e-193],
[-8.3694e-193,-3.1797e-193,-8.08071e-193],[0,0,0]],"basis":"atph",
"alpha":[1,1,2],"derivatives":[[0,0,1e-188],[0,0,-5e-198],[0,0,1e-197],
[0,0,-9e-193]]}' >near
made spatial-hermite --convert=bezier <near
verified 'Bezier curves of data that are near' 1 --problems=near

# offsets whose distance and the size of the curve have a ratio without a square
for ratio in '-300 5e-1' '-200 1e+100' '-300 1e-160' '+100 1e-200' '-1 1e+300'; do
  size=${ratio% *}
  for command in planar tc; do
    echo '{"points":[[0,0],[2eX,1eX],[3eX,0],[5eX,2eX]]}' | sed "s/eX/e$size/g" |
      made "$command" --offset="${ratio#* }" --sample=2
    verified "$command: size 1e$size, offset ${ratio#* }" 1
  done
  echo '{"points":[[0,0,0],[2eX,1eX,3eX],[3eX,0,1eX]]}' | sed "s/eX/e$size/g" |
    made spatial-hermite --offset="${ratio#* }" --sample=2
  verified "spatial-hermite: size 1e$size, offset ${ratio#* }" 1
done

# a quotient whose numerator alone is out of range
for size in e-300 e160; do
  echo '{"points":[[1eX,0],[2eX,1eX],[3eX,0]]}' | sed "s/eX/$size/g" |
    made planar --basis=atph --offset="1$size"
  verified "atph: size and offset 1$size" 1
done
