# SPDX-License-Identifier: GPL-3.0-or-later
#
# Points in space as CSV: columns of vectors and of segments, 2 and 3 columns
# without a header, and the tables that are printed.  (CSV itself: csv.t.)
. "$srcdir/tests/cli/lib.sh"

# table NAME TEXT PROBLEM [ARGUMENT...]: CSV, which is for printf, gives the
# curve that the JSON problem gives
table() {
  name=$1 text=$2
  printf '%s\n' "$3" >problem.json
  shift 3
  # shellcheck disable=SC2059
  printf "$text" >table.csv
  run spatial-hermite -q -f csv problem.json
  mv out want.csv
  run spatial-hermite -q -f csv "$@" table.csv
  expect "$name" 0
  equal_files "$name: the curve" want.csv out
}

points='"points":[[0,0,0],[1,2,3],[2,0,1]]'
plane='"points":[[0,0],[1,2],[2,0]]'
tangents='"tangents":[[1,0,2],[0,1,0],[-1,0,1]]'
derivatives='"derivatives":[[1,0,2],[0,1,0],[-1,0,1]]'
flat='[[1,0],[0,1],[-1,0.5]]'

# ---- points and vectors ------------------------------------------------------

table 'no header, three columns' '0,0,0\n1,2,3\n2,0,1\n' "{$points}"
table 'no header, two columns' '0,0\n1,2\n2,0\n' "{$plane}"
table 'x, y, z' 'x,y,z\n0,0,0\n1,2,3\n2,0,1\n' "{$points}"
table 'z, y, x' 'Z,y_m,x\n0,0,0\n3,2,1\n1,0,2\n' "{$points}"
table 'a first line with the names' '# z_m,x,y\n0,0,0\n3,1,2\n1,2,0\n' \
  "{$points}"
table 'x, y' 'y,x\n0,0\n2,1\n0,2\n' "{$plane}"
table 'a column z that is empty' 'x,y,z\n0,0,\n1,2,\n2,0,\n' "{$plane}"
table 'points in quotes, with blanks' 'x,y,z\n"0", 0 ,0\n 1,"2",3\n2,0,"1"\n' \
  "{$points}"
table 'tangents' \
  'x,y,z,tx,ty,tz\n0,0,0,1,0,2\n1,2,3,0,1,0\n2,0,1,-1,0,1\n' \
  "{$points,$tangents}"
table 'tangents in another order' \
  'tz,z,tx,y,ty,x\n2,0,1,0,0,0\n0,3,0,2,1,1\n1,1,-1,0,0,2\n' \
  "{$points,$tangents}"
table 'derivatives' \
  'dx,dy,dz,x,y,z\n1,0,2,0,0,0\n0,1,0,1,2,3\n-1,0,1,2,0,1\n' \
  "{$points,$derivatives}"
table 'derivatives in another order' \
  'DZ,x,dy,y,dx,z\n2,0,0,0,1,0\n0,1,1,2,0,3\n1,2,0,0,-1,1\n' \
  "{$points,$derivatives}"
table 'tangents of two coordinates' \
  'x,y,tx,ty\n0,0,1,0\n1,2,0,1\n2,0,-1,0.5\n' "{$plane,\"tangents\":$flat}"
table 'derivatives of two coordinates' \
  'x,y,dy,dx\n0,0,0,1\n1,2,1,0\n2,0,0.5,-1\n' "{$plane,\"derivatives\":$flat}"
table 'tangents in space, points in the plane' \
  'x,y,tx,ty,tz\n0,0,1,0,2\n1,2,0,1,0\n2,0,-1,0,1\n' "{$plane,$tangents}"
table 'columns of tangents that are empty' \
  'x,y,z,tx,ty,tz\n0,0,0,,,\n1,2,3,,,\n2,0,1,,,\n' "{$points}"
table 'columns of derivatives that are empty, beside tangents' \
  'x,y,tx,ty,dx,dy\n0,0,1,0,,\n1,2,0,1,,\n2,0,-1,0.5,,\n' \
  "{$plane,\"tangents\":$flat}"
table '--columns' '0,9,0,0,1,0,2\n3,9,2,1,0,1,0\n1,9,0,2,-1,0,1\n' \
  "{$points,$tangents}" --columns=z,-,y,x,tx,ty,tz

run spatial-hermite -q -f csv --table=lengths - <<'END'
id,x,y,z,tx,ty,tz
a,0,0,0,,,
a,1,2,2,,,
b,0,0,0,1,0,0
b,1,2,3,1,0,0
END
expect 'empty for one problem, and not for the next' 0
echo a,0,0,3,3,3 >want
sed -n 2p out >found
numbers 'empty for one problem: its curve is a chord' 1e-15 want found
true_that 'empty for one problem: two of them' count 3 out

# ---- numbers of segments and points ------------------------------------------

