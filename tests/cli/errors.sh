# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of error records share: a failure is a line on standard error
# and a record, both known to the byte.  Read after lib.sh.

# errors_of COMMAND: what follows is about that command.
errors_of() {
  method=$1
  printf '%s\n' "$good" >good.json
  run "$method" good.json
  expect 'a good problem' 0
  # what it is in the files of bad
  good_line=$(sed 's/\("file":"\)good.json"/\1b.jsonl"/' out)
  good_item=$(sed 's/\("file":"\)good.json"/\1c.json"/' out)
}

# escape TEXT: sets escaped to it as it stands in a JSON string.
escape() {
  escaped=$1
  case $1 in
  *[\\\"]*) escaped=$(printf '%s' "$1" | sed 's/\\/\\\\/g; s/"/\\"/g') ;;
  esac
}

# error_record CODE FIELD MESSAGE FILE LINE[:COLUMN] [ID]; FIELD may be empty
error_record() {
  line=${5%:*} column=
  case $5 in *:*) column=",\"column\":${5#*:}" ;; esac
  printf '{%s"command":"%s","status":"error","error":{"code":"%s",' \
    "${6:+\"id\":$6,}" "$method" "$1"
  escape "$2"
  field=$escaped
  escape "$3"
  printf '"message":"%s%s",%s"file":"%s","line":%s%s}}\n' \
    "${2:+$field }" "$escaped" "${2:+\"field\":\"$field\",}" "$4" \
    "$line" "$column"
}

# bad CODE FIELD MESSAGE PROBLEM: as an object, in JSON Lines and in an array.
# The problem is one line, or members of the one that `with' makes; FIELD may be
# empty.
bad() {
  case $4 in '"'*'":'*) set -- "$1" "$2" "$3" "$(with "$4")" ;; esac
  printf '%s\n' "$4" >a.json
  printf '%s\n' "$good" "$4" "$good" >b.jsonl
  printf '[%s,\n%s,\n%s]' "$good" "$4" "$good" >c.json
  {
    error_record "$1" "$2" "$3" a.json 1
    printf '%s\n' "$good_line"
    error_record "$1" "$2" "$3" b.jsonl 2
    printf '%s\n' "$good_line" "$good_item"
    error_record "$1" "$2" "$3" c.json 2
    printf '%s\n' "$good_item"
  } >want
  says="${2:+$2: }$3 [$1]"
  run "$method" a.json b.jsonl c.json
  if [ "$status" -eq 1 ] && ! cmp -s out want; then
    equal_files "records: $says" want out
  else
    expect "$says" 1 "phspline: a.json:1: record 1: $says
phspline: b.jsonl:2: record 3: $says
phspline: c.json:2: record 6: $says
phspline: 3 of 7 records failed"
  fi
}

# bad_csv STATUS LINE[:COLUMN] FIELD CODE MESSAGE TEXT [OPTION]...: what options
# set is not looked at.
bad_csv() {
  # shellcheck disable=SC2059
  printf "$6" >a.csv
  wanted=$(error_record "$4" "$3" "$5" a.csv "$2")
  wanted_status=$1
  says="phspline: a.csv:${2%:*}: record 1: ${3:+$3: }$5 [$4]"
  text=$6
  shift 6
  run "$method" "$@" a.csv
  sed 's/,"set":{[^}]*}//' out >a.out
  mv a.out out
  expect "$* $text" "$wanted_status" "$says
$(failed 1 1)" "$wanted"
}

# warned NAME CODE MESSAGE SEGMENT PROBLEM; SEGMENT may be empty
warned() {
  id=$(printf %s "$1" | cut -c 1)
  printf '%s\n' "$5" >a.json
  run "$method" a.json
  expect "$1: a warning" 0 \
    "phspline: a.json:1: record $id: warning: $3 [$2]"
  equal "$1: the record" \
    "\"ok\" [{\"code\":\"$2\",${4:+\"segment\":$4,}\"message\":\"$3\"}]" \
    "$(get status) $(get warnings)"
  run "$method" -q a.json
  expect "$1: quiet" 0 ''
  equal "$1: quiet, but recorded" "\"$2\"" "$(get 'warnings[0].code')"
  run "$method" --strict a.json
  expect "$1: an error under --strict" 1 \
    "phspline: a.json:1: record $id: $3 [$2]
$(failed 1 1)" "$(error_record "$2" '' "$3" a.json 1 "\"$id\"")"
  run "$method" --strict -q a.json
  expect "$1: an error under --strict, quiet" 1 \
    "phspline: a.json:1: record $id: $3 [$2]"
}
