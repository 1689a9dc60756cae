# SPDX-License-Identifier: GPL-3.0-or-later
#
# `bubble': records and tables of surfaces over meshes, against simple truths
# and against one another after motions; and every way for a problem to be
# wrong.  (Known surfaces: bubble-reference.t.)
#
# shellcheck disable=SC2016,SC2154,SC2034  # programs of jq; what errors.sh sets
# and reads
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

meshes=$srcdir/data/byrtus-2011-meshes.jsonl
points='"points":[[-1,-1,-1],[1,-1,-1],[-1,1,-1],[1,1,-1],[-1,-1,1],'\
'[1,-1,1],[-1,1,1],[1,1,1]]'
faces='"faces":[[0,2,3,1],[4,5,7,6],[0,1,5,4],[2,6,7,3],[0,4,6,2],[1,3,7,5]]'
good="{$points,$faces}"
flat='"points":[[0,0,0],[2,0,0],[2,1,0],[0,1,0]]'

# ---- records -----------------------------------------------------------------

feed "{\"id\":7,\"meta\":[1],$points,$faces}" bubble
expect 'a record' 0
equal 'a record: its members' '{id:number,command:string,status:string,'\
'meta:[number],surface:string,closed:bool,continuity:number,patches:['\
'{face:number,vertices:[number],bidegree:[number],control_points:[[number]]}'\
'],area:number,volume:number,diagnostics:{iterations:number,residual:number,'\
'interpolation_error:number,continuity_error:number,curvature_jump:number,'\
'normal_jump:number,degree:number,folded:number,area:number}}' \
  "$(json shape <out)"
equal 'a record: values' '7 [1] "bubble" true 1 9 [0,2,3,1] [10,10]' \
  "$(get id) $(get meta) $(get surface) $(get closed) $(get continuity) \
$(get diagnostics.degree) $(get 'patches[0].vertices') \
$(get 'patches[0].bidegree')"
true_that 'corners are the points of the face' jq -e '.patches[0] |
  .control_points | length == 121 and .[0] == [-1,-1,-1] and
  .[10] == [-1,1,-1] and .[110] == [1,-1,-1] and .[120] == [1,1,-1]' out
feed "{$flat,\"faces\":[[0,1,2,3]]}" bubble
true_that 'a flat face' jq -e '(.area - 2 | fabs) < 1e-14 and .closed == false and
  (has("volume") | not) and all(.patches[0].control_points[]; .[2] == 0)' out
feed "{$flat,\"faces\":[[0,1,2,3]],\"continuity\":0}" bubble
true_that 'continuity 0' jq -e '.patches[0] | .bidegree == [1,1] and
  .control_points == [[0,0,0],[2,0,0],[0,1,0],[2,1,0]]' out
feed "{$points,\"faces\":[[1,3,2,0],[6,7,5,4],[4,5,1,0],[3,7,6,2],[2,6,4,0],
  [5,7,3,1]]}" bubble
true_that 'faces run around the other way' jq -e '.volume < -19.9' out
feed "{$points,\"faces\":[[0,2,3,1],[6,7,5,4],[0,1,5,4],[3,7,6,2],[0,4,6,2],
  [1,3,7,5]]}" bubble
true_that 'faces run around both ways' jq -e '.volume - 19.944271445 | fabs <
  1e-9' out
run bubble --continuity=2 --degree=9 --table=patches "$meshes"
expect 'a table' 0
true_that 'a table: rows' count $((1 + (6 + 12 + 22 + 40 + 24) * 121)) out
equal 'a table: columns' 'id,patch,row,column,x,y,z' "$(head -n 1 out)"
run bubble --continuity=2 --degree=15 "$meshes"
mv out want
for jobs in 2 3; do
  run bubble -j "$jobs" --continuity=2 --degree=15 "$meshes"
  equal_files "$jobs jobs" want out
done

# One mesh that is spread over threads, and one whose patch in the middle of many
# fails: which one, no matter how many jobs.
jq -nc '32 as $n | {points: [range($n + 1) as $j | range($n + 1) as $i |
  [$i, $j, ($i * $j / 9 | sin)]], faces: [range($n) as $j | range($n) as $i |
  ($j * ($n + 1) + $i) as $a | [$a, $a + 1, $a + $n + 2, $a + $n + 1]]}' \
  >large.json
for options in '--degree=exact' '--continuity=2 --degree=15' \
  '--tolerance=1e-5' '--continuity=2 --tolerance=1e-12'; do
  # several words
  # shellcheck disable=SC2086
  for jobs in 1 2 5; do
    "$PHSPLINE" bubble -j $jobs $options large.json >$jobs.out 2>&1
  done
  equal_files "one mesh, 2 jobs: $options" 1.out 2.out
  equal_files "one mesh, 5 jobs: $options" 1.out 5.out
