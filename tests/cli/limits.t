# SPDX-License-Identifier: GPL-3.0-or-later
#
# What a record may take: samples, memory, time.  One that reaches a limit is an
# error record that names it; the others are what they would have been.
. "$srcdir/tests/cli/lib.sh"

# beside NAME MESSAGE ARGUMENT...: of three problems the one in the middle, wide,
# reaches a limit, with one thread and with two
printf '%s\n' "$good" '{"id":"wide","points":[[0,0],[9e5,1]],"meta":7}' \
  "$good" >three.jsonl
beside() {
  name=$1 message=$2
  shift 2
  run planar "$@" good.jsonl
  mv out plain.out
  for jobs in 1 2; do
    run planar -j "$jobs" "$@" three.jsonl
    expect "$name, --jobs=$jobs" 1 \
      "phspline: three.jsonl:2: record wide: $message [limit]
$(failed 1 3)"
    {
      cat plain.out
      printf '{"id":"wide","command":"planar","status":"error","meta":7,%s' \
        '"error":{"code":"limit","message":"'
      printf '%s","file":"three.jsonl","line":2}}\n' "$message"
      cat plain.out
    } >want
    equal_files "$name, --jobs=$jobs: the records" want out
  done
}
printf '%s\n' "$good" >good.jsonl

# ---- samples -----------------------------------------------------------------

many='samples 0.1 apart would be 9e+06 or more, above the 1000 of --max-samples'
beside '--max-samples, by spacing' "$many" --spacing=0.1 --max-samples=1000
beside '--max-samples=1e3' "$many" --spacing=0.1 --max-samples=1e3
feed "$good" planar --chord-error=1e-12 --max-samples=1000
expect 'more chords than there may be' 1 "phspline: -:1: record 1: chords within \
1e-12 of the curve take more samples than the 1000 of --max-samples [limit]
$(failed 1 1)"
feed "$good" planar -n 3 --max-samples=8
expect 'as many samples as there may be' 0 ''
feed "$good" planar -n 3 --max-samples=7
expect 'one more' 1 "phspline: -:1: record 1: the samples would be 8, above the \
7 of --max-samples [limit]
$(failed 1 1)"
feed "$good" planar -n 3 -d 0.1 --max-samples=7
expect 'the same of an offset' 1 "phspline: -:1: record 1: the samples would be \
8, above the 7 of --max-samples [limit]
$(failed 1 1)"

# ---- memory ------------------------------------------------------------------

beside '--max-memory' \
  "the record takes $(
    run planar --spacing=0.1 --max-memory=100M three.jsonl
    sed -n 's/.*takes \([0-9]*\) bytes.*/\1/p' err
  ) bytes of memory or more, above the 104857600 of --max-memory" \
  --spacing=0.1 --max-memory=100M
beside '--max-memory, of text' \
  'the record takes more bytes of memory, with its result as text, than the 1048576 of --max-memory' \
  --spacing=100 --max-memory=1M

# Whether a record keeps to the limit does not depend on those before it.
awk 'BEGIN {
  for (k = 0; k < 300; k++) {
    printf "{\"points\":["
    for (i = 0; i < 2 + k % 40 * 4; i++) printf "%s[%d,%d]", i ? "," : "", i, i % 2
    print "]}"
  }
}' >sizes.jsonl
run planar -q -j 1 --max-memory=40K sizes.jsonl
mv out one.out
true_that 'some records keep to 40K' grep -q '"status":"ok"' one.out
true_that 'some do not' grep -q '"code":"limit"' one.out
run planar -q -j 3 --max-memory=40K sizes.jsonl
equal_files 'the same ones with three threads' one.out out
i=0
while IFS= read -r line && [ "$i" -lt 40 ]; do
  i=$((i + 1))
  printf '%s\n' "$line" >alone.jsonl
  run planar -q --max-memory=40K alone.jsonl
  sed -n "${i}p" one.out | sed "s/sizes.jsonl/alone.jsonl/;s/\"line\":$i}/\"line\":1}/" >want
  cmp -s want out || break
