# SPDX-License-Identifier: GPL-3.0-or-later
#
# phspline schema: its command line; and, by a validator that is not ours, that
# every problem and every result is as the schemas say, and that what is not
# like one is not.
. "$srcdir/tests/cli/lib.sh"

# ---- the command line ----------------------------------------------------------

# refused WHAT MESSAGE ARGUMENT...
refused() {
  what=$1
  message=$2
  shift 2
  run schema "$@" </dev/null
  expect "$what" 2 "phspline: $message
Try 'phspline --help'." ''
}
refused 'an unknown command' "unknown command 'bogus'" bogus
refused 'a command misspelt' \
  "unknown command 'planr'; did you mean \"planar\"?" planr
refused 'a field' "unknown command 'points'" points
refused 'an empty word' "unknown command ''" ''
refused 'an option' "unknown option '--pretty'" --pretty
refused 'two commands' 'schema takes one command' planar tc
refused 'a file' "unknown command '-'" -
run schma </dev/null
expect 'schema misspelt' 2 "phspline: unknown command 'schma'; \
did you mean \"schema\"?
Try 'phspline --help'." ''
run --help
mv out help
for arguments in 'schema --help' 'schema -h' 'help schema'; do
  # several words
  # shellcheck disable=SC2086
  run $arguments
  expect "$arguments" 0 ''
  equal_files "$arguments is --help" help out
done
if [ -c /dev/full ]; then
  status=0
  # expect reads it
  # shellcheck disable=SC2034
  "$PHSPLINE" schema >/dev/full 2>err || status=$?
  : >out
  expect 'a full disk' 4 'phspline: cannot write standard output: No space left on device'
fi

