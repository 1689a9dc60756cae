# SPDX-License-Identifier: GPL-3.0-or-later
#
# The number of worker threads changes no byte: of the results, of what is said
# about them, and of the exit status.  (Also run under the thread sanitizer.)
. "$srcdir/tests/cli/lib.sh"

# 4000 lines: curves of 2 to 200 points, and one in ten that fails, in one of
# several ways, at one of several stages; one of the eight ways is a warning.
# Fewer, and one number of threads, where every step takes long (PH_SHORT=1).
lines=4000 threads='2 8'
[ "${PH_SHORT-}" != 1 ] || lines=1600 threads=3
awk -v lines=$lines 'BEGIN {
  for (i = 1; i <= lines; i++) {
    n = i % 500 == 0 ? 200 : 2 + i % 5
    text = ""
    for (k = 0; k < n; k++)
      text = text (k ? "," : "") "[" k "," (k * k * i) % 7 "]"
    points = "\"points\":[" text "]"
    kind = i % 10 ? 0 : int(i / 10) % 8 + 1
    if (kind == 1) points = "\"points\":[[0,0],[0,0]]"
    if (kind == 2) points = "\"points\":[[0,0],[1,\"x\"]]"
    if (kind == 3) points = "\"points\":[[0,0],[1,1e999]]"
    if (kind == 4) points = points ",\"knots\":[0]"
    if (kind == 5) points = points ",\"closd\":true"
    if (kind == 6) points = "\"points\":[[0,0],[1,0],[0,0]]"
    if (kind == 7) points = "\"points\":[[0,0],"
    if (kind == 8) points = "\"points\":[]"
    print "{\"id\":" i "," points "}"
  }
}' >many.jsonl

# same NAME STATUS ARGUMENT...: as --jobs=1, of $method; out and err are left
# for a look
method=planar
same() {
  name=$1 wanted=$2
  shift 2
  run $method --jobs=1 "$@"
  mv out out.1
  mv err err.1
  equal "$name, --jobs=1" "$wanted" "$status"
  for jobs in $threads; do
    run $method --jobs="$jobs" "$@"
    equal "$name, --jobs=$jobs" "$wanted" "$status"
    equal_files "$name, --jobs=$jobs: results" out.1 out
    equal_files "$name, --jobs=$jobs: messages" err.1 err
  done
}

same 'thousands' 1 many.jsonl
equal 'a result for each' $lines "$(wc -l <out | tr -d ' ')"
json get id out | grep -v absent >ids
grep -v '"points":\[\[0,0\],}' many.jsonl | sed 's/.*"id":\([0-9]*\),.*/\1/' \
  >want
equal_files 'in the order of the problems' want ids
equal 'the sum' "$(failed $((lines * 7 / 80)) $lines)" "$(tail -n 1 err)"
equal 'a message for each failure and warning' $((lines / 10 + 1)) "$(wc -l <err | tr -d ' ')"

sed -n 1,1000p many.jsonl >some.jsonl
same 'a sweep' 1 -S knots=uniform,chordal -S closed=false some.jsonl
equal 'a result for each value' 1988 "$(wc -l <out | tr -d ' ')"
printf '%s\n' "$good" >one.json
same 'a sweep of one problem' 0 -S 'points[0][0]=0:0.5:800' one.json
equal 'its last value' '{"points[0][0]":0.5}' "$(tail -n 1 out | json get sweep)"
same 'a sweep of what an option gives' 0 --knots='[0,1,2]' \
  -S 'knots[1]=0.5:1.5:800' one.json
same 'offsets in CSV' 1 -f csv --table=offsets -d 1,-1 some.jsonl
same '--strict' 1 --strict -q some.jsonl
sed 's/$/,/; 1s/^/[/; 999q' some.jsonl | grep -v '"points":\[\[0,0\],}' \
  >array.json
same 'an array that breaks off' 3 array.json
same 'a file that cannot be read' 3 some.jsonl nosuch.json

