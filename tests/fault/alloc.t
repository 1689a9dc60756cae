# SPDX-License-Identifier: GPL-3.0-or-later
#
# Memory that gives out: each allocation of a run fails in turn, alone and with
# all after it.  A record whose allocation fails is an error record, and no
# record is lost; or the run ends with status 5 and says so; or it ends as it
# would have.  No line of output is half, no file is replaced by less than the
# whole, and the sanitizers of this build have nothing to report.
#
# Where every step takes long (PH_SHORT=1), one allocation in three fails alone,
# another with all after it; which, goes on from one command to the next, and so
# each of those that commands share has its turn.  `make asan SHORT=
# TESTS=alloc.t' takes every one.
. "$srcdir/tests/cli/lib.sh"

# No run of these needs more allocations: the loops below are bounded.
most=2000

# also WHAT: adds to why
also() {
  why=${why:+$why, }$1
}

# Sets why to what is wrong with the last run, nothing if it ended as it may:
# results are those of the good run, as far as they go; a record may have failed
# for want of memory, which makes a status of 0 one of 1.  It is asked thousands
# of times: processes are few.
judge() {
  why='' said='' short=''
  while read -r line || [ -n "$line" ]; do
    said="$said$line "
  done <err
  case $said in
  *'memory is exhausted'*) short=1 ;;
  esac
  if [ -z "$short" ]; then
    [ "$status" -eq "$good_status" ] ||
      also "status $status, and no word of memory"
    cmp -s good.out out || also "status $status, but other results"
  elif [ "$status" -eq 5 ]; then
    if [ -s out ]; then
      judge_part out good.out
    fi
  elif [ "$format" = text ]; then
    also "status $status"
  elif [ "$status" -ne "$good_status" ] &&
    [ "$status $good_status" != '1 0' ]; then
    also "status $status instead of $good_status"
  else
    judge_whole out good.out
  fi
  case $said in
  *Sanitizer* | *'runtime error'*) also 'a sanitizer reports' ;;
  esac
  if [ -n "$file" ]; then
    if [ -z "$short" ]; then
      cmp -s good.file "$file" || also 'the file is not what it should be'
    elif [ "$status" -ne 5 ]; then
      judge_file
    elif [ "$(cat "$file")" != old ]; then
      also 'the old file is gone'
    fi
    [ "$(ls -A d)" = file ] || also "there is more than the file: $(ls -A d)"
  fi
}

# The same for what a run has written that has failed as a whole.
judge_part() {
  if [ -n "$(tail -c 1 "$1")" ]; then
    also 'a line is cut off'
  elif [ "$format" = text ]; then
    cmp -s "$1" "$2" || also 'other text'
  else
    part=$(awk -v format="$format" -v good="$2" -v whole="${3-}" '
      { record = record $0 }
      /^{/ { n[FILENAME]++ }
      format == "pretty" && $0 != "}" { next }
      FILENAME == good { was[record] }
      !(record in was) && record !~ /"code": ?"out-of-memory"/ {
        print "line " FNR ": " substr(record, 1, 100)
      }
      { record = "" }
      END {
        if (record != "") print "a record is cut off"
        if (whole && n[good] != n[ARGV[2]]) print "a record is lost"
      }' "$2" "$1")
    [ -z "$part" ] || also "$part"
  fi
}

# The same for a run that went on: there is a record, good or failed, for each
# one of JSON; of a table the rows of failed ones are missing.
judge_whole() {
  if [ -s "$1" ] || [ -s "$2" ]; then
    judge_part "$1" "$2" whole
  fi
}

# What it left in the file: the records, or a figure without those that failed.
judge_file() {
  case $(head -c 5 good.file) in
  '<?xml' | ?PNG*)
    [ "$(head -c 5 "$file")" = "$(head -c 5 good.file)" ] ||
      also 'the figure is none'
    ;;
  *) judge_whole "$file" good.file ;;
  esac
}

# once NUMBER ARGUMENT...: a run in which that allocation fails
once() {
  number=$1
  shift
  if [ -n "$file" ]; then
    echo old >"$file"
  fi
  status=0
  PH_FAIL_AT=$number "$PHSPLINE" "$@" >out 2>err <in || status=$?
}

# is_turn MODE: whether allocation n is one of those that fail so.
commands=0
is_turn() {
  [ "${PH_SHORT-}" = 1 ] || return 0
  case $1$(((commands + n) % 3)) in
  all0 | one1) return 0 ;;
  esac
  return 1
}

