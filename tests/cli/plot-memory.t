# SPDX-License-Identifier: GPL-3.0-or-later
#
# --plot: what becomes of the results when drawing fails.  cairo and what it
# calls crash or hang where malloc fails; the results must be whole, the old
# figure must stay, no temporary file may, and the status is 5.
. "$srcdir/tests/cli/lib.sh"

printf '%s\n' "$good" >good.jsonl
if ! "$PHSPLINE" planar -p want.svg good.jsonl >want.out 2>err; then
  echo 'skip figures: built without cairo'
  exit
fi

# fresh: a directory with an old figure
fresh() {
  rm -rf d
  mkdir d
  echo old >d/x.svg
}

# verdict: what is wrong with a run to d/out and d/x.svg that may have failed;
# nothing, if it ended as it may
verdict() {
  cmp -s want.out d/out || echo "other results, status $status"
  [ "$(cd d && echo *)" = 'out x.svg' ] || echo "there is more: $(ls -A d)"
  case $status:$(tail -n 1 err) in
  0:*)
    tail -n 1 d/x.svg | grep -q '</svg>' || echo 'half a figure'
    return
    ;;
  "5:phspline: memory is exhausted") ;;
  "5:phspline: cannot draw d/x.svg: not done after 600 s; $whole") ;;
  "5:phspline: cannot draw d/x.svg: drawing was ended by signal "*" (\
"*"), as it is when memory is exhausted; $whole") ;;
  *) echo "status $status: $(cat err)" ;;
  esac
  [ "$(cat d/x.svg)" = old ] || echo 'the old figure is gone'
}
whole='the results are whole'

# limit_memory KILOBYTES: an extension that most shells have
limit_memory() {
  # shellcheck disable=SC3045
  ulimit -v "$1" 2>cmd.out
}

# ---- allocation number N of drawing fails ------------------------------------

# A library in the place of malloc, for the process that draws only; there, a
# hang ends after 2 seconds.
cat >fail.c <<'END'
#define _GNU_SOURCE
#include <pthread.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);

static int drawing;
static long count, limit;

static int fails(void) {
  long n = drawing ? count++ : -1;
  return n == limit || (n > limit && getenv("FAIL_ON"));
}

void *malloc(size_t n) { return fails() ? NULL : __libc_malloc(n); }

void *calloc(size_t k, size_t n) {
  return fails() ? NULL : __libc_calloc(k, n);
}

void *realloc(void *p, size_t n) {
  return fails() ? NULL : __libc_realloc(p, n);
}

unsigned alarm(unsigned seconds) {
  struct itimerval timer = {{0, 0}, {seconds < 2 ? seconds : 2, 0}};
  setitimer(ITIMER_REAL, &timer, NULL);
  return 0;
}

static void begin(void) { drawing = 1; }

__attribute__((constructor)) static void prepare(void) {
  limit = atol(getenv("FAIL_AT") ? getenv("FAIL_AT") : "-2");
  pthread_atfork(NULL, NULL, begin);
}
END

# exhaust NAME: all N, in steps
exhaust() {
  n=0 runs=0 died=0 why=
  while [ "$n" -le 12000 ] && [ -z "$why" ]; do
    fresh
    status=0
    env FAIL_AT=$n LD_PRELOAD="$PWD/fail.so" "$PHSPLINE" planar -o d/out \
      -p d/x.svg good.jsonl 2>err || status=$?
    why=$(verdict)
    runs=$((runs + 1))
    case $(cat err) in *'ended by'* | *'not done'*) died=$((died + 1)) ;; esac
    n=$((n + 1 + n / 3))
  done
  equal "$1: $runs of 12000 allocations" '' "${why:+allocation $n: $why}"
  true_that "$1: some crash or hang" [ "$died" -gt 0 ]
}

