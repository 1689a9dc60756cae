#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs in parts, by engines that people have: make, GNU parallel, ssh, Slurm
# (make check-cluster).  Whatever is killed on the way, what merge puts together
# is the output of a single run, byte for byte.  Daemons run on the loopback, on
# files below a temporary folder, and are ended by their process ids.
#
# texts with $ are for inner shells; numbers of parts are words
# shellcheck disable=SC2016,SC2013
set -u
export LC_ALL=C
srcdir=$(cd "${srcdir:-.}" && pwd)
PHSPLINE=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
export PHSPLINE
scripts=$srcdir/data/slurm
tmp=$(mktemp -d)
bad=0 good=0 daemons=''

finish() {
  for daemon in $daemons; do
    kill "$daemon" 2>/dev/null
  done
  cd / && umount "$tmp/full" 2>/dev/null
  wait
  rm -rf "$tmp"
}
trap finish EXIT
trap 'exit 1' HUP INT TERM
cd "$tmp" || exit 1

pass() {
  echo "ok $1"
  good=$((good + 1))
}
fail() {
  echo "not ok $1: $2"
  bad=$((bad + 1))
}
skip() {
  echo "SKIP $1: $2"
}
# that NAME COMMAND...: the command succeeds
that() {
  name=$1
  shift
  if "$@" >that.out 2>&1; then
    pass "$name"
  else
    fail "$name" "status $? of $*"
    sed 's/^/  /' that.out | tail -n 5
  fi
}
# until_true SECONDS COMMAND...: waits until the command succeeds
until_true() {
  tries=$((10 * $1))
  shift
  while ! "$@" >/dev/null 2>&1; do
    tries=$((tries - 1))
    [ "$tries" -gt 0 ] || return 1
    sleep 0.1
  done
}
# merged NAME: the parts are put together, and are the single run
merged() {
  that "$1: nothing is missing" sh "$scripts/merge" $n out
  that "$1: the bytes of one run" cmp one out
  rm -f out out.*-of-* .out.*
}
has() {
  command -v "$1" >/dev/null
}

# ---- a job -------------------------------------------------------------------

# Curves of 10 to 400 points; one in nine fails, so some in every part.
n=12
awk 'BEGIN {
  for (i = 1; i <= 3000; i++) {
    m = i % 9 ? 10 + 390 * (i % 20 == 0) : 1
    text = ""
    for (k = 0; k < m; k++)
      text = text (k ? "," : "") "[" k "," sin(k * (i % 7 + 1)) "]"
    print "{" (i % 2 ? "\"id\":" i "," : "") "\"points\":[" text "]}"
  }
}' >in.jsonl
"$PHSPLINE" planar --shard=0/1 --quiet in.jsonl -o one 2>/dev/null
that 'a single run has bad records' [ $? -eq 1 ]
k=0
while [ $k -lt $n ]; do
  "$PHSPLINE" planar --quiet --shard=$k/$n --fields=id in.jsonl 2>/dev/null |
    grep -o '"status":"[a-z]*"' | sort -u | tr '\n' ' '
  k=$((k + 1))
done >statuses
that 'bad records and good ones in every part' [ "$(grep -o '"error" "status":"ok"' \
  statuses | wc -l)" -eq $n ]

