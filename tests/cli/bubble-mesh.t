# SPDX-License-Identifier: GPL-3.0-or-later
#
# `bubble': what is made of its surfaces: samples, edges, surfaces beside them,
# meshes as OBJ and STL, which other programs read.  The exact surface is held
# against what is known of it, and polynomials against the exact one.
#
# shellcheck disable=SC2154,SC2016  # what lib.sh sets; programs of jq
. "$srcdir/tests/cli/lib.sh"

meshes=$srcdir/data/byrtus-2011-meshes.jsonl
jq -c 'select(.id == "cube")' "$meshes" >cube.json
jq -c 'select(.id == "monkey saddle")' "$meshes" >saddle.json
jq -c 'select(.id == "torus")' "$meshes" >torus.json

# ---- exact surfaces ------------------------------------------------------------

for n in 1 2; do
  run bubble --degree=exact --continuity=$n "$meshes"
  expect "exact $n" 0
  cp out exact
  true_that "exact $n: no control points, no jumps" jq -se 'all(.[];
    (.diagnostics | .normal_jump < 1e-14 and .continuity_error < 1e-15 and
    (has("degree") | not)) and all(.patches[]; keys == ["face", "vertices"]))' \
    out
  true_that "exact $n: curvatures" jq -se "all(.[]; $n < 2 or
    .diagnostics.curvature_jump < 1e-11)" out
  run verify --problems="$meshes" exact
  expect "exact $n: verified" 0
  for what in samples areas; do
    run bubble --degree=exact --continuity=$n --sample=5 "$meshes"
    if [ $what = areas ]; then
      jq -c '.area, (.volume // empty)' out >known
    else
      jq -c '.samples[] | .point, .normal' out >known
    fi
    run bubble --tolerance=1e-9 --continuity=$n --sample=5 "$meshes"
    if [ $what = areas ]; then
      jq -c '.area, (.volume // empty)' out >found
    else
      jq -c '.samples[] | .point, .normal' out >found
    fi
    numbers "exact $n: $what of polynomials" 2e-8 known found
  done
done
run bubble --degree=exact --continuity=0 --sample=2 cube.json
true_that 'exact 0' jq -e '(.area - 24 | fabs) < 1e-13 and .samples[4].point ==
  [0,0,-1]' out
jq -c '.faces[0] |= reverse' cube.json >other.json
run bubble --degree=exact cube.json
"$PHSPLINE" verify --problems=other.json out >verdict 2>err
equal 'exact: faces of another problem' 'patches[0].vertices' \
  "$(jq -r .error.field verdict)"

# ---- samples -------------------------------------------------------------------

run bubble --sample=2 --continuity=2 cube.json
equal 'samples: members' '{patch:number,u:number,v:number,point:[number],'\
'normal:[number],gauss:number,mean:number,principal:[number]}' \
  "$(json get 'samples[0]' <out | json shape)"
true_that 'samples: where they are' jq -e '(.samples | length) == 54 and
  (.samples[9:18] | map([.patch,.u,.v])) == [[1,0,0],[1,0.5,0],[1,1,0],
  [1,0,0.5],[1,0.5,0.5],[1,1,0.5],[1,0,1],[1,0.5,1],[1,1,1]]' out
# corners of the cube are on the sphere through them, of radius sqrt 3
true_that 'samples: curvatures at corners, against the normal' jq -e '
  all(.samples[] | select((.u - .u * .u) + (.v - .v * .v) == 0);
    [.gauss - 1 / 3, (.principal[] + 1 / (3 | sqrt)), .mean + 1 / (3 | sqrt),
      (.normal as $n | [.point, $n] | transpose | map(.[0] * .[1]) | add) -
      (3 | sqrt)] | all(.[]; fabs < 1e-11))' out
true_that 'samples: mean and Gauss curvature' jq -e 'all(.samples[];
  (.gauss - .principal[0] * .principal[1] | fabs) < 1e-12 and
  (2 * .mean - .principal[0] - .principal[1] | fabs) < 1e-12 and
  .principal[0] >= .principal[1])' out
jq -c '.normals |= map(map(-.))' cube.json >other.json
jq -c '.samples[] | .point, .normal, .gauss, .mean, .principal' out >known
run bubble --sample=2 --continuity=2 other.json
jq -c '.samples[] | .point, (.normal | map(-.)), .gauss, -.mean, (.principal |
  [-.[1], -.[0]])' out >found
numbers 'samples: normals on the other side' 1e-12 known found

# Curvatures by differences of points and normals, of the fourth order, on both
# kinds of surfaces, and what is beside them.
jq -c '.faces |= .[:1] | .points |= [.[0], .[5], .[6], .[1]] | .normals |=
  [.[0], .[5], .[6], .[1]] | .faces = [[0, 1, 2, 3]]' torus.json >patch.json
