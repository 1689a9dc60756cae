# SPDX-License-Identifier: GPL-3.0-or-later
#
# Streams of problems: their forms, their ends, what is broken in them, files
# that cannot be read, promptness, and memory that does not grow with them.
. "$srcdir/tests/cli/lib.sh"

# problem ID: one that is cheap to solve
problem() {
  printf '{"id":%s,"points":[[0,0],[1,%s]]}' "$1" "$1"
}

# stream NAME STATUS IDS TEXT [ARGUMENT...]: the ids of the records, in order,
# for a text for printf on standard input; messages are not looked at
stream() {
  name=$1 wanted="$2 $3"
  # shellcheck disable=SC2059
  printf "$4" >in
  shift 4
  run planar "$@" <in
  equal "$name" "$wanted" "$status $(get id)"
}

a=$(problem 1) b=$(problem 2) c=$(problem 3)

# ---- forms -------------------------------------------------------------------

stream 'one object' 0 1 "$a"
stream 'one object and a line break' 0 1 "$a\\n"
stream 'an array' 0 '1 2 3' "[$a,$b,$c]"
stream 'an array of many lines' 0 '1 2 3' "\\n[\\n  $a,\\n  $b\\n,$c\\n]\\n\\n"
stream 'an array of one' 0 1 "[$a]"
stream 'JSON Lines' 0 '1 2 3' "$a\\n$b\\n$c\\n"
stream 'JSON Lines without the last line break' 0 '1 2 3' "$a\\n$b\\n$c"
stream 'JSON Lines with blank lines' 0 '1 2 3' "\\n$a\\n\\n \\t\\n$b\\n\\n$c\\n\\n"
stream 'JSON Lines of Windows' 0 '1 2 3' "$a\\r\\n$b\\r\\n$c\\r\\n"
stream 'objects one after another' 0 '1 2 3' "$a$b $c"
stream 'objects and arrays, mixed' 0 '1 2 3 1' "${a}[$b,$c]\\n$a"
stream 'objects of many lines' 0 '7 1' \
  "{\\n\"id\"\\n:7 ,\\r\\n\\t\"points\": [ [0,\\n0],\\n[1,1]\\n]\\n}\\n$a"
stream 'a byte-order mark' 0 '1 2' "\\357\\273\\277$a\\n$b"
stream 'a byte-order mark before an array' 0 '1 2' "\\357\\273\\277[$a,$b]"
stream 'an empty array' 0 '' '[]'
stream 'empty arrays' 0 '1' "[ ]\\n[]${a}[\\n]"
stream 'nothing' 0 '' ''
stream 'blanks' 0 '' ' \n\t\r\n  '
stream 'a byte-order mark alone' 0 '' '\357\273\277'
stream 'nothing, called JSON' 0 '' '' -i json
stream 'nothing, called CSV' 0 '' '' -i csv
expect 'nothing in, nothing out' 0 'phspline: there is no problem in standard input' ''

# ---- what is broken ----------------------------------------------------------

stream 'a broken line of JSON Lines' 1 '1 absent 3' "$a\\n{\"id\":2,\\n$c\\n"
expect 'it is told' 1 \
  "phspline: -:2: record 2: the text ends inside an object [syntax]
$(failed 1 3)"
stream 'a problem that fails has an empty path' 1 '' \
  "$a\\n{\"id\":2,\"points\":[[0,0]]}\\n$a\\n" -f svg-path
equal 'an empty path between two' 'M0,0C M0,0C' \
  "$(sed 's/C.*/C/' out | tr '\n' ' ' | sed 's/ *$//; s/  */ /')"
equal 'a line for each' 3 "$(wc -l <out | tr -d ' ')"
stream 'two broken lines' 1 '1 absent absent 3' "$a\\n{\\n]\\n$c\\n"
stream 'a first line that is broken' 1 'absent 2' "{\"id\":1,]\\n$b\\n"
stream 'a last line that is broken' 1 '1 2 absent' "$a\\n$b\\n{\"id\":3,"
stream 'a broken line of Windows' 1 '1 absent 3' "$a\\r\\n{\"id\":2,\\r\\n$c\\r\\n"
stream 'a blank line after a broken line' 1 '1 absent 3' "$a\\nx\\n\\n$c"
stream 'something behind an object, in JSON Lines' 1 '1 2 absent 3' \
  "$a\\n$b,\\n$c\\n"