run schema
expect 'of all commands' 0 ''
mv out all.schema
for command in planar spatial-hermite arclength sphere tc cone bubble verify; do
  run schema "$command"
  expect "of $command" 0 ''
  mv out "$command.schema"
  equal "title of $command" "\"phspline $command\"" \
    "$(json get title "$command.schema")"
  equal "fields of $command" \
    "$("$PHSPLINE" help "$command" |
      sed -n '/^Fields/,/^$/s/^  \([a-z][a-z_]*\) .*/\1/p' | sort)" \
    "$(jq -r --arg d "$command-problem" '.["$defs"][$d].properties // {} |
      keys[] | select(. != "id" and . != "meta")' "$command.schema" | sort)"
  equal "what is told of each member of $command" '[]' \
    "$(jq -c '[.["$defs"] | to_entries[] |
      select(.key | test("^checks$|-(set|sweep)$") | not) |
      .value.properties // {} | to_entries[] |
      select((.value.description // "") == "") | .key] - ["id", "meta"]' \
      "$command.schema")"
done
equal 'a problem of any command, a result of one' \
  '["planar","spatial-hermite","arclength","sphere","tc","cone","bubble","verify"]' \
  "$(jq -c '[.["$defs"].result.oneOf[]["$ref"] | ltrimstr("#/$defs/") |
    rtrimstr("-result")]' all.schema)"

# ---- the validator -------------------------------------------------------------

python=
for p in python3 /usr/bin/python3; do
  if "$p" -c 'from jsonschema import Draft202012Validator' >/dev/null 2>&1; then
    python=$p
  fi
done
if [ -z "$python" ]; then
  echo 'skip schema of records: no python3 with jsonschema (python3-jsonschema)'
  exit 0
fi

: >table
lines=0

# good DEFINITION FILE
good() {
  printf 'good\t%s\t%s\n' "$1" "$2" >>table
}

# solved COMMAND FILE OPTION...: the problems of a file, their results, and what
# verify says of these
solved() {
  one_in 7 || return 0
  lines=$((lines + 1))
  command=$1
  file=$2
  shift 2
  "$PHSPLINE" "$command" -q "$@" "$file" >"$lines.json" 2>/dev/null ||
    [ $? -eq 1 ] || fail "$command $* $file" 'it does not run'
  "$PHSPLINE" verify -q "$lines.json" >"$lines.verify" 2>/dev/null ||
    [ $? -eq 1 ] || fail "verify of $command $* $file" 'it does not run'
  good "$command-result" "$lines.json"
  # by every command's schema: it takes long
  [ $# -gt 0 ] || good verify-problem "$lines.json"
  good verify-result "$lines.verify"
}

# with COMMAND FILE: the problems of a file, with each line of options of
# standard input
with() {
  good "$1-problem" "$2"
  good problem "$2"
  while read -r options; do
    # several words
    # shellcheck disable=SC2086
    solved "$1" "$2" $options
  done
}

# what all commands have
common='--sample=1
--spacing=0.4 --pretty
--chord-error=0.1
--offset=0.1
--offset=-0.2,0.2 --sample=2
--sample=1 --strict
--closed
--override=closed=true --offset=0.05
--tolerance=1e-3
--sample=2 --sweep=closed=true,false
--strict --offset=1
--set=closed=false --pretty --chord-error=0.5
--jobs=2 --offset=-1
--offset=0.1 --spacing=0.7
--override=closed=false
--offset=0.3 --chord-error=0.2
--fail-fast --sweep=closed=false'

cat >planar.json <<'END'
{"id":1,"points":[[0,0],[2,1],[3,0],[5,2]]}
{"id":"b","meta":{"a":[1,null]},"points":[[0,0],[4,0],[4,3],[0,3]],"closed":true}
{"points":[[0,0],[2,1],[3,0]],"knots":[0,1,3],"end_derivatives":[[1,1],[1,-1]]}
{"points":[[0,0],[2,1],[3,0]],"basis":"atph","alpha":"chordal:1.2"}
{"points":[[0,0],[1,0],[0,0]]}
END
with planar planar.json <<END

$common
--solutions=all
--solutions=all --basis=atph
--minimize=IES
--minimize=E --basis=atph --free=scale
--override=basis=atph --sample=2
--override=basis=atph --offset=0.1 --sample=1
--override=basis=atph --convert=bezier
--override=basis=atph --convert=bezier --offset=0.1 --spacing=1
--override=basis=atph --convert=bezier --solutions=all --tolerance=0.1
--convert=bezier
--sweep=knots=chordal,uniform
--sweep=points[1][0]=1:2:2
--sweep=points*=1,2
--sweep=alpha=0.5,1 --override=basis=atph
--override=knots=uniform
--set=knots=[0,2,3,7]
END

cat >spatial-hermite.json <<'END'
{"id":1,"points":[[0,0,0],[1,1,0],[2,0,1]]}
{"points":[[0,0],[1,1],[2,0]],"closed":true}
{"points":[[0,0,0],[1,1,1]],"derivatives":[[1,0,1],[0,1,1]]}
{"points":[[0,0,0],[1,1,1]],"tangents":[[1,0,1],[0,1,1]],"angles":[0,0.1]}
{"points":[[0,0,0],[1,1,1]],"angles":[[0,0.1]],"axis":"x","shape":false}
{"points":[[0,0,0],[0,0,0]]}
END
with spatial-hermite spatial-hermite.json <<END

$common
--sample=1 --frame=rmf
--sample=1 --frame=erf --offset=0.1
--spacing=0.5 --frame=frenet
--basis=atph
--basis=atph --criterion=F1 --offset=0.1 --sample=1 --frame=erf
--basis=atph --convert=bezier
--basis=atph --convert=bezier --offset=0.1 --sample=1 --frame=frenet
--criterion=bv
--criterion=F3
--override=criterion=hc --override=tension=0.8
--tension=[1,0.9]
--sweep=tension=0.7,1
--sweep=criterion=cc,hc
--sweep=angles[1]=0,0.1
--override=shape=false
--planarity=1e-3
END

cat >arclength.json <<'END'
{"id":"free","points":[[0,0,0],[1,1,0],[2,0,1]]}
{"id":2,"points":[[0,0,0],[1,1,0],[2,0,1]],"lengths":[1.6,1.9]}
{"points":[[0,0],[1,1],[2,0]],"lengths":1.6,"refine":1}
{"derivatives":[[1,0,0],[0,1,0],[0,1,1]],"lengths":[1,1]}
{"tangents":[[1,0,0],[0,1,0],[0,1,1]],"lengths":[1.2,1],"start":[1,2,3]}
{"points":[[0,0,0],[1,1,0],[2,0,1]],"lengths":[0.5,1.9]}
END
with arclength arclength.json <<END

$common
--sample=1 --frame=rmf
--sample=1 --frame=erf --offset=0.1
--refine=1
--refine=2 --offset=0.1
--refine=3
--all_minima
--starts=2 --all_minima --refine=2
--length_sigma=0.01
--planar=free
--sweep=refine=1,2
--sweep=lengths*=1,1.01
--sweep=lengths[1]=1.8,1.9
--override=knots=uniform
--magnitudes=mean
END

cat >sphere.json <<'END'
{"id":1,"points":[[1,0,0],[0,1,0],[0,0,1]]}
{"lonlat":[[-9,39],[-25,38],[-64,32],[-74,40]],"radius":1.5}
{"points":[[1,0,0],[0,1,0],[0,0,1]],"closed":true}
{"points":[[1,0,0],[0,1,0],[0,0,1]],"shape":"warn","increase":"plus:0.5"}
{"lonlat":[[0,0],[1,1],[2,0]],"end_tangents":[[0,1,0],[0,1,1]],"center":[1,0,0]}
{"points":[[1,0,0],[-1,0,0]]}
END
with sphere sphere.json <<END

$common
--model=nielson
--model=nielson --ends=rest --criterion=legacy --increase=times:1.5
--override=shape=false --tension=5
--sweep=tension=0,10
--sweep=tension*=2
--epsilon=1e-3
--ends=rest
--knots=uniform --offset=-0.1,0.1
--override=increase=plus:.5 --sample=2
--radius_tolerance=0.1
END

cat >tc.json <<'END'
{"id":1,"points":[[0,0],[2,1],[3,0],[5,2]]}
{"points":[[0,0],[2,1],[3,0]],"tangents":[[1,1],[1,0],[1,-1]]}
{"points":[[0,0],[2,1]],"derivatives":[[1,1],[1,0]]}
{"curve":[[0,0],[1,2],[3,2],[4,0]],"tolerance":0.1}
{"curve":[[[0,0],[1,2],[3,2],[4,0]],[[4,0],[5,1],[6,0]]],"pieces":6}
{"points":[[0,0],[2,1],[3,0]],"closed":true,"lambda":0.5}
{"points":[[0,0],[0,0]]}
END
with tc tc.json <<END

$common
--blaschke
--blaschke --offset=0.1 --sample=1
--solutions=all
--solutions=all --mode=g1
--solutions=standard
--mode=g1-pair
--mode=g1-pair --joint=chord
--mode=g1-pair --joint=chord --joint_angle=0.3 --joint_position=0.5
--mode=g1-auto
--mode=g1-fair --sample=2
--mode=spline --ends=circle
--mode=approximate --pieces=8
--convert=bezier
--sweep=lambda=0.3,0.5
--sweep=mode=g1,g1-pair
--end_tangents=[[1,0],[1,1]]
END

# errors that are not of fields
printf '{"points":[[0,0],[1,1]]}\n{"points"\n[1]\n{"id":4,"nosuch":1}\n' >bad.jsonl
for command in planar spatial-hermite arclength sphere tc; do
  solved "$command" bad.jsonl
  solved "$command" bad.jsonl --pretty --sweep=closed=true,false
  case $command in
  sphere) printf 'id,lon,lat\na,0,0\na,1,\n' >"$command.csv" ;;
  *) printf 'id,x,y\na,0,0\na,1,\n' >"$command.csv" ;;
  esac
  solved "$command" "$command.csv" --set=closed=true