table 'knots' 'x,y,z,knot\n0,0,0,1\n1,2,3,2\n2,0,1,5\n' \
  "{$points,\"knots\":[1,2,5]}"
table 'tensions of an open curve' \
  'x,y,z,tension\n0,0,0,\n1,2,3,0.5\n2,0,1,0.75\n' \
  "{$points,\"tension\":[0.5,0.75]}"
table 'tensions of a closed curve: the first row closes it' \
  'tension,x,y,z\n0.25,0,0,0\n0.5,1,2,3\n0.75,2,0,1\n' \
  "{$points,\"tension\":[0.5,0.75,0.25],\"closed\":true}" --closed
table 'tensions of a closed curve whose last row repeats the first' \
  'tension,x,y,z\n,0,0,0\n0.5,1,2,3\n0.75,2,0,1\n0.25,0,0,0\n' \
  "{$points,\"tension\":[0.5,0.75,0.25],\"closed\":true}" --closed
table 'angles of atph' 'x,alpha,y,z\n0,,0,0\n1,0.5,2,3\n2,1.5,0,1\n' \
  "{$points,\"alpha\":[0.5,1.5],\"basis\":\"atph\",\"criterion\":\"cc\"}" \
  --basis=atph --criterion=cc
table 'all at once' 'alpha,knot,tension,tz,ty,tx,z,y,x\n,0,,2,0,1,0,0,0\n'\
'0.5,1,0.75,0,1,0,3,2,1\n1.5,3,0.5,1,0,-1,1,0,2\n' \
  "{$points,$tangents,\"alpha\":[0.5,1.5],\"tension\":[0.75,0.5],
  \"knots\":[0,1,3],\"basis\":\"atph\",\"criterion\":\"bv\"}" \
  --basis=atph --criterion=bv
table 'a closed curve with its tangents, the last row repeats the first' \
  'x,y,z,tx,ty,tz\n0,0,0,1,0,2\n1,2,3,0,1,0\n2,0,1,-1,0,1\n0,0,0,1,0,2\n' \
  "{$points,$tangents,\"closed\":true}" --closed
table 'options fill in what has no column' \
  '0,0,0\n1,2,3\n2,0,1\n' "{$points,$tangents,\"angles\":[[1,2],[2,3]]}" \
  --tangents='[[1,0,2],[0,1,0],[-1,0,1]]' --angles='[[1,2],[2,3]]'

# ---- tables ------------------------------------------------------------------

# A straight line on knots that are those of its speed.
printf '%s\n' '{"id":"a","points":[[0,0,0],[5,0,0],[5,0,10]],'\
'"tangents":[[2,0,0],[1,0,0],[0,0,1]]}' \
  '{"points":[[0,0],[1,1e999]]}' \
  '{"id":"c","points":[[0,0],[0,-5]]}' >some.jsonl
run spatial-hermite -q -f csv --table=lengths some.jsonl
equal 'lengths of some that fail' 1 "$status"
printf '%s\n' id,segment,t0,t1,length,cumulative a,0,0,5,5,5 c,0,0,5,5,5 >want
sed 3d out >found
numbers 'lengths: a failed problem has no rows' 1e-15 want found
true_that 'lengths: a row for each segment' count 4 out
awk -F, 'NR == 3 { print $1, $2, $3, $4, $6 - $5 }' out >found
equal 'lengths are summed' 'a 1 5 15 5' "$(cat found)"
run spatial-hermite -q -f csv some.jsonl
cat >want <<'END'
id,segment,index,x,y,z
a,0,0,0,0,0
a,0,1,1,0,0
a,0,2,2,0,0
a,0,3,3,0,0
a,0,4,4,0,0
a,0,5,5,0,0
END
sed -n 1,7p out >found
numbers 'control points' 1e-15 want found
cat >want <<'END'
c,0,0,0,0,0
c,0,1,0,-1,0
c,0,2,0,-2,0
c,0,3,0,-3,0
c,0,4,0,-4,0
c,0,5,0,-5,0
END
sed -n '14,$p' out >found
numbers 'control points: points of two coordinates have a z, too' 1e-15 \
  want found
run spatial-hermite -f csv --table=lengths - <<'END'
x,y
END
expect 'a table of nothing has its header' 0 \
  'phspline: there is no problem in standard input' \
  'id,segment,t0,t1,length,cumulative'
run spatial-hermite -q -f csv --convert=bezier --basis=atph --alpha=1 \
  --criterion=cc --tolerance=1e-4 some.jsonl
awk -F, '$1 == "a" { segments[$2]; rows++ } END {
  for (k in segments) n++
  print (n > 2 && rows == 6 * n) }' out >found
equal 'Bezier pieces are counted as segments' 1 "$(cat found)"
run spatial-hermite -q -f csv --table=points some.jsonl
equal 'a table that is none' 2 "$status"
