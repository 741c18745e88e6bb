# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What `./check --cluster` does; sourced by it. A sweep by GNU parallel, by a Slurm array and by
# mpirun, all really run on this machine, gives the bytes of one process.

kClusterPackages=(parallel munge slurmctld slurmd slurm-client openmpi-bin)
kCluster=build/cluster

cluster_run() { build/release/app/hexagait sweep sweeps/smoke.yaml --quiet "$@"; }

# One process, and the hash that all others must have.
cluster_reference() {
  rm -rf "$kCluster"
  mkdir -p "$kCluster"
  cluster_run --jobs 1 --out "$kCluster/one"
  sha256sum <"$kCluster/one/trials.csv" >"$kCluster/hash"
  cut -c1-16 "$kCluster/hash" >"$note"
}

# cluster_same DIR: the merged result is that of the one process.
cluster_same() {
  sha256sum <"$1/merged/trials.csv" | cmp - "$kCluster/hash"
  cut -c1-16 "$kCluster/hash" >"$note"
}

cluster_parallel() {
  cluster_run --emit parallel --shards 5 --out "$kCluster/parallel"
  "$kCluster/parallel/parallel.sh"
  cluster_same "$kCluster/parallel"
}

# Two ranks share five shards.
cluster_mpi() {
  cluster_run --emit mpi --shards 5 --out "$kCluster/mpi"
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    "$kCluster/mpi/mpi.sh" -np 2 --oversubscribe --mca plm isolated
  cluster_same "$kCluster/mpi"
}

# A Slurm of this machine alone: its node is this host, its keys and state lie in build/cluster.
slurm_configuration() {
  local host cores user
  host=$(hostname -s) cores=$(nproc) user=$(id -un)
  cat <<END
ClusterName=hexagait
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$1/munge.socket
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=2,bf_interval=2
MinJobAge=300
ReturnToService=2
MpiDefault=none
StateSaveLocation=$1/state
SlurmdSpoolDir=$1/spool
SlurmctldPidFile=$1/slurmctld.pid
SlurmdPidFile=$1/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=10 State=UP
END
}

cluster_start_slurm() {
  local dir=$PWD/$kCluster/slurmd.d try
  mkdir -p "$dir/state" "$dir/spool" "$dir/munge"
  chmod 0700 "$dir/munge"
  chmod 0755 "$dir"
  dd if=/dev/urandom of="$dir/munge/key" bs=128 count=1 status=none
  chmod 0600 "$dir/munge/key"
  slurm_configuration "$dir" >"$dir/slurm.conf"

  # In the foreground each, so that we know whom to stop.
  munged --foreground --force --socket="$dir/munge.socket" --key-file="$dir/munge/key" \
    --pid-file="$dir/munge/pid" --log-file="$dir/munge/log" --seed-file="$dir/munge/seed" 3>&- &
  echo $! >>"$kCluster/daemons"
  for try in {1..50}; do [[ -S $dir/munge.socket ]] && break; sleep 0.1; done
  slurmctld -D -c -f "$SLURM_CONF" >"$dir/slurmctld.log" 2>&1 3>&- &
  echo $! >>"$kCluster/daemons"
  slurmd -D -c -f "$SLURM_CONF" >"$dir/slurmd.log" 2>&1 3>&- &
  echo $! >>"$kCluster/daemons"
  for try in {1..60}; do
    [[ $(sinfo --noheader --format=%t 2>/dev/null) == idle ]] && return 0
    sleep 0.5
  done
  sinfo || true
  tail -n 20 "$dir"/*.log
  return 1
}

cluster_slurm() {
  cluster_run --emit slurm --shards 5 --out "$kCluster/slurm"
  timeout 60 "$kCluster/slurm/slurm.sh" --wait || { tail -n 5 "$kCluster"/slurm/*.log; return 1; }
  cluster_same "$kCluster/slurm"
}

# Whatever happened, our daemons end; they end their own jobs.
cluster_stop() {
  local process
  [[ -f $kCluster/daemons ]] || return 0
  while read -r process; do kill "$process" 2>/dev/null || true; done < <(tac "$kCluster/daemons")
  rm -f "$kCluster/daemons"
}

check_cluster() {
  install_packages "${kClusterPackages[@]}"
  step "release build" build release --target hexagait_app
  export SLURM_CONF=$PWD/$kCluster/slurmd.d/slurm.conf
  trap cluster_stop EXIT
  step "sweep, one process" cluster_reference
  step "GNU parallel" cluster_parallel
  step "mpirun" cluster_mpi
  step "Slurm starts" cluster_start_slurm
  step "Slurm array" cluster_slurm
}
