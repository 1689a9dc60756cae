# SPDX-License-Identifier: GPL-3.0-or-later
#
# Where results go: a file that is replaced as a whole or not at all, whatever
# happens, and standard output that is full, closed or no longer read.
. "$srcdir/tests/cli/lib.sh"

printf '%s\n' "$good" >good.jsonl
printf '%s\n%s\n%s\n' "$good" "$bad" "$good" >mixed.jsonl
run planar good.jsonl
mv out good.out
run planar -q mixed.jsonl
mv out mixed.out

# Each case has a directory d, in which nothing but old, with an old text, is.
fresh() {
  rm -rf d
  mkdir d
  echo old >d/old
}

# untouched NAME: the old file is as it was, and alone
untouched() {
  equal "$1: the old file stays, alone" 'old old' "$(ls -A d) $(cat d/old)"
}

# replaced NAME WANTED: the old file has new content, and is alone
replaced() {
  equal "$1: nothing else is left" old "$(ls -A d)"
  equal_files "$1: the file" "$2" d/old
}

# mode FILE: its permissions as ls shows them
mode() {
  # shellcheck disable=SC2012  # the name is ours
  ls -ld "$1" | cut -c 1-10
}

# ---- a file is replaced ------------------------------------------------------

fresh
run planar -o d/old good.jsonl
expect '-o FILE' 0 '' ''
replaced '-o FILE' good.out
fresh
run planar --output=d/old mixed.jsonl
expect '-o FILE, a problem failed' 1 \
  "phspline: mixed.jsonl:2: record 2: $bad_says
$(failed 1 3)" ''
replaced '-o FILE, a problem failed' mixed.out
fresh
rm d/old
(
  umask 027
  run planar -o d/old good.jsonl
  expect 'a new file' 0 '' ''
)
replaced 'a new file' good.out
equal 'its mode is by umask' -rw-r----- "$(mode d/old)"
fresh
chmod 751 d/old
run planar -o d/old good.jsonl
equal 'the mode of an old file is kept' -rwxr-x--x "$(mode d/old)"
replaced 'a file with a mode' good.out
fresh
mkdir d/sub
mv d/old d/sub/old
ln -s sub/old d/link
run planar -o d/link good.jsonl
expect 'a symbolic link' 0 '' ''
equal 'the link stays' 'l sub/old' "$(mode d/link | cut -c 1) $(
  readlink d/link)"
equal_files 'what it points to is replaced' good.out d/sub/old
equal 'nothing else is left there' old "$(ls -A d/sub)"
rm d/sub/old
run planar -o d/link good.jsonl
expect 'a symbolic link to nothing' 0 '' ''
equal 'that link stays' l "$(mode d/link | cut -c 1)"
equal_files 'what it points to is made' good.out d/sub/old
fresh
cp mixed.jsonl d/old
run planar -q -o d/old d/old
equal 'the input itself: status' 1 "$status"
sed 's/mixed.jsonl/d\/old/' mixed.out >want
replaced 'the input itself' want
fresh
(
  cd d || exit
  "$PHSPLINE" planar -o old ../good.jsonl
)
replaced 'in the present directory' good.out
fresh
long=$(awk 'BEGIN { for (i = 0; i < 250; i++) printf "n" }')
run planar -o "d/$long" good.jsonl
expect 'a name as long as names may be' 0 '' ''
equal_files 'a name as long as names may be: the file' good.out "d/$long"
fresh
run planar -f csv -o d/old </dev/null
expect 'a table of nothing' 0 'phspline: there is no problem in standard input' ''
equal 'a table of nothing: the file' 'id,segment,index,x,y' "$(cat d/old)"
fresh
run planar -o d/old -o - good.jsonl
expect '-o - is standard output' 0 '' "$(cat good.out)"
untouched '-o -'
fresh
run planar -o d/old mixed.jsonl nosuch.json
equal 'input that cannot be read: status' 3 "$status"
equal_files 'input that cannot be read: what came before is there' mixed.out \
  d/old

if [ "$(id -u)" -eq 0 ]; then
  fresh
  chown 1:1 d/old
  run planar -o d/old good.jsonl
  equal 'what root replaces stays whose it was' '0 1 1' \
    "$status $(find d/old -user 1 -group 1 -exec echo 1 1 \;)"
else
  echo 'skip the owner of the file: only root could change it'
fi

# ---- no regular file ---------------------------------------------------------

