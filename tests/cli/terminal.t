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
