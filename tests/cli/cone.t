# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cone': records, tables, meshes and flat patterns of surfaces through contact
# elements, against simple truths; and every way for a problem to be wrong.
# (Published cases: cone-reference.t; random ones: tests/prop/t_cone.c.)
#
# shellcheck disable=SC2016,SC2154  # programs of jq and awk; what errors.sh sets
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

# Table 4.1 of [GON18].
points='"points":[[252.6524,62,92.5],[266.5158,65.1388,91.5]]'
rulings='"rulings":[[-0.1151,0.2405,0.9638],[-0.1785,0.165,0.97]]'
tangents='"tangents":[[0.9925,0.069,0.1013],[0.8847,0.4583,0.0849]]'
good="{$points,$rulings,$tangents}"

# the eighth part of a cone about z: a quarter of its elements, closed or not
cat >turn.awk <<'EOF'
function list(name, a, b, c,   k, t, text) {
  for (k = 0; k < n; k++) {
    t = 8 * atan2(1, 1) * k / 8
    text = text (k ? "," : "") sprintf("[%.17g,%.17g,%.17g]",
      a * cos(t) - b * sin(t), a * sin(t) + b * cos(t), c)
  }
  return "\"" name "\":[" text "]"
}
BEGIN {
  print "{" list("points", 2, 0, 0) "," list("rulings", -0.6, 0, 0.8) ","
  print list("tangents", 0, 1, 0) rest "}"
}
EOF
turn() {
  awk -v n="$1" -v rest="$2" -f turn.awk | tr -d '\n'
}

# ---- records -----------------------------------------------------------------

feed "{\"id\":7,\"meta\":[1],$points,$rulings,$tangents}" cone
expect 'a record' 0
equal 'a record: its members' '{id:number,command:string,status:string,'\
'meta:[number],surface:string,closed:bool,height:[number],strips:[{pair:number,'\
'method:string,frame:{point:[number],ruling:[number],tangent:[number],'\
'normal:[number]},geodesic_curvature:number,normal_curvature:number,'\
'length:number,vertex:[number],half_angle:number,sweep:number,'\
'development_angle:number,shift:[number],contact:{control_points:[[number]],'\
'weights:[number]},development:{control_points:[[number]],weights:[number],'\
'angle:number}}],pairs:[{case:string,lambda:[number],center:[number],'\
'radius:number}],length:number,area:number,diagnostics:{iterations:number,'\
'residual:number,interpolation_error:number,length_error:number,regular:bool,'\
'frame_error:number,isometry_error:number,shift:number,vertices_inside:number,'\
'sign_changes:number,large_arcs:number,folded:number,lambda_interval:[[number]]}}' \
  "$(json shape <out)"
equal 'a record: values' '7 [1] "cone-spline" false 0 "sphere" true' \
  "$(get id) $(get meta) $(get surface) $(get closed) $(get area) \
$(get 'pairs[0].case') $(get diagnostics.regular)"
true_that 'lambda has an interval' jq -e \
  '.diagnostics.lambda_interval[0] | .[0] == 0 and
    (.[1] - 7.3929 | fabs < 1e-4)' out
feed "{$points,$rulings,$tangents,\"lambda\":7.5}" cone -q
expect 'lambda beyond it' 0
true_that 'lambda beyond it: the arc is large' \
  jq -e '.diagnostics.large_arcs == 1 and .pairs[0].lambda[1] < 0' out

# csv NAME TEXT [OPTION...]: CSV, which is for printf, gives the same surface
feed "$good" cone -q --table=strips
mv out want.csv
csv() {
  name=$1
  # shellcheck disable=SC2059
  printf "$2" >a.csv
  shift 2
  run cone -q --table=strips "$@" a.csv
  expect "$name" 0
  equal_files "$name: the surface" want.csv out
}
rows='252.6524,62,92.5,-0.1151,0.2405,0.9638,0.9925,0.069,0.1013\n'\
'266.5158,65.1388,91.5,-0.1785,0.165,0.97,0.8847,0.4583,0.0849\n'
csv 'CSV' "x,y,z,rx,ry,rz,tx,ty,tz\n$rows"
csv 'CSV without names' "$rows" --columns=x,y,z,rx,ry,rz,tx,ty,tz
csv 'CSV with normals' "x,y,z,rx,ry,rz,tx,ty,tz,nx,ny,nz\n$(printf '%b' "$rows" |
  sed 's/1013$/1013,-0.0421,0.9682,-0.2466/; s/0849$/0849,-0.4306,0.8733,-0.2278/
    s/$/\\n/' | tr -d '\n')"

