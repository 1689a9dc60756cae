# SPDX-License-Identifier: GPL-3.0-or-later
#
# phspline verify: results of every command are right, with and without their
# problems; what it writes, and how it ends.  (Where rounding is large see
# verify-degenerate.t, of results that are wrong verify-tampered.t.)
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/verify.sh"

data=$srcdir/data
plane='{"points":[[0,0],[2,1],[3,0],[5,2]]}'
space='{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]]}'

# ---- what it writes ----------------------------------------------------------

printf '{"id":"a","meta":{"b":1},"points":[[0,0],[1,2],[3,1]]}\n' >p
made planar <p
run verify r
expect 'a verdict' 0
equal 'its shape' '{id:string,command:string,status:string,'\
'meta:{b:number},of:string,curve:string,segments:number,'\
'worst:{check:string,error:number}}' \
  "$(sed 's/,"checks".*/}/' out | json shape)"
equal 'its members' 'a	verify	ok	planar	ph	2' \
  "$(table id command status of curve segments | tr -d '"')"
equal 'the checks of a curve' '{shape:number,pythagorean_error:number,'\
'preimage_error:number,continuity_error:number,length_error:number,'\
'diagnostic_error:number}' "$(shape_of checks)"
verified 'with its problem' 1 --problems=p
equal 'the checks with the problem' number "$(shape_of \
  checks.interpolation_error)"
run verify --pretty r
equal 'indented' '  "status": "ok",' "$(sed -n 4p out)"
equal 'indented, the same' "$("$PHSPLINE" verify r | json compact)" \
  "$(json compact out)"
run verify -v r
equal 'a line for each' 1 \
  "$(grep -c '^phspline: r:1: record a: [a-z_]* [0-9.e-]*, [0-9.e-]* ms$' err)"
feed '{"id":1,"points":[[0,0]]}' planar
mv out r
run verify r
expect 'an error claims no curve' 0 '' \
  '{"id":1,"command":"verify","status":"ok","of":"planar","claims":"error"}'

# ---- results of all commands ---------------------------------------------------

# all NAME COMMAND FILE [OPTION]...: its results are right, and of its problems
all() {
  name=$1 command=$2 file=$3
  shift 3
  run "$command" -q "$@" "$file"
  mv out r
  verified "$name" "$(wc -l <r)"
  verified "$name, with the problems" "$(wc -l <r)" --problems="$file"
}

all planar planar "$data/gonzalez-2018.jsonl"
all atph planar "$data/gonzalez-2018-atph.jsonl"
all spatial spatial-hermite "$data/gonzalez-2018-spatial.jsonl"
all arclength arclength "$data/huard-2014.jsonl"
all sphere sphere "$data/iordanov-2015.jsonl"
all tc tc "$data/byrtus-2011.jsonl"
all 'curves to approximate' tc "$data/spanner.json"

# derived COMMAND PROBLEM [OPTION]...: with what can be derived from a curve.
derived() {
  command=$1 problem=$2
  shift 2
  for how in --sample=4 --spacing=0.4 --chord-error=0.01 '--sample=1 --pretty'
  do
    # shellcheck disable=SC2086 # two words
    printf '%s' "$problem" | made "$command" --offset=0.05,-0.1 $how "$@"
    verified "$command $how $*" 1
  done
}

derived planar "$plane"
derived planar "$plane" --closed
derived planar "$plane" --basis=atph
derived planar "$plane" --basis=atph --convert=bezier
derived planar "$plane" --solutions=all
derived spatial-hermite "$space" --frame=frenet
derived spatial-hermite "$space" --basis=atph --frame=erf
derived arclength "$space" --frame=rmf
derived arclength "$space" --lengths='[1.8,1.9,1.6]' --all_minima
derived arclength "$space" --length_sigma=0.01 --lengths='[1.8,1.9,1.6]' \
  --all_minima --refine=3
derived sphere '{"lonlat":[[0,0],[40,10],[80,-20],[120,50]]}' --frame=rmf
derived sphere '{"lonlat":[[0,0],[40,10],[80,-20]]}' --model=nielson --radius=3
derived tc "$plane"
derived tc '{"points":[[0,1],[6,1]],"tangents":[[1,-1],[1,1]]}' --mode=g1 \
  --solutions=all --blaschke
derived tc '{"curve":[[0,0],[1,2],[3,2],[4,-1],[6,0]]}' --tolerance=0.01

# all minima have their intervals
printf '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]],"lengths":[1.8,1.9,1.6]}\n' \
  >minima