# the first failure is the 1567th of 4000 problems, with many behind it
awk 'BEGIN {
  for (i = 1; i <= 4000; i++)
    print "{\"id\":" i ",\"points\":[[0,0],[" i % 1567 "," i % 1567 "]]}"
}' >late.jsonl
for file in '' nosuch.json array.json; do
  # shellcheck disable=SC2086
  same "--fail-fast $file" 1 --fail-fast late.jsonl $file
  equal "--fail-fast $file: what was written" 1567 "$(wc -l <out | tr -d ' ')"
done
same '--fail-fast in the middle of a sweep' 1 --fail-fast \
  -S 'points[0][0]=0,0.5' late.jsonl
equal '--fail-fast in the middle of a sweep: what was written' 3133 \
  "$(wc -l <out | tr -d ' ')"

printf '%s\n' "$bad" >bad.json
same '--fail-fast, and a file that nobody comes to' 1 --fail-fast bad.json \
  nosuch.json

# ---- long records ------------------------------------------------------------

# What is longer than half a megabyte leaves in pieces, when its turn has come;
# of 9 MB, also what would rather wait.  A failure and a short one beside each.
awk -v n=$((lines * 4)) 'BEGIN {
  for (i = 1; i <= 6; i++) {
    printf "{\"id\":\"long %d\",\"points\":[", i
    m = i % 3 ? n : n / 8
    for (k = 0; k < m; k++)
      printf "%s[%d,%.3f]", k ? "," : "", k, sin(k * i / 9)
    print "]}"
    print "{\"id\":\"bad " i "\",\"points\":[[0,0],[0,0]]}"
    print "{\"id\":\"good " i "\",\"points\":[[0,0],[1," i "]]}"
  }
}' >long.jsonl
for format in json csv geojson svg-path obj; do
  case $format in
  csv) set -- -f csv --table=offsets -d 1 ;;
  geojson) set -- -f geojson -n 2 ;;
  obj) set -- --pretty ;;
  *) set -- -f "$format" ;;
  esac
  same "long records, $*" 1 "$@" long.jsonl
  status=0
  "$PHSPLINE" planar -j 8 "$@" long.jsonl 2>err | cat >piped || status=$?
  equal_files "long records, $*: through a pipe" out piped
  run planar -j 8 "$@" -o file long.jsonl
  equal "long records, $*: -o, status" 1 "$status"
  equal_files "long records, $*: -o" piped file
done
same 'long records, --fail-fast' 1 --fail-fast long.jsonl
equal 'long records, --fail-fast: what was written' '"long 1" "bad 1" ' \
  "$(json get id out | tr '\n' ' ')"
run planar -j 8 --fail-fast -o never long.jsonl
true_that 'long records, --fail-fast: no file' test ! -e never

run planar --jobs=1024 one.json
expect 'more threads than problems' 0
run planar one.json
mv out default
run planar -j 1 one.json
equal_files 'the default' default out
for jobs in 1 8; do
  feed '' planar --jobs=$jobs
  expect "nothing to do, --jobs=$jobs" 0 \
    'phspline: there is no problem in standard input' ''
done

# a spline with a place that is hard, which is solved in blocks
walk 4 $((lines * 5)) >walk.csv
method=tc
same 'a long walk' 0 walk.csv
same 'a long walk, a certificate in parts' 0 --mode=spline walk.csv
method=planar
same 'offsets of a long walk, as a table' 0 -q -f csv --table=offsets -d 0.01 \
  walk.csv
same 'lengths of a long walk, as a table' 0 -q -f csv --table=lengths walk.csv
same 'a drawing of a long walk' 0 -q -f svg-path walk.csv
walk 5 "$lines" >walk.csv
same 'a drawing of its offset' 0 -q -f svg-path -d 0.1 walk.csv
for rule in --sample=2 --spacing=0.3 --spacing=1e3 --at=1,9,900,1500; do
  same "samples of a long walk, $rule" 0 -q --fields=samples $rule walk.csv
done
same 'samples that take too much memory' 1 --spacing=0.01 \
  --max-memory=$((lines * 2000)) walk.csv
true_that 'samples that take too much memory: it is told' \
  grep -q 'of --max-memory' err
same 'a drawing that takes too much memory' 1 -f svg-path --chord-error=1e-10 \
  --max-memory=$((lines * 1000)) walk.csv