done <sizes.jsonl
equal 'the same ones alone' 40 "$i"

# Memory that the system refuses is the failure of that record alone.
# shellcheck disable=SC3045  # as the next line says
if (ulimit -v 250000 && "$PHSPLINE" --version) >out 2>err; then (
  ulimit -v 250000
  for jobs in 1 2; do
    run planar -j $jobs --spacing=0.2 --max-memory=100G three.jsonl
    expect "memory is exhausted, --jobs=$jobs" 1 \
      "phspline: three.jsonl:2: record wide: memory is exhausted [out-of-memory]
$(failed 1 3)"
    equal "memory is exhausted, --jobs=$jobs: the records" \
      '"ok" "error" "ok"' "$(get status)"
  done
) else
  echo 'skip memory that is exhausted: the shell cannot limit that of the program'
fi
run planar --fail-fast --max-memory=1M --spacing=100 three.jsonl
expect '--fail-fast ends at a limit' 1 \
  "phspline: three.jsonl:2: record wide: the record takes more bytes of memory, \
with its result as text, than the 1048576 of --max-memory [limit]
$(failed 1 2)"

# ---- text --------------------------------------------------------------------

# A record whose text is too long is none that anybody keeps: those beside it
# are what they would have been, in every format.
over='the record is longer than the 60 bytes of --max-record-bytes'
# one ID LENGTH: a problem of so many bytes
one() {
  printf '{"id":"%s","points":[[0,0],[1,1]],"meta":"%0*d"}' "$1" \
    $(($2 - 42 - ${#1})) 0
}
# texts FORMAT LENGTH...: a stream of problems of so many bytes
texts() {
  format=$1 n=0
  shift
  for length; do
    n=$((n + 1))
    case $format,$n in
    array,1) printf '[' ;;
    array,* | csv,1) printf '%s' "${separator-,}" ;;
    esac
    one "k$n" "$length"
    test "$format" != lines || echo
  done
  test "$format" != array || printf ']'
}
for format in lines array joined; do
  for lengths in '61 59 60' '59 61 60' '59 60 61' '61 61 61'; do
    # shellcheck disable=SC2086  # several lengths
    texts $format $lengths >texts.json
    # shellcheck disable=SC2086
    set -- $lengths
    run planar -j 1 --max-record-bytes=60 texts.json
    equal "$format of $lengths: status" 1 "$status"
    mv out one.out
    mv err one.err
    for k in 1 2 3; do
      length=$1 line=1
      shift
      test "$format" != lines || line=$k
      if [ "$length" -gt 60 ]; then
        printf '{"id":"k%s","command":"planar","status":"error","error":{"code":' $k
        printf '"limit","message":"%s","file":"texts.json","line":%s}}\n' \
          "$over" $line
        echo "phspline: texts.json:$line: record k$k: $over [limit]" >&3
      else
        one k$k "$length" | "$PHSPLINE" planar
      fi
    done >want 3>want.err
    {
      failed "$(grep -c . want.err)" 3
      echo
    } >count.err
    cat count.err >>want.err
    equal_files "$format of $lengths: the records" want one.out
    equal_files "$format of $lengths: the messages" want.err one.err
    run planar -j 3 --max-record-bytes=60 texts.json
    equal_files "$format of $lengths: with three threads" one.out out
  done
done
printf 'id,x,y\na,0,0\na,1,1\nb,0,0\nb,1,1\nb,2,0\nc,0,0\nc,1,1\n' >rows.csv
run planar --max-record-bytes=12 rows.csv
equal 'CSV: the records' '"ok" "error" "ok"' "$(get status)"
equal 'CSV: the ids' '"a" "b" "c"' "$(get id)"
equal 'CSV: the message' "phspline: rows.csv:4: record b: the record is longer \
than the 12 bytes of --max-record-bytes [limit]
$(failed 1 3)" "$(cat err)"
run planar --fail-fast --max-record-bytes=12 rows.csv
equal 'CSV: --fail-fast' '"ok" "error"' "$(get status)"
run planar --max-record-bytes=18 rows.csv
expect 'CSV: as long as they may be' 0 ''
run planar --max-memory=60 texts.json
equal 'what --max-memory says counts for text' '"limit" "limit" "limit"' \
  "$(get error.code)"

# ---- time --------------------------------------------------------------------

beside '--time-limit' \
  'the record takes longer than the 0.05 seconds of --time-limit' \
  --spacing=0.1 --time-limit=0.05
run planar --time-limit=1000 good.jsonl
mv out late.out
run planar good.jsonl
equal_files 'results do not depend on the limit' out late.out

# used: the processor time of all runs so far, in milliseconds
used() {
  times >times.out
  sed -n 2p times.out | tr 'ms' '  ' |
    awk '{ printf "%d\n", 60000 * ($1 + $3) + 1000 * ($2 + $4) }'
}

# hard NAME COMMAND EASY HARD ARGUMENT...: between two records that are easy one
# that would take 2 seconds and more ends soon after its time, wherever it is
hard() {
  name=$1 command=$2
  printf '%s\n' "$3" "$4" "$3" >hard.json
  shift 4
  began=$(used)
  run "$command" -j 1 --time-limit=0.5 "$@" hard.json
  took=$(($(used) - began))
  expect "$name" 1 "phspline: hard.json:2: record 2: the record takes longer \
than the 0.5 seconds of --time-limit [limit]
$(failed 1 3)"
  equal "$name: the records" '"ok" "error" "ok"' "$(get status)"
  true_that "$name: it ends soon, after $took ms" [ $took -lt 1500 ]
}

# zigzag N DIMENSION, ball N: problems
zigzag() {
  awk -v n="$1" -v d="$2" 'BEGIN {
    printf "{\"points\":["
    for (i = 0; i < n; i++) {
      printf "%s[%.9g,%.9f", i ? "," : "", i / 10, 20 * sin(i * i / 9)
      printf "%s]", d == 3 ? sprintf(",%.9f", 9 * cos(i * i / 7)) : ""
    }
    print "]}"
  }'
}
ball() {
  awk -v n="$1" 'BEGIN {
    printf "{\"lonlat\":["
    for (i = 0; i < n; i++) printf "%s[%.9f,%.9f]", i ? "," : "", 300 * i / n, \
      20 * sin(i)
    print "]}"
  }'
}
space='{"points":[[0,0,0],[1,1,0],[2,0,1]]}'
sphere='{"lonlat":[[0,0],[20,10],[40,0]]}'
curve='{"curve":[[0,0],[1,1],[2,0],[3,1]]}'
hard 'planar, all solutions' planar "$good" "$(zigzag 13 2)" --solutions=all
hard 'planar, the fairest' planar "$good" "$(zigzag 3000 2)" --minimize=IES
line='{"points":[[0,0],[1,1]]}'
hard 'planar, chords' planar "$line" "$(zigzag 3000 2)" --chord-error=1e-12 \
  --max-samples=1e9