stream 'something behind an object, not in JSON Lines' 3 '1 absent' "$a,$b,$c"
stream 'a line that is no object' 1 '1 absent 3' "$a\\n[7]\\n$c\\n"
stream 'a broken array' 3 '1 absent' "[$a,{\"id\":2,},$c]"
expect 'it is told, too' 3 "phspline: -:1: record 2: expected a name in double \
quotes, found '}' [syntax]
$(failed 1 2)"
stream 'an array without a comma' 3 '1 absent' "[$a $b]"
stream 'an array with a comma too many' 3 '1 2 absent' "[$a,$b,]"
stream 'an array that ends too early' 3 '1 2 absent' "[$a,$b"
stream 'an array that ends within a problem' 3 '1 absent' "[$a,{\"id\""
stream 'an array that ends behind a comma' 3 '1 absent' "[$a,"
stream 'an array that only begins' 3 absent '['
stream 'a broken array in lines' 3 '1 absent' "[\\n$a,\\n{\"id\":2,\\n$c]"
stream 'an array that ends twice' 3 '1 absent' "[$a]]\\n$b"
stream 'an object that ends too early' 3 absent '{"id":1,"points":[[0,0],'
stream 'a second object that ends too early' 1 '1 absent' "$a\\n{\"id\":2,"
stream 'an object of many lines that ends too early' 3 absent '{\n"id":1,\n'
stream 'a broken object of many lines' 3 absent "{\\n\"id\" 1\\n}\\n$a"
stream 'NUL' 1 '1 absent 3' "$a\\n\\000\\n$c\\n"

printf '%s\n{"id":2,\n%s\n' "$a" "$c" >lines.jsonl
printf '[%s,{"id":2,]\n' "$a" >array.json
run planar array.json lines.jsonl
expect 'a broken array ends the stream, also before other files' 3 \
  "phspline: array.json:1: record 2: expected a name in double quotes, found \
']' [syntax]
$(failed 1 2)"
run planar lines.jsonl array.json
equal 'what was before it is there' '3 1 absent 3 1 absent' "$status $(get id)"
run planar --fail-fast lines.jsonl array.json
expect '--fail-fast' 1 \
  "phspline: lines.jsonl:2: record 2: the text ends inside an object [syntax]
$(failed 1 2)"
equal '--fail-fast: all up to the first failure' '1 absent' "$(get id)"
run planar --fail-fast array.json lines.jsonl
equal '--fail-fast at the broken array itself' '3 1 absent' "$status $(get id)"

# ---- files -------------------------------------------------------------------

problem 1 >1.json
printf '%s\n%s\n' "$b" "$c" >2.jsonl
printf 'id,x,y\n4,0,0\n4,1,4\n5,0,0\n5,1,5\n' >3.csv
printf 'id\tx\ty\n6\t0\t0\n6\t1\t6\n' >4.tsv
: >empty.json
run planar 1.json 2.jsonl 3.csv empty.json 4.tsv 1.json
expect 'several files are one stream' 0 'phspline: there is no problem in empty.json'
equal 'in the order given' '1 2 3 4 5 6 1' "$(get id)"
printf '{"points":[]}\n' >5.jsonl
run planar 2.jsonl 5.jsonl 1.json 5.jsonl
expect 'records are counted through all files, lines in each' 1 \
  "phspline: 5.jsonl:1: record 3: points: must be at least 2, found 0 \
[too-few-points]
phspline: 5.jsonl:1: record 5: points: must be at least 2, found 0 \
[too-few-points]
$(failed 2 5)"
equal 'the file is in the record' '"5.jsonl" "5.jsonl"' \
  "$(get error.file | sed 's/absent *//g; s/ $//')"

# unreadable NAME MESSAGE FILE: results before it are written, none after it
unreadable() {
  run planar 2.jsonl "$3" 1.json
  equal "$1: results" '3 2 3' "$status $(get id)"
  expect "$1: message" 3 "phspline: $2"
}

unreadable 'a file that is not there' \
  'cannot open nosuch.json: No such file or directory' nosuch.json
unreadable 'a file in what is no directory' \
  'cannot open 1.json/x: Not a directory' 1.json/x
mkdir directory
unreadable 'a directory' 'cannot read directory: Is a directory' directory
unreadable 'an empty name' 'cannot open : No such file or directory' ''
ln -s loop loop
unreadable 'a link to itself' \
  'cannot open loop: Too many levels of symbolic links' loop
unreadable 'a name that drives terminals' \
  'cannot open a\x0ab\x1b: No such file or directory' "$(printf 'a\nb\033')"
problem 9 >secret.json
chmod 000 secret.json
if cat secret.json >cmd.out 2>&1; then
  echo 'skip a file without permission: nothing is forbidden to this user'