# node NAME MINOR: prints a device to write to.  Root gets a node of its own: a
# program that replaced it instead would leave the machine without the real one.
node() {
  if [ "$(id -u)" -ne 0 ]; then
    echo "/dev/$1"
  elif mknod "$1" c 1 "$2" 2>cmd.out && (: >"$1") 2>cmd.out; then
    echo "$1"
  fi
}

null=$(node null 3)
if [ -c "$null" ]; then
  run planar -o "$null" good.jsonl
  expect 'a device is written to' 0 '' ''
  true_that 'and stays a device' [ -c "$null" ]
else
  echo 'skip a device: none can be made here'
fi
fresh
mkfifo d/fifo
limited "$PHSPLINE" planar -o d/fifo good.jsonl &
cat d/fifo >out
wait $!
equal_files 'a pipe is written to' good.out out
equal 'and stays one' p "$(mode d/fifo | cut -c 1)"

# ---- descriptors -------------------------------------------------------------

# What stands behind a descriptor is not ours: it is written to from where it
# stands, and keeps what it has.

# shared NAME DESCRIPTOR FILE: FILE is a name of DESCRIPTOR, which leads to d/old
shared() {
  fresh
  ln "d/old" d/hard
  status=0
  {
    echo before >&7
    case $2 in
    1) "$PHSPLINE" planar -o "$3" good.jsonl 2>err >&7 ;;
    2) "$PHSPLINE" planar -o "$3" good.jsonl >out 2>&7 ;;
    7) "$PHSPLINE" planar -o "$3" good.jsonl >out 2>err ;;
    esac || status=$?
    echo after >&7
  } 7>>d/old
  {
    printf 'old\nbefore\n'
    cat good.out
    echo after
  } >want
  equal "$1: status" 0 "$status"
  equal_files "$1: the file" want d/old
  equal_files "$1: it is the same file" d/hard d/old
  equal "$1: nothing else is left" 'hard
old' "$(ls -A d)"
}

: >err
: >out
if [ -e /dev/fd/1 ]; then
  ln -s /dev/stdout to-stdout
  ln -s /dev/fd to-fd
  shared '/dev/stdout' 1 /dev/stdout
  shared '/dev/fd/1' 1 /dev/fd/1
  shared 'a link to /dev/stdout' 1 to-stdout
  shared '/dev/stderr' 2 /dev/stderr
  shared '/dev/fd/7' 7 /dev/fd/7
  shared 'a link to /dev/fd' 7 to-fd/7
  shared '/dev/fd/../fd/07' 7 /dev/fd/../fd/07
  if [ -e /proc/self/fd/1 ]; then
    shared '/proc/self/fd/1' 1 /proc/self/fd/1
    shared '/proc/self/fd/7' 7 /proc/self/fd/7
  else
    echo 'skip /proc/self/fd: not on this system'
  fi
  if [ -e /proc/thread-self/fd/1 ]; then
    shared '/proc/thread-self/fd/1' 1 /proc/thread-self/fd/1
  else
    echo 'skip /proc/thread-self/fd: not on this system'
  fi

  # from where the descriptor stands, in a file that is not appended to
  fresh
  {
    echo before
    "$PHSPLINE" planar -q -o /dev/stdout mixed.jsonl 2>err
    echo after
  } >d/old
  {
    echo before
    cat mixed.out
    echo after
  } >want
  replaced '/dev/stdout, in the middle of a file' want
  "$PHSPLINE" planar -o /dev/stdout good.jsonl | cat >out
  equal_files '/dev/stdout is a pipe' good.out out

  # descriptors that cannot be written to
  bad_descriptor() {
    fresh
    run planar -o "$1" good.jsonl
    expect "$1 $2" 4 "phspline: cannot open $1: Bad file descriptor" ''
  }
  bad_descriptor /dev/fd/6 'is not open' 6>&-
  bad_descriptor /dev/fd/999999999 'is no descriptor'
  bad_descriptor /dev/stdin 'is for reading' <good.jsonl
  bad_descriptor /dev/stdin 'is closed' <&-
  status=0
  "$PHSPLINE" planar -o /dev/stdout good.jsonl >&- 2>err || status=$?
  expect '/dev/stdout is closed' 4 \
    'phspline: cannot open /dev/stdout: Bad file descriptor'

  if "$PHSPLINE" planar -p x.svg </dev/null 2>err; then
    fresh
    ln -s /dev/fd/7 figure.svg
    run planar -p figure.svg good.jsonl 7>>d/old
    expect 'a figure by a descriptor' 0 '' "$(cat good.out)"
    equal 'a figure by a descriptor: the file' 'old </svg>' \
      "$(sed -n '1p;$p' d/old | tr '\n' ' ' | sed 's/ $//')"
    rm figure.svg
    ln -s /dev/fd/1 figure.svg
    run planar -p figure.svg good.jsonl
    expect 'a figure into standard output' 2 \
      "phspline: --plot and standard output are the same file