# A program that is killed in the middle of its 5th part, once: when some of its
# output is in its file.
cat >killed <<'END'
#!/bin/sh
case "$*" in
*--shard=5/*)
  if mkdir killed.once 2>/dev/null; then
    (ulimit -v unlimited; exec "$REAL" "$@") &
    victim=$!
    tries=0
    while [ $tries -lt 2000 ]; do
      for file in .out.5-of-*; do
        [ -s "$file" ] && break 2
      done
      tries=$((tries + 1))
    done
    kill -9 $victim
    wait $victim
    exit
  fi
  ;;
esac
exec "$REAL" "$@"
END
printf '#!/bin/sh\nsleep 2\nexec "$REAL" "$@"\n' >slow
chmod +x killed slow
REAL=$PHSPLINE
export REAL

# ---- make --------------------------------------------------------------------

that 'make: runs' make -s -j 2 -f "$scripts/example.mk" N=$n FILES=in.jsonl \
  OUT=out
that 'make: the bytes of one run' cmp one out
rm -f out out.3-of-$n
that 'make: repeats what is missing' make -s -j 2 -f "$scripts/example.mk" N=$n \
  FILES=in.jsonl OUT=out
merged make
for k in 0 1 2 3; do
  : >"out.$k-of-$n"
done
sh "$scripts/merge" $n out 2>merge.err
that 'merge: refuses' sh -c '[ ! -e out ] &&
  grep -q "^merge: parts of out are missing: 4,5,6,7,8,9,10,11$" merge.err'
rm -f out.*

# ---- GNU parallel ------------------------------------------------------------

# a file each; options of parallel are not the script's
# shellcheck disable=SC2120,SC2119
# spread [OPTION]...: all parts, two at once
spread() {
  seq 0 $((n - 1)) | parallel --will-cite -j 2 --joblog log "$@" \
    "sh '$scripts/part' {} $n out planar --quiet --jobs=1 in.jsonl"
}
if has parallel; then
  that 'parallel: runs' spread
  merged parallel
  rm -f log
  PHSPLINE=$tmp/killed
  that 'parallel: a worker is killed, and repeated' spread --retries 3
  PHSPLINE=$REAL
  that 'parallel: it was killed' test -d killed.once
  that 'parallel: each part is logged once' sh -c \
    "[ \"\$(awk 'NR > 1' log | wc -l)\" -eq $n ]"
  merged 'parallel, a worker killed'
  rm -rf log killed.once
  spread >/dev/null 2>&1 &
  until_true 20 sh -c "[ \"\$(ls out.*-of-$n | wc -l)\" -ge 2 ]"
  coordinator=$(pgrep -P $! -f parallel | head -n 1)
  kill -9 "${coordinator:-$!}" 2>/dev/null
  wait $! 2>/dev/null
  if sh "$scripts/merge" $n out 2>/dev/null; then
    fail 'parallel: the coordinator is killed' 'all was done before'
  else
    pass 'parallel: the coordinator is killed'
  fi
  that 'parallel: resumed' spread --resume-failed
  that 'parallel: nothing twice' sh -c \
    "[ -z \"\$(awk 'NR > 1 && \$7 == 0 { print \$1 }' log | sort | uniq -d)\" ]"
  merged 'parallel, the coordinator killed'
  rm -f log
else
  skip parallel 'there is no GNU parallel'
fi

# ---- a full disk -------------------------------------------------------------

mkdir full
if mount -t tmpfs -o size=1m none full 2>/dev/null; then
  k=0
  while [ $k -lt $n ]; do
    (cd full && sh "$scripts/part" $k $n out planar -q ../in.jsonl 2>>err)
    case $? in
    0) mv full/out.$k-of-$n . ;;
    4) [ ! -e full/out.$k-of-$n ] || fail 'a full disk' 'half a part' ;;
    *) fail 'a full disk' 'not with status 4' ;;
    esac
    [ $k -ne 2 ] || head -c 990000 /dev/zero >full/rest
    k=$((k + 1))
  done
  that 'a full disk: told' grep -q 'No space left on device' full/err
  sh "$scripts/merge" $n out 2>merge.err
  that 'a full disk: parts are missing' grep -q 'are missing: .*3' merge.err
  for k in $(sed 's/.*: //; s/,/ /g' merge.err); do
    sh "$scripts/part" "$k" $n out planar -q in.jsonl 2>/dev/null
  done
  merged 'a full disk, repeated elsewhere'
else
  skip 'a full disk' 'nothing can be mounted here'
fi

# ---- ssh ---------------------------------------------------------------------

start_ssh() {
  has sshd && has ssh && has ssh-keygen || return 1
  mkdir -p /run/sshd 2>/dev/null
  ssh-keygen -q -t ed25519 -N '' -f host && ssh-keygen -q -t ed25519 -N '' -f key &&
    cp key.pub authorized && chmod 600 authorized || return 1
  port=$((20000 + $$ % 20000))
  "$(command -v sshd)" -D -e -p $port -h "$tmp/host" -f /dev/null \
    -o ListenAddress=127.0.0.1 -o AuthorizedKeysFile="$tmp/authorized" \
    -o StrictModes=no -o UsePAM=no -o PidFile=none \
    -o PermitRootLogin=prohibit-password 2>sshd.log &
  daemons="$daemons $!"
  login="ssh -i $tmp/key -p $port -o StrictHostKeyChecking=no \
    -o UserKnownHostsFile=/dev/null -o LogLevel=ERROR 127.0.0.1"
  # words
  # shellcheck disable=SC2086
  until_true 5 $login true
}
if ! has parallel; then
  skip ssh 'there is no GNU parallel'
elif start_ssh; then
  # both nodes are this machine
  that 'ssh: runs' spread --sshlogin "1/$login" --sshlogin 1/: --workdir "$tmp" \
    --env PHSPLINE
  that 'ssh: some of it by ssh' sh -c "awk '{ print \$2 }' log | grep -q ssh ||
    [ \"\$(awk 'NR > 1 { print \$2 }' log | sort -u | wc -l)\" -eq 2 ]"
  merged ssh
else
  skip ssh "no server on the loopback: $(tail -n 1 sshd.log 2>/dev/null)"
fi

# ---- Slurm -------------------------------------------------------------------

start_munge() {
  mkdir -m 700 munge && head -c 1024 /dev/urandom >munge/key &&
    chmod 600 munge/key && chmod 755 "$tmp" && chmod 711 munge || return 1
  munged -F -f --key-file="$tmp/munge/key" --socket="$tmp/munge/socket" \
    --pid-file="$tmp/munge/pid" --log-file="$tmp/munge/log" \
    --seed-file="$tmp/munge/seed" >munge.log 2>&1 &
  daemons="$daemons $!"
  until_true 5 munge -S "$tmp/munge/socket" -n
}
start_controller() {
  slurmctld -D >>controller.log 2>&1 &
  controller=$!
  daemons="$daemons $controller"
  until_true 10 scontrol ping
}
start_slurm() {
  for program in munged munge slurmctld slurmd sbatch scontrol squeue; do
    has $program || return 1
  done
  [ "$(id -u)" -eq 0 ] || return 1
  start_munge || return 1
  mkdir state spool
  node=$(hostname -s)
  cat >slurm.conf <<END
ClusterName=check
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$((20001 + $$ % 20000))
SlurmdPort=$((20002 + $$ % 20000))
AuthType=auth/munge
AuthInfo=socket=$tmp/munge/socket
CredType=cred/munge
SlurmUser=root
StateSaveLocation=$tmp/state
SlurmdSpoolDir=$tmp/spool
SlurmctldPidFile=$tmp/slurmctld.pid
SlurmdPidFile=$tmp/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=0
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MinJobAge=300
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
END
  SLURM_CONF=$tmp/slurm.conf
  export SLURM_CONF
  start_controller || return 1
  slurmd -D -N "$node" >node.log 2>&1 &
  daemons="$daemons $!"
  until_true 20 sh -c 'sinfo -h -o %T | grep -q idle'
}
# submit PARTS: an array job; waits until it has ended
submit() {
  PART=$scripts/part sbatch --parsable --array="$1" "$scripts/phspline.sbatch" \
    $n out planar --quiet in.jsonl >job 2>sbatch.err
}
ended() {
  until_true 120 sh -c '[ -z "$(squeue -h)" ]'
}
if start_slurm; then
  that 'slurm: submitted' submit 0-$((n - 1))
  that 'slurm: ended' ended
  merged slurm

  PHSPLINE=$tmp/killed
  submit 0-$((n - 1))
  ended
  PHSPLINE=$REAL
  sh "$scripts/merge" $n out 2>merge.err
  that 'slurm: a worker is killed, its part is missing' grep -q \
    'are missing: 5$' merge.err
  submit "$(sed 's/.*: //' merge.err)"
  ended
  merged 'slurm, a worker killed'

  # what was submitted is on the disk after some seconds
  PHSPLINE=$tmp/slow
  submit 0-$((n - 1))
  PHSPLINE=$REAL
  until_true 30 sh -c "[ \"\$(ls out.*-of-$n | wc -l)\" -ge 6 ]"
  kill -9 "$controller"
  wait "$controller" 2>/dev/null
  that 'slurm: the controller is killed, and another one goes on' \
    start_controller
  # a task whose end the first one alone knew seems to run on: it is cancelled,
  # and what is missing then, submitted again
  until_true 30 sh "$scripts/merge" $n out
  scancel --user=root
  that 'slurm: it ends' ended
  rm -f out
  sh "$scripts/merge" $n out 2>merge.err ||
    { submit "$(sed 's/.*: //' merge.err)" && ended; }
  rm -f out
  merged 'slurm, the controller killed'

  submit 0-$((n - 1))
  until_true 30 sh -c 'squeue -h -t R | grep -q .'
  running=$(squeue -h -t R -o %i | head -n 1)
  that 'slurm: a task is requeued' scontrol requeue "$running"
  that 'slurm: it runs again' ended
  merged 'slurm, a task repeated'
else
  skip slurm "it does not start here: $(tail -n 1 controller.log node.log \
    2>/dev/null | tail -n 1)"
fi

echo
echo "$good passed, $bad failed"
[ "$bad" -eq 0 ]
