#!/usr/bin/env bash
# A sweep by every engine: processes here, GNU parallel, and Slurm, all of it real. munged, slurmctld and two slurmd run on
# this machine as two nodes on the loopback address, without systemd. In the midst of a job array one node's daemon is
# killed and started again, in the midst of another the controller. Every engine leaves the same bytes, and no task runs
# twice.
#   SweepEnginesTest.sh BUILD SOURCE WORK
# Exit code 77 where slurm-wlm, munge or parallel are not there. ./dev setup installs them.
set -euo pipefail

for Program in slurmctld slurmd munged sbatch squeue parallel; do
	PATH=$PATH:/usr/sbin command -v $Program >/dev/null ||
		{ echo "skipped: there is no $Program: apt-get install slurm-wlm munge parallel, which ./dev setup does"; exit 77; }
done
PATH=$PATH:/usr/sbin
Drydock=$(realpath "$1")/bin/drydock Configs=$(realpath "$2")/configs
rm -rf "$3"
mkdir -p "$3"
cd "$3"
Work=$PWD
export DRYDOCK_CACHE_DIR=${DRYDOCK_CACHE_DIR:-$Work/cache} SLURM_CONF=$Work/slurm.conf

cat >sweep.json <<END
{"scene": {"file": "$Configs/scenes/toon_character_1080p.exr"},
	"volumes": [{"bUnbound": true, "Settings": {"BloomThreshold": -1}}],
	"sweep": {"axes": [{"name": "r.BloomQuality", "values": [1, 5]}, {"name": "BloomIntensity", "values": [0.5, 1, 2, 3]}],
		"against": {"r.BloomQuality": 5}}}
END