Try 'phspline planar --help'." ''
    run planar -o /dev/stdout -p figure.svg good.jsonl
    expect 'a figure into the output' 2 \
      "phspline: --plot and --output are the same file
Try 'phspline planar --help'." ''
    rm figure.svg
    status=0
    # shellcheck disable=SC2094  # that is what is tried
    "$PHSPLINE" planar -p d/old.svg good.jsonl >d/old.svg 2>err || status=$?
    expect 'a figure onto standard output' 2 \
      "phspline: --plot and standard output are the same file
Try 'phspline planar --help'."
    # the first descriptor that the program opens itself is nobody's
    ln -s /dev/fd/3 figure.svg
    run planar -o d/old -p figure.svg good.jsonl 3>&-
    expect "a figure into the program's own file" 4 \
      'phspline: cannot open figure.svg: Bad file descriptor' ''
    rm figure.svg
  else
    echo 'skip a figure by a descriptor: built without cairo'
  fi
else
  echo 'skip descriptors by name: no /dev/fd on this system'
fi

# what is read may not be what is written to directly
fresh
cp good.jsonl d/old
status=0
# shellcheck disable=SC2094  # that is what is tried
"$PHSPLINE" planar d/old >>d/old 2>err || status=$?
expect 'the input as standard output' 4 \
  'phspline: cannot write standard output: it is the input d/old'
equal_files 'the input as standard output: it stays' good.jsonl d/old
status=0
# shellcheck disable=SC2094  # that is what is tried
"$PHSPLINE" planar <d/old >>d/old 2>err || status=$?
expect 'standard input as standard output' 4 \
  'phspline: cannot write standard output: it is the input -'
status=0
"$PHSPLINE" verify --problems=d/old good.out >>d/old 2>err || status=$?
expect 'the problems as standard output' 4 \
  'phspline: cannot write standard output: it is the input d/old'
equal_files 'the problems as standard output: they stay' good.jsonl d/old

# ---- other names, owners, permissions ----------------------------------------

fresh
ln d/old d/hard
run planar -o d/old good.jsonl
expect 'a file with two names' 0 '' ''
equal_files 'a file with two names: the one is replaced' good.out d/old
equal 'a file with two names: the other is not' old "$(cat d/hard)"
fresh
ln -s loop d/loop
run planar -o d/loop good.jsonl
expect 'a link to itself' 4 \
  'phspline: cannot create d/loop: Too many levels of symbolic links' ''
equal 'a link to itself stays' 'loop loop
old' "$(readlink d/loop) $(ls -A d)"
fresh
chmod 444 d/old
if (: >>d/old) 2>/dev/null; then
  echo 'skip a file without permission: nothing is forbidden to this user'
else
  run planar -o d/old good.jsonl
  expect 'a file without permission' 4 \
    'phspline: cannot replace d/old: Permission denied' ''
  untouched 'a file without permission'
fi
fresh
run planar -o d/old/ good.jsonl
expect 'a file with a slash' 4 \
  'phspline: cannot create d/old/: Not a directory' ''
run planar -o d/new/ good.jsonl
expect 'a new file with a slash' 4 \
  'phspline: cannot create d/new/: No such file or directory' ''
run planar -o d/ good.jsonl
expect 'a directory with a slash' 4 'phspline: cannot open d/: Is a directory' ''
untouched 'names with a slash'

# ---- the disk ----------------------------------------------------------------

# What fails, and in which order things are done, is tests/unit/cli/t_output.c's.
# synced WANTED ARGUMENT...: so many files and directories are waited for
synced() {
  wanted=$1
  shift
  name="phspline $*"
  fresh
  strace -f -e trace=fsync -o trace "$PHSPLINE" "$@" >out 2>err
  equal "waits for the disk: $name" "$wanted" "$(grep -c 'fsync(' trace)"
}
if strace -o trace true 2>cmd.out; then
  synced 2 planar -o d/old good.jsonl
  synced 2 planar --output=d/new good.jsonl
  synced 2 verify -o d/old good.out
  synced 0 planar --no-sync -o d/old good.jsonl
  synced 0 verify --no-sync -o d/old good.out
  synced 0 planar good.jsonl
  synced 0 planar --fail-fast -o d/old mixed.jsonl
  synced 0 planar -o /dev/stdout good.jsonl