done

# ---- what does not matter ----------------------------------------------------

# moved NAME PROGRAM BACK: a mesh after a program of jq; what comes out, after
# another one, is what it was
run bubble --degree=11 --continuity=2 "$meshes"
jq -c '.area, [.patches[].control_points]' out >known
moved() {
  jq -c "$2" "$meshes" >moved.jsonl
  run bubble --degree=11 --continuity=2 moved.jsonl
  jq -c "$3" out >found
  numbers "$1" 1e-12 known found
}
all='.area, [.patches[].control_points]'
moved 'another unit' '.points |= map(map(. * 1e-100))' \
  '.area * 1e100 * 1e100, [.patches[].control_points | map(map(. * 1e100))]'
moved 'a rotation' 'def turn: [.[0] * 0.6 - .[1] * 0.8, .[0] * 0.8 +
    .[1] * 0.6, .[2]] | [.[0], .[1] * 0.28 - .[2] * 0.96, .[1] * 0.96 +
    .[2] * 0.28]; .points |= map(turn) | .normals |= map(turn)' \
  'def back: [.[0], .[1] * 0.28 + .[2] * 0.96, .[2] * 0.28 - .[1] * 0.96] |
    [.[0] * 0.6 + .[1] * 0.8, .[1] * 0.6 - .[0] * 0.8, .[2]];
  .area, [.patches[].control_points | map(back)]'
moved 'normals to the other side' '.normals |= map(map(-. * 3))' "$all"
moved 'points in another order' '.points |= reverse | .normals |= reverse |
  (.points | length - 1) as $n | .faces |= map(map($n - .))' "$all"
moved 'faces in another order' '.faces |= reverse' \
  '.area, [.patches | reverse[].control_points]'
moved 'faces the other way around' '.faces |= map([.[0], .[3], .[2], .[1]])' \
  '.area, [.patches[] | .bidegree[0] as $m | .control_points as $p |
    [range($m + 1) as $i | range($m + 1) as $j | $p[$j * ($m + 1) + $i]]]'

# A change of one point is not seen beyond the faces around its neighbours.
jq -c 'select(.id == "torus")' "$meshes" >torus.json
jq -c '.points[0][2] += 0.1' torus.json >other.json
run bubble --degree=9 torus.json other.json
equal 'what a point changes' 16 "$(jq -s '[.[0].patches, .[1].patches] |
  transpose | map(select(.[0] != .[1])) | length' out)"

# ---- verify --------------------------------------------------------------------

run bubble --continuity=2 "$meshes"
cp out result
"$PHSPLINE" verify --problems="$meshes" result >out 2>err
equal 'verified' '["ok","ok","ok","ok","ok"]' "$(jq -sc '[.[].status]' out)"
# tampered WHERE PROGRAM: a result that is not right any more
tampered() {
  sed -n 3p result | jq -c "$2" >wrong.json
  jq -c 'select(.id == "monkey saddle")' "$meshes" >problem.json
  "$PHSPLINE" verify --problems=problem.json wrong.json >out 2>err
  equal "tampered: $2" "$1" "$(jq -r .error.field out)"
}
tampered area '.area *= 1.00001'
tampered diagnostics.normal_jump '.diagnostics.normal_jump /= 2'
tampered diagnostics.curvature_jump '.diagnostics.curvature_jump /= 2'
tampered diagnostics.degree '.diagnostics.degree += 2'
tampered diagnostics.curvature_jump '.patches[6].control_points[1][2] += 0.01'
tampered 'patches[7].vertices' '.patches[7].vertices |= reverse'
tampered 'patches[2].control_points' '.patches[2].control_points |= .[1:]'
tampered 'patches[2].vertices[1]' '.patches[2].vertices[1] = 0.5'
tampered 'patches[2].vertices' '.patches[2].vertices |= .[:3]'
tampered 'patches[0].bidegree[0]' '.patches[0].bidegree = [99, 99]'
tampered closed '.closed = true'

# ---- errors --------------------------------------------------------------------

errors_of bubble
bad missing-field faces 'is missing: it must be an array of arrays of numbers' \
  "{$points}"
bad bad-type faces 'must be an array of arrays of numbers, found a number' \
  "{$points,\"faces\":7}"
bad bad-type 'faces[1]' 'must be an array of numbers, found a number' \
  "{$points,\"faces\":[[0,1,2,3],4]}"
bad bad-type 'faces[0][2]' 'must be a number, found a string' \
  "{$points,\"faces\":[[0,1,\"2\",3]]}"
