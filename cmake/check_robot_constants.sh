#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Lengths, times, speeds, forces and gains of a robot follow from its model, in core/params alone. This
# finds new ones elsewhere: numbers that are not 0, with such a unit in the comment of their line or of the
# line above. What may stay is in robot_constants_allowed.txt, with the reason.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

units='\[(m|s|N|N m|kg|m/s|m/s²|rad/s|1/s|1/m|m²|m/\(N s\)|N m/rad|N m s/rad)[],;]'
number='(k[A-Z][A-Za-z]*|[a-z_]+) = -?[0-9.]*[1-9][0-9.e-]*[;,]'
found=$(git ls-files core gait_state heading_control posture footstep_gen navigation path_following sim3d walk |
  grep -E '\.[ch]pp$' | grep -vE '_test\.cpp$|/testing/|^core/(params|load|yaml|text)/' |
  xargs awk -v units="$units" -v number="$number" '
    FNR == 1 { above = "" }
    $0 ~ number && ($0 ~ units || above ~ units) { sub(/^ +/, ""); print FILENAME ": " $0 }
    { above = $0 ~ /^ *\/\// ? $0 : "" }')
allowed=cmake/robot_constants_allowed.txt
status=0
while IFS= read -r line; do
  [[ -n $line ]] || continue
  known=false
  while IFS= read -r entry; do
    [[ -n $entry && $entry != \#* ]] || continue
    [[ $line == "${entry%% # *}"* ]] && known=true
  done <"$allowed"
  $known || { printf '%s\n' "$line"; status=1; }
done <<<"$found"
((status == 0)) || echo "A length, time, force or gain of a robot belongs into core/params: see $allowed" >&2
exit $status