done

# data and vectors, with the commands they are of
for file in "$srcdir"/data/*.json* "$srcdir"/tests/vectors/*.jsonl; do
  case ${file##*/} in
  gonzalez-2018-spatial* | spatial*) command=spatial-hermite ;;
  gonzalez*) command=planar ;;
  huard* | arclength*) command=arclength ;;
  iordanov* | sphere*) command=sphere ;;
  cone*) command=cone ;;
  bubble* | byrtus-2011-meshes*) command=bubble ;;
  *) command=tc ;;
  esac
  good "$command-problem" "$file"
  case $file in
  */vectors/arclength*) ;; # they take long, and say nothing else
  *) solved "$command" "$file" ;;
  esac
done
[ "${PH_SHORT-}" = 1 ] ||
  true_that 'enough command lines' test "$lines" -ge 190

# ---- what is not like a problem or a result -------------------------------------

sed -n 1p planar.json >p1.json
sed -n 2p planar.json >p2.json
sed -n 4p planar.json >p4.json
sed -n 4p sphere.json >s4.json
sed -n 5p tc.json >t5.json
sed -n 2p arclength.json >a2.json
solve() {
  name=$1
  shift
  "$PHSPLINE" "$@" >"$name" 2>/dev/null
}
solve ph.r planar --offset=0.1 --sample=1 --set=knots=uniform --solutions=all \
  p1.json
solve atph.r planar --offset=0.1 p4.json
solve sweep.r planar '--sweep=points*=1,2' --sweep=closed=true p1.json
solve bezier.r planar --convert=bezier p4.json
solve space.r spatial-hermite --offset=0.1 --sample=1 --frame=rmf \
  spatial-hermite.json