# ---- one cone ----------------------------------------------------------------

# Of the cone with its apex at (0, 0, 8/3), points at the radius 2 and rulings of
# the slope 4/3: from the height -1/2 to 1 its area is that of an annulus.
turn 8 ',"closed":true,"height":[-0.5,1]' >turn.json
run cone -q turn.json
expect 'a cone all around' 0
true_that 'a cone all around: length, area, vertices, angles' jq -e '
  def near(a): . - a | fabs < 1e-12;
  (3.141592653589793 as $pi |
   (.length | near(4 * $pi)) and
   (.area | near($pi * 0.6 * ((10 / 3 + 0.5) * (10 / 3 + 0.5) -
     (10 / 3 - 1) * (10 / 3 - 1)))) and
   ([.strips[].development_angle] | add | near(2 * $pi * 0.6)) and
   all(.strips[]; (.vertex[2] | near(8 / 3)) and (.vertex[0] | near(0)) and
     (.half_angle | sin | near(0.6)))) and
  all(.pairs[]; .case == "pencil") and (.strips | length) == 16' out
run cone -q --override='height=[-1,4]' turn.json
true_that 'its vertex within the height' jq -e '.diagnostics |
  .vertices_inside == 16 and .regular == false' out
true_that 'both sides of the vertex have an area' jq -e '.area -
  3.141592653589793 * 0.6 * ((10 / 3 + 1) * (10 / 3 + 1) +
    (4 - 10 / 3) * (4 - 10 / 3)) | fabs < 1e-11' out
turn 3 ',"height":[0,1]' >part.json
run cone -q --offset=0.5,-0.25 part.json
true_that 'parallel cones: their rings' jq -e '
  def near(a): . - a | fabs < 1e-12;
  . as $r | .offsets as [$a, $b] | ($a.length / .length | near(1 - 0.5 *
    $r.strips[0].normal_curvature)) and ($b.length / .length |
    near(1 + 0.25 * $r.strips[0].normal_curvature)) and
  ($a.strips[0].frame.ruling == $r.strips[0].frame.ruling)' out
run cone --offset=9 part.json
expect 'a parallel cone that is none' 1 "phspline: part.json:1: record 1: \
strips[0]: has no parallel surface at the distance 9: its radius of normal \
curvature is 2.5 [infeasible]
$(failed 1 1)"

# ---- samples, meshes, patterns -----------------------------------------------

run cone -q --sample=3x2 --table=samples part.json
expect 'samples' 0
equal 'samples: their columns' 'id,strip,s,h,x,y,z,nx,ny,nz,u,v' \
  "$(head -n 1 out)"
true_that 'samples: how many' count $((1 + 4 * 4 * 3)) out
true_that 'samples: on the cone, and as far from the apex as when flat' awk -F, '
  function abs(x) { return x < 0 ? -x : x }
  BEGIN { bad = 1 }
  NR > 1 {
    bad = 0
    r = sqrt($5 ^ 2 + $6 ^ 2)
    if (!(abs(r - 0.75 * (8 / 3 - $7)) < 1e-12)) exit bad = 1
    if (!(abs($8 ^ 2 + $9 ^ 2 + $10 ^ 2 - 1) < 1e-12)) exit bad = 1
    flat = sqrt($11 ^ 2 + ($12 - 10 / 3) ^ 2)
    if (!(abs(flat - (10 / 3 - $4)) < 1e-12)) exit bad = 1
  }
  END { exit bad }' out
run cone -q --table=samples --sample=2 turn.json
true_that 'samples of the edges of the height' count $((1 + 16 * 3 * 2)) out
feed "$good" cone -q --table=samples --sample=2
true_that 'samples of the contact curve alone' count $((1 + 2 * 3)) out
feed "$good" cone -q --table=development
true_that 'the development' count $((1 + 2 * 3)) out

