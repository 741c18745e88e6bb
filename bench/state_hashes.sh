#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Prints the state hash of a list of walks, actions and sweeps, a line each: what a change that is to
# move no robot leaves as it is. Two minutes.
#
#   bench/state_hashes.sh [HEXAGAIT] >after.txt; diff before.txt after.txt
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
hexagait=$(realpath "${1:-$here/build/release/app/hexagait}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$here"

# The last column of a row: a walk's own hash, or one of the numbers that an action ended with, all of
# their digits.
row() {
  local out hash
  out=$("$hexagait" "$@" --json 2>/dev/null </dev/null) || true
  hash=$(grep -oE '"state_hash": *"[0-9a-f]{16}' <<<"$out" | grep -oE '[0-9a-f]{16}$' | head -n 1) ||
    hash=$(grep -oiE '"(seconds|stability_margin_m|tilt_rad|odometry_error_m|foot_force_max_n)": *[-0-9.e]+' \
             <<<"$out" | grep -oE '[-0-9.e]+$' | sha256sum | cut -c 1-16)
  printf '%-88s %s\n' "$*" "$hash"
}

for options in "--radius 1.5" "--crab 45deg --terrain steps:0.10" "--spin cw" "--spin ccw" \
               "--radius -1 --terrain boxes:0.10" "--terrain boxes:0.20 --seed 3" \
               "--random-commands 1" "--random-posture 0.05" "--duty-factor 0.75" "--gait tripod" \
               "--control-period 0.004" "--physics-step 0.001"; do
  # shellcheck disable=SC2086  # words on purpose
  row walk --robot robots/argos.urdf --seconds 10 $options
done
row walk --robot robots/hexapod_4dof.urdf --seconds 10
row walk --robot genghis2d --seconds 20
row walk --robot genghis2d --terrain step:10cm --seconds 20 --random-posture 0.025
for action in actions/*.yaml; do
  robot=argos
  [[ $(basename "$action") != push_up.yaml ]] || robot=quadruped
  row run "$action" --robot "robots/$robot.urdf"
done
row run actions/look_around.yaml --robot robots/argos.urdf --controller virtual_model
row run actions/push_up.yaml --robot robots/quadruped_rpp.urdf

# Of a sweep: the columns that say how each walk went.
sweep_row() {
  "$hexagait" sweep "$scratch/$1.yaml" --out "$scratch/$1" --jobs 2 >/dev/null 2>&1 || true
  printf '%-88s %s\n' "sweep $1" \
    "$(awk -F, 'NR == 1 {for (k = 1; k <= NF; ++k) if ($k ~ /^(seed|speed_m_s|speed|hash)$/) use[k] = 1}
                {for (k = 1; k <= NF; ++k) if (k in use) printf "%s ", $k; print ""}' \
         "$scratch/$1/trials.csv" | sha256sum | cut -c 1-16)"
}

cat >"$scratch/slice.yaml" <<'END'
simulator: slice
controllers: [tripod, free, unadjusted, "wave:0.75"]
terrains: [flat, profile]
roughness: [1, 3]
seeds: 200
slices: 200
END
cat >"$scratch/box2d.yaml" <<'END'
simulator: box2d
controllers: [tripod, free]
terrains: [rough]
roughness: [0.04]
seeds: 4
seconds: 10
END
cat >"$scratch/ode.yaml" <<'END'
simulator: ode
controllers: [tripod, free]
robots: [argos]
terrains: [boxes]
roughness: [0.10]
seeds: 3
seconds: 5
random_posture: 0.05
END
for name in slice box2d ode; do sweep_row $name; done
