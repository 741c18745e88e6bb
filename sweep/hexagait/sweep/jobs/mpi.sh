#!/usr/bin/env bash
# Runs the shards by mpirun, which gets the options: -np 16 --hostfile hosts.
cd "$(dirname "${BASH_SOURCE[0]}")"
@preamble@if (($# == 0)); then set -- -np "$shards"; fi
"${MPIRUN:-mpirun}" "$@" "$PWD/rank.sh"
merge