# mesh NAME EULER: of the mesh in out: each edge has two faces, or one at a
# boundary; vertices - edges + faces; normals are along those of the faces
mesh() {
  true_that "$1" awk -v euler="$2" '
    BEGIN { nv = nw = 0 }
    $1 == "v" { for (i = 2; i <= 4; i++) v[nv, i] = $i; nv++ }
    $1 == "vn" { for (i = 2; i <= 4; i++) w[nw, i] = $i; nw++ }
    $1 == "f" {
      faces++
      for (i = 2; i <= 5; i++) {
        split($i, at, "/")
        p[i] = (at[1] < 0 ? nv + at[1] : at[1] - 1)
        q[i] = (at[3] < 0 ? nw + at[3] : at[3] - 1)
      }
      for (i = 2; i <= 5; i++) {
        j = (i < 5 ? i + 1 : 2)
        if (edge[p[i], p[j]]++) exit bad = 1
        if (!((p[j], p[i]) in edge)) edges++
      }
      for (k = 2; k <= 4; k++) {
        a[k] = v[p[4], k] - v[p[2], k]
        b[k] = v[p[5], k] - v[p[3], k]
      }
      dot = (a[3] * b[4] - a[4] * b[3]) * w[q[2], 2]
      dot += (a[4] * b[2] - a[2] * b[4]) * w[q[2], 3]
      dot += (a[2] * b[3] - a[3] * b[2]) * w[q[2], 4]
      if (!(dot > 0)) exit bad = 1
    }
    END { exit (bad || nv - edges + faces != euler || !faces) }' out
}
run cone -q --format=obj --sample=4x3 turn.json
expect 'a mesh' 0
mesh 'a mesh all around is watertight' 0
run cone -q --format=obj part.json
mesh 'a mesh of a part' 1
run cone -q --format=obj --sample=2 --offset=0.5 part.json
mesh 'a mesh with a parallel one' 2
run cone -q --format=obj --sample=2 part.json turn.json
mesh 'two meshes in one file' 1

# Another program: edges with two faces each, unit normals along the faces, and
# flat coordinates that stretch nothing; angles in parts of a thousand.
if command -v python3 >/dev/null; then
  for mesh in '4 1 2 47 0' '16 1 2 12 0'; do
    steps=${mesh%% *}
    run cone -q --closed --height='[0,18]' --format=obj --sample="$steps"x3 \
      "$srcdir/data/lampshade.csv"
    equal "a mesh is read elsewhere, $steps steps" "${mesh#* }" \
      "$(python3 "$srcdir/tests/cli/obj.py" out 2)"
  done
else
  echo 'skip a mesh is read elsewhere: no python3'
fi
run cone -q --format=stl --sample=4x3 --closed --height='[0,18]' \
  "$srcdir/data/lampshade.csv"
mv out mesh.stl
run cone -q --format=obj --sample=4x3 --closed --height='[0,18]' \
  "$srcdir/data/lampshade.csv"
equal 'triangles: two for each face' $((84 + 100 * $(grep -c '^f' out))) \
  "$(wc -c <mesh.stl)"
if command -v admesh >/dev/null; then
  admesh -e -d -v mesh.stl >report # leaves boundaries as they are
  equal 'triangles: admesh turns none around' '0 0 0' "$(grep -oE \
    '(Degenerate facets|Facets reversed|Normals fixed) *: *[0-9]*' report |
    sed 's/.*: *//' | tr '\n' ' ' | sed 's/ $//')"
fi
feed "$good" cone --format=obj
expect 'a mesh of no height' 1 'phspline: -:1: record 1: height: must have an '\
"extent for --format=obj, as in --height=[-1,1] [bad-value]
$(failed 1 1)" ''

# Points of the flat pattern, of many strips, back on the surface.
turn 8 ',"closed":true,"height":[-0.5,1]' >turn.json
run cone -q --sample=5x3 turn.json
jq -c '{flat: [.samples[].flat]}' out >flat.json
jq -c '[.samples[].point]' out >points.json
jq -cs '.[0] + .[1]' turn.json flat.json >located.json
run cone located.json
expect 'points of the flat pattern' 0
mv out result.json
true_that 'points of the flat pattern: all are located, where they were' \
  jq -es '.[0] as $p | .[1].located as $l | ($p | length) == ($l | length) and
    all(range($p | length); . as $i | $l[$i].index == $i and
      all(range(3); $p[$i][.] - $l[$i].point[.] | fabs < 1e-13))' \
  points.json result.json
