# SPDX-License-Identifier: GPL-3.0-or-later
#
# Command lines that make no sense: the message, status 2, nothing written.
# And those that ask for help.
. "$srcdir/tests/cli/lib.sh"

hint="Try 'phspline planar --help'."

# usage MESSAGE ARGUMENT...: what `phspline planar -o keep ARGUMENT...' says
usage() {
  message=$1
  shift
  mkdir dir
  printf 'old\n' >dir/keep
  feed "$good" planar -o dir/keep "$@"
  if [ "$(cat dir/keep)" != old ] || [ "$(ls -A dir)" != keep ]; then
    fail "$message" 'it wrote to the output file'
  else
    expect "$message" 2 "phspline: $message
$hint" ''
  fi
  rm -r dir
}

# ---- options -----------------------------------------------------------------

usage "unknown option '--nosuch'" --nosuch
usage "unknown option '--nosuch'" --nosuch=1
usage "unknown option '--clsoed'; did you mean \"closed\"?" --clsoed
usage "unknown option '--knot'; did you mean \"knots\"?" --knot=uniform
usage "unknown option '--out'; did you mean \"output\"?" --out=x
usage "planar has no option '--end-tangents', but there is one of sphere" \
  --end-tangents=1
usage "unknown option '--Pretty'; did you mean \"pretty\"?" --Pretty
usage "unknown option '-x'" -x
usage "unknown option '-x'" --pretty -xq
usage "unknown option '-x'" --pretty -qx
usage "unknown option '-x'" - -x
usage "unknown option '-1'" -1
usage "unknown option '-\\xc3'" '-é'

# names are never cut short, not even where no other begins so
usage "unknown option '--prett'; did you mean \"pretty\"?" --prett
usage "unknown option '--input'; did you mean \"input-format\"?" --input=csv
usage "unknown option '--verb'; did you mean \"verbose\"?" --verb
usage "unknown option '--offse'; did you mean \"offset\"?" --offse 1
usage "unknown option '--job'; did you mean \"jobs\"?" --job
usage "unknown option '--pr'" --pr
usage "unknown option '--fail'; did you mean \"fail-fast\"?" --fail=1

usage "option '--jobs' needs a value" --jobs
usage "option '-j' needs a value" -j
usage "option '-j' needs a value" -qj
usage "option '-o' needs a value" -q x -o
usage "option '--knots' needs a value" --knots
usage "option '--pretty' takes no value" --pretty=1
usage "option '--quiet' takes no value" --quiet=
usage "option '--help' takes no value" --help=planar
usage "unknown option '--quie'; did you mean \"quiet\"?" --quie=

usage "--input-format must be auto|json|csv|text|geojson|svg|gpx|obj, found 'xml'" --input-format=xml
usage "--input-format must be auto|json|csv|text|geojson|svg|gpx|obj, found 'jsn'; \
did you mean \"json\"?" -i jsn
usage "--input-format must be auto|json|csv|text|geojson|svg|gpx|obj, found ''" -i ''
usage "--input-format must be auto|json|csv|text|geojson|svg|gpx|obj, found 'CSV'; \
did you mean \"csv\"?" -i CSV
usage "--format must be json|csv|text|npy|svg-path|svg|geojson|dxf|obj|stl|opendrive|gcode, found 'svgz'; did you mean \"svg\"?" -f svgz
usage "--format must be json|csv|text|npy|svg-path|svg|geojson|dxf|obj|stl|opendrive|gcode, found 'json|csv'" --format='json|csv'
usage "--table must be control-points|lengths|samples|offsets|strips|patches|edges|development|located, found 'length'; \
did you mean \"lengths\"?" -f csv --table=length
usage '--table needs --format=csv, text or npy' -f json --table=lengths
usage '--table needs --format=csv, text or npy' --table=lengths -f svg-path
for sampling in --sample=3 --spacing=1; do
  usage "--format=svg-path has no samples; --chord-error says how near paths \
are to the curve" -f svg-path "$sampling"
done
usage '--format=svg-path is of cubics; --convert does nothing there' \
  -f svg-path --convert=bezier