else
  unreadable 'a file without permission' \
    'cannot open secret.json: Permission denied' secret.json
fi

run planar 5.jsonl nosuch.json 1.json
expect 'all that is said of records comes before it' 3 \
  "phspline: 5.jsonl:1: record 1: points: must be at least 2, found 0 \
[too-few-points]
phspline: cannot open nosuch.json: No such file or directory
$(failed 1 1)"
run planar -f csv --table=lengths nosuch.json
expect 'a table of nothing has its header' 3 \
  'phspline: cannot open nosuch.json: No such file or directory' \
  'id,segment,t0,t1,length,cumulative'

# ---- promptness --------------------------------------------------------------

# The producer waits for each answer: a program that waits for more input, or
# for full buffers, would be killed by `limited'.
mkfifo question answer

# prompt NAME FIRST ARGUMENT...: three problems, one after the other; FIRST is
# written first, and gives no answer unless it is empty
prompt() {
  name=$1 first=$2 answers=
  shift 2
  limited "$PHSPLINE" planar "$@" question >answer 2>err &
  exec 4<answer 3>question
  printf '%s' "$first" >&3
  for id in 1 2 3; do
    case $* in
    *csv*) printf '%s,0,0\n%s,1,1\n\n' $id $id >&3 ;;
    *) problem $id >&3 ;;
    esac
    line=
    read -r line <&4
    answers="$answers$(printf '%s\n' "$line" | json get id | sed 's/$/ /')"
    case $first in
    '[') printf ',' >&3 ;;
    *) printf '\n' >&3 ;;
    esac
  done
  exec 3>&-
  cat <&4 >rest
  exec 4<&-
  code=0
  wait $! || code=$?
  case $first in
  '[') equal "$name: the array is cut off" 3 "$code" ;;
  *) equal "$name: status" 0 "$code" ;;
  esac
  equal "$name" '1 2 3 ' "$answers"
}

for jobs in 1 2 8; do
  prompt "an answer to each line, --jobs=$jobs" '' --jobs=$jobs
done
prompt 'an answer to each element of an array' '['
prompt 'an answer to each CSV record that a blank line ends' 'id,x,y
' -i csv
prompt 'an answer also behind much input' "$(
  awk 'BEGIN { for (i = 0; i < 9999; i++) printf "                    " }')"

# ---- memory ------------------------------------------------------------------

# light NAME RECORDS ARGUMENT...: a stream on standard input, one row for each
# problem of $method, within 32 MB (it needs 5 to 15); the exit status is $fails
method=planar fails=0
light() {
  name=$1 wanted=$2
  shift 2
  status=0
  peak kilobytes "$PHSPLINE" $method -f csv --table=lengths -j 2 "$@" >out \
    2>err || status=$?
  if [ "$status" -ne $fails ] || ! count $((wanted + 1)) out; then
    fail "$name" "exit status $status, $(wc -l <out) lines; $(head -n 3 err)"
  elif [ "$(cat kilobytes)" -gt 32768 ]; then
    fail "$name" "it held $(cat kilobytes) kB"
  else
    pass "$name"
  fi
}

if instrumented; then
  echo 'skip constant memory: the program is instrumented'