run verify --problems=located.json result.json
expect 'points of the flat pattern: verified' 0
sed 's/"located":\[{"index":0,"strip":0,"s":0,/&"h":0.2,"hh":/; s/"hh":[^,]*,//' \
  result.json >wrong.json
run verify -q wrong.json
equal 'points of the flat pattern: another place is refused' \
  '1 "located[0].point"' "$status $(get error.field)"
sed 's/"index":7,/"index":8,/' result.json >wrong.json
run verify -q --problems=located.json wrong.json
equal 'points of the flat pattern: another point is refused' \
  '1 "located[7].flat"' "$status $(get error.field)"
run cone --flat='[[0,0],[9,9],[0.5,0.3],[0,1.1]]' --table=located part.json
expect 'points beside the flat pattern' 0 "phspline: part.json:1: record 1: \
warning: 2 of 4 points are outside of the flat pattern, the first is flat[1] \
[outside]"
equal 'points beside the flat pattern: the others' 'index 0 2' \
  "$(cut -d, -f2 out | tr '\n' ' ' | sed 's/ $//')"
feed "$good" cone -q --flat='[[9,9]]'
equal 'no point on the flat pattern: no member' absent "$(get located)"

run cone -q --format=svg-path part.json
expect 'a flat pattern' 0
true_that 'a flat pattern: an outline and three rulings' \
  awk '{ exit gsub(/M/, "") != 4 }' out
true_that 'a flat pattern: its outline is closed, and of two radii' awk '
  function abs(x) { return x < 0 ? -x : x }
  {
    n = split($0, part, "M")
    split(part[2], piece, "C")
    m = split(part[2], piece, "C")
    split(piece[1], first, ",")
    for (i = 2; i <= m; i++) {
      split(piece[i], p, /[ ,]/)
      r = sqrt(p[5] ^ 2 + (p[6] - 10 / 3) ^ 2)
      if (abs(r - 10 / 3) > 1e-6 && abs(r - 7 / 3) > 1e-6) exit bad = 1
    }
    exit p[5] != first[1] || p[6] != first[2]
  }
  END { exit bad }' out

# d CLASS: the attribute d of the path of that class in out, "none" of those without
d() {
  case $1 in
  none) grep '<path ' out | grep -v class= ;;
  *) grep "class=\"$1\"" out ;;
  esac | sed 's/.* d="\([^"]*\)".*/\1/'
}

cp out pattern
run cone -q --format=svg --offset=0.1 part.json
equal 'a drawing of a flat pattern: rulings are apart from the outline' \
  '1  1/rulings ruling 1@0.1 offset 1@0.1/rulings offset ruling' \
  "$(sed -n 's/^<path id="\([^"]*\)"\( class="\([^"]*\)"\)*.*/\1 \3/p' out |
    tr '\n' ' ' | sed 's/ $//')"
equal 'a drawing of a flat pattern: an outline, closed, and three rulings' \
  'MZ MMM' "$(d none | tr -dc MZ) $(d ruling | tr -dc MZ)"
equal 'a drawing of a flat pattern: the paths are those of svg-path' \
  "$(cat pattern)" "$(d none | tr -d Z)$(d ruling)"
jq -c 'del(.height)' part.json >bare.json
run cone -q --format=svg bare.json
equal 'a drawing without a height: the contact curve' 'M 1' \
  "$(d none | tr -dc MZ) $(grep -c '<path ' out)"

# Squares of coordinates are out of range.
for unit in 1e-160 1e213; do
  jq -c --argjson u "$unit" '.points |= map(map(. * $u)) | del(.height, .closed)' \
    turn.json >far.json
  run cone -q --sample=4 far.json
  expect "in the unit $unit: samples" 0
  cp out result.json
  jq -c '{flat: [.samples[].flat]}' out >flat.json
  jq -cs '.[0] + .[1]' far.json flat.json >located.json
  run cone -q located.json
  true_that "in the unit $unit: they are located" \
    jq -es '(.[0].samples | length) == (.[1].located | length)' result.json out
  run verify -q --problems=far.json result.json
  equal "in the unit $unit: verified" '0 "ok"' "$status $(get status)"