solve arc.r arclength --all_minima a2.json
solve sphere.r sphere --offset=0.1 s4.json
solve tc.r tc --blaschke --offset=-3 t5.json
solve error.r planar bad.jsonl --offset=1
sed -n 2p error.r >syntax.r
solve ok.v verify ph.r
sed 's/"length":[0-9.]*/"length":7/' ph.r >wrong.r
solve wrong.v verify wrong.r
solve none.v verify syntax.r

# definition, file, path, value; see schema.py
sed '/^#/d; s/  */	/g; s/^/bad	/' >>table <<'END'
# problems: members
planar-problem p1.json points -
planar-problem p1.json nosuch 1
planar-problem p1.json tangents [[1,0],[1,0]]
planar-problem p1.json id null
planar-problem p1.json id [1]
planar-problem p1.json command "planar"
problem p1.json nosuch 1
# types
planar-problem p1.json points 1
planar-problem p1.json points null
planar-problem p1.json points/1 5
planar-problem p1.json points/1/0 "2"
planar-problem p1.json points/1/0 null
planar-problem p1.json closed 1
planar-problem p1.json closed "true"
planar-problem p1.json solutions true
planar-problem p1.json alpha true
# shapes
planar-problem p1.json points/1 [1]
planar-problem p1.json points/1 [1,2,3]
planar-problem p1.json end_derivatives [1,2]
sphere-problem s4.json points/0 [1,0]
sphere-problem s4.json lonlat [[1,2,3]]
tc-problem t5.json curve/0 []
tc-problem t5.json curve [[[[0,0]]]]
arclength-problem a2.json points/1 [1,1]
arclength-problem a2.json lengths/0 [1]
arclength-problem a2.json start [[0,0,0]]
# words
planar-problem p1.json knots "chordl"
planar-problem p1.json basis "PH"
planar-problem p4.json alpha "chordal:"
planar-problem p4.json alpha "chordal:x"
planar-problem p4.json alpha "chordal:1.2:3"
planar-problem p1.json knots "geodesic"
sphere-problem s4.json increase "plus"
sphere-problem s4.json increase "minus:1"
sphere-problem s4.json shape "warning"
arclength-problem a2.json refine "2"
tc-problem t5.json mode "g3"
# results: headings
planar-result ph.r status "error"
planar-result ph.r status "fine"
planar-result ph.r status -
planar-result ph.r command -
planar-result ph.r command "tc"
planar-result ph.r command "plain"
planar-result ph.r nosuch 1
planar-result ph.r error {"code":"limit","message":""}
planar-result ph.r id true
planar-result ph.r set/knots "uniforme"
planar-result ph.r set/nosuch 1
planar-result ph.r set {}
planar-result sweep.r sweep/closed 3
planar-result sweep.r sweep/points* "2"
planar-result sweep.r sweep/pointless* 2
planar-result sweep.r sweep/points[a] 2
tc-result tc.r command "planar"
result ph.r status "error"
result ph.r command "verify"
# the curve
planar-result ph.r curve "tc"
planar-result ph.r curve "atph"
planar-result ph.r curve "bezier"
planar-result ph.r dimension 3
planar-result ph.r degree 6
planar-result ph.r closed 0
planar-result ph.r length "7"
planar-result ph.r length null
planar-result ph.r segments []
planar-result ph.r segments -
planar-result ph.r segments/0/interval [0]
planar-result ph.r segments/0/interval -
planar-result ph.r segments/0/control_points/5 -
planar-result ph.r segments/0/control_points/6 [1,1]
planar-result ph.r segments/0/control_points/2 [1,1,1]
planar-result ph.r segments/0/preimage -
planar-result ph.r segments/0/preimage/1 [1]
planar-result ph.r segments/0/alpha 1
planar-result ph.r segments/0/tension 1
planar-result ph.r segments/0/nosuch 1
planar-result ph.r center [0,0,0]
planar-result ph.r intervals []
planar-result atph.r segments/0/alpha -
planar-result atph.r segments/0/alpha 0
planar-result bezier.r segments/0/preimage [[1,0],[1,0],[1,0]]
sphere-result sphere.r radius 0
sphere-result sphere.r radius -
sphere-result sphere.r tensions {}
sphere-result sphere.r indicators/0 2
sphere-result sphere.r indicators/0 0.5
sphere-result sphere.r segments/0/preimage []
spatial-hermite-result space.r segments/0/tension -
spatial-hermite-result space.r segments/0/angles [1]
spatial-hermite-result space.r segments/0/shape_ok "yes"
spatial-hermite-result space.r segments/0/preimage/0 [1,2]
tc-result tc.r segments/0/blaschke/0/weights/0 0
tc-result tc.r segments/0/blaschke/0/control_points/0 [0,0]
tc-result tc.r intervals/0/segments [0,1,2]
tc-result tc.r intervals/0/segments [0.5,1]
tc-result tc.r intervals/0/root "plus"
tc-result tc.r intervals/0/natural_length 1
arclength-result arc.r intervals/0/length -
arclength-result arc.r intervals/0/lambda 1
# offsets and samples
planar-result ph.r offsets []
planar-result ph.r offsets/0/distance -
planar-result ph.r offsets/0/vector "e2"
planar-result ph.r offsets/0/degree 5
planar-result ph.r offsets/0/gaps null
planar-result ph.r offsets/0/gaps [-1]
planar-result ph.r offsets/0/gaps [0.5]
planar-result ph.r offsets/0/cusps [{"segment":0}]
planar-result ph.r offsets/0/cusps {}
planar-result ph.r offsets/0/beziers []
planar-result ph.r offsets/0/segments/0/weights/0 -1
planar-result ph.r offsets/0/segments/0/weights/9 -
planar-result ph.r offsets/0/segments/0/segment -1
planar-result ph.r offsets/0/segments/0/numerator []
planar-result atph.r offsets/0/beziers -
planar-result atph.r offsets/0/error -
planar-result atph.r offsets/0/segments/0/denominator -
planar-result atph.r offsets/0/segments/0/weights []
spatial-hermite-result space.r offsets/0/vector "e1"
spatial-hermite-result space.r offsets/0/vector -
spatial-hermite-result space.r frame "RMF"
spatial-hermite-result space.r samples/0/normal [1,0]
sphere-result sphere.r offsets/0/degree 3
sphere-result sphere.r offsets/0/samples/0/lonlat -
planar-result ph.r samples/0/t -
planar-result ph.r samples/0/point [0,0,0]
planar-result ph.r samples/0/torsion 0
planar-result ph.r samples/0/segment 0.5
planar-result ph.r samples {}
# the certificate
planar-result ph.r diagnostics -
planar-result ph.r diagnostics/nosuch 1
planar-result ph.r diagnostics/energy "1"
planar-result ph.r diagnostics/simple 1
planar-result ph.r diagnostics/second_order "minimum"
planar-result ph.r diagnostics/kantorovich/certified -
planar-result ph.r diagnostics/kantorovich/h "1"
planar-result ph.r diagnostics/starts []
arclength-result arc.r diagnostics/starts/0/outcome "won"
arclength-result arc.r diagnostics/starts/0/iterations -1
arclength-result arc.r diagnostics/natural_lengths/0 "1"
planar-result ph.r solutions/0/good -
planar-result ph.r solutions/0/good 1
planar-result ph.r solutions/0/diagnostics/kantorovich {"certified":true}
planar-result ph.r warnings []
planar-result ph.r warnings [{"code":"limit","message":""}]
planar-result ph.r warnings [{"code":"loop"}]
# errors
planar-result syntax.r error -
planar-result syntax.r error/code "syntax-error"
planar-result syntax.r error/code "usage"
planar-result syntax.r error/code -
planar-result syntax.r error/message -
planar-result syntax.r error/line 1.5
planar-result syntax.r error/nosuch 1
planar-result syntax.r status "ok"
planar-result syntax.r segments []
# verdicts
verify-result ok.v of "verify"
verify-result ok.v of -
verify-result ok.v status "error"
verify-result ok.v worst/check "length"
verify-result ok.v worst/error -
verify-result ok.v checks/nosuch 0
verify-result ok.v checks/shape "0"
verify-result ok.v segments []
verify-result ok.v claims "error"
verify-result ok.v curve "phh"
verify-result wrong.v error -
verify-result wrong.v status "ok"
verify-result none.v claims "ok"
verify-result none.v claims -
verify-problem ph.r of "planar"
verify-problem ok.v id 1
END
sed -i '$d' table # a verdict is no result to verify
true_that 'enough that is not' test "$(grep -c '^bad' table)" -ge 60

"$python" "$srcdir/tests/cli/schema.py" all.schema planar.schema \
  spatial-hermite.schema arclength.schema sphere.schema tc.schema verify.schema \
  <table >said 2>&1 || fail 'the validator' "$(tail -n 1 said)"
cat said
equal 'an answer to each' "$(wc -l <table)" "$(wc -l <said)"