# exhaust NAME FORMAT ARGUMENT...: the output is lines, records that end with a
# line `}' (pretty), or one piece (text).
# With all that follow failing, too, a run succeeds when it needs no more: so
# the number of allocations is found, and then each of them fails alone.
exhaust() {
  name=$1 format=$2 bad_runs=0 needs=0 commands=$((commands + 1))
  shift 2
  once -1 "$@"
  good_status=$status
  mv out good.out
  [ -z "$file" ] || mv "$file" good.file
  for mode in all one; do
    n=0
    while [ "$n" -lt "$most" ]; do
      if [ "$mode" = one ] && [ "$n" -gt "$needs" ]; then
        break
      elif ! is_turn "$mode"; then
        n=$((n + 1))
        continue
      elif [ "$mode" = all ]; then
        PH_FAIL_ON=1
        export PH_FAIL_ON
      fi
      once "$n" "$@"
      unset PH_FAIL_ON
      judge
      if [ -n "$why" ]; then
        bad_runs=$((bad_runs + 1))
        if [ "$bad_runs" -le 3 ]; then
          fail "$name, allocation $n fails ($mode)" "$why"
          sed -n 1,8p err
        fi
      fi
      if [ "$mode" = all ] && [ "$status" -eq "$good_status" ]; then
        needs=$n
        break
      fi
      n=$((n + 1))
    done
  done
  if [ "$needs" -eq 0 ]; then
    fail "$name" 'no allocation was needed, or too many'
  elif [ "$bad_runs" -eq 0 ]; then
    pass "$name ($needs allocations)"
  fi
}

# alone NAME ARGUMENT...: of three records that in the middle fails alone where
# nothing but its own text lacks memory.
alone() {
  name=$1 n=0 codes=
  shift
  while [ "$codes" != 'ok out-of-memory ok ' ] && [ "$n" -lt "$most" ]; do
    once "$n" "$@"
    codes=$(sed 's/.*"code":"\([a-z-]*\)".*/\1/;s/^{.*/ok/' out | tr '\n' ' ')
    n=$((n + 1))
  done
  true_that "$name" [ "$n" -lt "$most" ]
}

PH_FAIL_AT=0 "$PHSPLINE" --version >out 2>err </dev/null && {
  fail 'the build' 'no allocation fails in it'
  exit
}

