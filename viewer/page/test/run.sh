#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: run.sh PROGRAM [DIR]
#
# Tests the page of `PROGRAM steer` and `PROGRAM replay` in Debian's Chromium, without a window; leaves pictures in DIR
# (out/steer), among them the film of the README, steer.gif, and what it measured. Needs Node.js, npm and Chromium.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
out=$(realpath -m "${2:-out/steer}")
mkdir -p "$out" build/page-test
cp "$here"/*.mjs "$here"/package*.json "$here"/.npmrc "$here"/../src/{countdown,frame,path,player,replay,tape,why}.js build/page-test
cd build/page-test
[[ node_modules/.package-lock.json -nt package-lock.json && -d node_modules/playwright-core ]] ||
  npm ci --ignore-scripts --no-audit --no-fund --loglevel=error
exec env HEXAGAIT="$program" OUT="$out" node --test --test-concurrency=1 --test-reporter=spec ./*_test.mjs
