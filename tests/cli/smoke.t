# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every path of the program once, in little time: also run under valgrind.
. "$srcdir/tests/cli/lib.sh"

# A status of the program is 0 to 5; valgrind's own is 9.
printf '%s\n' '{"id":"a","points":[[0,0],[1,1],[2,0]],"meta":{"n": [1]}}' \
  "$bad" '{"points":[[0,0],[1' '{"points":[[0,0],[1,0],[0,0]]}' \
  '{"points":[[0,0],[1,1]],"end_derivatives":[[-1,-1],[-1,-1]]}' \
  '{"points":[[0,0],[2,1],[3,3],[0,2],[0,0]],"closed":true}' \
  '{"points":[[0,0],[1,1],[2,0]],"knots":[0,1,1.5]}' >some.jsonl
run planar -j 1 some.jsonl
equal 'JSON Lines' '1 "ok" "error" "error" "ok" "ok" "ok" "ok"' \
  "$status $(get status)"
cp out one
run planar -j 2 some.jsonl
equal_files 'two threads' one out
run planar --pretty -v --progress --offset=0.1,-0.1 -S knots=uniform,chordal \
  -S closed=false,true some.jsonl
equal 'a sweep, offsets, all that can be said' 1 "$status"
true_that 'all of it is JSON' json shape out
run planar -q -S 'points[0][0]=0:0.5:3' -S 'knots[1]=0.5,1' some.jsonl
equal 'sweeps of elements' 37 "$(wc -l <out | tr -d ' ')"
run planar --strict --fail-fast some.jsonl
expect '--fail-fast' 1 "phspline: some.jsonl:2: record 2: $bad_says
$(failed 1 2)"
run planar --set=knots=uniform --override='knots=[0,1,3]' \
  --end_derivatives='[[1,1],[1,-1]]' -f csv --table=lengths some.jsonl
equal 'fields as options, a table' '1 id,segment,t0,t1,length,cumulative' \
  "$status $(sed -n 1p out)"

printf '[%s,\n%s,\n%s' "$good" "$bad" '{"points":' >array.json
printf '\357\273\277id,x,y,knot\r\n1,0,0,\r\n"1",1,"1",\r\n\r\n2,0,0,1\n' \
  >some.csv
printf '2,"3",4,2\n3,0,0,nan\n4,0\n5,0,0,0\n5,0,"0' >>some.csv
printf '0\t0\t7\n3\t4\t7\n' >some.tsv
run planar array.json
equal 'an array that breaks off' '3 "ok" "error" "error"' "$status $(get status)"
run planar some.csv
equal 'CSV' '3 "ok" "ok" "error" "error" "error"' "$status $(get status)"
run planar --columns=x,y,- some.tsv
equal '--columns' '0 5' "$status $(get length)"
feed '  [ ] {"id":1,"points":[[0,0],[3,4]]}
{}' planar -f csv
equal 'standard input' '1 7' "$status $(wc -l <out | tr -d ' ')"
for table in control-points lengths offsets; do
  run planar -f csv --table=$table -d 1 some.jsonl some.csv
  equal "the table of $table" 3 "$status"
done
printf '%s\n' '{"points":[[0,0,0],[1,1,0],[2,0,1]]}' \
  '{"points":[[0,0,0],[1,1,1]],"tangents":[[0.4,-1.5,-1.2],[-2,-1,-2]]}' \
  '{"points":[[0,0],[1,0],[0,0]],"criterion":"hc"}' \
  '{"points":[[0,0,0],[1,0,0],[0,1,0]],"closed":true,"criterion":"bv"}' \
  '{"points":[[0,0,0],[1,1,1]],"derivatives":[[1,0,1],[0,1,1]],"angles":[1,2]}' \
  '{"points":[[0,0,0],[1,1,1]],"tangents":[[1,0,1],[0,0,0]]}' >space.jsonl
run spatial-hermite --offset=0.1 space.jsonl
equal 'points in space' '1 "ok" "ok" "ok" "ok" "ok" "error"' \
  "$status $(get status)"
run spatial-hermite --basis=atph --criterion=F1 --convert=bezier \
  --tolerance=1e-3 -q -S shape=true,false space.jsonl
equal 'points in space, atph' 1 "$status"
true_that 'points in space, atph: JSON' json lines out
feed 'x,y,z,tx,ty,tz,tension
0,0,0,1,0,0,
1,1,2,0,1,1,0.5' spatial-hermite -f csv
equal 'points in space as CSV' '0 7' "$status $(wc -l <out | tr -d ' ')"
feed 'solved' planar
equal 'neither JSON nor CSV' '3 "syntax"' "$status $(get error.code)"
run planar nosuch.json
expect 'no such file' 3 \
  'phspline: cannot open nosuch.json: No such file or directory' ''
echo old >file
run planar --fail-fast -o file some.jsonl
equal 'an output that is not replaced' '1 old' "$status $(cat file)"
run planar -o file some.jsonl
equal_files 'an output that is' one file
run planar -o nosuch/file some.jsonl
expect 'an output that cannot be' 4 \
  'phspline: cannot create nosuch/file: No such file or directory' ''
run planar >&-
equal 'no standard output' 0 "$status"

for arguments in '--help' 'help planar' '--version' 'planar --help' \
  'planar --version' 'help spatial-hermite' 'spatial-hermite --help'; do
  # shellcheck disable=SC2086
  run $arguments
  equal "phspline $arguments" 0 "$status"
done
for arguments in '' 'x' '-x' 'help x' 'planar --nosuch' 'planar -x' \
  'planar --jobs' 'planar --jobs=x' 'planar --set x' 'planar --set x=1' \
  'planar --knots=x' 'planar --offset=x' 'planar --sweep x' \
  'planar --sweep knots=x' 'planar --sweep knots[0]=1:2' \
  'planar --sweep knots[=1' 'planar --columns=x' 'planar --delimiter=xx' \
  'planar --table=x' 'planar --pretty=1' 'planar --pretty -f csv'; do
  # shellcheck disable=SC2086
  run $arguments
  equal "phspline $arguments" 2 "$status"
done