bad bad-shape faces 'must have one or more' "{$points,\"faces\":[]}"
bad bad-shape 'faces[1]' 'must have 4 points, found 3; with subdivide of 1 or '\
'more it may have others' \
  "{$points,\"faces\":[[0,2,3,1],[4,5,7]]}"
bad bad-value 'faces[0]' 'must have numbers of points, whole and from 0 to 7, '\
'found 8' "{$points,\"faces\":[[0,1,2,8]]}"
bad bad-value 'faces[0]' 'must have numbers of points, whole and from 0 to 7, '\
'found -1' "{$points,\"faces\":[[0,-1,2,3]]}"
bad bad-value 'faces[0]' 'has points[1] twice' \
  "{$points,\"faces\":[[0,1,2,1]]}"
bad bad-value 'faces[2]' 'is the third one at the edge of points 0 and 2, '\
'after faces 0 and 1; two are allowed' \
  "{$points,\"faces\":[[0,2,3,1],[0,4,6,2],[2,0,5,7]]}"
bad bad-value 'points[4]' 'belongs to no face' \
  "{$points,\"faces\":[[0,2,3,1]]}"
bad too-few-points points 'must have at least 4 points, found 3' \
  '{"points":[[0,0,0],[1,0,0],[1,1,0]],"faces":[[0,1,2,3]]}'
bad coincident-points 'points[1]' 'coincides with points[0], at the other end '\
'of an edge of faces[0]' \
  '{"points":[[0,0,0],[0,0,0],[1,1,0],[0,1,0]],"faces":[[0,1,2,3]]}'
bad bad-shape normals 'must have 8 vectors, one for each point, found 1' \
  "{$points,$faces,\"normals\":[[0,0,1]]}"
up='[0,0,1],[0,0,1],[0,0,1]'
bad zero-tangent 'normals[3]' 'must not be zero' \
  "{$flat,\"faces\":[[0,1,2,3]],\"normals\":[$up,[0,0,0]]}"
bad zero-tangent 'points[1]' 'has no normal: those of the faces around it add '\
'up to 0; give normals' \
  '{"points":[[0,0,0],[1,0,0],[2,0,0],[0,1,0]],"faces":[[3,0,1,2]]}'
bad bad-value 'faces[2]' 'closes a surface that has one side only, so that the '\
'faces do not say where normals point; give normals' \
  '{"points":[[0,0,0],[0,0,1],[1,0,0],[1,0,1],[1,1,0],[1,1,1]],'\
'"faces":[[0,1,3,2],[2,3,5,4],[4,5,0,1]]}'
smooth='cannot be smooth: its edge between points[0] and points[1]'
look='look at these normals, or take continuity 0'
bad bad-value 'faces[0]' "$smooth has normals at its ends that are too far \
apart, or on opposite sides of the surface; $look" \
  "{$flat,\"faces\":[[0,1,2,3]],\"normals\":[[0,0,-1],$up]}"
bad bad-value 'faces[0]' "$smooth is parallel to a normal at one of its ends; \
$look" "{$flat,\"faces\":[[0,1,2,3]],\"normals\":[[1,0,0],[1,0,0],[0,0,1],\
[0,0,1]]}"
bad bad-value continuity 'must be 0, 1 or 2, found 3' \
  "{$points,$faces,\"continuity\":3}"
bad bad-value degree 'must be a whole number from 5, the degree of edges of '\
'continuity 1, to 31, found 4' "{$points,$faces,\"degree\":4}"
bad bad-value degree 'must be a whole number from 9, the degree of edges of '\
'continuity 2, to 31, found 32' "{$points,$faces,\"degree\":32,\"continuity\":2}"
bad bad-value degree 'must be "auto", "exact" or a number, found "high"' \
  "{$points,$faces,\"degree\":\"high\"}"
bad bad-value tolerance 'must be from 1e-12 to 1 radians, found 2' \
  "{$points,$faces,\"tolerance\":2}"

# points that jitter, so that no degree is high enough
jq -c 'select(.id == "monkey saddle") | {tolerance: 1e-12, continuity: 2, faces,
  points: [.points | to_entries[] | .key as $i | .value | to_entries |
    map(.value + (($i * 7 + .key * 3) | sin) / 20)]}' "$meshes" >rough.json
run bubble rough.json
equal 'no degree is high enough' 'no-convergence faces[0] needs blending '\
'functions of a higher degree than 31: normals miss by 3e-10; try a larger '\
'tolerance, a number for degree, or finer faces' "$(jq -r '.error |
  "\(.code) \(.message)"' out | sed 's/by 3[0-9.]*e/by 3e/')"
