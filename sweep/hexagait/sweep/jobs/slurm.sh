#!/usr/bin/env bash
# Submits the shards, and the merge for when all of them are well. Options go to
# sbatch. With --wait it ends when all is done.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
wait=()
if [[ ${1:-} == --wait ]]; then wait=(--wait); shift; fi
array=$(sbatch --parsable "$@" shard.sbatch)
sbatch "${wait[@]}" "$@" --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes merge.sbatch
