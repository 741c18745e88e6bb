#!/usr/bin/env bash
# Runs the shards, as many at once as there are cores, or as the options say, which
# go to GNU parallel: --jobs 4, or --sshlogin with a directory that all share.
cd "$(dirname "${BASH_SOURCE[0]}")"
@preamble@export -f shard
export hexagait sweep folder results shards
seq "$shards" | parallel --will-cite --halt soon,fail=1 --joblog parallel.log --workdir "$PWD" --env shard --env hexagait --env sweep --env folder --env results --env shards "$@" shard
merge