equal 'no degree is high enough: the status' 1 "$status"
run bubble -q --degree=31 rough.json
expect 'a degree that is given' 0
# one corner of a box is far away: quadrics are found, normals lie along edges
printf '%s\n' 'v -1 -1 -8.000000000000008e+63' 'v 1 -1 -1' 'v -1 1 -1' 'v 1 1 0' \
  'v -1 -1 1' 'v 1 -1 1' 'v -1 1 1' 'v 2 1 1' 'f 1 3 4 2' 'f 5 6 8 7' \
  'f 1 2 6 5' >far.obj
run bubble -q --subdivide=1 far.obj
equal 'a corner far away' 'bad-value faces[7] cannot be smooth: its edge '\
'between points[6] and points[18] is parallel to a normal at one of its ends; '\
'look at these normals, or take continuity 0' \
  "$(jq -r '.error | "\(.code) \(.message)"' out)"

# normals that turn a corner back over its neighbours
warned 1 folded 'the patch of faces[0] is folded: its normal turns to the '\
'other side (such patches: 1)' 0 "{\"id\":\"1\",\"points\":[[0,0,0],[2,0,0],\
[0.4,0.4,0],[0,2,0]],\"faces\":[[0,1,2,3]],\"normals\":[$up,[0,0,1]]}"

# ---- any data ----------------------------------------------------------------

# of every size, as far as areas and volumes are numbers
for size in e-221 e-162 e-100 e75; do
  accepted bubble "a mesh of 1$size" --edges --sample=2 --offset=1$size <<EOF
{"points":[[0,0,0],[5$size,0,0],[0,4$size,0],[0,0,1$size],[-5$size,0,0],
[0,-4$size,0]],"faces":[[0,1,2,3],[0,3,4,5]]}
EOF
done
feed '{"points":[[0,0,0],[1e300,0,0],[0,1e300,0],[1e300,1e300,1e300]],
"faces":[[0,1,3,2]]}' bubble -q
equal 'an area beyond all numbers' '1 "too-large"' \
  "$status $(jq -c .error.code out)"

# a volume is that of its faces, which way ever patches are folded
accepted bubble 'a closed surface with folds' --degree=10 --subdivide=1 <<EOF
{"points":[[0,0,0],[9,0,0],[0,9,-2],[0,-1,10]],
"faces":[[0,1,2],[0,2,3],[0,3,1],[1,3,2]]}
EOF
for faces in '[4,5,7,6]' '[6,7,5,4]'; do
  accepted bubble "a cube with the face $faces" --continuity=0 <<EOF
{$points,"faces":[[0,2,3,1],$faces,[0,1,5,4],[2,6,7,3],[0,4,6,2],[1,3,7,5]]}
EOF
  true_that "a cube with the face $faces: its volume" jq -e \
    '(.volume - 8 | fabs) < 1e-14' any.result
done

# sides in line at a corner; slivers; a curvature of 3e9
accepted bubble 'a corner whose normal is a limit' <<EOF
{"points":[[0,0,0],[0,-0.7,0],[2.02,-0.7,0],[2,0,0]],"degree":20,
"normals":[[0.2,0,0],[0,0,0.001],[0,0,0.001],[0,0.4,0]],"faces":[[0,1,3,2]]}
EOF
accepted bubble 'two points that are near to one another' --subdivide=1 <<EOF
{"points":[[0,-20,0],[-10.01702,-22.6398114387,5.094229956],
[-10.0170211,-22.639811,5.09422996]],"faces":[[0,1,2]]}
EOF
accepted bubble 'points that are the same, not at one edge' --subdivide=2 --edges <<EOF
{"points":[[0,0,0],[0,0,0],[0,1,0],[0,0,0]],"normals":[[1,0,0],[0,1,0],
[0,0,0.7],[0,0,0.7]],"faces":[[0,1,2],[0,2,3],[0,3,1]]}
EOF

# ---- the command line --------------------------------------------------------

# usage NAME MESSAGE OPTION...
usage() {
  name=$1 message=$2
  shift 2
  run "$@" </dev/null
  expect "$name" 2 "phspline: $message
Try 'phspline $1 --help'." ''
}
usage 'a table of others' '--table: the surfaces of bubble have patches, '\
'samples and edges' \
  bubble --table=strips
usage 'a table of patches' '--table: strips, development, located, '\
'patches and edges are of surfaces, planar makes curves' planar --table=patches
usage 'a format of others' '--format=svg-path is not of surfaces of patches' \
  bubble --format=svg-path
usage 'samples by two numbers' '--sample must be a whole number from 1 to '\
"1000000, found '3x4'" bubble --sample=3x4
usage 'a table of samples' '--table=samples needs --sample' \
  bubble --table=samples
usage 'offsets alone' '--offset needs --sample, or a format of meshes: '\
'surfaces beside those of bubble are samples' bubble --offset=1
usage 'a mesh of curves' '--format=stl is of surfaces, planar makes curves' \
  planar --format=stl