mkdir d
file=
printf '%s\n' '{"id":"a","points":[[0,0],[1,1],[2,0]],"meta":{
"\u0061": [1], "b":{"c":2,"d":3}}}' "$bad" '{"points":[[0,0],[1' \
  '{"id":"\u0062","points":[[0,0],[2,1],[3,3],[0,2]],"closed":true}' \
  '{"p\u006fints":[[0,0],[1,0],[0,0]],"knots":[0,1,3]}' >some.jsonl
printf '[%s,%s,{"points":' "$good" "$bad" >array.json
printf 'id,x,y,knot\n"a",0,0,\na,"1",1,\n\nb,0,0,1\nb,3,4,2\n' >some.csv
printf 'c,0,0,x\nd,"0,0,\n' >>some.csv
awk 'BEGIN {
  printf "{\"points\":["
  for (i = 0; i < 1000; i++) printf "%s[%d,%d]", i ? "," : "", i, i * i % 7
  print "]}"
}' >large.json
: >in

exhaust 'JSON Lines' lines planar -j 1 some.jsonl
exhaust 'JSON Lines, two threads' lines planar -j 2 some.jsonl
exhaust 'an array that breaks off' lines planar -j 1 array.json
exhaust 'a large problem' lines planar -j 1 -d 0.1 large.json
# from 2048 segments on two threads look for two solutions
awk 'BEGIN {
  print "x,y"
  for (i = 0; i < 2600; i++) printf "%d,%.3f\n", i % 2 ? i + 3 : i, 9 * sin(i / 9)
}' >turning.csv
exhaust 'a large problem, two threads' lines planar -j 2 \
  --fields=length,diagnostics turning.csv
exhaust 'CSV' lines planar -j 1 some.csv
exhaust 'CSV, two threads' lines planar -j 2 some.csv
exhaust 'records that are too long' lines planar -j 1 \
  --max-record-bytes=40 some.jsonl some.csv
exhaust 'several files' lines planar -j 1 array.json some.csv
exhaust 'a table' lines planar -j 1 -f csv some.jsonl
exhaust 'a table of offsets' lines planar -j 1 -f csv --table=offsets \
  -d 1,-1 some.csv
exhaust 'offsets' lines planar -j 1 -d 1 -d -1,2 some.jsonl
exhaust 'sweeps' lines planar -j 1 -S knots=uniform,chordal \
  -S 'points[0][0]=0:0.5:2' some.jsonl
exhaust 'a sweep, two threads' lines planar -j 2 \
  -S 'knots=[0,1,2],uniform' some.jsonl
exhaust 'fields as options' lines planar -j 1 --set knots=uniform \
  --override='knots=[0,1,2]' '--end_derivatives=[[1,1],[1,1]]' some.jsonl
exhaust 'columns' lines planar -j 1 --columns=id,x,y,- some.csv
printf '%s' '{"points":[[0,0],[1,0],[0,1],[1,2]],"basis":"atph"}' >atph.json
exhaust 'angles' lines planar -j 1 -d 0.1 atph.json
exhaust 'a conversion' lines planar -j 1 --convert=bezier atph.json
exhaust 'all solutions' lines planar -j 1 --solutions=all atph.json
exhaust 'the fairest' lines planar -j 1 --minimize=IES atph.json
printf '%s' '{"points":[[0,0,0],[1,0,1],[0,1,2],[1,2,0]]}' >space.json
printf '%s\n' '{"points":[[0,0,0],[1,1,1]],"tangents":[[0.4,-1.5,-1.2],' \
  '[-2,-1,-2]]}' '{"points":[[0,0],[1,0],[0,0]],"closed":false}' \
  '{"points":[[0,0,0],[1,0,0]],"derivatives":[[1,0,0],[1,1,1]]}' >shapes.jsonl
printf 'x,y,z,tx,ty,tz,tension\n0,0,0,1,0,0,\n1,2,3,0,0,1,0.5\n' >space.csv
exhaust 'in space' lines spatial-hermite -j 1 space.json
exhaust 'in space, closed, two threads' lines spatial-hermite -j 2 --closed \
  space.json
exhaust 'in space, shapes' lines spatial-hermite -j 1 --shape=true shapes.jsonl
exhaust 'in space, angles' lines spatial-hermite -j 1 '--angles=[0,1]' \
  space.json
exhaust 'in space, F1 and alpha' lines spatial-hermite -j 1 --criterion=F1 \
  --basis=atph space.json
exhaust 'in space, a conversion' lines spatial-hermite -j 1 --basis=atph \
  --alpha=1 --criterion=cc --convert=bezier --tolerance=1e-4 space.json
exhaust 'in space, CSV' lines spatial-hermite -j 1 -f csv --table=lengths \
  space.csv
exhaust 'in space, offsets' lines spatial-hermite -j 1 -d 0.1 space.json
exhaust 'in space, offsets of atph' lines spatial-hermite -j 1 -d 0.1 \
  --basis=atph --alpha=1 --criterion=cc --tolerance=1e-3 space.json
echo '{}' >empty.json
printf '%s\n' '{"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]],"lengths":[5,3,2]}' \
  '{"points":[[0,0],[1,0],[1,1]],"lengths":[0.5,2]}' \
  '{"tangents":[[1,0,0],[1,1,0],[0,1,1]],"lengths":[1,2]}' \
  '{"derivatives":[[1,0,0],[0,1,0],[0,0,1]],"lengths":[1,1]}' \
  '{"points":[[0,0],[1,0]],"lengths":[2]}' >lengths.jsonl
printf 'x,y,z,length\n1,1,0,\n0,4,3,4.9\n2,4,2,2.5\n3,3,3,2\n' >lengths.csv
awk 'BEGIN {
  printf "{\"points\":["
  for (i = 0; i < 200; i++) printf "%s[%.9f,%.9f,%g]", i ? "," : "", \
    cos(i / 5), sin(i / 5), i / 10
  print "]}"
}' >long.json
exhaust 'lengths' lines arclength -j 1 lengths.jsonl
exhaust 'lengths, two threads' lines arclength -j 2 lengths.jsonl
exhaust 'lengths, many' lines arclength -j 1 --refine=2 long.json
exhaust 'lengths, CSV' lines arclength -j 1 -f csv --table=lengths lengths.csv
exhaust 'lengths, fitted, a sweep' lines arclength -j 1 --length_sigma=0.1 \
  -S 'lengths[1]=2,3' lengths.csv
