# SPDX-License-Identifier: GPL-3.0-or-later
#
# phspline verify: results that are not what they say, each by one change of a
# good one, and texts that are no results at all.
. "$srcdir/tests/cli/lib.sh"

if ! command -v jq >/dev/null; then
  echo 'skip verify-tampered: no jq'
  exit 0
fi

# good NAME PROBLEM COMMAND [OPTION]...: a result that is right, in NAME.
good() {
  base=$1
  printf '%s\n' "$2" >"$base.problem"
  shift 2
  run "$@" -q "$base.problem"
  mv out "$base"
  run verify --problems="$base.problem" "$base"
  expect "$base is right" 0
}

# tampered FILTER CHECK [OPTION]...: the base, changed, fails, by that check at
# least.
tampered() {
  filter=$1 check=$2
  shift 2
  jq -c "$filter" "$base" >bad
  run verify -q "$@" bad
  if [ "$status" -eq 1 ] && ! cmp -s "$base" bad &&
    [ "$(get status)" = '"error"' ] &&
    [ "$(get error.code)" = '"not-verified"' ] &&
    jq -e ".worst.error >= .checks.$check and .checks.$check > 1e-9" out \
      >/dev/null; then
    pass "$base: $filter"
  else
    fail "$base: $filter" "status $status, $(get checks)"
    cut -c 1-300 err
  fi
}

# refused FILTER CODE FIELD: the base, changed, cannot be read.
refused() {
  jq -c "$1" "$base" >bad
  run verify -q bad
  equal "$base: $1" "1 \"$2\" \"$3\"" \
    "$status $(get error.code) $(get error.field)"
}

# says FILTER MESSAGE [OPTION]...: what is said of the base, changed.
says() {
  filter=$1 message=$2
  shift 2
  jq -c "$filter" "$base" >bad
  run verify -q "$@" bad
  expect "$base: $filter" 1 "phspline: bad:1: record 1: $message"
}

points='[[0,0],[2,1],[3,0],[5,2]]'

# ---- planar --------------------------------------------------------------------

good ph "{\"points\":$points}" planar --offset=0.3 --sample=2
tampered '.segments[1].control_points[2][0] += 1e-6' pythagorean_error
tampered '.segments[1].control_points[0][1] += 1e-6' continuity_error
tampered '.segments[1].control_points |= map([.[0] + 1e-7, .[1]])' \
  continuity_error
tampered '.segments[1].control_points |= reverse' continuity_error
tampered '.segments[0:2] |= [
  .[1] + {interval: .[0].interval}, .[0] + {interval: .[1].interval}]' \
  continuity_error
tampered '.segments[2].control_points = [[3,0],[3,1],[3.5,-1],[4,2],[5,3],[5,2]]
  | del(.segments[].preimage, .offsets, .samples)' pythagorean_error
tampered '.segments[1].preimage[1][0] *= 1.000001' preimage_error
tampered '.segments[1].preimage |= reverse' preimage_error
tampered '.segments[2].length += 1e-6' length_error
tampered '.length *= 1.00001' length_error
tampered '.segments[0].interval[1] += 1e-4
  | .segments[1].interval[0] = .segments[0].interval[1]' continuity_error