true_that 'a drawing that takes too much memory: it is told' \
  grep -q 'of --max-memory' err
run planar -q -o walk.json walk.csv
sed 's/"energy":/"energy":1/' walk.json >false.json
method=verify
same 'energies of a long walk' 1 walk.json false.json
method=planar

# ---- points in space ---------------------------------------------------------

# Each kind of problem that has code of its own: criteria, the search for a
# minimum, reduced tensions, closed and plane curves, failures, warnings.  Where
# every step takes long, one in five of the searches for an alpha: they take nine
# tenths of the time.
awk -v short="${PH_SHORT-}" 'BEGIN {
  split("cc hc bv zero F1 F2 F3", criterion, " ")
  for (i = 1; i <= 140; i++) {
    n = i % 100 == 0 ? 100 : 2 + i % 4
    points = ""
    tangents = ""
    for (k = 0; k < n; k++) {
      comma = k ? "," : ""
      points = points comma "[" k "," (k * k * i) % 7 "," (k * i) % 5 "]"
      tangents = tangents comma "[" 1 + (i + k) % 4 "," (k * i) % 5 - 2 "," \
        (k + i) % 3 - 1 "]"
    }
    kind = i % 7
    text = "{\"id\":" i ",\"points\":[" points "]"
    if (kind > 2) text = text ",\"tangents\":[" tangents "]"
    if (kind == 2) text = text ",\"derivatives\":[" tangents "]"
    if (kind < 4 || n == 100) text = text ",\"criterion\":\"" \
      criterion[n == 100 ? 1 : 1 + int(i / 7) % 7] "\",\"axis\":\"bisector\""
    else if (kind == 4) text = text ",\"angles\":[0.5," i "]"
    else if (kind == 5) text = text ",\"basis\":\"atph\""
    else text = text ",\"criterion\":\"zero\""
    if (i % 11 == 0) text = text ",\"closed\":true"
    if (i % 13 == 0) text = text ",\"tension\":[1]"
    if (i % 17 == 0) text = text ",\"angle\":0"
    if (!(short == 1 && kind == 5 && i % 5 != 2)) print text "}"
  }
}' >space.jsonl
method=spatial-hermite
same 'in space' 1 space.jsonl
equal 'in space: a result for each' "$(wc -l <space.jsonl)" "$(wc -l <out)"
for code in unknown-field bad-shape shape-unsatisfiable too-few-points; do
  true_that "in space: some are $code" grep -q "\[$code\]" err
done
true_that 'in space: tensions are reduced' grep -q '"reduced":1' out
true_that 'in space: some are at the bound' grep -q '"at_bound":true' out
sed -n 1,24p space.jsonl >some-space.jsonl
same 'in space, a sweep' 1 -S shape=true,false -S tension=0.5,1 some-space.jsonl
same 'in space, offsets and Bezier pieces' 1 -d 0.1,-0.2 --convert=bezier \
  --tolerance=1e-5 some-space.jsonl
same 'in space, a table' 1 -f csv --strict some-space.jsonl
# Curves whose segments several threads look for; of the second the first of two
# segments without angles is told, of the third all that lack the shape are
# counted, and the last searches.
awk 'BEGIN {
  n = 2800
  for (i = 1; i <= 4; i++) {
    printf "{\"id\":%d,\"points\":[", i
    m = i < 4 ? n : 12
    for (k = 0; k < m; k++)
      printf "%s[%d,%.3f,%.3f]", k ? "," : "", k, sin(k * k / 7), cos(k / 5)
    printf "]"
    if (i == 2) {
      printf ",\"angles\":[0,0],\"axis\":\"x\",\"tangents\":["
      for (k = 0; k < m; k++)
        printf "%s[%s,0,0]", k ? "," : "", (k % 500 == 0 && k >= 2500 ? "-1" : "1")
      printf "]"
    }
    print (i == 3 ? ",\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"cc\"" : \
      i == 4 ? ",\"criterion\":\"F1\"" : "") "}"
  }
}' >long-space.jsonl
same 'in space, long' 1 -d 0.01 long-space.jsonl
true_that 'in space, long: the first failure is told' \
  grep -q 'record 2: segments\[2499\]: has no angles' err