exhaust 'lengths, all minima and offsets' lines arclength -j 1 -d 0.1 \
  --all_minima --starts=2 lengths.csv
exhaust 'lengths, out of the plane' lines arclength -j 1 \
  --set='points=[[4,2],[-3,0],[4,2],[-4,3]]' --closed \
  --lengths='[7.7,7.7,8.53,8.53]' empty.json
exhaust 'lengths, none' lines arclength -j 1 --starts=2 \
  --set='points=[[0,0,0],[1,1,0],[2,0,1],[3,1,1]]' \
  --lengths='[1.4143,1.7321,1.4143]' empty.json
printf '%s\n' '{"id":"a","lonlat":[[0,0],[20,0],[40,0],[40,20],[60,50]]}' \
  '{"points":[[1,0,0],[0,0.707,0.707],[-1,0,0],[0,0,-1]],"closed":true}' \
  '{"points":[[1,0,0],[-1,0,0]]}' >sphere.jsonl
printf 'lon,lat,tension\n0,0,1\n10,20,1\n40,30,2.5\n60,-10,0\n' >sphere.csv
printf '%s' '{"lonlat":[[0,0],[150,60],[-20,-70],[100,10]],"closed":true,' \
  '"shape":false}' >wide.json
awk 'BEGIN {
  printf "{\"lonlat\":["
  for (i = 0; i < 16; i++) printf "%s[%.9f,%.9f]", i ? "," : "", \
    i, 20 * sin(i * i / 9)
  print "]}"
}' >track.json
exhaust 'on a sphere' lines sphere -j 1 sphere.jsonl
exhaust 'on a sphere, steps' lines sphere -j 1 --increase=times:2 \
  --model=nielson --criterion=legacy sphere.jsonl
exhaust 'on a sphere, only a warning' lines sphere -j 1 --shape=warn \
  --epsilon=1e-11 sphere.jsonl
exhaust 'on a sphere, continuation' lines sphere -j 1 wide.json
exhaust 'on a sphere, a track' lines sphere -j 1 track.json
exhaust 'on a sphere, CSV' lines sphere -j 1 -f csv --table=lengths \
  --ends=clamped '--end_tangents=[[0,1,0],[0,0,1]]' sphere.csv
exhaust 'on a sphere, samples and offsets' lines sphere -j 1 -n 3 -d 0.1 \
  sphere.jsonl
exhaust 'on a sphere, a table of offsets' lines sphere -j 1 -f csv \
  --table=offsets -d 0.1 sphere.csv
printf '%s\n' '{"points":[[0,0],[2,1],[3,0]],"tangents":[[1,1],[1,0],[-1,2]]}' \
  '{"points":[[0,0],[2,1],[3,3],[0,2]],"closed":true,"lambda":0.7}' \
  '{"points":[[0,0],[1,0]],"derivatives":[[1,1],[-1,1]]}' \
  '{"points":[[0,0],[1,0]],"tangents":[[1,1],[1,-3]],"mode":"g1-pair",' \
  '"joint":"chord"}' '{"points":[[0,0],[1,0],[0,0]]}' >cubics.jsonl
printf 'x,y,tx,ty\n0,0,1,1\n1,0,1,0\n2,2,-1,3\n' >cubics.csv
printf '%s' '{"curve":[[[0,0],[1,2],[3,2],[4,0]],[[4,0],[5,-2],[6,0]]]}' \
  >chain.json
exhaust 'cubics' lines tc -j 1 cubics.jsonl
exhaust 'cubics, offsets and images' lines tc -j 1 -d 0.1 --blaschke \
  cubics.jsonl
exhaust 'cubics, all solutions' lines tc -j 1 --mode=g1-pair --solutions=all \
  cubics.csv
printf 'x,y\n0,0\n1,1\n2,0\n3,3\n2,5\n-1,2\n' >turning.csv
exhaust 'cubics with continuous curvature' lines tc -j 1 --mode=g2 turning.csv
exhaust 'cubics, a table of samples' lines tc -j 1 -n 2 -f csv --table=samples \
  cubics.csv
exhaust 'cubics along a chain' lines tc -j 1 --tolerance=0.01 chain.json
exhaust 'cubics along a chain, so many' lines tc -j 1 --pieces=3 \
  -S 'curve[1][1][1]=-1,-2' chain.json