tampered '.curve = "tc"' shape
tampered '.curve = "atph"' shape
tampered '.closed = true' continuity_error
tampered '.segments[1].interval[1] = -1 | .segments[2].interval[0] = -1' shape
tampered '.samples[3].point[0] += 1e-6' sample_error
tampered '.samples[3].s += 1e-6' sample_error
tampered '.samples[3].t += 1e-6' sample_error
tampered '.samples[3].tangent |= map(-.)' sample_error
tampered '.samples[3].curvature *= -1' sample_error
tampered '.samples[1:3] |= reverse' sample_error
tampered '.offsets[0].distance += 1e-6' offset_error
tampered '.offsets[0].segments[1].weights[4] *= 1.0001' offset_error
tampered '.offsets[0].segments[1].control_points[4][1] += 1e-6' offset_error
tampered '.offsets[0].segments[1].interval[0] = 0.1' offset_error
tampered '.offsets[0].segments |= reverse' offset_error
tampered '.offsets[0].samples[2].point[0] += 1e-6' sample_error
tampered '.offsets[0].length += 1e-6' offset_error
tampered '.diagnostics.energy *= 1.0001' diagnostic_error
tampered '.diagnostics.absolute_rotation_index += 0.001' diagnostic_error
printf '{"points":[[0,0],[2,1],[3,0],[5,2.000001]]}' >other
tampered '.meta = 1' interpolation_error --problems=other
printf '{"points":[[0,0],[2,1],[3,0],[5,2]],"closed":true}' >other
tampered '.meta = 1' shape --problems=other
printf '{"points":%s,"end_derivatives":[[1,1],[1,0]]}' "$points" >other
tampered '.meta = 1' end_derivative_error --problems=other

good cusp '{"points":[[0,0],[2,1],[3,0],[5,2]]}' planar --offset=-1
tampered '.offsets[0].cusps |= .[1:]' offset_error
tampered '.offsets[0].cusps[0].t += 0.01' offset_error
tampered '.offsets[0].cusps += [{segment: 2, t: 0.9}]' offset_error

# ---- gaps ----------------------------------------------------------------------

angle='{"curve":[[[0,0],[10,0]],[[10,0],[10,10]]]}'
for gap_how in --chord-error=0.01 --spacing=4 --sample=2; do
  good "gap$gap_how" "$angle" tc --tolerance=0.01 --offset=-3 "$gap_how"
  first='(.offsets[0].samples | map(.segment) | index(1))'
  tampered "del(.offsets[0].samples[$first])" sample_error
  tampered "del(.offsets[0].samples[$first - 1])" sample_error
  tampered "del(.offsets[0].samples[$first - 1, $first])" sample_error
  tampered ".offsets[0].samples[$first:] |= map(.s += 3)" sample_error
done
tampered '.offsets[0].gaps = []' offset_error
tampered 'del(.offsets[0].gaps)' offset_error
tampered '.offsets[0].gaps = [0, 1]' offset_error
tampered '.offsets[0].gaps = [1, 1]' offset_error
good loop '{"curve":[[[0,0],[4,3],[4,-3],[0,0]]],"closed":true}' tc \
  --tolerance=0.01 --offset=-0.1 --spacing=1
tampered '.offsets[0].gaps = []' offset_error
tampered '.offsets[0].gaps += [1]' offset_error
tampered 'del(.offsets[0].samples[0])' sample_error
tampered 'del(.offsets[0].samples[-1])' sample_error

# ---- all solutions ---------------------------------------------------------------

good far '{"points":[[0,0],[2e-300,1e-300],[3e-300,0]]}' planar --offset=0.5
tampered '.offsets[0].distance *= 1.00000001' offset_error
tampered '.offsets[0].segments[1].control_points[4][0] += 1e-9' offset_error
tampered '.offsets[0].segments[1].weights[4] *= 1.0001' offset_error

good all "{\"points\":$points}" planar --solutions=all
tampered '.solutions[2].segments[1].control_points[3][0] += 1e-6' \
  pythagorean_error
tampered '.solutions[2].length += 1e-6' length_error
tampered '.solutions |= [.[1], .[0]] + .[2:]' shape

# ---- trigonometric ---------------------------------------------------------------

good atph "{\"points\":$points}" planar --basis=atph --offset=0.3 --sample=2
tampered '.segments[1].alpha += 1e-5' pythagorean_error
tampered '.segments[1].control_points[2][0] += 1e-6' pythagorean_error
tampered '.segments[1].length += 1e-6' length_error
tampered '.offsets[0].segments[1].denominator[2] *= 1.0001' offset_error
tampered '.offsets[0].beziers[1].control_points[2][0] += 1e-3' offset_error
tampered '.samples[3].curvature += 1e-6' sample_error

