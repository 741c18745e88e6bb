#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Are walks, actions and sweeps the same to the last bit on every processor?
#
#   app/same_bits.sh golden HEXAGAIT   their hashes are those of app/golden_hashes.txt
#   app/same_bits.sh fma HEXAGAIT      the C library without fused multiply-add gives the same hashes
#   app/same_bits.sh write HEXAGAIT    makes app/golden_hashes.txt anew
#   app/same_bits.sh more HEXAGAIT     prints the hashes of many more, two minutes: what a change that
#                                      is to move no robot leaves as it is
#
# Exit status 77: this processor, or a missing file of hashes, cannot tell.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mode=$1 hexagait=$(realpath "$2")
golden=$root/app/golden_hashes.txt
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$root"

# All numbers of an action's result, or the state hash of a walk.
row() {
  local out hash
  out=$("$hexagait" "$@" --json 2>/dev/null </dev/null) || true
  hash=$(grep -oE '"state_hash": *"[0-9a-f]{16}' <<<"$out" | grep -oE '[0-9a-f]{16}$') ||
    hash=$(grep -oE '"[a-z_]+": *-?[0-9][-+0-9.e]*' <<<"$out" | sha256sum | cut -c 1-16)
  printf '%s  %s\n' "$hash" "$*"
}

# sweep_row NAME LINE…: all of trials.csv of a sweep file of these lines
sweep_row() {
  local name=$1
  shift
  printf '%s\n' "$@" >"$scratch/$name.yaml"
  "$hexagait" sweep "$scratch/$name.yaml" --out "$scratch/$name" --quiet >/dev/null
  printf '%s  sweep of %s\n' "$(sha256sum <"$scratch/$name/trials.csv" | cut -c 1-16)" "$name"
  rm -r "${scratch:?}/$name"
}

hashes() {
  row walk --robot robots/argos.urdf --seconds 3 --radius 2
  row walk --robot robots/argos.urdf --seconds 2 --spin cw --terrain boxes:0.10
  row walk --robot robots/argos.urdf --seconds 2 --crab 40deg --terrain steps:0.10 --random-posture 0.05
  row walk --robot robots/hexapod_4dof.urdf --seconds 2
  row walk --robot genghis2d --seconds 4 --terrain step:10cm --random-posture 0.025
  row run actions/tripod.yaml --robot robots/argos.urdf
  row run actions/look_around.yaml --robot robots/argos.urdf --controller virtual_model
  row run actions/push_up.yaml --robot robots/quadruped_rpp.urdf
  sweep_row slices 'simulator: slice' 'controllers: [free, "wave:0.75"]' 'terrains: [profile]' \
    'roughness: [2]' 'seeds: 20' 'slices: 100'
  sweep_row walks 'simulator: ode' 'controllers: [free]' 'robots: [robots/argos.urdf]' 'terrains: [boxes]' \
    'roughness: [0.10]' 'seeds: 2' 'seconds: 2' 'random_posture: 0.05'
}

more_hashes() {
  local options action robot
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
  sweep_row slice 'simulator: slice' 'controllers: [tripod, free, unadjusted, "wave:0.75"]' \
    'terrains: [flat, profile]' 'roughness: [1, 3]' 'seeds: 200' 'slices: 200'
  sweep_row box2d 'simulator: box2d' 'controllers: [tripod, free]' 'terrains: [rough]' \
    'roughness: [0.04]' 'seeds: 4' 'seconds: 10'
  sweep_row ode 'simulator: ode' 'controllers: [tripod, free]' 'robots: [argos]' 'terrains: [boxes]' \
    'roughness: [0.10]' 'seeds: 3' 'seconds: 5' 'random_posture: 0.05'
}

# The C library then uses sin, cos, atan2, exp, … as on a processor that has none of these.
without_fma() {
  GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable hashes
}

case "$mode" in
  golden)
    if [[ ! -f $golden ]]; then
      echo "There is no $golden; \"app/same_bits.sh write HEXAGAIT\" makes it"
      exit 77
    fi
    hashes >"$scratch/now"
    diff "$golden" "$scratch/now"
    ;;
  write) hashes >"$golden" ;;
  more) more_hashes ;;
  fma)
    if ! grep -qw fma /proc/cpuinfo 2>/dev/null; then
      echo "This processor has no fused multiply-add: nothing to compare with"
      exit 77
    fi
    hashes >"$scratch/with"
    without_fma >"$scratch/without"
    diff "$scratch/with" "$scratch/without"
    ;;
esac