for degree in 15 exact; do
  run bubble --degree=$degree --continuity=2 --sample=80 patch.json \
    --table=samples --offset=0.1
  true_that "differences of normals: $degree" python3 \
    "$srcdir/tests/cli/samples.py" out 0.1
done

# ---- edges ---------------------------------------------------------------------

run bubble --edges --continuity=2 saddle.json
cp out result
true_that 'edges: the largest jumps' jq -e '([.edges[].normal_jump // 0] | max) as
  $jump | ([.edges[].curvature_jump // 0] | max) as $bend |
  ($jump / .diagnostics.normal_jump - 1 | fabs) < 1e-6 and
  ($bend / .diagnostics.curvature_jump - 1 | fabs) < 1e-6' out
true_that 'edges: boundaries' jq -e 'all(.edges[]; (.faces | length) as $n |
  ($n == 1 or $n == 2) and has("normal_jump") == ($n == 2)) and
  ([.edges[].faces[]] | length) == 4 * (.patches | length)' out
true_that 'edges: strips' jq -e 'all(.edges[].strip; (.height | length) == 10 and
  (.gradient | length) == 8 and (.hessian | length) == 6 and
  (.hessian[0] | length) == 6 and .height[0] == 0 and .height[9] == 0)' out
run bubble --table=edges --continuity=2 saddle.json
equal 'edges: columns' 'id,edge,vertex0,vertex1,face0,face1,normal_jump,'\
'curvature_jump' "$(head -n 1 out)"
true_that 'edges: rows' count "$(($(jq '.edges | length' result) + 1))" out
run bubble --edges --continuity=0 cube.json
true_that 'edges of continuity 0' jq -e 'all(.edges[]; (.normal_jump - 1.5707963267948966 |
  fabs) < 1e-12 and (has("strip") | not))' out

# ---- verify --------------------------------------------------------------------

run bubble --continuity=2 --edges --sample=3 --offset=0.1,-0.05 -q "$meshes"
cp out result
run verify --problems="$meshes" result
expect 'verified' 0
# tampered WHERE PROGRAM
tampered() {
  sed -n 3p result | jq -c "$2" >wrong.json
  "$PHSPLINE" verify wrong.json >out 2>err
  equal "tampered: $2" "$1" "$(jq -r .error.field out)"
}
tampered 'samples[7].point' '.samples[7].point[1] += 1e-6'
tampered 'samples[7].normal' '.samples[7].normal |= [.[1], .[0], .[2]]'
tampered 'samples[7].principal' '.samples[7].principal[1] *= 1.0001'
tampered 'samples[7].gauss' '.samples[7].gauss += 0.001'
tampered 'samples[7].mean' '.samples[7].mean += 0.001'
tampered 'samples[7].patch' '.samples[7].patch = 99'
tampered 'samples[7].patch' '.samples[7].u = 1.5'
tampered 'offsets[1].samples[9].point' '.offsets[1].samples[9].point[0] += 1e-6'
tampered 'offsets[0].samples[294].principal' '.offsets[0].distance = 0.2'
tampered 'edges[3].normal_jump' '.edges[3].normal_jump += 0.01'
tampered 'edges[3].curvature_jump' '.edges[3].curvature_jump += 0.01'
tampered 'edges[3]' '.edges[3].vertices = [0, 21]'

# ---- meshes --------------------------------------------------------------------

# obj NAME BOUNDARIES ANGLE OPTION...: angles of normals and tiles, in thousandths
obj() {
  name=$1 boundaries=$2 angle=$3
  shift 3
  run bubble --format=obj "$@"
  expect "obj: $name" 0
  python3 "$srcdir/tests/cli/obj.py" out "$boundaries" >report 2>err ||
    equal "obj: $name: read" '' "$(cat err)"
  true_that "obj: $name: normals" awk -v most="$angle" '$3 > most { print; bad = 1 }
    END { exit bad || !NR }' report
}
obj 'a closed surface' 0 170 cube.json
obj 'an open surface' 1 150 --sample=16 saddle.json
obj 'exact, one beside' 0 170 --degree=exact --offset=0.1 torus.json
true_that 'obj: objects' grep -qx 'o torus@0.1' out
jq -c 'del(.normals) | .faces[1] |= reverse | .faces[4] |= reverse' cube.json \
  >other.json