usage '--table=samples needs --sample, --spacing, --chord-error or --at' \
  --table=samples
usage '--pretty needs --format=json' --pretty --table=lengths
usage '--sample, --spacing and --chord-error are alternatives' \
  --sample=3 --spacing=1
usage '--sample, --spacing and --chord-error are alternatives' \
  --chord-error=1 --spacing=1
usage '--frame needs --sample, --spacing, --chord-error or --at' --frame=rmf
usage '--frame: the curves of planar are in the plane, where the normal is '\
'(-ty,tx)' --frame=erf --sample=3
usage "--frame must be frenet|erf|rmf, found 'RMF'; did you mean \"rmf\"?" \
  --frame=RMF
for n in 0 -1 x '' inf nan 1e999; do
  usage "--spacing must be a number greater than 0, found '$n'" --spacing="$n"
  usage "--chord-error must be a number greater than 0, found '$n'" \
    --chord-error="$n"
done
for n in 640 640x 640x0 x480 640X480 1.5x200 99x200 200x20001; do
  usage "--plot-size must be WIDTHxHEIGHT, whole numbers from 100 to 20000, \
found '$n'" --plot=x.svg --plot-size="$n"
done
usage '--table=offsets needs --offset' -f csv --table=offsets
usage '--pretty needs --format=json' --pretty -f csv

for k in 1 1/ /1 1/1 2/1 -1/2 0/0 0/2x 0/1e3 0/1000000001 ''; do
  usage "--shard must be K/N, whole numbers with K, from 0, below N, and N at \
most 1000000000, found '$k'" --shard="$k"
done
for k in 1 : x:1 2:1 -1:2 0:2x 1:99999999999999999999999; do
  usage "--range must be FROM:TO, bytes from 0, or FROM:, found '$k'" --range="$k"
done
usage '--shard and --range are alternatives' --range=0:1 --shard=0/1
usage '--shard and --range are alternatives' --shard=0/1 --range=0:1
usage '--shard does not go with --plot, which is of the whole run' \
  --shard=0/1 --plot=x.svg
usage '--range needs --format=json, csv, text or svg-path: files of svg are no '\
'parts of one' --range=0: -f svg

usage '--output must be the name of a file' --output=
for n in 0 -1 1.5 1025 1e9 x '' ' 1' 0x2 nan inf 1,2; do
  usage "--jobs must be a whole number from 1 to 1024, found '$n'" --jobs="$n"
done
for d in '' x '1,' ',1' '1,,2' '1 2' nan inf 1e999 '[1]'; do
  usage "--offset takes numbers, found '$d'" --offset="$d"
done
for c in '' ab ';;' '\n' é; do
  usage "--delimiter must be one character or \\t, found '$c'" --delimiter="$c"
done
usage '--delimiter: must be neither a quote nor a line break' --delimiter='"'
usage '--columns: column "y" is missing: planar needs it for points' \
  --columns=x
usage '--columns: column "x" is missing: planar needs it for points' \
  --columns=id,-,y
usage '--columns: column "yy" is unknown to planar; did you mean "y"?' \
  --columns=x,yy
usage '--columns: column 2 has no name' --columns=x,,y
usage '--columns: columns 1 and 3 ("x") are the same' --columns=x,y,x

# ---- fields ------------------------------------------------------------------

allowed='must be "chordal", "centripetal", "uniform" or an array of numbers'
for option in --set --override; do
  usage "$option: 'knots' is not FIELD=VALUE" "$option" knots
  usage "$option: '' is not FIELD=VALUE" "$option="
  usage "$option: '=uniform' is not FIELD=VALUE" "$option==uniform"
  usage "$option: planar has no field 'knot'; did you mean \"knots\"?" \
    "$option=knot=uniform"
  usage "$option: planar has no field 'id'" "$option=id=1"
  usage "$option: planar has no field 'knots[1]'" \
    "$option=knots[1]=0.5"
  usage "$option: knots $allowed, found \"unifrom\"; did you mean \"uniform\"?" \
    "$option" knots=unifrom
  usage "$option: knots $allowed, found a number" "$option=knots=1"
  usage "$option: closed must be true or false, found \"yes\"" \
    "$option=closed=yes"
