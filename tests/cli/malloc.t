# SPDX-License-Identifier: GPL-3.0-or-later
#
# Memory that gives out in libraries: GSL, expat and cJSON ask malloc, which the
# program's own allocations (tests/fault/alloc.t) do not cover.  One call of
# malloc fails, or all after it; a run ends as if none had, or says that memory
# is exhausted: never by a signal, and never with another curve.
. "$srcdir/tests/cli/lib.sh"

cat >fail.c <<'END'
#include <errno.h>
#include <stdlib.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);

static long count, limit = -1;
static int on, begun;

static int fails(void) {
  long n = begun ? __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED) : 0;
  if (n > 0 && (n == limit || (on && limit > 0 && n > limit))) {
    errno = ENOMEM; /* pthread_create wants to see it */
    return 1;
  }
  return 0;
}

void *malloc(size_t n) { return fails() ? NULL : __libc_malloc(n); }

void *calloc(size_t k, size_t n) {
  return fails() ? NULL : __libc_calloc(k, n);
}

void *realloc(void *p, size_t n) {
  return fails() ? NULL : __libc_realloc(p, n);
}

__attribute__((constructor)) static void prepare(void) {
  const char *at = getenv("FAIL_AT");
  limit = at ? atol(at) : -1;
  on = getenv("FAIL_ON") != NULL;
  begun = 1;
}
END

# judge: what is wrong with the last run; nothing, if it ended as it may
judge() {
  if [ "$status" -gt 5 ]; then
    echo "status $status"
  elif grep -q 'memory is exhausted\|out-of-memory' out err; then
    [ "$status" -ne 0 ] || echo 'status 0, but memory was exhausted'
  elif [ "$status" -ne 0 ]; then
    echo "status $status, and no word of memory: $(sed -n 1p err)"
  elif ! cmp -s good.out out; then
    echo 'other results'
  fi
}

# exhaust NAME ARGUMENT...: calls that fail are near to each other first
exhaust() {
  name=$1
  shift
  "$PHSPLINE" "$@" >good.out 2>err </dev/null || fail "$name" "$(cat err)"
  n=1 runs=0 told=0 why=
  while [ "$n" -le 3000 ] && [ -z "$why" ]; do
    status=0
    env FAIL_AT="$n" LD_PRELOAD="$PWD/fail.so" "$PHSPLINE" "$@" >out 2>err \
      </dev/null || status=$?
    why=$(judge)
    runs=$((runs + 1))
    [ "$status" -eq 0 ] || told=$((told + 1))
    n=$((n + 1 + n / 5))
  done
  equal "$name: $runs runs" '' "${why:+call $n or before: $why}"
  true_that "$name: some fail" [ "$told" -gt 0 ]
}

case ${COMPILE-} in
*-fsanitize*)
  echo 'skip malloc: it is the sanitizer'"'"'s'
  exit
  ;;
esac
if grep -q valgrind "$PHSPLINE" ||
  ! ${CC:-cc} -shared -fPIC -o fail.so fail.c 2>cmd.out ||
  ! env LD_PRELOAD="$PWD/fail.so" "$PHSPLINE" --version >cmd.out 2>&1; then
  echo 'skip malloc: no way here to take its place'
  exit
fi

cat >cube.obj <<'END'
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
END
printf 'x,y\n0,0\n1,1\n2,0\n3,3\n2,5\n-1,2\n' >turning.csv

# enough that both threads have parts of it: segments, crossings, text
awk 'BEGIN {
  print "x,y"
  for (i = 0; i < 9000; i++) printf "%d,%.3f\n", i % 2 ? i + 3 : i, 9 * sin(i / 9)
}' >long.csv

exhaust 'bubble' bubble -j 1 cube.obj
exhaust 'planar, two threads' planar -j 2 -q --fields=length,diagnostics long.csv
exhaust 'tc g2' tc -j 1 -q --mode=g2 turning.csv
xml=
if "$PHSPLINE" sphere -q "$srcdir/data/walk.gpx" >cmd.out 2>&1; then
  xml=1
  exhaust 'GPX' sphere -j 1 -q "$srcdir/data/walk.gpx"
else
  echo 'skip GPX: built without expat'
fi
export FAIL_ON=1
exhaust 'bubble, from then on' bubble -j 1 cube.obj
exhaust 'planar, two threads, from then on' planar -j 2 -q \
  --fields=length,diagnostics long.csv
exhaust 'tc g2, from then on' tc -j 1 -q --mode=g2 turning.csv
[ -z "$xml" ] || exhaust 'GPX, from then on' sphere -j 1 -q "$srcdir/data/walk.gpx"