# Pieces are not farther away between the places where their distance is taken.
good coarse "{\"points\":$points}" planar --basis=atph --offset=0.3 \
  --tolerance=1e-3 --nurbs
tampered '.offsets[0].error /= 1.1' offset_error
tampered '.offsets[0].error /= 1.01' offset_error
tampered '.nurbs[0].error /= 1.1' nurbs_error
tampered '.nurbs[0].error /= 1.01' nurbs_error

# ---- in space -------------------------------------------------------------------

good spatial '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]],
  "tangents":[[1,0,0],[0,1,0],[1,0,1],[1,1,0]]}' \
  spatial-hermite --offset=0.1 --sample=2 --frame=erf
tampered '.segments[1].control_points[3][2] += 1e-6' pythagorean_error
tampered '.segments[1].preimage[0] |= map(-.) | .segments[1].preimage[1][2] += 0.01' \
  preimage_error
tampered '.samples[3].torsion += 1e-6' sample_error
tampered '.samples[3].normal |= map(-.)' sample_error
# shellcheck disable=SC2016 # jq's variable
tampered '.samples[3] |= (.normal as $n | .normal = .binormal | .binormal = $n)' \
  sample_error
tampered '.offsets[0].vector = "e3"' offset_error
printf '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]],
  "tangents":[[1,0,0],[0,1,0],[1,0,1],[1,1,1e-5]]}' >other
tampered '.meta = 1' tangent_error --problems=other

good frame '{"points":[[0,0,0],[1,1,0],[2,0,1],[4,1,2]]}' \
  spatial-hermite --sample=4 --frame=erf
tampered '.frame = "rmf"' sample_error

# a frame that turns about the tangent by ANGLE at a sample
# shellcheck disable=SC2016 # jq's variables
turned='.normal as [$x, $y, $z] | .binormal as [$u, $v, $w] |
  .normal = [$x + $a * $u, $y + $a * $v, $z + $a * $w] |
  .binormal = [$u - $a * $x, $v - $a * $y, $w - $a * $z]'
good turning '{"points":[[0,0,0],[1,1,0],[2,0,1],[4,1,2]]}' \
  spatial-hermite --sample=4 --frame=rmf
for i in 0 3 7 14; do
  tampered ".samples[$i] |= (1e-8 as \$a | $turned)" sample_error
done
good sharp '{"points":[[0,0,0],[1.75,5.2,-3.2],[1.6,4.78,-2.9]],"tension":0.02}' \
  spatial-hermite --sample=2 --frame=rmf
for i in 1 2 4; do
  tampered ".samples[$i] |= (1e-7 as \$a | $turned)" sample_error
done

good bent '{"points":[[0,0,0],[1,1,1e-7],[2,0,0],[3,1,0]]}' spatial-hermite
tampered '.diagnostics.energy *= 1.000001' diagnostic_error
tampered '.diagnostics.F2 *= 1.000001' diagnostic_error

for criterion in F1 F2 F3; do
  good "fair$criterion" '{"points":[[0,0,0],[1,1,0],[2,0,1],[4,1,2]]}' \
    spatial-hermite --criterion="$criterion"
  tampered '.diagnostics.energy *= 1.000001' diagnostic_error
  tampered '.diagnostics.F1 *= 1.000001' diagnostic_error
  tampered '.diagnostics.F2 *= 1.00000001' diagnostic_error
  tampered '.diagnostics.F3 *= 1.000001' diagnostic_error
  tampered '.diagnostics.functional *= 1.000001' diagnostic_error
done
good inflected '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]]}' \
  spatial-hermite --criterion=F2
tampered '.diagnostics.F1 *= 1.000001' diagnostic_error
# nothing is known of F3 here, which is F2
good flat '{"points":[[0,0,0],[1,1,0],[2,0,1.4781058e-10],[3,1,0]]}' \
  spatial-hermite --criterion=F3
tampered '.diagnostics.functional *= 1.000001' diagnostic_error
base=fairF3
echo '{"points":[[0,0,0],[1,1,0],[2,0,1],[4,1,2]],"criterion":"F3"}' >other
tampered '.diagnostics.functional = .diagnostics.F1 | del(.set)' \
  diagnostic_error --problems=other