else
  # 200 MB, which are read and passed on, but cost little else
  awk 'BEGIN {
    meta = "x"
    while (length(meta) < 4000) meta = meta meta
    for (i = 1; i <= 50000; i++)
      print "{\"points\":[[0,0],[1," i "]],\"meta\":\"" meta "\"}"
  }' | light 'memory for 200 MB of JSON Lines' 50000
  awk 'BEGIN {
    meta = "x"
    while (length(meta) < 1000000) meta = meta meta
    for (i = 1; i <= 200; i++)
      print "{\"points\":[[0,0],[1," i "]],\"meta\":\"" meta "\"}"
  }' | light 'memory for 200 MB in long lines' 200
  # many small ones
  awk 'BEGIN {
    for (i = 1; i <= 200000; i++)
      print (i == 1 ? "[" : ",") "{\"points\":[[0,0],[1," i "]]}"
    print "]"
  }' | light 'memory for an array of 200 000 problems' 200000
  awk 'BEGIN {
    print "id,x,y"
    for (i = 1; i <= 200000; i++)
      print i ",0,0\n" i ",1," i
  }' | light 'memory for 200 000 CSV records' 200000
  # blanks, which no limit of a record counts
  blanks() {
    head -c 100000000 /dev/zero | tr '\0' "$1"
  }
  {
    blanks ' '
    echo "$good"
    blanks ' '
  } | light 'memory for blanks' 2 --max-record-bytes=1K
  {
    printf '0,0\n1,1\n'
    blanks ' '
    printf '\n0,0\n2,2\n'
  } | light 'memory for a blank line of CSV' 2 --max-record-bytes=1K
  fails=1
  {
    printf '{bad\n'
    blanks '\n'
    echo "$good"
  } | light 'memory for blank lines behind what is broken' 2 \
    --max-record-bytes=1K
  {
    printf '0,0\n1,1\n'
    blanks ' '
    printf '0,0\n2,2\n\n0,0\n3,3\n'
  } | light 'memory for a row that begins with blanks' 2 --max-record-bytes=1K
  fails=0
  # one long problem: 60 000 points, of which the text is 27 MB
  awk 'BEGIN {
    for (i = 0; i < 60000; i++) printf "%d,%.3f\n", i, sin(i / 9)
  }' >in
  light 'memory for a long curve' 59999 -i csv <in
  peak kilobytes "$PHSPLINE" planar -j 1 -i csv in >out 2>err
  true_that 'memory for a long curve as JSON: 350 bytes a point' test \
    "$(cat kilobytes)" -le $((6144 + 350 * 60000 / 1024))
  # one JSON problem: peak for a byte of it, above the program's own 6 MB
  # held COMMAND TENTHS WHAT
  held() {
    peak kilobytes "$PHSPLINE" "$1" -q -j 1 in >out 2>err
    held=$(($(cat kilobytes) * 1024 - 6000000)) bytes=$(wc -c <in)
    true_that "memory for a JSON problem$3, $1: $((10 * held / bytes)) tenths" \
      [ $((10 * held)) -le $(($2 * bytes)) ]
  }
  # of 4 MB, of which up to 32 stay with the program when they are freed (with
  # text and workspaces kept it was 10.4, 9.4 and 50; with equations that are
  # solved and points that are copied 8.1 and 7.7; with two iterates of tc in
  # memory, and its chain three times, 23.8; with joints twice 7.0, 7.1, 12.8)
  # heavy COMMAND DIMENSION TENTHS
  heavy() {
    awk -v d="$2" 'BEGIN {
      printf "{\"points\":["
      for (i = 0; i < 110000; i++) {
        t = i / 10
        printf "%s[%.12f,%.12f", i ? "," : "", t + 0.3 * sin(i * i / 9), \
          20 * sin(t)
        printf "%s]", d == 3 ? sprintf(",%.12f", 9 * cos(t)) : ""
      }
      print "]}"
    }' >in
    held "$1" "$3" ''
  }
  heavy planar 2 69
  heavy spatial-hermite 3 65
  heavy tc 2 119
  # of 14.5 MB, smooth: a point has 33 bytes (with joints twice, workspaces and
  # points kept beside the curve, and certificates by arrays 6.6, 11.3; tc with
  # intervals beside its chain 8.5)
  awk 'BEGIN {
    printf "{\"closed\":true,\"points\":["
    n = 440000
    for (i = 0; i < n; i++) {
      a = i * 8 * atan2(1, 1) / n
      r = 2 + cos(3 * a) / 9
      printf "%s[%.12f,%.12f]", i ? "," : "", r * cos(a), r * sin(a)
    }
    print "]}"
  }' >in
  held planar 51 ', smooth'
  held spatial-hermite 95 ', smooth'
  held tc 70 ', smooth'
  # one problem, many results
  problem 1 >in
  light 'memory for a sweep of 200 000' 200000 \
    -S 'points[0][0]=0:0.5:200000' -S 'points[0][1]=0' <in
  # the same in space
  method=spatial-hermite
  awk 'BEGIN {
    for (i = 1; i <= 100000; i++)
      print "{\"points\":[[0,0,0],[1," i "," i % 7 "]],\"shape\":false}"
  }' | light 'memory for 100 000 problems in space' 100000
  awk 'BEGIN {
    print "id,x,y,z,tx,ty,tz"
    for (i = 1; i <= 100000; i++)
      print i ",0,0,0,1,1," i "\n" i ",1," i ",2,0,1,1"
  }' | light 'memory for 100 000 CSV records in space' 100000
  printf '{"points":[[0,0,0],[1,2,3]],"tangents":[[1,0,0],[0,1,0]]}' >in
  light 'memory for 2 000 minimisations' 2000 --criterion=F1 \
    -S 'points[0][0]=0:0.5:2000' <in
fi