case ${COMPILE-} in
*-fsanitize*) echo 'skip malloc: it is the sanitizer'"'"'s' ;;
*)
  if ${CC:-cc} -shared -fPIC -o fail.so fail.c -pthread 2>cmd.out &&
    env LD_PRELOAD="$PWD/fail.so" "$PHSPLINE" --version >cmd.out 2>&1; then
    exhaust 'malloc fails once'
    export FAIL_ON=1
    exhaust 'malloc fails from then on'
    unset FAIL_ON
  else
    echo 'skip malloc: no way here to take its place'
  fi
  # whether the results alone fit into so much
  why='' limit=20000 runs=0 status=5
  while [ "$limit" -lt 400000 ] && [ -z "$why" ]; do
    fresh
    if (
      limit_memory "$limit"
      "$PHSPLINE" planar -j 1 good.jsonl
    ) >cmd.out 2>&1; then
      (
        limit_memory "$limit"
        run planar -j 1 -o d/out -p d/x.svg good.jsonl
        verdict >why
        echo "$status" >last
      )
      why=$(cat why) runs=$((runs + 1))
      if [ "$(cat last)" = 0 ]; then
        break
      fi
    fi
    limit=$((limit + limit / 16))
  done
  equal "ulimit -v: $runs limits" '' "${why:+limit $limit: $why}"
  equal 'ulimit -v: enough in the end' 0 "$(cat last)"
  ;;
esac

# ---- the process that draws is killed ----------------------------------------

# While it waits for the reader of a figure that is larger than a pipe.
awk 'BEGIN { for (i = 0; i < 40; i++)
  print "{\"points\":[[0,0],[1,1],[" i ",0],[3,1],[4,3]]}" }' >long.jsonl
"$PHSPLINE" planar -q long.jsonl >want.out
mkfifo pipe.svg

# children PID: the processes that it has started
children() {
  ps -A -o pid= -o ppid= | awk -v parent="$1" '$2 == parent { print $1 }'
}

# until COMMAND...: within a minute
until_true() {
  tries=0
  while ! "$@" && [ "$tries" -lt 600 ]; do
    tries=$((tries + 1))
    sleep 0.1
  done
}

is_drawing() {
  child=$(children "$pid")
  [ -s d/out ] && [ -n "$child" ]
}

is_gone() {
  case $(ps -o stat= -p "$1") in '' | Z*) ;; *) false ;; esac
}

# killed NAME WHOM SIGNAL STATUS MESSAGE: child or parent
killed() {
  fresh
  exec 5<>pipe.svg
  defaults "$PHSPLINE" planar -q -o d/out -p pipe.svg long.jsonl 2>err &
  pid=$!
  until_true is_drawing
  case $2 in child) kill -s "$3" "$child" ;; *) kill -s "$3" "$pid" ;; esac
  status=0
  wait "$pid" 2>cmd.out || status=$?
  until_true is_gone "$child"
  exec 5>&-
  equal "$1: status and message" "$4 $5" "$status $(cat err)"
  equal_files "$1: the results" want.out d/out
  true_that "$1: no process is left" is_gone "$child"
}

if ! ps -A -o pid= -o ppid= >cmd.out 2>&1; then
  echo 'skip processes that are killed: no ps'
else
  ended='phspline: cannot draw pipe.svg: drawing was ended by signal'
  as="as it is when memory is exhausted; $whole"
  killed 'SIGKILL' child KILL 5 "$ended 9 (Killed), $as"
  killed 'SIGALRM' child ALRM 5 \
    "phspline: cannot draw pipe.svg: not done after 600 s; $whole"
  case $(uname):${COMPILE-} in
  Linux:*-fsanitize*) ;;
  Linux:*)
    killed 'SIGSEGV' child SEGV 5 "$ended 11 (Segmentation fault), $as"
    killed 'SIGTERM to the program' parent TERM 143 ''
    killed 'SIGKILL to the program' parent KILL 137 ''
    ;;
  esac
  killed 'SIGPIPE' child PIPE 141 ''
fi

# ---- where nobody is told of the end of processes ----------------------------

status=0
sh -c 'trap "" CHLD; exec "$@"' sh "$PHSPLINE" planar -p x.svg good.jsonl \
  >out 2>err || status=$?
expect 'SIGCHLD is ignored' 0 ''
equal_files 'SIGCHLD is ignored: the figure' want.svg x.svg
