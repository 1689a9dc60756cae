# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs the examples of README, the manual, the help texts and the demo.
#
# An example is an indented display: four blanks or more, in the manual .Bd in
# the section EXAMPLES.  A display after a line "prints", or "prints, with exit
# status N,", is what the example before it prints: the lines that begin with
# "phspline: " on standard error, all others on standard output.  Numbers agree
# if they do to 1e-12, relatively or absolutely; all else has to be the same.
# Every call of the program must end with status 0, or N.
set -eu
bad=0
top=$(pwd)

fail() {
  echo "not ok examples $1"
  bad=1
}

# manual PAGE: its examples, in the form of the other documents
manual() {
  awk '
    /^\.Sh / { inside = $2 == "EXAMPLES"; next }
    !inside || /^\.\\"/ { next }
    /^\.Bd/ { display = 1; print ""; next }
    /^\.Ed/ { display = 0; print ""; next }
    /^\.Pp/ { print ""; next }
    { print (display ? "    " : "") $0 }' "$1" |
    sed "s/\\\\-/-/g; s/\\\\(aq/'/g; s/\\\\e/\\\\/g; s/\\\\&//g"
}

# split FILE: each example to N.cmd, what it prints to N.out, the exit status to
# N.status
split() {
  awk '
    /^    / {
      if (!display) {
        display = 1
        if (text ~ /^prints/) {
          file = n ".out"
          if (text ~ /status/) {
            gsub(/[^0-9]/, "", text)
            print text >(n ".status")
          }
        } else {
          file = ++n ".cmd"
        }
      }
      print substr($0, 5) >file
      next
    }
    { display = 0 }
    NF { text = $0 }' "$1"
}

# compare EXPECTED FILE: how they differ, other than in rounding
compare() {
  awk '
    # finds the next number in s from position i on
    function find(s, i) {
      start = match(substr(s, i), /[-+]?[0-9]+(\.[0-9]*)?([eE][-+]?[0-9]+)?/)
      start = start ? i + start - 1 : length(s) + 1
      size = start > length(s) ? 0 : RLENGTH
    }
    function magnitude(x) { return x < 0 ? -x : x }
    function near(x, y,    scale) {
      scale = magnitude(x) > magnitude(y) ? magnitude(x) : magnitude(y)
      return magnitude(x - y) <= 1e-12 * (scale > 1 ? scale : 1)
    }
    function same(a, b,    i, j, x, before) {
      i = j = 1
      while (i <= length(a)) {
        find(a, i)
        before = substr(a, i, start - i)
        x = substr(a, start, size)
        i = start + size
        find(b, j)
        if (before != substr(b, j, start - j) || (x == "") != (size == 0) ||
            !near(x + 0, substr(b, start, size) + 0)) {
          return 0
        }
        j = start + size
      }
      return j > length(b)
    }
    FILENAME == ARGV[1] { expected[n = FNR] = $0; next }
    { m = FNR }
    m > n || !same(expected[m], $0) {
      print "expected: " expected[m]
      print "     got: " $0
      bad = 1
    }
    END {
      for (i = m + 1; i <= n; i++) print "expected: " expected[i]
      exit bad || m != n
    }' "$1" "$2"
}

# not_ours NAME FILE: a display that does not call the program
not_ours() {
  while read -r word rest; do
    case $word in
    make | ./configure)
      test "$word" = make || rest=configure
      for target in $rest; do
        case $target in
        *=*) ;;
        *) grep -q "^$target:" "$srcdir/Makefile" ||
          fail "$1: no target $target in Makefile" ;;
        esac
      done
      ;;
    man) test -f "$srcdir/$rest" || fail "$1: no $rest" ;;
    PATH=*) ;;
    *) fail "$1: neither an example nor a known command: $word" ;;
    esac
  done <"$2"
}

