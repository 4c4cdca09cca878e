#!/bin/bash
# samples/cluster/campaigns.sbatch on a Slurm cluster of two nodes on this machine: 60 campaigns, one node is killed in the middle, and
# all results are those of a batch without the cluster. Needs root, slurm-wlm and munge (Debian); skipped, saying so, without them.
# usage: slurm.sh ETALON
set -euo pipefail
etalon=$(realpath "$1") here=$(cd "$(dirname "$0")/../.." && pwd)
for program in munged slurmctld slurmd sbatch; do
    command -v "$program" >/dev/null || { echo "skipped: there is no $program (slurm-wlm and munge of Debian)"; exit 0; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: the cluster needs root"; exit 0; }

D=$(mktemp -d)
chmod 755 "$D"
end() {
    for file in slurmctld slurmd-n1 slurmd-n2 munged; do
        [ ! -f "$D/$file.pid" ] || kill "$(<"$D/$file.pid")" 2>/dev/null || true
    done
    sleep 1
    [ "${KEEP:-}" ] || rm -rf "$D"
}
trap end EXIT
mkdir -p "$D"/{state,spool/n1,spool/n2,munge,local,cluster}
chmod 755 "$D/munge"
head -c 1024 /dev/urandom >"$D/munge/munge.key"
chmod 600 "$D/munge/munge.key"
munged --force --key-file="$D/munge/munge.key" --socket="$D/munge/munge.sock" --pid-file="$D/munged.pid" \
    --log-file="$D/munge/munged.log" --seed-file="$D/munge/seed"
cat >"$D/slurm.conf" <<CONF
ClusterName=mini
SlurmctldHost=localhost
SlurmUser=root
AuthInfo=socket=$D/munge/munge.sock
StateSaveLocation=$D/state
SlurmdSpoolDir=$D/spool/%n
SlurmctldPidFile=$D/slurmctld.pid
SlurmdPidFile=$D/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdParameters=config_overrides
SlurmdTimeout=10
NodeName=n[1-2] NodeHostname=localhost NodeAddr=127.0.0.1 Port=[17001-17002] CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF=$D/slurm.conf
slurmctld -L "$D/slurmctld.log"
slurmd -N n1 -L "$D/n1.log"
slurmd -N n2 -L "$D/n2.log"

for i in $(seq 60); do
    c=$D/cluster/c$i
    mkdir -p "$c"
    cp -r "$here"/samples/prexyt-cmm/{campaign.toml,robot.toml,truth.toml,encoders.csv,exports} "$c"
    "$etalon" simulate "$c" --seed "$i" >/dev/null
    echo "c$i"
done >"$D/cluster/campaigns.txt"
cp -r "$D"/cluster/. "$D/local"
(cd "$D/local" && "$etalon" batch campaigns.txt >/dev/null)

cd "$D/cluster"
export ETALON=$etalon
job=$(sbatch --parsable --array=0-9 "$here/samples/cluster/campaigns.sbatch" "$D/cluster/campaigns.txt")
summary=$(sbatch --parsable --dependency=afterany:"$job" "$here/samples/cluster/campaigns.sbatch" "$D/cluster/campaigns.txt")
until [ "$(squeue -h -t R -w n2 -o %A | wc -l)" -gt 0 ] && compgen -G "$D/cluster/c*/out" >/dev/null; do sleep 0.2; done

# node n2 ends as with its power: its daemon, the steps of its jobs and all that they started
tree() { echo "$1"; for child in $(pgrep -P "$1" || true); do tree "$child"; done; }
lost=()
for id in $(squeue -h -t R -w n2 -o %A); do
    for step in $(pgrep -f "^slurmstepd: \[$id\." || true); do mapfile -t -O ${#lost[@]} lost < <(tree "$step"); done
done
kill -9 "$(<"$D/slurmd-n2.pid")" "${lost[@]}" 2>/dev/null || true
done_by_then=$(find "$D/cluster" -path '*/out/manifest.json' | wc -l)
echo "n2 was killed with ${#lost[@]} processes when $done_by_then of 60 campaigns were done"
slept=0
while squeue -h -j "$job,$summary" 2>/dev/null | grep -q .; do
    # the node comes back, and requeued tasks need not wait two minutes
    [ $slept != 20 ] || slurmd -N n2 -L "$D/n2.log"
    for id in $(squeue -h -t PD -j "$job" -r -o %A); do scontrol update JobId="$id" StartTime=now 2>/dev/null || true; done
    [ $slept -lt 600 ] || { squeue; tail -20 "$D"/*.log; echo "the jobs do not end"; exit 1; }
    sleep 1
    slept=$((slept + 1))
done
echo "the jobs took $slept s after that"
cd "$D"
same=0
for i in $(seq 60); do
    diff -r "local/c$i/out" "cluster/c$i/out" && same=$((same + 1))
    [ -z "$(find "cluster/c$i" -name '.*' -mindepth 1)" ] || { echo "litter in c$i"; exit 1; }
done
cmp local/batch.parquet cluster/batch.parquet
echo "$same of 60 results are those of the local batch"
[ "$same" = 60 ]