hard 'planar, chords of offsets' planar "$line" "$(zigzag 3000 2)" -d 0.1 \
  --chord-error=1e-12 --max-samples=1e9
two='{"points":[[0,0,0],[1,1,1]]}'
hard 'in space, F1' spatial-hermite "$two" "$(zigzag 3000 3)" --criterion=F1
hard 'in space, F3 and alpha' spatial-hermite "$two" "$(zigzag 3000 3)" \
  --criterion=F3 --basis=atph
hard 'lengths' arclength "$space" "$(zigzag 6000 3)" --refine=3
hard 'lengths, all minima' arclength "$space" "$(zigzag 300 3)" --all_minima \
  --starts=30
hard 'sphere' sphere "$sphere" "$(ball 3000)"
hard 'sphere, nielson' sphere "$sphere" "$(ball 3000)" --model=nielson
hard 'sphere, increases' sphere "$sphere" "$(ball 3000)" --increase=plus:0.01 \
  --shape=warn
hard 'cubics near a curve' tc "$curve" \
  "$(zigzag 400 2 | sed 's/points/curve/')" --mode=approximate \
  --tolerance=1e-10
mv hard.json problems.json
run tc --mode=approximate --tolerance=0.03 problems.json
hard 'verify cubics near a curve' verify "$(sed -n 1p out)" "$(sed -n 2p out)" \
  --problems=problems.json

