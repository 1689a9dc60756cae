# SPDX-License-Identifier: GPL-3.0-or-later
#
# `bubble --degree=exact': records of surfaces without control points, which
# `verify' recomputes from their vertices and edges.
#
# shellcheck disable=SC2154,SC2016  # what lib.sh sets; programs of jq
. "$srcdir/tests/cli/lib.sh"

meshes=$srcdir/data/byrtus-2011-meshes.jsonl
jq -c 'select(.id == "monkey saddle")' "$meshes" >saddle.json
jq -c 'select(.id == "cube")' "$meshes" >cube.json

for n in 0 1 2; do
  run bubble --degree=exact --continuity=$n --sample=3 -q saddle.json cube.json
  expect "continuity $n" 0
  cp out result$n
  cat saddle.json cube.json >problems
  run verify --problems=problems result$n
  expect "continuity $n: verified" 0
  run verify result$n
  expect "continuity $n: verified alone" 0
done
equal 'members' '{vertices:[{point:[number],normal:[number]}],edges:['\
'{vertices:[number],faces:[number],normal_jump:number,curvature_jump:number,'\
'strip:{height:[number],gradient:[[number]],hessian:[[number]]}}]}' \
  "$(tail -n 1 result2 | jq -c '{vertices, edges: .edges[:1]}' | json shape)"
run bubble --degree=exact --offset=0.05,-0.05 --sample=2 -q cube.json
cp out beside
run verify --problems=cube.json beside
expect 'surfaces beside' 0
jq -c 'del(.normals) | .subdivide = 1' saddle.json >fine.json
run bubble --degree=exact fine.json
cp out fine
run verify --problems=fine.json fine
expect 'subdivided' 0

# ---- records that are not right any more --------------------------------------

# tampered WHERE PROGRAM [N]: of the saddle, of continuity N or 2
tampered() {
  head -n 1 "result${3-2}" | jq -c "$2" >wrong.json
  "$PHSPLINE" verify wrong.json >out 2>err
  equal "tampered: $2" "$1" "$(jq -r .error.field out)"
}
tampered vertices 'del(.vertices)'
tampered 'patches[0].vertices' 'del(.edges)'
tampered 'vertices[2].normal' '.vertices[2].normal |= map(. * 1.001)'
tampered 'patches[4].vertices' '.vertices |= .[:11]'
tampered 'edges[3].strip' '.edges[3].strip.height |= .[1:]'
tampered 'edges[3].strip' 'del(.edges[3].strip.hessian)'
tampered 'diagnostics.area' '.area *= 1.000001'
tampered 'samples[20].point' '.samples[20].point[0] += 1e-6'
tampered 'samples[20].mean' '.samples[20].mean *= 1.0001'
tampered closed '.closed = true'

# Any number that the surface depends on: what both patches of an edge have of
# it does not fit what others have, or what is told.  (In a plane of symmetry
# gradients count by their direction, and no edge is in one here.)
jq -c 'del(.normals) | .points |= [to_entries[] | .key as $i | .value |
  to_entries | map(.value + (($i * 7 + .key * 3) | sin) / 80)]' saddle.json \
  >rough.json
for n in 1 2; do
  run bubble --degree=exact --continuity=$n rough.json
  jq -c '. as $r | [paths(numbers) | select((.[0] == "vertices") or
      (.[0] == "edges" and .[2] == "strip" and .[3] != "hessian"))] as $all |
    $r, (range(0; $all | length; 11) as $i | $r | .id = $i |
    setpath($all[$i]; getpath($all[$i]) + 1e-5))' out >wrong
  "$PHSPLINE" verify wrong >out 2>err
  true_that "continuity $n: any number that is wrong" jq -se '(.[0] |
    .status == "ok") and (.[1:] | length > 40 and all(.[]; .status != "ok"))' out
done

# ---- what rounding makes of jumps ---------------------------------------------

accepted bubble 'jumps where tangents are all but along each other' --edges <<'EOF'
{"points":[[0,0,0],[0,0,-300],[-300,0,-300],[300,0,0],[0,-200,0],[300,0,0],
[0,300,0],[0,0,0]],"normals":[[0.9,0,0],[0,1,0],[0,1,0],[-0.1,0,0.7],
[0,-0.8,0.5],[0,0,-0.2],[0.1,0,0],[0,0.2,0.05]],"faces":[[0,2,3,1],[4,5,7,6],
[0,1,5,4],[2,6,7,3]],"degree":"exact"}
EOF
jq -c '.edges[6].curvature_jump *= 1.000001' any.result >wrong
run verify -q wrong
equal 'a jump that is larger by a millionth' '1 "edges[6].curvature_jump"' \
  "$status $(get error.field)"
accepted bubble 'a jump of 0 where derivatives in the plane are large' --edges <<'EOF'
{"points":[[-246,-256.3,-255.7],[255,-253.4,-259.8],[-261.6,248.2,-255],
[261.7,253.1,-246.7],[-254.5,-247.8,257.9],[253.7,-252.9,257.6],[-254.6,260.1,
260.2],[259.7,248.1,263.2]],"normals":[[0.8849,0.331,-0.3276],[-0.1332,0.9829,
0.1268],[-0.2499,0.965,0.07889],[-0.1123,-0.6904,0.7147],[0.1314,-0.8446,
0.5191],[-0.05935,0.9765,-0.2072],[0.1238,0.9596,-0.2528],[0.9793,0.196,
0.05127]],"faces":[[0,2,3,1],[4,5,7,6],[0,1,5,4],[2,6,7,3],[0,4,6,2],
[1,3,7,5]],"continuity":2,"degree":"exact"}
EOF
jq -c '.edges[3].curvature_jump += 1e-4' any.result >wrong
run verify -q wrong
equal 'a jump that is there no more' '1 "edges[3].curvature_jump"' \
  "$status $(get error.field)"