good lengths '{"points":[[0,0,0],[1,1,0],[2,0,1]],"lengths":[1.6,1.9]}' \
  arclength
tampered '.intervals[0].length += 1e-6' length_error
printf '{"points":[[0,0,0],[1,1,0],[2,0,1]],"lengths":[1.6,1.900001]}' >other
tampered '.meta = 1' prescribed_length_error --problems=other

good minima '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]],
  "lengths":[1.8,1.9,1.6]}' arclength --all_minima --starts=5
tampered '.solutions[1].intervals[0].length += 1e-6' length_error
tampered '.solutions[1].intervals[1].segments = [2,2]' shape
tampered '.solutions[1].intervals |= reverse' shape
tampered '.solutions[0].intervals[2].length += 1e-6' length_error
refused 'del(.solutions[1].intervals)' missing-field 'solutions[1].intervals'
refused '.solutions[1].intervals |= .[1:]' bad-shape 'solutions[1].intervals'

# ---- on a sphere -----------------------------------------------------------------

good sphere '{"lonlat":[[0,0],[40,10],[80,-20],[120,50]],"radius":2}' \
  sphere --offset=0.1 --sample=2
tampered '.segments[1].control_points[1] |= map(. * 1.000001)' sphere_error
tampered '.radius *= 1.000001' sphere_error
tampered '.center[2] = 1e-6' sphere_error
tampered '.segments[1].length += 1e-6' length_error
tampered '.offsets[0].samples[3].point |= map(-.)' sample_error
tampered '.samples[3].curvature += 1e-6' sample_error

# ---- B-splines ------------------------------------------------------------------

good nurbs '{"points":[[0,0],[1,2],[3,-1],[4,4]],"closed":true}' planar \
  --nurbs --offset=0.1
tampered '.nurbs[0].control_points[7][1] += 1e-6' nurbs_error
tampered '.nurbs[0].knots[8] += 1e-3' nurbs_error
tampered '.nurbs[0].knots |= map(. * 2)' nurbs_error
tampered '.nurbs[0].degree = 4' nurbs_error
tampered '.offsets[0].nurbs[0].weights[12] *= 1.0001' nurbs_error
tampered '.offsets[0].nurbs[0].weights[3] = 1e400' nurbs_error
tampered '.offsets[0].nurbs[0].knots |= map(. - 1)' nurbs_error
tampered '.nurbs[0].error = 1 | .nurbs[0].control_points[7][1] += 1e-3' \
  nurbs_error
good nurbs-open '{"points":[[0,0],[1,2],[3,-1],[4,4]],"basis":"atph"}' planar \
  --nurbs
tampered '.nurbs[0].closed = true' nurbs_error
tampered '.nurbs[0].error = -1' nurbs_error
good nurbs-loop '{"points":[[0,0],[1,2],[3,-1],[4,4]],"closed":true}' planar \
  --nurbs --offset=0.1 --offset-mode=trimmed
tampered '.offsets[0].loops[0].nurbs[0].control_points[3][0] += 1e-6' nurbs_error
tampered '.offsets[0].loops[0].nurbs[0].degree = 3' nurbs_error

# ---- cubics --------------------------------------------------------------------

good tc '{"points":[[0,0],[2,1],[3,0],[5,2]]}' tc --offset=0.1 --blaschke
tampered '.segments[1].control_points[1][0] += 1e-6' pythagorean_error
tampered '.segments[1].blaschke[0].weights[2] *= 1.0001' blaschke_error
tampered '.segments[1].blaschke[0].control_points[2][2] += 1e-5' blaschke_error
tampered '.offsets[0].segments[2].weights |= reverse' offset_error

good near '{"curve":[[0,0],[1,2],[3,2],[4,-1],[6,0]]}' tc --tolerance=0.01
tampered '.diagnostics.distance /= 2' distance_error --problems=near.problem

