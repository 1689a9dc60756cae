# SPDX-License-Identifier: GPL-3.0-or-later
#
# Time that is over: at one look at the clock, whichever it is, of the record in
# the middle of a stream.  That record is an error record with the code limit,
# those beside it are what they would have been, and the sanitizers of this
# build have nothing to report.  Work that is long looks often.
. "$srcdir/tests/cli/lib.sh"

echo "$good" >good.json
PH_LATE_AT=0 "$PHSPLINE" planar --time-limit=1e9 good.json >out 2>err && {
  fail 'the build' 'no time is over in it'
  exit
}

# judge: sets why to what is wrong with the last run: one record or none failed
judge() {
  why=$(paste -d '\n' good.out out | awk -v status="$status" '
    NR % 2 { good = $0; next }
    $0 == good { next }
    /"status":"error"/ && /"code":"limit"/ { failed++; next }
    { print "record " NR / 2 ": " substr($0, 1, 200) }
    END {
      if (NR != 6) print "there are " NR / 2 " records"
      if (failed > 1 || status != (failed > 0)) {
        print failed + 0 " records failed, status " status
      }
    }')
  case $(cat err) in
  *Sanitizer* | *'runtime error'*) why="$why, a sanitizer reports" ;;
  esac
}

# From one look that is late to the next; larger where every step takes long.
growth=1
[ "${PH_SHORT-}" != 1 ] || growth=6

# late NAME LOOKS COMMAND EASY HARD ARGUMENT...: of three records the hard one in
# the middle looks at least so often.
late() {
  what=$1 least=$2 command=$3 n=0 bad_runs=0
  printf '%s\n' "$4" "$5" "$4" >three.json
  shift 5
  set -- "$command" -q -j 1 --time-limit=1e9 "$@" three.json
  run "$@"
  equal "$what: a good run" '"ok" "ok" "ok" 0' "$(get status) $status"
  mv out good.out
  while
    status=0
    PH_LATE_AT=$n "$PHSPLINE" "$@" >out 2>err || status=$?
    judge
    if [ -n "$why" ]; then
      bad_runs=$((bad_runs + 1))
      [ $bad_runs -gt 3 ] || fail "$what, look $n" "$why"
    fi
    [ $status -ne 0 ] && [ $n -lt 10000000 ]
  do
    n=$((n + 1 + n * growth / 2))
  done
  [ $bad_runs -gt 0 ] || pass "$what"
  true_that "$what: it looks at the clock $least times" [ $n -gt "$least" ]
}

# verified LOOKS ARGUMENT...: the same of the verification of these results
verified() {
  what="verify: $what" least=$1
  mv three.json problems.json
  sed -n 1p good.out >easy.out
  sed -n 2p good.out >hard.out
  late "$what" "$least" verify "$(cat easy.out)" "$(cat hard.out)" \
    --problems=problems.json
}

# walk N DIMENSION: points of a zigzag
walk() {
  awk -v n="$1" -v d="$2" 'BEGIN {
    printf "{\"points\":["
    for (i = 0; i < n; i++) {
      printf "%s[%d,%.9f", i ? "," : "", i, 3 * sin(i * i / 9)
      printf "%s]", d == 3 ? sprintf(",%.9f", 2 * cos(i * i / 7)) : ""
    }
    print "]}"
  }'
}
space='{"points":[[0,0,0],[1,1,0],[2,0,1]]}'
sphere='{"lonlat":[[0,0],[20,10],[40,0]]}'
bend='{"curve":[[0,0],[1,1],[2,0],[3,1]]}'
chain='{"curve":[[[0,0],[1,5],[2,-5],[3,0]],[[3,0],[4,6],[5,-5],[6,0]]]}'
ball=$(awk 'BEGIN {
  printf "{\"lonlat\":["
  for (i = 0; i < 40; i++) printf "%s[%d,%.9f]", i ? "," : "", i * 7, \
    20 * sin(i * i)
  print "]}"
}')

late 'planar' 40 planar "$good" "$(walk 40 2)"
late 'planar, all' 1000 planar "$good" "$(walk 7 2)" --solutions=all
late 'planar, the fairest' 100 planar "$good" "$(walk 12 2)" --minimize=IES
late 'planar, samples and offsets' 100 planar "$good" "$(walk 40 2)" \
  --chord-error=1e-4 -d 0.1
verified 100
late 'space' 40 spatial-hermite "$space" "$(walk 40 3)"
late 'space, F3' 200 spatial-hermite "$space" "$(walk 6 3)" --criterion=F3 \
  --frame=rmf -n 3
verified 100
late 'space, frame and offsets' 100 spatial-hermite "$space" "$(walk 40 3)" \
  --frame=rmf --spacing=0.1 -d 0.1
late 'lengths' 1000 arclength "$space" "$(walk 40 3)" -d 0.1 -n 3
verified 100
late 'lengths, all minima' 1000 arclength "$space" "$(walk 6 3)" --all_minima
late 'sphere' 1000 sphere "$sphere" "$ball" --shape=warn
late 'sphere, nielson' 1000 sphere "$sphere" "$ball" --model=nielson \
  --shape=warn
late 'sphere, offsets' 100 sphere "$sphere" "$ball" --shape=false -d 0.1 -n 3
verified 100
late 'cubics' 40 tc "$good" "$(walk 40 2)" --mode=spline
late 'cubics, all' 100 tc "$good" "$(walk 5 2)" --mode=spline --solutions=all
late 'cubics near a curve' 100 tc "$bend" "$chain" --mode=approximate \
  --tolerance=1e-4 --chord-error=1e-3
verified 100