Fail() {
	printf 'FAILED: %s\n' "$*"
	tail -n 5 ./*.log */log/*.txt 2>/dev/null
	exit 1
}
Plan() { "$Drydock" sweep plan sweep.json --out "$1" >plan.log 2>&1 || Fail "plan $1"; }
Sums() { (cd "$1" && find results plots table.json table.csv sheet.png tasks.jsonl -type f ! -path '*.writing.*' -print0 | sort -z | xargs -0 sha256sum); }
ExpectSame() {
	Sums "$1" >"$1.sums"
	cmp local.sums "$1.sums" || Fail "$1 has other bytes than local: $(diff local.sums "$1.sums" | head -n 4)"
	printf '%s: %s files, sha256 of all sums %s\n' "$1" "$(wc -l <"$1.sums")" "$(sha256sum <"$1.sums" | cut -c1-64)"
}
# Until the command succeeds, for so many seconds.
Until() {
	local Seconds=$1 What=$2 Tries
	shift 2
	for ((Tries = 0; Tries < Seconds * 5; ++Tries)); do "$@" >/dev/null 2>&1 && return; sleep 0.2; done
	Fail "$What did not come in $Seconds s"
}

Plan local
"$Drydock" sweep submit local --engine local >local.log 2>&1 || Fail "submit local"
ExpectSame local

Plan parallel
"$Drydock" sweep submit parallel --engine parallel --shards 8 -- -j 2 >parallel.log 2>&1 || Fail "submit parallel"
ExpectSame parallel

# --- Slurm ---------------------------------------------------------------------------------------------------------------
User=$(id -un) Host=$(hostname -s)
mkdir -p munge ctld spool.n1 spool.n2
chmod 711 . munge
head -c 1024 /dev/urandom >munge/key
chmod 400 munge/key
cat >slurm.conf <<END
ClusterName=drydock
SlurmctldHost=$Host(127.0.0.1)
SlurmctldPort=16817
SlurmUser=$User
SlurmdUser=$User
AuthType=auth/munge
AuthInfo=socket=$Work/munge/socket
StateSaveLocation=$Work/ctld
SlurmdSpoolDir=$Work/spool.%n
SlurmctldPidFile=$Work/slurmctld.pid
SlurmdPidFile=$Work/slurmd.%n.pid
SlurmctldLogFile=$Work/slurmctld.log
SlurmdLogFile=$Work/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
ReturnToService=2
SlurmdTimeout=20
BatchStartTimeout=5
MpiDefault=none
NodeName=n1 NodeHostname=$Host NodeAddr=127.0.0.1 Port=17001 CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=$Host NodeAddr=127.0.0.1 Port=17002 CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END

Started=()
EndAll() {
	local Process
	for Process in "${Started[@]}"; do kill -TERM "$Process" 2>/dev/null || true; done
	wait 2>/dev/null || true
}
trap EndAll EXIT
munged --foreground --force --key-file="$Work/munge/key" --socket="$Work/munge/socket" --pid-file="$Work/munge/pid" \
	--log-file="$Work/munge.log" --seed-file="$Work/munge/seed" >>munged.out.log 2>&1 &
Started+=($!)
Until 20 munged test -S munge/socket
StartController() { slurmctld -D "$@" >>slurmctld.out.log 2>&1 & Controller=$! Started+=($!); }
StartNode() { slurmd -D -N "$1" >>"slurmd.$1.out.log" 2>&1 & Node=$! Started+=($!); }
StartController -c
StartNode n1
StartNode n2
AreIdle() { [ "$(sinfo -h -N -o %T | grep -c '^idle')" = 2 ]; }
Until 60 "two idle nodes" AreIdle

Done() { "$Drydock" sweep status "$1" --json | jq .done; }
IsMid() { local Now; Now=$(Done "$1"); [ "$Now" -ge 1 ] && [ "$Now" -lt 7 ]; }
IsQueueEmpty() { local Jobs; Jobs=$(squeue -h) && [ -z "$Jobs" ]; }
# The queue is empty, or has not changed for a minute.
StillJobs="" StillSince=$SECONDS
IsQueueStill() {
	local Jobs
	Jobs=$(squeue -h -o '%i %T' | sort) || return 1
	[ -n "$Jobs" ] || return 0
	[ "$Jobs" = "$StillJobs" ] || { StillJobs=$Jobs StillSince=$SECONDS; }
	[ $((SECONDS - StillSince)) -ge 60 ]
}
# The controller has written its jobs to disk since FILE was written.
IsRecorded() { [ ctld/job_state -nt "$1" ]; }
Submit() {
	Plan "$1"
	"$Drydock" sweep submit "$1" --engine slurm --shards 8 >"$1.log" 2>&1 || Fail "submit $1"
	cat "$1.log"
}
# Expect NAME END: END becomes true, and the folder NAME holds what every engine leaves. A killed controller forgets jobs of
# its last seconds, and may wait without end for a job that a node has under the same id. A user cancels what is left and
# submits again, and so does this.
Expect() {
	Until 300 "the end of $1" "$2"
	if [ "$(Done "$1")" -lt 8 ] || ! IsQueueEmpty; then
		scancel --user="$User"
		Until 120 "an empty queue" IsQueueEmpty
		printf 'submitted again with %s of 8 tasks done\n' "$(Done "$1")"
		"$Drydock" sweep submit "$1" --engine slurm --shards 8 >"$1.log" 2>&1 || Fail "submit $1 again"
		Until 300 "the end of $1" IsQueueEmpty
	fi
	Until 60 "the page of $1" test -s "$1/sweep.html"
	ExpectSame "$1"
	local Run
	Run=$(cat "$1"/log/shard_*.txt | awk '/ tasks run,/ { Sum += $1 } END { print Sum }')
	[ "$Run" = 8 ] || Fail "$Run tasks ran, not 8"
}

Submit node
Until 120 "the midst of node" IsMid node
printf 'killed the daemon of n2 with %s of 8 tasks done\n' "$(Done node)"
kill -KILL "$Node"
sleep 2
StartNode n2
Expect node IsQueueEmpty

Until 60 "two idle nodes" AreIdle
scontrol update PartitionName=all State=DOWN # jobs wait until the controller's record has them
Submit controller
Until 60 "the controller's record of the jobs" IsRecorded controller.log
scontrol update PartitionName=all State=UP
Until 120 "the midst of controller" IsMid controller
printf 'killed the controller with %s of 8 tasks done\n' "$(Done controller)"
kill -KILL "$Controller"
sleep 2
StartController
Expect controller IsQueueStill # its queue may need a hand
echo "local, parallel and two runs by Slurm: the same bytes, nothing twice"