# ---- verify ------------------------------------------------------------------

run planar -n 1000 good.jsonl
mv out result.jsonl
run verify --max-memory=10K result.jsonl
equal 'verify --max-memory: status' 1 "$status"
equal 'verify --max-memory: code' '"limit"' "$(get error.code)"
run verify --time-limit=1e-9 result.jsonl
expect 'verify --time-limit' 1 "phspline: result.jsonl:1: record 1: the record \
takes longer than the 1e-09 seconds of --time-limit [limit]
$(failed 1 1)"
printf '{"id":2,"points":[[0,0],[1,1]]}\n' >two.jsonl
sed 's/{/{"id":1,/' good.jsonl >one.jsonl
cat one.jsonl two.jsonl >both.jsonl
{
  run planar -n 1000 one.jsonl
  cat out
  run planar two.jsonl
  cat out
} >results.jsonl
run verify --max-record-bytes=2K results.jsonl
equal 'verify --max-record-bytes' '"error" "ok"' "$(get status)"
equal 'verify --max-record-bytes: id, code' '1 2 "limit" absent' \
  "$(get id) $(get error.code)"
run verify --max-record-bytes=2K --problems=both.jsonl results.jsonl
equal 'verify --max-record-bytes: the problem of the next one' '"error" "ok"' \
  "$(get status)"
equal 'verify --max-record-bytes: its own' \
  "phspline: results.jsonl:1: record 1: the record is longer than the 2048 bytes \
of --max-record-bytes [limit]
$(failed 1 2)" "$(cat err)"
run verify --max-record-bytes=1M --problems=both.jsonl results.jsonl
expect 'verify --max-record-bytes: enough' 0 ''
run verify --max-memory=1G --time-limit=1000 result.jsonl
expect 'verify within its limits' 0 ''

# ---- values ------------------------------------------------------------------

# bad_value OPTION WHAT VALUE...: none of the values is one
bad_value() {
  option=$1 what=$2
  shift 2
  for value; do
    run planar "--$option=$value" good.jsonl
    expect "--$option=$value" 2 "phspline: --$option must be $what, found \
'$value'
Try 'phspline planar --help'." ''
  done
}
bad_value max-samples 'a whole number from 1 to 1000000000' \
  0 -1 nan inf 1.5 1e10 1e400 1K '' x
bad_value max-memory \
  'a whole number of bytes from 1 to 1e+15, or one of K, M or G' \
  0 -1 nan inf 0.5 1e16 1e400 1.0001K 1k 1KK K 1MB '' x
bad_value max-record-bytes \
  'a whole number of bytes from 1 to 1e+15, or one of K, M or G' 0 -1 1.0001K x
bad_value time-limit 'a number greater than 0' 0 -1 nan inf 1e400 1s '' x
for value in 1000000 1e6 1000K 1.5M 1G 0.5G; do
  run planar --max-memory=$value good.jsonl
  expect "--max-memory=$value" 0 ''
done
run verify --max-samples=5 result.jsonl
expect 'verify takes no samples' 2 "phspline: verify has no option \
'--max-samples'
Try 'phspline verify --help'." ''