done

# ---- other cases -------------------------------------------------------------

# solved NAME CASE PROBLEM
solved() {
  feed "$3" cone -q
  expect "$1" 0
  equal "$1: its case" "\"$2\"" "$(get 'pairs[0].case')"
  mv out result.json
  printf '%s' "$3" >problem.json
  run verify --problems=problem.json result.json
  equal "$1: verified" '0 "ok"' "$status $(get status)"
}
solved 'a plane' flat '{"points":[[0,0,0],[2,1,0]],"rulings":[[0,1,0],'\
'[-0.6,0.8,0]],"tangents":[[1,0,0],[0.8,0.6,0]],"height":[0,1]}'
solved 'a cylinder' parallel '{"points":[[0,0,0],[3,1,1]],"rulings":[[0,1,0],'\
'[0,1,0]],"tangents":[[1,0,0],[0.6,0,0.8]],"height":[0,1]}'
solved 'a cone that is not circular' apex '{"points":[[4,0,0],[0,2,0.5]],'\
'"rulings":[[-4,0,4],[0,-2,3.5]],"tangents":[[0,1,0],[-1,0,0]],"height":[0,1]}'
true_that 'a cone that is not circular: both vertices are its own' jq -e '
  all(.strips[]; .vertex | (.[0] | fabs < 1e-14) and (.[1] | fabs < 1e-14) and
    (.[2] - 4 | fabs < 1e-14)) and .pairs[0].center == null' result.json
solved 'rulings that meet between their points' apex '{"points":[[1,0,0],'\
'[0,-1,-1]],"rulings":[[1,0,0],[0,1,1]],"tangents":[[0,1,0],[-1,0,0]]}'
solved 'half a circle, of which a leg is infinite' parallel '{"points":[[0,0,0],'\
'[1,0,2]],"rulings":[[0,1,0],[0,1,0]],"tangents":[[1,0,0],[-1,0,0]],'\
'"lambda":0.5}'
solved 'a far point on a ruling' sphere "{\"points\":[[252.6524,62,92.5],\
[266.3373,65.3038,92.47]],$rulings,$tangents,\"height\":[-2,2]}"
feed "{\"points\":[[0,0,0],[0,0,0],[2,1,0]],\"rulings\":[[0,1,0],[0,1,0],\
[0,1,0]],\"tangents\":[[1,0,0],[1,0,0],[1,0,0]]}" cone --merge=0.1 -q
expect 'elements that are there twice, joined' 0
equal 'elements that are there twice, joined: two strips' '[1] 2' \
  "$(get merged) $(jq '.strips | length' out)"

# ---- what is wrong -----------------------------------------------------------

errors_of cone
other='"rulings":[[0,1,0],[0,1,0]]'
bad zero-tangent 'rulings[1]' 'must not be zero' \
  "{$points,\"rulings\":[[0,0,1],[0,0,-0.0]],$tangents}"
bad zero-tangent 'tangents[0]' 'must not be zero' \
  "{$points,$rulings,\"tangents\":[[0,0,0],[0,0,1]]}"
bad missing-field rulings 'is missing: it must be an array of vectors [x,y,z]' \
  "{$points,$tangents}"
bad missing-field tangents 'is missing: it must be an array of vectors [x,y,z]' \
  "{$points,$rulings}"
bad missing-field points 'is missing: it must be an array of points [x,y,z]' \
  "{$rulings,$tangents}"
bad too-few-points points 'must be at least 2, found 1' \
  '{"points":[[0,0,0]],"rulings":[[0,1,0]],"tangents":[[1,0,0]]}'
bad bad-shape tangents 'must have 2 vectors, one for each point, found 1' \
  "{$points,$rulings,\"tangents\":[[1,0,0]]}"