for refine in 1 2 3; do
  all "all minima, refine $refine" arclength minima --all_minima --starts=5 \
    --refine="$refine"
  cp r out
  equal "the intervals of the best, refine $refine" "$(get intervals)" \
    "$(get 'solutions[0].intervals')"
  equal "the intervals of another, refine $refine" \
    "$(get 'intervals[2].segments') absent" \
    "$(get 'solutions[1].intervals[2].segments') $(
      get 'solutions[1].intervals[3]')"
done

# ---- problems ------------------------------------------------------------------

printf '0,0\n2,1\n3,0\n5,2\n' >p.csv
made planar <p.csv
verified 'a table of points' 1 --problems=p.csv
printf 'id,x,y\n1,0,0\n1,2,1\n1,3,0\nb,0,0\nb,2,1\n01.0,5,5\n01.0,6,7\n' >ids.csv
run planar ids.csv
sed -n '3p;1p;2p' out >r
sed -n '1,2p' out >r2
run verify --problems=ids.csv r2
expect 'a problem without a result' 1 \
  'phspline: ids.csv:7: 1 of 3 problems have no result, this one first'
sed -n 2p r2 | sed 's/"id":"b",//' >r3
run verify --problems=ids.csv r3
equal 'no ids in the results: by order' '"shape"' \
  "$(get worst.check)"
printf 'x;y\n0;0\n2;1\n' >semicolon
printf '{"points":[[0,0],[2,1]]}' | made planar
verified 'columns of the problems' 1 --problems=semicolon --delimiter=';' \
  -i csv --columns=x,y
printf '{"points":[[0,0],[2,1],[1,3]]}\n' >open
made planar --closed <open
verified 'a field that was set' 1 --problems=open
equal 'is told' '{"closed":true}' "$(get set)"
verified 'a field that was set, and is again' 1 --problems=open \
  --set=closed=true
made planar --override=knots=uniform --set='end_derivatives=[[1,1],[0,1]]' \
  <open
equal 'what was set' '{"knots":"uniform","end_derivatives":[[1,1],[0,1]]}' \
  "$(json get set r)"
verified 'fields that were set' 1 --problems=open
verified 'fields that are set again' 1 --problems=open \
  --override=knots=uniform -s 'end_derivatives=[[1.0, 1],[0,1e0]]'
run verify --problems=open -q -s 'end_derivatives=[[1,1],[0,2]]' r
expect 'a field that was not' 1 'phspline: r:1: record 1: '\
'set.end_derivatives: is not what the problem has; --override sets that of '\
'the problem [not-verified]'
sed 's/,"set":{[^}]*}//' r >r2
run verify --problems=open -q -s 'end_derivatives=[[1,1],[0,2]]' r2
equal 'a field that is not said to be' '1 "end_derivative_error"' \
  "$status $(get worst.check)"
printf '{"points":[[0,0],[2,1],[1,3]],"knots":"chordal"}\n' >chordal
made planar --set=knots=uniform <chordal
verified 'a field that the problem has' 1 --problems=chordal
equal 'was not set' absent "$(json get set r)"
made planar --override=knots=uniform <chordal
run verify --problems=chordal -q r
expect 'one that was overridden' 1 'phspline: r:1: record 1: set.knots: is not '\
'what the problem has; --override sets that of the problem [not-verified]'
verified 'and is so again' 1 --problems=chordal --override=knots=uniform
feed '{"points":[[0,0]]}' planar -q --closed --set=free=scale
equal 'an error record tells what was set' '{"command":"planar","status":'\
'"error","set":{"closed":true,"free":"scale"},"error":{"code":'\
'"too-few-points"' "$(cut -d , -f 1-5 out)"
feed '{"points":[[0,0]]' planar -q --closed
equal 'but not of what is no problem' absent "$(get set)"
for made in 'planar --basis=atph --alpha=0.5 --solutions=all' \
  'planar --basis=atph --convert=bezier' 'planar --minimize=MV' \
  'planar --set=closed=true --override=closed=false' \
  'tc --mode=c2 --tolerance=0.5' 'tc --closed' \
  'tc --mode=approximate --tolerance=0.01'; do
  # shellcheck disable=SC2086 # words
  run $made -q open
  mv out r
  grep -q '"status":"ok"' r && verified "$made" 1 --problems=open
done

