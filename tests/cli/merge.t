# SPDX-License-Identifier: GPL-3.0-or-later
#
# The field merge and the option --merge, of every command: which points are
# joined, what is told, that the curve is the one of the points that are left,
# and that verify pairs it with the problem.
. "$srcdir/tests/cli/lib.sh"

# joins COMMAND PROBLEM WITHOUT SAYS [OPTION]...: the curve of a problem is that
# of another, which has no points to join; the first has a warning, with the
# numbers of the points that are gone.
joins() {
  command=$1 problem=$2 without=$3 says=$4
  shift 4
  printf '%s\n' "$problem" >problem
  feed "$without" "$command" -q
  expect "$command: without" 0
  sed 's/,"warnings".*/}/' out >wanted
  run "$command" "$@" problem
  expect "$command: joins" 0 \
    "phspline: problem:1: record 1: warning: $says [merged-points]"
  mv out result
  sed 's/,"set":{[^}]*}//; s/,"merged":\[[0-9,]*\]//; s/,"warnings".*/}/' \
    result >found
  equal_files "$command: the curve" wanted found
  run verify --problems=problem result
  expect "$command: verified" 0
  feed "$problem" "$command" "$@" --strict
  expect "$command: strict" 1 \
    "phspline: -:1: record 1: $says [merged-points]
phspline: 1 of 1 records failed"
}

one='1 of 4 points were joined with neighbours nearer than'
points='"points":[[0,0],[2,1],[2,1.01],[4,0]]'
left='"points":[[0,0],[2,1],[4,0]]'
joins planar "{$points}" "{$left}" "$one 0.1: points[2]" --merge=0.1
joins planar "{\"merge\":0.1,$points,\"knots\":[0,1,2,3]}" \
  "{$left,\"knots\":[0,1,3]}" "$one 0.1: points[2]"
joins planar "{$points,\"basis\":\"atph\",\"alpha\":[1,2,1.1]}" \
  "{$left,\"basis\":\"atph\",\"alpha\":[1,1.1]}" "$one 0.1: points[2]" \
  --merge=0.1
joins spatial-hermite \
  "{$points,\"tangents\":[[1,0],[1,0.1],[1,0.09],[1,0]]}" \
  "{$left,\"tangents\":[[1,0],[1,0.1],[1,0]]}" "$one 0.1: points[2]" --merge=0.1
joins arclength '{"points":[[0,0],[2,0],[2,0],[5,0]],"lengths":[2,0,3]}' \
  '{"points":[[0,0],[2,0],[5,0]],"lengths":[2,3]}' "$one 0.1: points[2]" \
  --merge=0.1
joins sphere \
  '{"lonlat":[[0,0],[1,0],[1.00001,0],[2,1]],"radius":6371000}' \
  '{"lonlat":[[0,0],[1,0],[2,1]],"radius":6371000}' \
  "$one 2: lonlat[2]" --merge=2
joins tc "{$points,\"derivatives\":[[1,0],[1,0],[1,0],[1,0]]}" \
  "{$left,\"derivatives\":[[1,0],[1,0],[1,0]]}" "$one 0.1: points[2]" \
  --merge=0.1
sheet='"rulings":[[0,1,0],[0,1,0],[0,1,0]],'\
'"tangents":[[1,0,0.6],[1,0,0],[1,0,-0.6]],"height":[0,1]'
joins cone "{\"points\":[[0,0,0],[1,0,0.3],[1.01,0,0.3],[2,0,0]],\
\"rulings\":[[0,1,0],[0,1,0],[0,1.05,0],[0,1,0]],\"tangents\":[[1,0,0.6],\
[1,0,0],[1.05,0,0],[1,0,-0.6]],\"height\":[0,1]}" \
  "{\"points\":[[0,0,0],[1,0,0.3],[2,0,0]],$sheet}" "$one 0.1: points[2]" \
  --merge=0.1

# ---- closed data and ends ----------------------------------------------------