bad bad-value 'tangents[0]' 'is not orthogonal to rulings[0]: the cosine is '\
'0.447, at most 0.001 is allowed; look for misprints in both' \
  "{$points,$other,\"tangents\":[[2,1,0],[1,0,0]]}"
bad bad-value 'normals[1]' 'is neither rulings[1] x tangents[1] nor its '\
'opposite: it is off by 1.41, at most 0.005 is allowed' \
  "{$points,$other,\"tangents\":[[1,0,0],[0,0,1]],\
\"normals\":[[0,0,-1],[0,1,0]]}"
bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  "{\"points\":[[1,2,3],[1,2,3]],$rulings,$tangents}"
bad bad-value lambda 'must be greater than 0, found 0' \
  "{$points,$rulings,$tangents,\"lambda\":0}"
bad bad-shape height 'must have 2 numbers, from where to where, found 1' \
  "{$points,$rulings,$tangents,\"height\":[1]}"
bad bad-value height 'must not begin above its end, found [1,-1]' \
  "{$points,$rulings,$tangents,\"height\":[1,-1]}"
bad bad-value degenerate_tolerance \
  'must be greater than 0 and at most 0.1, found 1' \
  "{$points,$rulings,$tangents,\"degenerate_tolerance\":1}"
bad bad-shape 'flat[1]' 'must have 2 numbers, found 3' \
  "{$points,$rulings,$tangents,\"flat\":[[0,0],[1,2,3]]}"
bad infeasible 'pairs[0]' 'has no pair of circular cones: the rulings are those '\
'of a saddle, as of a helicoid; see whether one of them points the other way' \
  '{"points":[[0,0,0],[0,0,1]],'\
'"rulings":[[1,0,0],[0.8,0.6,0]],"tangents":[[0,0,1],[0,0,1]]}'
bad infeasible 'pairs[0]' 'has no pair of cones: one contact element is the '\
'other one turned by 180 degrees; ruling and tangent must not turn back' \
  '{"points":[[0,0,0],[1,0,0]],"rulings":[[0,1,0],[0,-1,0]],'\
'"tangents":[[1,0,0],[-1,0,0]]}'
bad infeasible 'pairs[0]' 'has no pair of cones: the tangent planes are '\
'parallel, and not the same' '{"points":[[0,0,0],[1,0,1]],'\
'"rulings":[[0,1,0],[-0.6,0.8,0]],"tangents":[[1,0,0],[0.8,0.6,0]]}'
bad infeasible 'pairs[0]' 'has no pair of cones with such legs: the second '\
'contact element is not ahead of the first, or no second leg belongs to this '\
'lambda' "{\"points\":[[0,0,0],[-1,0,0]],$other,\
\"tangents\":[[1,0,0],[1,0,0]]}"
bad_csv 1 2 tangents missing-field 'is missing: it must be an array of vectors '\
'[x,y,z]' 'x,y,z,rx,ry,rz\n0,0,0,1,0,0\n'
bad_csv 3 1:1 '' missing-field 'column "rz" is missing: cone needs it for '\
'rulings' 'x,y,z,rx,ry,tx,ty,tz\n0,0,0,1,0,0,1,0\n'
bad_csv 1 3 'rulings[1]' not-finite 'needs a finite number in column ry, '\
'found "nan"' \
  'x,y,z,rx,ry,rz,tx,ty,tz\n0,0,0,0,1,0,1,0,0\n1,0,0,0,nan,0,1,0,0\n'

# warned_of CODE PROBLEM: and no more than that
warned_of() {
  feed "$2" cone
  equal "warnings: $1" "0 $1" \
    "$status $(jq -r '[.warnings[].code] | join(" ")' out)"
}
warned_of vertex-inside "$(turn 2 ',"height":[0,4]')"
warned_of sign-change '{"points":[[0,0,0],[1,0,1]],"rulings":[[0,1,0],[0,1,0]],'\
'"tangents":[[1,0,0],[1,0,0]]}'
warned_of large-arc "{$points,$rulings,$tangents,\"lambda\":7.5}"
warned_of outside "{$points,$rulings,$tangents,\"flat\":[[7,7]]}"
warned_of far-contact '{"points":[[0,0,0],[1,0,0.1]],"rulings":[[0,1,0],'\
'[0.00001,1,0.00002]],"tangents":[[1,0,0],[0.99,0,0.14]]}'