# ---- surfaces ------------------------------------------------------------------

good cone '{"points":[[252.6524,62,92.5],[266.5158,65.1388,91.5]],
  "rulings":[[-0.1151,0.2405,0.9638],[-0.1785,0.165,0.97]],
  "tangents":[[0.9925,0.069,0.1013],[0.8847,0.4583,0.0849]],
  "height":[-5,5]}' cone --offset=2 --sample=2x1
tampered '.strips[1].frame.point[0] += 1e-6' frame_error
tampered '.strips[0].frame.normal |= map(-.)' frame_error
tampered '.strips[0].contact.control_points[1][2] += 1e-6' frame_error
tampered '.strips[1].contact.weights[1] += 1e-6' frame_error
tampered '.strips[1].shift[0] += 1e-6' frame_error
tampered '.strips[0].development.control_points[2][1] += 1e-6' isometry_error
tampered '.strips[1].development.weights[1] += 1e-6' isometry_error
tampered '.strips[1].development.angle += 1e-6' isometry_error
tampered '.strips[0].vertex[1] += 1e-3' diagnostic_error
tampered '.strips[0].half_angle += 1e-6' diagnostic_error
tampered '.pairs[0].lambda[1] += 1e-6' diagnostic_error
tampered '.pairs[0].center[1] += 1e-3' diagnostic_error
tampered '.diagnostics.lambda_interval[0][1] += 1e-6' diagnostic_error
tampered '.diagnostics.shift += 1e-6' diagnostic_error
tampered '.diagnostics.sign_changes += 1' diagnostic_error
tampered '.length += 1e-6' length_error
tampered '.area += 1e-5' length_error
tampered '.offsets[0].strips[0].frame.point[0] += 1e-6' frame_error
tampered '.offsets[0].distance += 1e-4' offset_error
tampered '.offsets[0].samples[1].point[2] += 1e-6' sample_error
tampered '.samples[1].flat[0] += 1e-6' sample_error
tampered '.samples[3].normal |= map(-.)' sample_error
says 'del(.strips[0].frame)' 'strips[0].frame: is missing [missing-field]'
says '.strips[1].pair = 1' \
  'strips[1].pair: is not that of two strips in a row (shape) [not-verified]'
says '.samples[0].strip = 2' 'samples[0].strip: is none (sample_error) [not-verified]'
says '.command = "planar"' 'segments: are missing (shape) [not-verified]'

good general '{"points":[[252.6524,62,92.5],[266.5158,65.1388,91.5]],
  "rulings":[[-0.1151,0.2405,0.9638],[-0.1785,0.165,0.97]],
  "tangents":[[0.9925,0.069,0.1013],[0.8847,0.4583,0.0849]],
  "method":"atph","apexes":[-30,70],"height":[-5,5]}' cone --sample=2x1
tampered '.strips[1].control_points[2][1] += 1e-6' pythagorean_error
tampered '.strips[0].preimage[1][2] += 1e-6' preimage_error
tampered '.strips[1].frame.point[0] += 1e-6' frame_error
tampered '.strips[0].frame.normal |= map(-.)' frame_error
tampered '.strips[1].vertex[1] += 1e-4' frame_error
tampered '.strips[0].vertex[1] += 1e-4' interpolation_error \
  --problems=general.problem