square='[0,0],[2,0],[2,2],[0,2]'
joins planar "{\"closed\":true,\"points\":[$square,[0,0.05],[0,0]]}" \
  "{\"closed\":true,\"points\":[$square]}" \
  '1 of 6 points were joined with neighbours nearer than 0.1: points[4]' \
  --merge=0.1
feed "{\"closed\":true,\"points\":[$square,[0,0]]}" planar --merge=0.1
expect 'a repeated last point is not told' 0
equal 'nor in the record' absent "$(get merged)"

feed "{\"points\":[$square,[0,1.95]]}" planar --merge=0.1
equal 'the last point stays' '[3] [0,1.95]' \
  "$(get merged) $(get 'segments[2].control_points[5]')"

# ---- CSV, sweeps and options -------------------------------------------------

printf 'x,y,length\n0,0,\n2,0,2\n2,0,0\n5,0,3\n' >data.csv
run arclength --merge=1e-6 data.csv
expect 'CSV' 0 'phspline: data.csv:2: record 1: warning: 1 of 4 points were joined with neighbours nearer than 1e-06: points[2] [merged-points]'
equal 'in the record' '{"merge":0.000001} [2]' "$(get set) $(get merged)"
printf '{%s}\n' "$points" >problem
run planar -q --sweep=merge=0.1,0.001 problem
expect 'swept' 0
mv out result
run verify --problems=problem result
expect 'swept and verified' 0
sed 's/"merged":\[2\]/"merged":[1]/' result >bad
run verify -q --problems=problem bad
expect 'others than are said' 1 \
  'phspline: bad:1: record 1: merged: are not the points that merge joins [not-verified]'

# ---- failures ----------------------------------------------------------------

# bad COMMAND PROBLEM LINE SAYS [OPTION]...
bad() {
  printf '%s\n' "$2" >problem
  command=$1 line=$3 says=$4
  shift 4
  run "$command" "$@" problem
  expect "$command: $says" 1 "phspline: problem:$line: record 1: $says
$(failed 1 1)"
}

for command in planar spatial-hermite arclength tc; do
  bad "$command" '{"points":[[0,0],[2,1],[2,1]]}' 1 \
    'points[2]: coincides with points[1]; --merge=D joins points nearer than D [coincident-points]'
  bad "$command" '{"points":[[0,0],[2,1]]}' 1 \
    'merge: must be greater than 0, found 0 [bad-value]' --merge=0
  bad "$command" '{"points":[[0,0],[2,1],[2,1]]}' 1 \
    'points: must be at least 2, found 1: merge joined 2 of 3 [too-few-points]' \
    --merge=3
done
bad sphere '{"lonlat":[[0,0],[9,0],[9,0]]}' 1 \
  'lonlat[2]: coincides with lonlat[1]: they are less than 1e-10 rad apart; --merge=D joins points nearer than D [coincident-points]'
bad sphere '{"lonlat":[[0,0],[9,0],[9,0]]}' 1 \
  'merge: must be greater than 0, found -1 [bad-value]' --merge=-1
bad arclength '{"tangents":[[1,0],[0,1]],"lengths":1}' 1 \
  'merge: is for points [bad-value]' --merge=1
bad tc '{"curve":[[0,0],[1,1],[2,0]]}' 1 'merge: is for points [bad-value]' \
  --merge=1
bad spatial-hermite \
  "{$points,\"tangents\":[[1,0],[1,0],[0,1],[1,0]]}" 1 \
  'tangents[2]: differs from tangents[1] by more than a tenth, but merge joins points[2] to points[1] [bad-value]' \
  --merge=0.1
# the element and the line are those that were given
bad arclength '{"points":[[0,0],[2,1],[2,1],[4,0],[5,0]],
"lengths":[3,
1,
4,
-2]}' 5 'lengths[3]: must be greater than 0, found -2 [bad-value]' --merge=0.1
for x in nan inf x; do
  run planar --merge="$x" problem
  expect "--merge=$x" 2 "phspline: --merge: merge must be a number, found \"$x\"
Try 'phspline planar --help'."
done
run verify --merge=1 result
expect 'verify has set' 2 "phspline: verify has no option '--merge', but there is one of planar
Try 'phspline verify --help'."