# Between the contact curve and the height there is the vertex of one strip, and
# not of the other: the vertices are on two sides.
fold='{"points":[[0,0,0],[2,1,0]],"rulings":[[0,0,1],[0.6,0,0.8]],'\
'"tangents":[[1,0,0],[0,1,0]],"height":FROM}'
feed "$(echo "$fold" | sed 's/FROM/[3,4]/')" cone
equal 'folded: warnings' '0 sign-change folded' \
  "$status $(jq -r '[.warnings[].code] | join(" ")' out)"
true_that 'folded: it is told' jq -e '.diagnostics | .folded == 1 and
  .vertices_inside == 0 and .regular == false' out
cp out folded.json
run verify -q folded.json
equal 'folded: verified' 0 "$status"
for change in '.folded = 0' '.regular = true'; do
  jq -c ".diagnostics |= ($change)" folded.json >wrong.json
  run verify -q wrong.json
  equal "folded: $change is refused" 1 "$status"
done
feed "$(echo "$fold" | sed 's/FROM/[-1.6,-1.2]/')" cone
true_that 'not folded' jq -e '.diagnostics | .folded == 0 and .regular' out
feed "$(echo "$fold" | sed 's/FROM/[-1.6,-1.58]/')" cone --offset=0.5,0.95
true_that 'folded: not the surface, but that at a distance' jq -e '
  .diagnostics.folded == 0 and ([.warnings[] | select(.code == "folded") |
  .message] == ["the surface at the distance 0.95 turns back on itself " +
  "at the end of strip 0, as one strip there is beyond its vertex (such rulings: 1)"])' out
# ---- the command line --------------------------------------------------------

# usage NAME MESSAGE OPTION...
usage() {
  name=$1 message=$2
  shift 2
  run "$@" </dev/null
  expect "$name" 2 "phspline: $message
Try 'phspline $1 --help'." ''
}
usage 'a table of curves' '--table: the surfaces of cone have strips, samples, '\
'development and located' cone --table=lengths
usage 'a table of surfaces' '--table: strips, development, located, '\
'patches and edges are of '\
'surfaces, planar makes curves' planar --table=strips
usage 'a mesh of curves' '--format=obj is of surfaces, tc makes curves' tc \
  --format=obj
usage 'samples that are not asked for' '--table=samples needs --sample' cone \
  --table=samples
for sample in 0 1.5 2x0 2x 3x2x1 x3 ''; do
  usage "--sample=$sample" '--sample must be one or two whole numbers from 1 to '\
"1000000, as 20 or 20x4, found '$sample'" cone --sample="$sample"
done
usage 'an option of curves' "cone has no option '--spacing'" cone --spacing=1

# ---- any data -----------------------------------------------------------------

accepted cone 'contact points far along the rulings' <<'EOF'
{"points":[[0,0,0],[0,0,0.0002],[0,0,0]],"tangents":[[-0.436,-0.639,-0.634],
[0.436,0.639,0.634],[0.84,0.332,0.4]],"rulings":[[-0.622,0.723,-0.3],
[-0.622,0.7229,-0.3],[-0.38,0.92,0.036]]}
EOF
accepted cone 'a height that is nothing beside the shift' <<'EOF'
{"points":[[0,0,0],[0,0,2e188],[0,0,0]],"height":[0,9],
"tangents":[[-0.527,0.82,-0.22],[-0.845,0.39,0.365],[-0.526,0.35,0.78]],
"rulings":[[0.66,0.559,0.5],[0.533,0.673,0.514],[0.793,0.53,0.297]]}
EOF
accepted cone 'a surface far from a tiny one' --offset=-0.007 <<'EOF'
{"points":[[0,0,0],[0,0,2e-216]],"tangents":[[-1,-0,0],[-0.245,-0.97,0]],
"rulings":[[-0,0.9,0.4],[-0.87,0.22,0]]}
EOF
accepted cone 'a sphere that data hardly tell' <<'EOF'
{"points":[[-3728735,-2662131.3,3792685.6],[-10296956.5,-2882455,715637]],
"tangents":[[-0.5558817,0.4639369,-0.6897522],[-0.8890955,-0.4493934,
0.0869176]],"rulings":[[-0.2767937,0.6791088,0.6798503],[-0.2767937,0.6791088,
0.6798503]]}
EOF
accepted cone 'a vertex beyond all numbers' <<'EOF'
{"points":[[0,0,0],[0,0,2e296]],"tangents":[[0.32,-0.923,0.216],
[-0.444,-0.113,0.89]],"rulings":[[0.805417327756,0.384143038608,
0.451372411695],[0.805417327756,0.384143038608,0.451372411695]]}
EOF
accepted cone 'a height within which there is the vertex' --offset=1 <<'EOF'
{"points":[[0,0,0],[80,0,0],[0,0,0]],"tangents":[[-1,-0,0],[-0.59,-0.808,0],
[0.304,-0.95,-0]],"lambda":[0.7,9],"height":[-0.08278,-0.048],
"rulings":[[-0,0.8,0],[-0.6526,0.477,0.589],[-0.77,-0.246,0.5892]]}
EOF

