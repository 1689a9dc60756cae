# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of `verify' share: results, and what is said of them.  Read
# after lib.sh.

# verified NAME COUNT [OPTION]...: the results in the file r are right.
verified() {
  name=$1 wanted=$2
  shift 2
  run verify "$@" r
  if [ "$status" -eq 0 ] && [ ! -s err ] &&
    [ "$(grep -c '"command":"verify","status":"ok"' out)" -eq "$wanted" ]; then
    pass "$name"
  else
    fail "$name" "status $status, $(wc -l <out) records"
    { cat err && grep -v '"status":"ok"' out; } | sed -n '1,4p' | cut -c 1-400
  fi
}

# refuses NAME CHECK PROBLEMS FILTER: what jq makes of r, by that check.
refuses() {
  jq -c "$4" r >wrong.json
  run verify -q --problems="$3" wrong.json
  equal "$1" "\"$2\" 1" "$(jq -c .worst.check out) $status"
}

# made COMMAND [OPTION]...: its results of standard input, in r.
made() {
  run "$@" -q -
  mv out r
  [ "$status" -eq 0 ] || fail "$*" "status $status: $(sed -n 1p err)"
}