cat >ids <<'END'
{"id":"a","points":[[0,0],[1,2],[3,1]]}
{"id":2,"points":[[0,0],[1,2],[4,1]]}
{"id":"c","points":[[0,0]]}
{"id":"d","points":[[0,0],[1,2],[5,1]]}
END
run planar -q ids
sed '1!G;h;$!d' out >r
verified 'by id, in any order' 4 --problems=ids
sed 's/"id":2/"id":2.0/; s/"id":"d"/"id":"\\u0064"/' r >r2
mv r2 r
verified 'ids are what they stand for' 4 --problems=ids
sed 's/"id":[^,]*,//' ids >none
run planar -q none
mv out r
verified 'by order' 4 --problems=none
sed 's/^{/{"id":"x",/' none >same
run planar -q same
mv out r
verified 'by order of one id' 4 --problems=same
sed -n '2p' r >r2
cat r r2 >r3
run verify -q --problems=same r3
expect 'more results than problems' 1 'phspline: r3:5: record x: same has only '\
'4 problems of this id, and this is a further result [not-verified]'
sed 's/"id":"x"/"id":"y"/' r >r2
run verify -q --problems=same r2
equal 'another id' 4 "$(grep -c 'id: is that of no problem in same' err)"
verified 'one worker' 4 --problems=same -j 1
"$PHSPLINE" verify -j 1 --problems=ids r3 >one 2>&1
"$PHSPLINE" verify -j 7 --problems=ids r3 >seven 2>&1
equal_files 'workers do not matter' one seven

# sweeps
printf '%s\n' "$plane" '{"points":[[0,0],[1,2],[3,1]]}' >two
run planar -q --sweep=knots=chordal,uniform,centripetal two
mv out r
verified 'a sweep, by order' 6 --problems=two
sed 's/^{/{"id":4,/' two >four
run planar -q --sweep='points[1][0]*=0.9:1.1:3' --sweep=closed=true,false four
mv out r
verified 'a sweep, by id' 12 --problems=four
run arclength -q --sweep='lengths[1]=1.8,1.9' \
  --set='lengths=[1.8,1.9,1.6]' - <<END
$space
END
mv out r
printf '%s\n' "$space" >p
verified 'a sweep of an element' 2 --problems=p
sed 's/,"set":{[^}]*}//' r >r2
run verify -q --problems=p r2
equal 'a sweep of what is not there' 2 \
  "$(grep -c 'lengths: has no element lengths\[1\] for --sweep' err)"

# problems that are none
printf '{"points":[[0,0],[2,1]]\n{"points":[[0,0],[2,1]]}\n' >broken
run planar -q broken
mv out r
run verify --problems=broken r
equal 'a broken line among the problems' "$(cat <<'END'
{"command":"verify","status":"ok","of":"planar","claims":"error"}
END
)" "$(sed -n 1p out)"
expect 'it has its error record' 0
printf '{"pionts":[[0,0],[2,1]]}\n' >bad
printf '{"points":[[0,0],[2,1]]}' | made planar
run verify -q --problems=bad r
expect 'a problem that cannot be read' 1 'phspline: bad:1: record 1: pionts: is '\
'not a field of planar; did you mean "points"? [unknown-field]'
run verify --problems=missing r
equal 'no file of problems' 3 "$status"
equal 'it says so' 'phspline: cannot open missing: ' "$(cut -c 1-31 err)"
feed '' verify --problems=p
expect 'no results' 1 'phspline: p was not read: no result says what it solves
phspline: there is no result in standard input' ''
printf '{"id":1,"command":"tc","status":"error"}' >r
cat r r >r2
run verify -q --problems=p.csv r2
equal 'too many errors' 1 "$(grep -c 'p.csv has only 1 problem,' err)"

# ---- the command line --------------------------------------------------------

run verify --sample=3 r
expect 'an option of other commands' 2 \
  "phspline: verify has no option '--sample'
Try 'phspline verify --help'."
run verify -n 3 r
expect 'its letter' 2 "phspline: verify has no option '-n'
Try 'phspline verify --help'."
run planar --problems=p r
expect 'an option of verify' 2 "phspline: planar has no option '--problems'
Try 'phspline planar --help'."
run verify --problems=- -
expect 'both are standard input' 2 \
  "phspline: problems and results cannot both be standard input
Try 'phspline verify --help'."
run verify --columns=x,y r
equal 'columns of what' 2 "$status"
run verify --problems=p --set=color=1 r
expect 'a field of no command' 2 "phspline: --set: no command has a field 'color'
Try 'phspline verify --help'."
run verify --problems=p.csv --columns=x,yy r
equal 'columns that are none' 2 "$status"
equal 'nothing is written' '' "$(cat out)"
run verify --tolerance=0 r
equal 'a tolerance' 2 "$status"
run help verify
equal 'help' 1 "$(grep -c '^      --problems=FILE' out)"
equal 'no fields' 0 "$(grep -c '^Fields' out)"
run --help
equal 'among the commands' 1 "$(grep -c '^  verify  ' out)"
