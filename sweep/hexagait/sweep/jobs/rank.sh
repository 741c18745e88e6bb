#!/usr/bin/env bash
# One process of mpi.sh: its share of the shards. Knows Open MPI, MPICH and Slurm.
cd "$(dirname "${BASH_SOURCE[0]}")"
@preamble@rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:?no rank: start mpi.sh}}}
size=${OMPI_COMM_WORLD_SIZE:-${PMI_SIZE:-${SLURM_NTASKS:?no number of ranks}}}
for ((k = rank + 1; k <= shards; k += size)); do shard "$k"; done