done
usage "--knots: knots $allowed, found \"\"" --knots=
usage "--knots: knots must be JSON: the text ends inside an array" --knots='[0,'
usage '--knots: knots must be JSON: something follows the value' --knots='[0]1'
usage '--knots: knots[1] is 1e999, which overflows a double' --knots='[0,1e999]'
usage '--closed: closed must be true or false, found "maybe"' --closed=maybe
usage '--points: points[1] must have 2 numbers, found 3' \
  --points='[[0,0],[1,1,1]]'
usage '--end_derivatives: end_derivatives must be an array of vectors [x,y], '\
'found "x"' --end_derivatives=x

# ---- sweeps ------------------------------------------------------------------

usage "--sweep: 'knots' is not FIELD=START:STOP:COUNT or FIELD=V1,V2,..." \
  --sweep knots
usage "--sweep: '=1,2' is not FIELD=START:STOP:COUNT or FIELD=V1,V2,..." \
  -S =1,2
usage "--sweep: planar has no field 'knot'; did you mean \"knots\"?" \
  --sweep knot=uniform
usage "--sweep: planar has no field 'meta'" --sweep meta=1
for target in 'knots[' 'knots[]' 'knots[x]' 'knots[-1]' 'knots[1' 'knots[1]x' \
  'points[1][1][1]' 'knots[1.5]' 'knots[9999999999999999999]'; do
  usage "--sweep: '$target' is not a field or an element like knots[2] or \
points[0][1]" --sweep "$target=1,2"
done
for range in 1:2:0 1:2:-1 1:2:1.5 1:2: 1::3 :2:3 1:x:3 1:2:3:4 1:2:1e10 \
  inf:1:2 0:nan:2; do
  usage "--sweep: '$range' is not START:STOP:COUNT[:log] with a COUNT from 1 to \
1000000000" \
    --sweep "points[0][0]=$range"
done
usage "--sweep: knots $allowed, found a number" --sweep knots=1:2:3
usage "--sweep: knots[1] takes numbers, found 'x'" --sweep 'knots[1]=1,x'
usage "--sweep: knots[1] takes numbers, found ''" --sweep 'knots[1]='
usage "--sweep: knots[1] takes numbers, found '1e999'" --sweep 'knots[1]=1e999'
usage "--sweep: knots[1] takes numbers, found '1:2'" --sweep 'knots[1]=1:2'
usage "--sweep: closed takes values, found ''" --sweep closed=
usage "--sweep: closed takes values, found ''" --sweep closed=true,,false
usage "--sweep: knots $allowed, found \"x\"" --sweep knots=uniform,x
usage "--sweep: knots must be JSON: the text ends inside an array" \
  --sweep 'knots=[0,1'
usage '--sweep: knots is swept twice' --sweep knots=uniform \
  --sweep knots=chordal
usage '--sweep: points[0][1] is swept twice' -S 'points[0][1]=1,2' \
  -S 'points[0][0]=1,2' -S 'points[0][01]=3,4'
usage '--sweep: too many combinations' --sweep 'points[0][0]=0:1:1000000000' \
  --sweep 'points[0][1]=0:1:1000000000' --sweep 'points[1][0]=0:1:1000000000'

# a message is one line, whatever it is about
nasty=$(printf 'a\nb\033')
usage "--format must be json|csv|text|npy|svg-path|svg|geojson|dxf|obj|stl|opendrive|gcode, found 'a\\x0ab\\x1b'" -f "$nasty"
usage "unknown option '--a\\x0ab\\x1b'" "--$nasty"
usage "--jobs must be a whole number from 1 to 1024, found 'a\\x0ab\\x1b'" \
  -j "$nasty"
usage "--set: 'a\\x0ab\\x1b' is not FIELD=VALUE" -s "$nasty"
usage "--set: planar has no field 'a\\x0ab\\x1b'" -s "$nasty=1"
usage "--sweep: planar has no field 'a\\x0ab\\x1b'" -S "$nasty=1"
usage "--offset takes numbers, found '\
1111111111111111111111111111111111111111...'" --offset="$(
  printf '1%.0s' 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 \
    24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40 41 42)x"

