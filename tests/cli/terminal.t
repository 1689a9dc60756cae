# SPDX-License-Identifier: GPL-3.0-or-later
#
# At a terminal: no waiting for problems that nobody was asked to type, and a
# line of progress that leaves no trace.
. "$srcdir/tests/cli/lib.sh"

if ! limited terminal '' true >cmd.out 2>&1; then
  echo 'skip a terminal: this system gives none'
  exit 0
fi

# at_terminal TEXT ARGUMENT...: as run, with the text typed
at_terminal() {
  text=$1
  shift
  status=0
  limited terminal "$text" "$PHSPLINE" "$@" >out 2>err || status=$?
}

printf '%s\n' "$good" >good.jsonl
at_terminal '' planar
expect 'no file, but a terminal' 2 \
  "phspline: no FILE, and standard input is a terminal
Try 'phspline planar --help'." ''
at_terminal "$good
" planar -
expect 'a - is typed' 0 ''
equal 'what was typed' '"ok"' "$(get status)"
at_terminal '' planar good.jsonl
expect 'a file' 0 ''
at_terminal '' planar -q --progress good.jsonl
expect 'less than a second is no progress' 0 ''

# The line of progress appears after a second, and goes before the next line.
slowly() {
  printf '%s\n' "$bad"
  sleep 1.2 2>cmd.out || sleep 2
  printf '%s\n' "$bad"
}

# progress NAME WANTED ARGUMENT...: what is said, with @ for escape, < for
# carriage return and N for the time
mkfifo slow
progress() {
  name=$1 wanted=$2
  shift 2
  slowly >slow &
  at_terminal '' planar -j 1 "$@" slow
  wait $!
  equal "$name: status" 1 "$status"
  equal "$name" "$wanted" "$(tr '\033\r' '@<' <err | sed 's/[0-9.]* s, [0-9.e+-]* a second</N s</g')"
}

said="phspline: slow:1: record 1: $bad_says
phspline: slow:2: record 2: $bad_says"
shown='phspline: 2 records, 2 failed, N s<@[K'
progress 'progress by itself' "$said
$shown$(failed 2 2)"
progress 'progress asked for' "$said
$shown$(failed 2 2)" --progress
progress 'no progress when quiet' "$said" -q
progress 'progress asked for, when quiet' "$said
$shown" -q --progress

# Of files, about how many records there are, and the time that is left: lines
# are of one length, so that the estimate is right.
awk 'BEGIN {
  for (k = 0; k < 40; k++) {
    printf "{\"points\":["
    for (i = 0; i < 9; i++) printf "%s[%d,%d]", i ? "," : "", i, i * i % 7
    print "],\"solutions\":\"all\"}"
  }
}' >long.jsonl
at_terminal '' planar -j 1 --quiet --progress long.jsonl
tr '\r' '\n' <err | sed 's/.*phspline:/phspline:/' | grep ' left$' >shown || :
if [ -s shown ]; then
  equal 'the time that is left: the form' '' "$(grep -v -E '^phspline: [0-9]+ of (about )?[0-9]+ records, 0 failed, [0-9.]+ s, [0-9.e+]+ a second, [0-9.]+ (s|min) left$' shown)"
  # done / of = time / (time + left), and the rate is done / time
  # shellcheck disable=SC2016
  true_that 'the time that is left: by what is done' awk '
    { sub(/about /, ""); of = $4; t = $8; rate = $10; left = $13 }
    $14 == "min" { left *= 60 }
    !(of > 38 && of < 42) || !(t > 0) { exit 1 }
    !(left > (of / $2 - 1) * t - 0.1 - 0.1 * of / $2 &&
      left < (of / $2 - 1) * t + 0.1 + 0.1 * of / $2) { exit 1 }
    !(rate * t > 0.8 * $2 && rate * t < 1.2 * $2) { exit 1 }
    $2 <= last { exit 1 }
    { last = $2 }' shown
else
  echo 'skip the time that is left: the run took less than a second'
fi