else
  echo 'skip waiting for the disk: strace is missing, or may not trace'
fi

# ---- a file is not replaced --------------------------------------------------

fresh
run planar --fail-fast -o d/old mixed.jsonl
equal '--fail-fast: status' 1 "$status"
untouched '--fail-fast'

# refused NAME MESSAGE FILE: it cannot even be begun
refused() {
  run planar -o "$3" good.jsonl
  expect "$1" 4 "phspline: $2" ''
}

fresh
refused 'a directory that is not there' \
  'cannot create nosuch/x: No such file or directory' nosuch/x
refused 'a file as directory' 'cannot create d/old/x: Not a directory' d/old/x
refused 'a directory as file' 'cannot open d: Is a directory' d
refused 'a directory that is not there, as file' \
  'cannot create nosuch/: No such file or directory' nosuch/
untouched 'refused'
chmod 500 d
if (: >d/new) 2>/dev/null; then
  rm d/new
  echo 'skip a directory without permission: nothing is forbidden to this user'
else
  refused 'a directory without permission' \
    'cannot create d/old: Permission denied' d/old
  untouched 'a directory without permission'
fi
chmod 700 d

# A file that may not grow is the nearest to a full disk that anyone can have.
fresh
awk -v line="$good" 'BEGIN { for (i = 0; i < 1000; i++) print line }' >thousand
(
  ulimit -f 64
  run planar -o d/old thousand
  expect 'no room for the file' 4 'phspline: cannot write d/old: File too large'
)
untouched 'no room for the file'

# ---- interrupted -------------------------------------------------------------

# interrupted NAME STATUS SIGNAL JOBS: while the program waits for input, with
# one result written.  What it says of that result tells that it is there.
mkfifo input messages
interrupted() {
  fresh
  defaults "$PHSPLINE" planar -v -j "$4" -o d/old input 2>messages &
  pid=$!
  exec 4<messages 3>input
  cat good.jsonl >&3
  read -r message <&4
  equal "$1: in the middle of its work" 'phspline: input:1: record 1:' \
    "$(printf '%s' "$message" | cut -d ' ' -f 1-4)"
  equal "$1: two files then" 2 "$(find d -type f | wc -l | tr -d ' ')"
  kill -s "$3" "$pid"
  status=0
  wait "$pid" 2>cmd.out || status=$?
  equal "$1: status" "$2" "$status"
  equal "$1: nothing is said" '' "$(cat <&4)"
  exec 3>&- 4<&-
  untouched "$1"
}

interrupted 'SIGTERM' 143 TERM 1
interrupted 'SIGINT' 130 INT 1
interrupted 'SIGHUP' 129 HUP 1
interrupted 'SIGQUIT' 131 QUIT 1
interrupted 'SIGTERM, with threads' 143 TERM 4
interrupted 'SIGINT, with threads' 130 INT 4

# who ignores a signal for the program, as nohup does, is obeyed
fresh
(
  trap '' INT HUP
  "$PHSPLINE" planar -v -o d/old input 2>messages &
  pid=$!
  exec 4<messages 3>input
  cat good.jsonl >&3
  read -r message <&4
  kill -s INT "$pid"
  kill -s HUP "$pid"
  cat good.jsonl >&3
  exec 3>&-
  status=0
  wait "$pid" || status=$?
  equal 'signals that were ignored from the start: status' 0 "$status"
)
cat good.out good.out >want
replaced 'signals that were ignored from the start' want

# the name has become that of a directory since
fresh
"$PHSPLINE" planar -o d/old input >out 2>err &
exec 3>input
rm d/old
mkdir d/old
cat good.jsonl >&3
exec 3>&-
status=0
wait $! || status=$?
expect 'a name that cannot be replaced' 4 \
  'phspline: cannot replace d/old: Is a directory' ''
equal 'a name that cannot be replaced: no file is left' old "$(ls -A d)"

# ---- standard output ---------------------------------------------------------

full=$(node full 7)
if [ -c "$full" ]; then
  run planar -o "$full" good.jsonl
  expect 'a full device' 4 \
    "phspline: cannot write $full: No space left on device" ''
else
  echo 'skip a full device as file: none can be made here'