# example NAME N: runs one, in the working directory
example() {
  : >statuses
  expected=0
  test ! -f "$2.status" || expected=$(cat "$2.status")
  # a shell as the user has it, which goes on when a command fails
  status=0
  sh "./$2.cmd" >stdout 2>stderr </dev/null || status=$?
  why=
  : >differences
  if [ ! -s statuses ]; then
    why='it does not call phspline'
  elif grep -qvx "$expected" statuses &&
    ! { grep -q '| head' "$2.cmd" && ! grep -qvx 141 statuses; }; then
    why="exit status $(tr '\n' ' ' <statuses), not $expected"
  elif [ "$status" -ne 0 ] && [ "$status" -ne "$expected" ]; then
    why="exit status $status"
  elif [ -f "$2.out" ]; then
    sed '/^phspline: /d' "$2.out" >stdout.expected
    sed -n '/^phspline: /p' "$2.out" >stderr.expected
    compare stdout.expected stdout >>differences || why='other output'
    compare stderr.expected stderr >>differences || why='other messages'
  elif [ -s stderr ]; then
    why='messages'
  fi
  if [ -z "$why" ]; then
    echo "ok examples $1 $2"
  else
    fail "$1 $2: $why"
    cat "$2.cmd" stderr differences
  fi
}

# what a figure needs, which the program may have been built without
figures=yes
printf '0,0\n1,1\n' >two.csv
"$PHSPLINE" planar two.csv --plot=two.svg >two.out 2>two.err || figures=no
if [ "$figures" = no ] && ! grep -q 'built without cairo' two.err; then
  fail "--plot: $(cat two.err)"
fi

# missing FILE: prints what the example needs and is not there; fails if there is
# nothing
missing() {
  for tool in jq gnuplot; do
    if grep -qw "$tool" "$1" && ! command -v "$tool" >/dev/null; then
      echo "$tool"
      return
    fi
  done
  grep -Eq -e '(--plot=| -p )' "$1" && [ "$figures" = no ] && echo cairo
}

# run NAME PATH: the examples of the text on standard input, in a directory like
# the source's after make; PATH: with the program on it
run() {
  mkdir -p "$top/$1/build/plain"
  cd "$top/$1"
  cat >text
  ln -s "$srcdir/data" data
  cat >build/plain/phspline <<EOF
#!/bin/sh
status=0
"$PHSPLINE" "\$@" || status=\$?
echo \$status >>"$top/$1/statuses"
exit \$status
EOF
  chmod +x build/plain/phspline
  split text
  saved=$PATH
  test -z "$2" || PATH=$PWD/build/plain:$PATH
  ran=0 n=1
  while [ -f "$n.cmd" ]; do
    if grep -q '^PATH=' "$n.cmd"; then
      # shellcheck disable=SC1090
      . "./$n.cmd"
    fi
    if ! grep -q 'phspline [a-z-]' "$n.cmd"; then
      not_ours "$1 $n" "$n.cmd"
    elif missing=$(missing "$n.cmd"); then
      echo "skip examples $1 $n: no $missing"
      ran=$((ran + 1))
    else
      example "$1" "$n"
      ran=$((ran + 1))
    fi
    n=$((n + 1))
  done
  PATH=$saved
  cd "$top"
  test "$ran" -gt 0 || fail "$1: no example was found in it"
}

# ---- README and the manual ----

# without its picture; the first byte of braille in UTF-8 is 342
sed "/$(printf '\342')/d" "$srcdir/README" >README.txt
run README '' <README.txt
for page in "$srcdir"/man/*.[1-9]; do
  grep -q '^\.Sh EXAMPLES' "$page" || continue # of results, none to run
  manual "$page" >page.txt
  run "${page##*/}" PATH <page.txt
done

# ---- help: its examples take the user's files for granted ----

"$PHSPLINE" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z-]*\)  .*/\1/p' \
  >commands
