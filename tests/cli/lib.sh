# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the shell tests share; each reads it with `. "$srcdir/tests/cli/lib.sh"'.
# It runs the program, compares, and prints the lines that tests/run counts.
# Needs what tests/run gives: PHSPLINE, the helper programs on PATH, an empty
# directory.
#
# shellcheck disable=SC2034  # what is set here is used there
set -u

# ---- verdicts ----------------------------------------------------------------

# pass NAME, fail NAME WHY
pass() {
  printf 'ok %s\n' "$1"
}

fail() {
  printf 'not ok %s: %s\n' "$1" "$2"
}

# shown NAME TEXT: its lines, none of which begins as those do that are counted.
shown() {
  printf '%s\n' "$2" | sed "s/^/  $1: /" | cut -c 1-1000 | sed -n '1,20p'
}

# equal NAME WANTED FOUND: two texts.
equal() {
  if [ "$2" = "$3" ]; then
    pass "$1"
  else
    fail "$1" 'not what was wanted'
    shown wanted "$2"
    shown found "$3"
  fi
}

# same_records A B: two files, byte by byte, but for the member of results that
# says which file their problem is in.
same_records() {
  cmp "$1" "$2" >cmp.out 2>&1 && return
  for file in "$1" "$2"; do
    sed 's/\("status":"ok"\),"file":"[^"]*"/\1/' "$file" >"$file.nofile"
  done
  cmp "$1.nofile" "$2.nofile" >cmp.out 2>&1
  same=$?
  rm -f "$1.nofile" "$2.nofile"
  return $same
}

# equal_files NAME WANTED FOUND: two files, as same_records compares them.
equal_files() {
  if same_records "$2" "$3"; then
    pass "$1"
  else
    fail "$1" "$(cat cmp.out)"
    diff "$2" "$3" | sed -n '1,6p' | cut -c 1-300
  fi
}

# equal_but_set NAME WANTED FOUND: the same of records, whatever options set.
equal_but_set() {
  for file in "$2" "$3"; do
    sed 's/,"set":{[^}]*}//' "$file" >"$file.set"
  done
  equal_files "$1" "$2.set" "$3.set"
}

# numbers NAME TOLERANCE WANTED FOUND: two files, numbers by tolerance.
numbers() {
  if numcmp "$2" "$3" "$4" >cmp.out 2>&1; then
    pass "$1"
  else
    fail "$1" "they differ by more than $2"
    sed 's/^/  /' cmp.out
  fi
}

# true_that NAME COMMAND...: the command succeeds.
true_that() {
  name=$1
  shift
  if "$@" >cmd.out 2>&1; then
    pass "$name"
  else
    fail "$name" "status $? of: $*"
    sed 's/^/  /' cmd.out
  fi
}

# ---- where every step takes long ---------------------------------------------

# one_in COUNT: of COUNT calls the last is true where PH_SHORT=1, elsewhere all
# are.  Calls are counted through the whole test: what a loop leaves out in one
# round, it does in another, if COUNT and the length of the loop have no common
# divisor.
calls=0
one_in() {
  [ "${PH_SHORT-}" = 1 ] || return 0
  calls=$((calls + 1))
  [ $((calls % $1)) -eq 0 ]
}

# ---- the program -------------------------------------------------------------

# run ARGUMENT...: the program, with the standard input of the function; sets
# status and the files out and err.
run() {
  status=0
  "$PHSPLINE" "$@" >out 2>err || status=$?
}

# feed TEXT ARGUMENT...: the same with a text on standard input.  (A pipe into
# run would take it, and its status, to another shell.)
feed() {
  printf '%s' "$1" >in
  shift
  run "$@" <in
}

# expect NAME STATUS [STDERR [STDOUT]]: what the last run did, to the byte; a
# text is without its last line break, stdout is not looked at if not given.
expect() {
  why=
  if [ "$status" -ne "$2" ]; then
    why="exit status $status, wanted $2"
  elif [ -n "${3-}" ] || [ -s err ] && [ "$(cat err)" != "${3-}" ]; then
    why='standard error'
  elif [ $# -gt 3 ] && [ "$(cat out)" != "$4" ]; then
    why='standard output'
  fi
  if [ -z "$why" ]; then
    pass "$1"
  else
    fail "$1" "$why"
    shown wanted "${3-}"
    shown stderr "$(cat err)"
    if [ $# -gt 3 ]; then
      shown wanted "$4"
      shown stdout "$(cat out)"
    fi
  fi
}

# accepted COMMAND NAME OPTION...: the problem on standard input is solved, and
# its result passes verification; they stay in any.json and any.result.
accepted() {
  _command=$1 _name=$2
  shift 2
  cat >any.json
  run "$_command" -q "$@" any.json
  expect "$_name" 0
  cp out any.result
  run verify -q --problems=any.json any.result
  expect "$_name, verified" 0
}

# count LINES FILE: whether the file has so many lines.
count() {
  [ "$(wc -l <"$2")" -eq "$1" ]
}

# get PATH: of each record in out, with blanks for line breaks.
get() {
  json row "$1" out
}

# table PATH...: of each record in out a line, with tabs between its values.
table() {
  : >table.out
  for path; do
    json get "$path" out | paste table.out - >table.next
    mv table.next table.out
  done
  cut -f 2- table.out
}

# floats PATH: the numbers at a path of out, one on a line
floats() {
  json get "$1" out | tr -d '[]' | tr ',' '\n'
}

# shape_of PATH: of the first value there
shape_of() {
  json get "$1" out | json shape
}

# holds NAME CONDITION: of the numbers on standard input, one on a line: as x[1]
# to x[n] of awk
holds() {
  if awk "{ x[NR] = \$1 + 0 } END { n = NR; exit !($2) }"; then
    pass "$1"
  else
    fail "$1" "not so: $2"
  fi
}

# ---- data --------------------------------------------------------------------

# A problem that can be solved, one that cannot, and what is said about it.
good='{"points":[[0,0],[1,1],[2,0]]}'
bad='{"points":[[0,0],[0,0]]}'
joins='; --merge=D joins points nearer than D'
bad_says="points[1]: coincides with points[0]$joins [coincident-points]"

# walk SEED N: the first N points of a walk with sharp and with slight turns, as
# CSV.
walk() {
  awk -v seed="$1" -v n="$2" 'BEGIN {
    for (i = 0; i < n; i++) {
      turn = -1.8
      for (k = 0; k < 12; k++) {
        seed = (seed * 16807) % 2147483647
        turn += .3 * seed / 2147483647
      }
      a += turn
      printf "%.6f,%.6f\n", x += cos(a), y += sin(a)
    }
  }'
}

# failed N M: the last line on standard error.
failed() {
  printf 'phspline: %s of %s records failed' "$1" "$2"
}

# ---- circumstances -----------------------------------------------------------

# Whether the program is slowed down and fattened by a sanitizer or valgrind.
instrumented() {
  grep -q -e __asan_init -e __tsan_init -e valgrind "$PHSPLINE"
}

# limited COMMAND...: ended after a minute if it does not end by itself.
limited() {
  if command -v timeout >/dev/null 2>&1; then
    timeout -k 5 60 "$@"
  else
    "$@"
  fi
}