obj 'faces both ways around' 0 170 other.json
run bubble --format=obj --sample=3 cube.json torus.json
equal 'obj: points of the second count backwards' 2 "$(grep -c '^o' out)"
true_that 'obj: two objects' python3 "$srcdir/tests/cli/obj.py" out 0
run bubble --format=obj --sample=4 --continuity=0 cube.json
equal 'obj: points are shared, normals of continuity 0 are not' '98 150' \
  "$(grep -c '^v ' out) $(grep -c '^vn' out)"
run bubble --format=obj --sample=4 cube.json
equal 'obj: points and normals are shared' '98 98 96' \
  "$(grep -c '^v ' out) $(grep -c '^vn' out) $(grep -c '^f' out)"

# stl NAME TRIANGLES PARTS OPTION...: as admesh sees it
stl() {
  name=$1 triangles=$2 parts=$3
  shift 3
  "$PHSPLINE" bubble --format=stl "$@" -o out.stl || echo "not ok $name"
  equal "stl: $name: size" $((84 + 50 * triangles)) "$(wc -c <out.stl)"
  if ! command -v admesh >/dev/null; then
    echo "skip stl: $name: no admesh"
    return
  fi
  admesh out.stl >report
  equal "stl: $name: admesh" "$parts 0 0 0 0 0 0 0" "$(grep -oE \
    '(of parts|Degenerate facets|Edges fixed|Facets [a-z]*|Backwards edges|Normals fixed) *: *[0-9]*' report |
    sed 's/.*: *//' | tr '\n' ' ' | sed 's/ $//')"
}
stl 'a cube' 768 1 cube.json
stl 'a torus, and one inside' 10240 2 --offset=-0.2 torus.json
jq -c 'select(.id == "ellipsoid")' "$meshes" >ellipsoid.json
stl 'exact, of continuity 2' 4800 1 --degree=exact --continuity=2 --sample=10 \
  ellipsoid.json
stl 'faces both ways around' 768 1 other.json
# one file is one mesh
"$PHSPLINE" bubble --format=stl cube.json torus.json >out 2>err
equal 'stl: of one problem' '1 phspline: torus.json:1: record torus: is not the only problem: --format=stl is the mesh of one [bad-value]' "$? $(head -n 1 err)"
equal 'stl: the first is whole' $((84 + 50 * 768)) "$(wc -c <out)"
"$PHSPLINE" bubble --format=stl -S continuity=1,2 cube.json >out 2>err
equal 'stl: of one sweep' $((84 + 50 * 768)) "$(wc -c <out)"
jq -c '.points |= map(map(. * 1e40))' cube.json >other.json
run bubble --format=stl other.json
expect 'stl: beyond its numbers' 1 'phspline: other.json:1: record cube: points: are beyond the numbers of --format=stl, or the triangles are too many [bad-value]
phspline: 1 of 1 records failed' ''

# ---- figures -------------------------------------------------------------------

if "$PHSPLINE" planar -p x.svg nosuch.json 2>&1 | grep -q 'without cairo'; then
  echo 'skip figures: no cairo'
else
  # and under the address sanitizer no word of a leak
  run bubble -q --format=stl -p figure.svg cube.json torus.json
  equal 'stl: what is refused is not drawn' '1 1' "$status $(wc -l <err)"
  for jobs in 1 3; do
    run bubble -j $jobs -S continuity=0,1,2 -p $jobs.svg cube.json
    expect "a figure, $jobs jobs" 0
  done
  equal_files 'a figure is the same' 1.svg 3.svg
  # 24 steps on 4 sides of 6 patches, of 3 surfaces
  equal 'borders of patches' $((24 * 4 * 6 * 3)) \
    "$(tr -d ' ' <1.svg | grep -o 'rgb(22%,24%,28%)' | wc -l | tr -d ' ')"
  true_that 'shades and bands are of many colours' test 500 -lt \
    "$(grep -oE 'rgb\([^)]*\)' 1.svg | sort -u | wc -l)"
  run bubble --degree=exact -p one.png torus.json
  expect 'a PNG' 0
  true_that 'a PNG' test -s one.png
fi

# ---- what is refused -----------------------------------------------------------

run bubble --offset=0.1 --sample=2 --continuity=0 cube.json
equal 'beside continuity 0' 'continuity must be 1 or 2 for --offset: of 0 normals jump at edges' "$(jq -r .error.message out)"
run bubble --offset=0.1 --sample=5 --continuity=2 saddle.json
equal 'a surface that turns back' 'offset-cusp 18 the surface at distance 0.1 turns back, where radii of curvature towards it are smaller: first in patches[18]' "$(jq -r '.warnings[0] | "\(.code) \(.segment) \(.message)"' out)"
run bubble --sample=40 --max-samples=10000 cube.json
equal 'too many samples' 'the surface would have 10086 samples, more than the 10000 of --max-samples' "$(jq -r .error.message out)"