# searches of one curve by all threads
sed -n 4p long-space.jsonl >searches.jsonl
same 'in space, searches' 0 --criterion=F3 --basis=atph -q searches.jsonl

# ---- points on a sphere ------------------------------------------------------

# lines that are cut where the longitude is 180 degrees
awk 'BEGIN {
  printf "{\"lonlat\":["
  for (i = 0; i < 1500; i++)
    printf "%s[%.6f,%.6f]", i ? "," : "", (i * 5) % 360 - 180, 80 * sin(i / 99)
  print "]}"
}' >laps.json
method=sphere
same 'laps of a sphere' 0 -q -f geojson -n 8 laps.json
equal 'laps of a sphere: lines' 21 \
  "$(jq '.features[0].geometry.coordinates | length' out)"

# Both models, open and closed, tensions to find, failures at several stages, a
# long record among short ones.
awk 'BEGIN {
  for (i = 1; i <= 80; i++) {
    n = i % 40 == 0 ? 60 : 3 + i % 5
    text = ""
    for (k = 0; k < n; k++)
      text = text (k ? "," : "") "[" k * 2 * (1 + i % 9) % 360 "," \
        (k * k * i) % 40 "]"
    more = ""
    if (i % 3 == 0) more = more ",\"model\":\"nielson\""
    if (i % 4 == 0) more = more ",\"closed\":true"
    if (i % 5 == 0) more = more ",\"increase\":\"times:2\""
    if (i % 7 == 0) more = more ",\"epsilon\":1e-11,\"shape\":\"warn\""
    if (i % 11 == 0) text = text ",[0,0],[180,0]"
    if (i % 13 == 0) text = text ",[7,7],[7,7]"
    if (i % 17 == 0) more = more ",\"radius\":0"
    if (i % 19 == 0) more = more ",\"tension\":[1]"
    print "{\"id\":" i ",\"lonlat\":[" text "]" more "}"
  }
}' >sphere.jsonl
method=sphere
same 'on a sphere' 1 sphere.jsonl
equal 'on a sphere: a result for each' 80 "$(wc -l <out | tr -d ' ')"
for code in antipodal-points coincident-points bad-shape bad-value; do
  true_that "on a sphere: some are $code" grep -q "\[$code\]" err
done
true_that 'on a sphere: tensions are raised' grep -q '"tensions":\[0,[1-9]' out
sed -n 1,20p sphere.jsonl >some-sphere.jsonl
same 'on a sphere, samples and offsets' 1 -n 3 -d 0.01,-0.02 some-sphere.jsonl
same 'on a sphere, a sweep' 1 -S model=exact,nielson -S epsilon=0.01,0.1 \
  some-sphere.jsonl
same 'on a sphere, a table' 1 -f csv --table=offsets -d 0.01 --strict -q \
  some-sphere.jsonl

# ---- contact elements --------------------------------------------------------

# a strip that winds up; two legs of arcs that it has not
awk -v n=$((lines * 2)) 'BEGIN {
  print "x,y,z,rx,ry,rz,tx,ty,tz"
  for (i = 0; i < n; i++) {
    t = i / 10
    w = 0.3 * sin(0.37 * t)
    printf "%.12f,%.12f,%.12f,%.12f,%.12f,%.12f,%.12f,%.12f,0\n", cos(t), sin(t),
      1e-5 * t, -w * cos(t), -w * sin(t), sqrt(1 - w * w), -sin(t), cos(t)
  }
}' >strip.csv
legs=$(awk -v n=$((lines * 2 - 1)) 'BEGIN {
  for (i = 0; i < n; i++)
    printf "%s%s", i ? "," : "", (i % 1000 == 999 && i >= 1999) ? 9 : 0.05
}')
method=cone
same 'a long surface' 0 -q strip.csv
same 'a long surface that is refused' 1 --lambda="[$legs]" strip.csv
true_that 'a long surface that is refused: by its certificate' \
  grep -q 'strips\[[0-9]*\]: is refused by its certificate' err
