#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# check_c_math.sh BUILD_DIR: no source of the library or the command calls a function of the C library
# that is not rounded correctly, such as sin, atan2, exp or hypot: their last bits depend on the
# processor, or on the C library. hexagait/math/trigonometry.hpp has those that do not. The exceptions
# are in c_math_allowed.txt beside this script, each with its reason.
set -euo pipefail
allowed=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/c_math_allowed.txt
cd "$1"

names='a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|hypot|cbrt|erfc?|[lt]gamma|j[01n]|y[01n]'
# Objects of the library's rooms, the command and the experiments; not tests and benchmarks.
objects=$(find . -path '*/hexagait_*.dir/*.o' ! -path './bench/*' ! -name '*.gch.o' | sort)
[[ -n $objects ]] || { echo "no objects below $1" >&2; exit 1; }

# source_of OBJECT: its source; in a unity build, which compiles a room as a whole, hexagait/ROOM/unity.cpp
source_of() {
  local source=${1#*.dir/} room=${1%.dir/*}
  [[ $source != Unity/* ]] || source=hexagait/${room##*/hexagait_}/unity.cpp.o
  printf '%s' "${source%.o}"
}

# "SOURCE FUNCTION", a line per call out of a source.
calls=$(for object in $objects; do
  { nm -u "$object" 2>/dev/null || true; } | awk -v source="$(source_of "$object")" '{print source, $NF}'
done | grep -E " ($names)[fl]?\$" | sort -u || true)

status=0
declare -A used
while read -r source function; do
  [[ -n $source ]] || continue
  excused=false
  while read -r sources functions hash reason; do
    # shellcheck disable=SC2053  # patterns on purpose
    [[ $source == $sources && $function == $functions && $hash == "#" && -n $reason ]] || continue
    excused=true used["$sources $functions"]=1
  done <"$allowed"
  $excused && continue
  echo "$source calls $function() of the C library; use that of hexagait/math/trigonometry.hpp"
  status=1
done <<<"$calls"

# An exception that nobody needs any more; not where its sources have not been built.
while read -r sources functions hash reason; do
  [[ -n $sources && $sources != "#"* ]] || continue
  [[ -n ${used["$sources $functions"]:-} ]] && continue
  for object in $objects; do
    # shellcheck disable=SC2053  # patterns on purpose
    [[ $(source_of "$object") == $sources ]] || continue
    echo "$allowed: not needed: $sources $functions"
    status=1
    break
  done
done <"$allowed"
exit $status