tampered '.strips[0].length += 1e-6' length_error
tampered '.strips[0].development_angle += 1e-6' isometry_error
tampered '.strips[1].development.samples[9].point[0] += 1e-6' isometry_error
tampered '.strips[1].development.samples[9].t += 1e-6' isometry_error
tampered '.strips[1].development.angle += 1e-6' isometry_error
tampered '.strips[0].turn += 1e-4' diagnostic_error
tampered '.strips[0].F1 += 1e-6' diagnostic_error
tampered '.strips[0].shift[1] += 1e-6' diagnostic_error
tampered '.diagnostics.F2 *= 1.000001' diagnostic_error
tampered '.diagnostics.functional *= 1.000001' diagnostic_error
tampered '.diagnostics.inflections += 1' diagnostic_error
tampered '.diagnostics.vertices_inside = 1' diagnostic_error
tampered '.area += 1e-5' length_error
tampered '.samples[3].point[2] += 1e-6' sample_error
tampered '.samples[1].flat[0] += 1e-6' sample_error
tampered '.samples[3].normal |= map(-.)' sample_error
says 'del(.strips[1].alpha)' 'strips[1].alpha: is missing [missing-field]'
says '.strips[1].development.samples |= .[:-1]' 'strips[1].development: does '\
'not lead from 0 to alpha, in order (shape) [not-verified]'
says '.strips[1].method = "circular"' \
  'strips[1].method: is not that of the first strip (shape) [not-verified]'
says '.samples[0].strip = 2' 'samples[0].strip: is none (sample_error) [not-verified]'
sed 's/"apexes":\[-30/"apexes":[-31/' general.problem >other
tampered '.strips[0].turn += 0 | .meta = 1' interpolation_error --problems=other
sed 's/"height"/"contact_point":"midpoint","tangent_scale":"unit","height"/' \
  general.problem >other
tampered '.meta = 1' tangent_error --problems=other

# ---- what decides which checks there are ---------------------------------------

kind='curve: is of no kind that the command makes (shape) [not-verified]'
size='dimension: is not that of curves of the command (shape) [not-verified]'
degree='degree: is not that of curves of the command (shape) [not-verified]'
commands='"planar", "spatial-hermite", "arclength", "sphere", "tc", "cone" or "bubble"'
for base in ph atph spatial lengths sphere tc; do
  says 'del(.command)' 'command: is missing [missing-field]'
  says 'del(.status)' 'status: is missing [missing-field]'
  says '.command = "conic"' \
    "command: must be $commands, found \"conic\" [bad-value]"
  says '.command = "verify"' \
    "command: must be $commands, found \"verify\" [bad-value]"
  says '.command = 7' 'command: must be a string, found a number [bad-type]'
  says 'del(.command) | .status = "error" | del(.segments)' \
    'command: is missing [missing-field]'
  says '.status = "error"' \
    'segments: are not of an error record [bad-shape]'
  says 'del(.segments[].interval)' \
    'segments[0].interval: is missing (shape) [not-verified]'
  says '.degree += 1
    | .segments[].control_points |= . + [.[-1]]
    | del(.offsets, .segments[].preimage, .segments[].alpha, .samples)' "$degree"
done

# another command's name
base=ph
says '.command = "spatial-hermite"' "$size"
says '.command = "arclength"' "$size"
says '.command = "sphere"' "$kind"
says '.command = "tc"' "$kind"
says '.command = "cone"' "$kind"
says '.command = "bubble"' "$kind"
base=atph
says '.command = "spatial-hermite"' "$size"
says '.command = "arclength"' "$kind"
says '.command = "sphere"' "$kind"
says '.command = "tc"' "$kind"
base=spatial
says '.command = "planar"' "$size"
says '.command = "arclength"' 'intervals: are missing (shape) [not-verified]'
says '.command = "sphere"' "$kind"
says '.command = "tc"' "$kind"
base=lengths
says '.command = "planar"' "$size"
says '.command = "spatial-hermite"' \
  'intervals: are not what the command makes (shape) [not-verified]'
says '.command = "spatial-hermite" | del(.intervals)' \
  'segments[0].tension: is missing (shape) [not-verified]'
says '.command = "sphere"' "$kind"
says '.command = "tc"' "$kind"
base=sphere
says '.command = "planar"' "$kind"
says '.command = "spatial-hermite"' "$kind"
says '.command = "arclength"' "$kind"
says '.command = "tc"' "$kind"
base=tc
says '.command = "planar"' "$kind"
says '.command = "spatial-hermite"' "$kind"
says '.command = "arclength"' "$kind"
says '.command = "sphere"' "$kind"