exhaust 'cubics along a curve, two threads' lines tc -j 2 \
  '--curve=[[0,0],[1,2],[3,-2],[4,0]]' -S tolerance=0.1,0.01 empty.json
printf '%s' '{"points":[[252,62,92],[266,65,91]],"rulings":[[-0.12,0.24,0.96],' \
  '[-0.18,0.16,0.97]],"tangents":[[0.99218,0.071478,0.106153],' \
  '[0.884954,0.454894,0.089184]],"method":"atph","apexes":[-30,70],' \
  '"height":[-1,1]}' >general.json
exhaust 'general cones' lines cone -j 1 -n 2 --tolerance=0.1 general.json
printf '%s' '{"points":[[1,1,1],[1,1,-1],[1,-1,-1],[1,-1,1],[-1,1,1],' \
  '[-1,1,-1],[-1,-1,-1],[-1,-1,1]],"faces":[[0,3,2,1],[4,5,6,7],[0,1,5,4],' \
  '[3,7,6,2],[0,4,7,3],[1,2,6,5]]}' >cube.json
exhaust 'surfaces over a mesh' lines bubble -j 1 cube.json
printf '%s' '{"type":"Feature","id":3,"properties":{"a":[1]},"geometry":{' \
  '"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,0],[3,3]]]}}' \
  >lines.geojson
exhaust 'GeoJSON' lines planar -j 1 lines.geojson
exhaust 'NURBS' lines planar -j 1 -d 0.1 --nurbs lines.geojson
exhaust 'places' lines planar -j 1 --at=0.1,-0.1 lines.geojson
exhaust 'samples' lines planar -j 1 -n 2 some.jsonl
exhaust 'samples of atph' lines planar -j 1 -n 2 atph.json
exhaust 'samples in space' lines spatial-hermite -j 1 -n 2 space.json
exhaust 'samples with lengths' lines arclength -j 1 -n 2 lengths.jsonl
exhaust '-v' lines planar -j 1 -v --strict some.jsonl
exhaust '--pretty' pretty planar -j 1 --pretty -q array.json
exhaust 'help' text planar --help
exhaust 'help for the program' text --help
exhaust 'the version' text --version
exhaust 'a usage error' text planar --nosuch
exhaust 'a file that is not there' text planar -j 1 nosuch.json
file=d/file
exhaust 'a file' lines planar -j 1 -o d/file some.jsonl
exhaust 'a file, two threads' lines planar -j 2 -o d/file some.jsonl
exhaust 'a table in a file' lines planar -j 1 -f csv -o d/file some.csv
if "$PHSPLINE" planar -p x.svg </dev/null 2>err; then
  ln -s d/file figure.svg
  ln -s d/file figure.png
  exhaust 'a figure' lines planar -j 1 -q -p figure.svg -d 0.1 some.jsonl
  exhaust 'a figure of a sweep, two threads' lines planar -j 2 -p figure.svg \
    -S 'knots=[0,1,2],uniform' some.jsonl
  exhaust 'a figure of vectors in space' lines spatial-hermite -j 1 \
    -p figure.png shapes.jsonl
  exhaust 'a figure on a sphere' lines sphere -j 1 -q -p figure.svg sphere.csv
else
  echo 'skip figures: built without cairo'
fi

# verification: results with and without their problems, and texts that are none
file=
export PH_FAIL_AT=-1
"$PHSPLINE" planar -q -d 0.1 -n 1 some.jsonl >results.jsonl 2>/dev/null
"$PHSPLINE" planar -q -S knots=uniform,chordal some.csv >swept.jsonl 2>/dev/null
"$PHSPLINE" tc --blaschke=true space.csv >bad.jsonl 2>/dev/null
printf '%s\n' '{"points":[]}' '{"segments":1}' >>bad.jsonl
exhaust 'verification' lines verify -j 1 results.jsonl bad.jsonl
exhaust 'verification, two threads' lines verify -j 2 results.jsonl
exhaust 'verification, with problems' lines verify -j 1 --problems=some.jsonl \
  results.jsonl
exhaust 'verification of a sweep' lines verify -j 1 --problems=some.csv \
  --set=closed=false swept.jsonl
sed -n '1p;1p;1p' results.jsonl >three.jsonl
alone 'verification, of the record in the middle' verify -j 1 three.jsonl