test -s commands || fail '--help: no commands'
while read -r command; do
  mkdir "help-$command"
  cp "$srcdir/data/coastline.csv" "help-$command/coast.csv"
  cp "$srcdir/data/spiral.csv" "help-$command/points.csv"
  printf '0,0,0\n1,1,0\n2,0,1\n' >"help-$command/path.csv"
  printf '0,0,0,1,1,0\n1,1,0,1,0,1\n' >"help-$command/sensors.csv"
  cp "$srcdir/data/gonzalez-2018.jsonl" "help-$command/problems.jsonl"
  sed '1,/^x/d; s/$/,4.5,5.5/' "$srcdir/data/coastline.csv" \
    >"help-$command/track.csv"
  # no warnings: lengths of a smooth curve, or of none that is known
  awk -v OFS=, 'BEGIN { print "x,y,z,length"
    for (t = 0; t < 6; t += 0.5) { print cos(t), sin(t), 0.75 * t,
      t ? 0.625 : "" } }' >"help-$command/survey.csv"
  printf '1,0,0,\n0,1,0,2\n0,0,1,2\n' >"help-$command/ribbon.csv"
  printf '%s\n' x,y,z,rx,ry,rz,tx,ty,tz \
    252.6524,62,92.5,-0.1151,0.2405,0.9638,0.9925,0.069,0.1013 \
    266.5158,65.1388,91.5,-0.1785,0.165,0.97,0.8847,0.4583,0.0849 \
    >"help-$command/elements.csv"
  printf '{"tangents":[[1,0,0],[0,1,0],[0,0,1],[1,0,0]],"lengths":%s}\n' \
    '[1.2,1.4,0.7]' >"help-$command/problem.json"
  sed -n 3p "$srcdir/data/byrtus-2011-meshes.jsonl" \
    >"help-$command/mesh.json"
  if [ "$command" = sphere ]; then
    # as far as the coast of Brazil: no turn is sharper than the offsets
    sed '/^[^-0-9]/d' "$srcdir/data/magellan-elcano.csv" | head -n 6 \
      >"help-$command/track.csv"
    printf '1,0,0\n0.6,0.8,0\n0,0.6,0.8\n-0.6,0,0.8\n' \
      >"help-$command/points.csv"
  fi
  if [ "$command" = tc ]; then
    printf '0,0,1,1\n2,0,1,-1\n3,1,0,1\n' >"help-$command/outline.csv"
    printf '0,0\n1,3\n4,-2\n5,1\n' >"help-$command/bezier.csv"
    printf '{"points":[[0,0],[1,0]],"tangents":[[1,1],[1,-1]]}\n' \
      >"help-$command/problem.json"
    cp "$srcdir/data/spanner.json" "help-$command/drawing.json"
  fi
  "$PHSPLINE" help "$command" | sed -n '/^Examples:/,/^$/p' >help.txt
  run "help-$command" PATH <help.txt
done <commands

# ---- the demo, whose picture is that of README ----

mkdir demo
ln -s "$srcdir/data" demo/data
mkdir -p demo/build/plain
ln -s "$PHSPLINE" demo/build/plain/phspline
# not every system has that locale, of which the demo reads only the name
if (cd demo && LC_ALL=C.UTF-8 sh data/demo.sh build/plain/phspline) \
  >demo.out 2>demo.err && ! grep -v locale demo.err; then
  echo 'ok examples demo'
else
  fail 'demo: exit status or messages'
  cat demo.err
fi
# braille is U+2800 to U+28FF, in UTF-8 the bytes 342 240-243
picture() {
  grep "$(printf '\342[\240-\243]')" "$1" | sed 's/^  *//; s/ *$//'
}
picture demo.out >demo.picture
picture "$srcdir/README" >README.picture
if [ -s demo.picture ] && cmp demo.picture README.picture; then
  echo 'ok examples picture'
else
  fail 'picture: README does not have that of the demo'
fi
sed '1,/^Try next/d' demo.out >next.txt
mkdir -p demo-next/demo-output
run demo-next '' <next.txt
exit "$bad"