# ---- commands ----------------------------------------------------------------

# program MESSAGE ARGUMENT...: the same before a command is known
program() {
  message=$1
  shift
  feed "$good" "$@"
  expect "$message" 2 "phspline: $message
Try 'phspline --help'." ''
}

program 'no command'
program "unknown command 'planer'; did you mean \"planar\"?" planer
program "unknown command 'Planar'; did you mean \"planar\"?" Planar x
program "unknown command ''" ''
program "unknown command 'points.json'" points.json
program "unknown command '-'" -
program "unknown command 'plan\\x0aar'; did you mean \"planar\"?" "$(
  printf 'plan\nar')"
program "unknown command 'nosuch'" help nosuch
program "unknown command 'planr'; did you mean \"planar\"?" help planr
program "unknown option '--verson'; did you mean \"version\"?" --verson
program "unknown option '--pretty'" --pretty planar
program "unknown option '-x'" -x
program "option '--help' takes no value" --help=planar
program "option '--version' takes no value" --version=

# ---- help and version --------------------------------------------------------

version=$(sed -n 's/.*PH_VERSION "\(.*\)".*/\1/p' \
  "$srcdir/src/base/version.h")

# asked NAME USAGE ARGUMENT...: the text begins so, nothing on standard error
asked() {
  name=$1 usage=$2
  shift 2
  run "$@" </dev/null
  expect "$name" 0
  equal "$name: its first line" "phspline $version" "$(sed -n 1p out)"
  true_that "$name: its usage" grep -q -x -F -e "$usage" out
}

asked '--help' 'Usage: phspline COMMAND [OPTION]... [FILE]...' --help
mv out help
for arguments in -h help 'help help' 'help --help' '--help x'; do
  # shellcheck disable=SC2086
  run $arguments
  expect "$arguments" 0
  equal_files "$arguments is --help" help out
done
asked 'help planar' 'Usage: phspline planar [OPTION]... [FILE]...' help planar
mv out help
for arguments in --help -h '-q --help --nosuch' 'x -h' '--pretty -hx'; do
  # shellcheck disable=SC2086
  run planar $arguments
  expect "planar $arguments" 0
  equal_files "planar $arguments is help planar" help out
done
run --version
expect '--version' 0
equal '--version: its first line' "phspline $version" "$(sed -n 1p out)"
mv out version
for arguments in -V 'planar --version' 'planar -V' 'planar -qV x'; do
  # shellcheck disable=SC2086
  run $arguments
  expect "$arguments" 0
  equal_files "$arguments is --version" version out
done
for word in control-points --offset --closed 'Exit status' end_derivatives; do
  true_that "the help of planar tells of $word" grep -q -e "$word" help
done

# ---- operands ----------------------------------------------------------------

printf '%s\n' "$good" >a.jsonl
printf '{"id":"-","points":[[0,0],[1,1]]}' >./-x.json
printf '{"id":3,"points":[[0,0],[2,2]]}' >./--pretty
run planar -q a.jsonl --jobs 2 -- -x.json --pretty
expect 'options between files, and files after --' 0
equal 'their order' 'absent "-" 3' "$(get id)"
standard='{"id":"in","points":[[0,0],[1,1]]}'
feed "$standard" planar a.jsonl - -q a.jsonl
expect 'a - among the files' 0
equal 'a - is standard input' 'absent "in" absent' "$(get id)"
feed "$standard" planar
equal 'no file is standard input' '"in"' "$(get id)"
feed "$standard" planar - -
expect 'standard input is empty the second time' 0 \
  'phspline: there is no problem in standard input'
equal 'standard input is read once' '"in"' "$(get id)"
feed "$standard" planar -- -
equal 'a - after --' '"in"' "$(get id)"
run planar <&-
expect 'standard input is closed' 3 \
  'phspline: cannot read -: Bad file descriptor' ''
