# SPDX-License-Identifier: GPL-3.0-or-later
#
# .ci/install-packages, which `make deps', `make check' and others start: where
# nothing is missing it is silent, installs nothing and asks for no rights; else
# it says what it will install, and how, before it does.
. "$srcdir/tests/cli/lib.sh"

# stub NAME COMMANDS: a command in the place of the system's
mkdir bin
stub() {
  printf '#!/bin/sh\n%s\n' "$2" >"bin/$1"
  chmod +x "bin/$1"
}
PATH=$PWD/bin:$PATH
CC=compiler
export CC
unset PKG_CONFIG GSL_LIBS CJSON_LIBS CAIRO_LIBS TEEM_LIBS EXPAT_LIBS CHECK_LIBS
stub compiler 'test -e installed'
for tool in jq xmllint gnuplot python3 pkg-config apt-cache; do
  stub $tool :
done
stub apt-get 'echo "apt-get: $*" >&2; touch installed'
stub id 'cat user'
# a script's own words
# shellcheck disable=SC2016
stub sudo 'echo "$*" >>asked; shift; [ "$1" = true ] || exec "$@"'

# packages ARGUMENT...: the script, as of a user without rights
echo 1000 >user
packages() {
  status=0
  # expect reads it
  # shellcheck disable=SC2034
  sh "$srcdir/.ci/install-packages" "$@" >out 2>err || status=$?
}

touch installed
packages build test plot
expect 'nothing is missing' 0 '' ''
true_that 'nothing is missing: no rights are asked for' [ ! -e asked ]

options='-o DPkg::Lock::Timeout=300 install -y --no-install-recommends'
names='libgsl-dev libcjson-dev'
missing='install-packages: missing: gsl cjson'
running='install-packages: running:'
as="env DEBIAN_FRONTEND=noninteractive apt-get $options $names"
rm installed
packages build
expect 'sudo' 0 "$missing
$running sudo -n $as
apt-get: $options $names" ''
equal 'sudo: what it was asked' "-n true
-n $as" "$(cat asked)"

rm installed asked
stub sudo 'exit 1'
packages build
expect 'no sudo' 1 "$missing
install-packages: not root, and no sudo without a password; please run:
install-packages:   sudo apt-get install -y --no-install-recommends $names" ''
true_that 'no sudo: nothing is installed' [ ! -e installed ]

echo 0 >user
packages build
expect 'root' 0 "$missing
$running $as
apt-get: $options $names" ''