# another kind of curve
base=ph
says '.curve = "atph"' 'segments[0].alpha: is missing (shape) [not-verified]'
says '.curve = "bezier"' \
  'segments[0].preimage: is none of such control points (shape) [not-verified]'
says '.curve = "spherical-nu"' "$kind"
says '.dimension = 3' 'segments[0].control_points[0]: must have 3 numbers, '\
'found 2 [bad-shape]'
says '.radius = 1 | .center = [0,0,0]' \
  'radius: is not of such a curve (shape) [not-verified]'
says '.offsets[0].vector = "e2"' \
  'offsets[0].vector: is of curves in space (offset_error) [not-verified]'
says '.intervals = [{"length":.length,"segments":[0,2]}]' \
  'intervals: are not what the command makes (shape) [not-verified]'
says '.closed = null' 'closed: must be true or false, found null [bad-type]'
says 'del(.closed)' 'closed: is missing [missing-field]'
base=atph
says '.curve = "ph"' 'segments[0].alpha: is of ATPH curves alone (shape) '\
'[not-verified]'
tampered '.curve = "bezier"
  | del(.segments[].preimage, .segments[].alpha, .offsets, .samples)' length_error
base=spatial
says '.curve = "tc"' "$kind"
says 'del(.segments[].tension)' \
  'segments[0].tension: is missing (shape) [not-verified]'
tampered '.closed = true' continuity_error
base=lengths
says '.curve = "bezier" | del(.segments[].preimage)' "$kind"
says 'del(.intervals)' 'intervals: are missing (shape) [not-verified]'
tampered '.closed = true' continuity_error
base=sphere
says '.curve = "ph"' "$kind"
says 'del(.tensions)' 'tensions: are missing (shape) [not-verified]'
says '.closed = true' 'tensions: must have 3 numbers, found 4 [bad-shape]'
base=tc
says '.curve = "bezier" | del(.segments[].preimage)' "$kind"
says 'del(.intervals)' 'intervals: are missing (shape) [not-verified]'
tampered '.closed = true' continuity_error

# corners, which approximations alone may have
good corner "{\"points\":$points}" tc
# shellcheck disable=SC2016 # jq's variables
turned='.intervals[0].segments[1] as $k
  | .segments[$k].control_points[-1] as [$x, $y]
  | .segments[$k+1:] |= map(.control_points
    |= map([$x - .[1] + $y, $y + .[0] - $x]))
  | del(.segments[].preimage) | .diagnostics = {distance: 1}'
tampered "$turned" continuity_error --problems=corner.problem
equal 'a turn by a right angle' 1.414214 "$(json get checks.continuity_error out |
  awk '{ printf "%.6f", $1 }')"
good round "{\"points\":$points,\"closed\":true}" planar
says '.closed = false' 'closed: is not what the problem says (shape) '\
'[not-verified]' --problems=round.problem

# ---- what options set ----------------------------------------------------------

good set "{\"points\":$points}" planar --knots=uniform \
  --end_derivatives='[[1,1],[0,1]]'
tampered '.set.end_derivatives[1][1] = 1.00001' end_derivative_error \
  --problems=set.problem
tampered '.set.closed = true' shape --problems=set.problem
tampered '.set.basis = "atph"' shape --problems=set.problem
no='is not what the problem has; --override sets that of the problem'
says '.set.points = [[0,0],[2,1],[3,0],[5,3]]' "set.points: $no [not-verified]" \
  --problems=set.problem
says '.set.colour = 1' 'set.colour: is no field of the command [bad-value]' \
  --problems=set.problem
says '.set.knots = "uniforme"' 'set.knots: must be "chordal", "centripetal", '\
'"uniform" or an array of numbers, found "uniforme"; did you mean "uniform"? '\
'[bad-value]' --problems=set.problem
says '.set.closed = null' 'set.closed: must be true or false, found null '\
'[bad-type]' --problems=set.problem
says '.set = []' 'set: must be an object [bad-type]'
says '.sweep = 7' 'sweep: must be an object [bad-type]'
sed 's/"set":{/"set":{"knots":"chordal",/' set >bad
run verify -q --problems=set.problem bad
expect 'a field twice' 1 "phspline: bad:1: record 1: set.knots: $no [not-verified]"
good swept "{\"points\":$points}" planar --knots='[0,1,2,3]' \
  --sweep='points[1][0]=2.25' --end_derivatives='[[1,1],[0,1]]'