fi
if [ -c /dev/full ]; then
  # full MESSAGE STATUS ARGUMENT...: standard output is full
  full() {
    message=$1 wanted=$2
    shift 2
    status=0
    "$PHSPLINE" "$@" >/dev/full 2>err || status=$?
    expect "full: phspline $*" "$wanted" "$message"
  }
  space='phspline: cannot write standard output: No space left on device'
  full "$space" 4 planar good.jsonl
  full "$space" 4 planar -j 8 thousand
  awk 'BEGIN {
    printf "{\"points\":["
    for (i = 0; i < 9999; i++) printf "[%d,%.3f],", i, sin(i / 9)
    print "[10000,1]]}"
  }' >long.json
  full "$space" 4 planar long.json good.jsonl
  full "$space" 4 planar -j 8 good.jsonl long.json long.json
  full "$space" 4 planar -f csv good.jsonl
  full "$space" 4 planar -f csv </dev/null
  full "$space" 4 planar --help
  full "$space" 4 --help
  full "$space" 4 --version
  full 'phspline: cannot open nosuch: No such file or directory' 3 planar nosuch
  full 'phspline: there is no problem in standard input' 0 planar </dev/null
else
  echo 'skip a full device as standard output: no /dev/full'
fi

(
  ulimit -f 64
  run planar thousand
  expect 'no room for standard output' 4 \
    'phspline: cannot write standard output: File too large'
)

# shut NAME STATUS MESSAGE ARGUMENT...: standard output is closed
shut() {
  name=$1 wanted=$2 message=$3
  shift 3
  status=0
  "$PHSPLINE" "$@" >&- 2>err || status=$?
  expect "$name" "$wanted" "$message"
}

descriptor='phspline: cannot write standard output: Bad file descriptor'
shut 'standard output is closed' 4 "$descriptor" planar good.jsonl
shut 'standard output is closed, for a table' 4 "$descriptor" planar -f csv \
  good.jsonl
shut 'standard output is closed, for help' 4 "$descriptor" --help
fresh
shut 'standard output is closed, and not needed' 0 '' planar -o d/old good.jsonl
replaced 'standard output is closed' good.out
fresh
status=0
"$PHSPLINE" planar -o d/old mixed.jsonl 2>&- || status=$?
equal 'standard error is closed: status' 1 "$status"
replaced 'standard error is closed' mixed.out
fresh
status=0
"$PHSPLINE" planar -o d/old mixed.jsonl <&- >&- 2>&- || status=$?
equal 'all is closed: status' 1 "$status"
replaced 'all is closed' mixed.out
status=0
"$PHSPLINE" planar good.jsonl - good.jsonl <&- >out 2>err || status=$?
expect 'standard input is closed' 3 \
  'phspline: cannot read -: Bad file descriptor' "$(cat good.out)"

# ---- the same bytes --------------------------------------------------------------

# stamp: what tells that a file was written again
stamp() {
  ls -i d/old
  find d/old -newer older
}
: >older
fresh
run planar -o d/old good.jsonl
touch -d '2001-01-01' d/old
stamp >wanted
run planar -o d/old --if-changed good.jsonl
stamp >found
equal_files 'the same bytes, --if-changed: the file stays' wanted found
equal 'the same bytes, --if-changed: no other is left' 'old' "$(ls -A d)"
run planar -o d/old good.jsonl
stamp >found
true_that 'the same bytes without the option: it is another' \
  [ "$(cat wanted)" != "$(cat found)" ]
printf x >>d/old
run planar -o d/old --if-changed good.jsonl
replaced 'other bytes, --if-changed' good.out
rm d/old
run planar -o d/old --if-changed good.jsonl
replaced 'no file, --if-changed' good.out

# ---- a reader that has enough ------------------------------------------------

awk -v line="$good" 'BEGIN { for (i = 0; i < 5000; i++) print line }' >many
for jobs in 1 4; do
  {
    status=0
    defaults "$PHSPLINE" planar -j $jobs many 2>err || status=$?
    echo "$status" >status
  } | head -n 1 >out
  equal "a reader that ends, --jobs=$jobs: by SIGPIPE" 141 "$(cat status)"
  equal "a reader that ends, --jobs=$jobs: silently" '' "$(cat err)"
  equal_files "a reader that ends, --jobs=$jobs: its line" good.out out
done
fresh
{
  status=0
  defaults "$PHSPLINE" planar -o d/old mixed.jsonl >out 2>&1 || status=$?
  echo "$status" >status
} | :
{
  status=0
  sh -c 'trap "" PIPE; exec "$@"' sh "$PHSPLINE" planar many 2>err || status=$?
  echo "$status" >status
} | head -n 1 >out
equal 'a reader that ends, SIGPIPE is ignored' \
  '4 phspline: cannot write standard output: Broken pipe' \
  "$(cat status) $(cat err)"