# ---- what rounding and noise leave of pairs -----------------------------------

accepted cone 'an arc nearly all around, far from the origin' --offset=0.009 <<'EOF'
{"points":[[334420662,12519908,115542878.6],[334420661,12519908,115542878]],
"tangents":[[-0.91467527,0.34494307,0.2106738],[-0.22587468,-0.53304895,
-0.81537687]],"lambda":2,"rulings":[[0.2089053,-0.042754667,0.97700083],[
-0.891526166,-0.224243983,0.39356795]]}
EOF
accepted cone 'a sphere of a hundred million times the distance' <<'EOF'
{"points":[[0,0,0],[0,0,-0.0003]],"tangents":[[0.09038,-0.034126,0.99],[0.09038,
-0.034126,1]],"rulings":[[0.93116,-0.35158,-0.096609],[0.93116,-0.351584,
-0.096609]]}
EOF
equal 'equal legs are equal' true \
  "$(jq '.pairs[0].lambda | (.[0] / .[1] - 1 | fabs) < 1e-14' any.result)"

# Of a pencil of spheres one equation may miss by the tolerance; the others and
# the places along the rulings do not, and the centre cannot go elsewhere.
accepted cone 'a pencil of spheres, by a tolerance' <<'EOF'
{"points":[[-0.26,0.7,0.59],[0.76,0.46,1.2]],"tangents":[[0.402,-0.617,0.68],[
0.74,-0.64,0.21]],"rulings":[[-0.68,-0.695,-0.228],[-0.616,-0.77,-0.177]],
"degenerate_tolerance":0.002}
EOF
equal 'its case' '"pencil"' "$(jq '.pairs[0].case' any.result)"
run verify -q any.result
expect 'a pencil of spheres, verified alone' 0
for move in '[1e-6,0,0]' '[0,1e-6,0]' '[0,0,1e-6]' '[1e-6,1e-6,-1e-6]' \
  '[-6.8e-7,-6.95e-7,-2.28e-7]' '[-6.16e-7,-7.7e-7,-1.77e-7]'; do
  jq -c "$move as \$d | .pairs[0].center |= [., \$d] |
    .pairs[0].center |= (transpose | map(add))" any.result >bad
  run verify -q bad
  equal "its centre moved by $move" '1 "pairs[0].center"' \
    "$status $(get error.field)"
done

# Of data within the tolerance of two cases, here of rulings that meet, too, that
# is taken whose frames miss the least: the other one misses by 1e-3.
accepted cone 'constant slope with noise, by a tolerance' <<'EOF'
{"points":[[-0.25059,-1.57309,6.20395],[0.22548,-1.57698,6.58331]],"tangents":[[
0.86745,0.49753,6e-05],[0.6817,0.73163,0.00017]],"rulings":[[0.3085,-0.53797,
0.78448],[0.45343,-0.42267,0.7847]],"degenerate_tolerance":0.01}
EOF
true_that 'its case, frames and contact points' jq -e '.pairs[0].case == "parallel" and
  .diagnostics.shift < 0.3 and .diagnostics.frame_error < 1e-12' any.result
