#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
set -euo pipefail

usage() {
  cat <<'END'
Usage: bench/sweep_speedup.sh [COMMAND]

How near two jobs of one sweep come to two programs that know nothing of each other: a sweep of the
slice model (10 000 trials of some 0.1 ms, where messages cost most) with one job, with two, and as
two halves with one job each, in turn, five times. Prints a row each, and the medians.

COMMAND is hexagait; by default that of build/release.
END
}
[[ ${1:-} != -h && ${1:-} != --help ]] || { usage; exit 0; }

cd "$(dirname "${BASH_SOURCE[0]}")/.."
hexagait=$(realpath "${1:-build/release/app/hexagait}")
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cat >"$dir/sweep.yaml" <<'END'
simulator: slice
controllers: [tripod, free]
terrains: [descent:3-7]
seeds: 5000
slices: 500
END

# seconds COMMAND…: wall time.
seconds() {
  local begin=$EPOCHREALTIME
  "$@"
  local end=$EPOCHREALTIME
  printf '%d.%06d' $(((${end/./} - ${begin/./}) / 1000000)) $(((${end/./} - ${begin/./}) % 1000000))
}
sweep() { rm -rf "$dir/$1"; "$hexagait" sweep "$dir/sweep.yaml" --quiet --out "$dir/$@" >/dev/null; }
halves() {
  sweep first --jobs 1 --shard 1/2 &
  local other=$!
  sweep second --jobs 1 --shard 2/2
  wait "$other"
}

printf 'one job [s]   two jobs [s]   two programs [s]   speed-up of jobs   of programs   ratio\n'
for _ in 1 2 3 4 5; do
  one=$(seconds sweep one --jobs 1)
  two=$(seconds sweep two --jobs 2)
  programs=$(seconds halves)
  awk -v a="$one" -v b="$two" -v c="$programs" 'BEGIN {
    printf "%11.3f   %12.3f   %16.3f   %16.3f   %11.3f   %5.3f\n", a, b, c, a / b, a / c, c / b }'
done | tee "$dir/rows"
awk '{print $6}' "$dir/rows" | sort -n | awk 'NR == 3 {print "median of the ratio: " $1}'