tampered '.sweep."points[1][0]" = 2.250001' interpolation_error \
  --problems=swept.problem
tampered '.set.end_derivatives[0][0] = 1.00001' end_derivative_error \
  --problems=swept.problem
base=lengths
says '.set.lengths = [1.6,1.90001]' "set.lengths: $no [not-verified]" \
  --problems=lengths.problem

# ---- how much is too much ------------------------------------------------------

base=ph
jq -c '.segments[2].length += 1e-6' ph >bad
run verify --tolerance=1e-5 bad
expect 'within the tolerance' 0
run verify --pretty -q ph bad
equal 'one of two' 1 "$status"
run verify bad ph
equal 'the line on standard error' 1 "$(grep -c \
  '^phspline: bad:1: record 1: segments\[2\].length: .*(length_error .*) '\
'\[not-verified\]$' err)"
equal 'and the count' "$(failed 1 2)" "$(tail -n 1 err)"
run verify --fail-fast bad ph
equal 'the first failure is the end' 1 "$(wc -l <out | tr -d ' ')"
jq . bad >pretty
run verify -q pretty
equal 'the line of a segment' "$(grep -n '"interval"' pretty |
  sed -n '3s/:.*//p' | awk '{ print $1 - 1 }')" "$(get error.line)"

# ---- what is no result ---------------------------------------------------------

refused 'del(.segments)' missing-field segments
refused 'del(.curve)' missing-field curve
refused 'del(.segments[1].control_points)' missing-field \
  'segments[1].control_points'
refused 'del(.segments[1].length)' missing-field 'segments[1].length'
refused '.segments[1].interval[0] += 1' bad-value 'segments[1].interval'
refused '.segments[1].control_points[2] = [1]' bad-shape \
  'segments[1].control_points[2]'
refused '.segments[1].control_points[2] = null' bad-type \
  'segments[1].control_points[2]'
refused '.degree = 3' bad-shape 'segments[0].control_points'
refused '.samples[1].segment = 3' bad-value 'samples[1].segment'
refused '.curve = "circle"' bad-value curve
refused '.id = {}' bad-type id
sed 's/"length":[0-9.]*/"length":NaN/' ph >bad
run verify -q bad
equal 'NaN' '"syntax"' "$(get error.code)"
sed 's/"length":[0-9.]*/"length":1e400/' ph >bad
run verify -q bad
equal 'no double' '"not-finite" "segments[0].length"' \
  "$(get error.code) $(get error.field)"
sed 's/"length":/"length":1,"length":/' ph >bad
run verify -q bad
equal 'a name twice' '"bad-value" "segments[0].length"' \
  "$(get error.code) $(get error.field)"
feed '' verify
expect 'nothing' 0 'phspline: there is no result in standard input' ''
feed '[]' verify
expect 'no results' 0 'phspline: there is no result in standard input' ''
feed '7 "a"' verify -q
equal 'no objects' '"bad-type" "bad-type"' "$(get error.code)"
feed "{\"points\":$points}" verify -q
equal 'a problem' '"segments"' "$(get error.field)"
{ cut -c 1-300 ph && cat ph; } >bad
run verify -q bad
equal 'a broken line' '"error" "ok"' "$(get status)"
tr -d '\n' <ph | cut -c 1-300 | sed 's/^/[/' >bad
run verify -q bad
equal 'a broken array' 3 "$status"
if [ -w /dev/full ]; then
  "$PHSPLINE" verify ph >/dev/full 2>err
  equal 'a full disk' 4 "$?"
fi
yes "$(cat ph)" | sed 500q >many
run verify many
equal 'many' "0 500" "$status $(grep -c '"status":"ok"' out)"
