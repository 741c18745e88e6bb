#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The hexagait authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: check_docs.sh PROGRAM [DIR]
#
# Checks README.md and docs/*.md against the tree and the built command PROGRAM: relative links and
# their anchors lead somewhere, every `hexagait SUBCOMMAND --option` exists, so does every #include
# of ours, a block that begins with ```cpp FILE is in that file line by line (`…` stands for lines left
# out), and the index names every page. Prints what is wrong; exit status 1 if anything is. DIR is
# the project's directory; by default the one above this script.
set -euo pipefail

program=$1
cd "${2:-$(dirname "${BASH_SOURCE[0]}")/..}"
pages=(README.md docs/*.md)
bad=0
wrong() { printf '%s\n' "$1"; bad=1; }

# The anchors that GitHub makes of a page's headings.
anchors() {
  sed -n 's/^##* //p' "$1" | tr '[:upper:]' '[:lower:]' | sed 's/[^[:alnum:] _-]//g; s/ /-/g'
}

check_links() {
  local page target file anchor
  for page in "${pages[@]}"; do
    while read -r target; do
      file=${target%%#*} anchor=${target#*#}
      [[ -n $file ]] && file=$(dirname "$page")/$file || file=$page
      [[ -e $file ]] || { wrong "$page: link to $target, which does not exist"; continue; }
      [[ $target != *#* ]] || anchors "$file" | grep -qxF -- "$anchor" ||
        wrong "$page: link to $target; $file has no such heading"
    done < <(grep -oE '\]\([^)]+\)' "$page" | sed 's/^](//; s/)$//' | grep -vE '^[a-z]+:' || true)
  done
}

# The command lines of a page, one a line: in fenced blocks, or between backquotes.
command_lines() {
  {
    sed -n '/^ *```/,/^ *```/p' "$1"
    grep -oE '`[^`]+`' "$1" | tr -d '`'
  } | grep -oE '(^|[ /])hexagait [a-z]+( .*)?$' | sed -E 's/^.*hexagait //; s/ #.*//' || true
}

declare -A help
check_commands() {
  local page line subcommand option
  for page in "${pages[@]}"; do
    while read -r line; do
      subcommand=${line%% *}
      [[ -v help[$subcommand] ]] ||
        help[$subcommand]=$("$program" "$subcommand" --help 2>/dev/null || true)
      grep -qE "Usage: hexagait $subcommand( |$)" <<<"${help[$subcommand]}" ||
        { wrong "$page: there is no 'hexagait $subcommand'"; continue; }
      while read -r option; do
        grep -qE -- "(^|[ ,])$option([ ,=]|$)" <<<"${help[$subcommand]}" ||
          wrong "$page: 'hexagait $subcommand' has no $option"
      done < <(grep -oE -- '(^| )--[a-z][a-z-]*' <<<"$line" | tr -d ' ' | sort -u)
    done < <(command_lines "$page")
  done
}

check_includes() {
  local page header
  for page in "${pages[@]}"; do
    while read -r header; do
      compgen -G "$header" >/dev/null || compgen -G "*/$header" >/dev/null ||
        compgen -G "*/*/$header" >/dev/null || wrong "$page: there is no header <$header>"
    done < <(grep -oE '<hexagait/[a-z0-9_/]+\.hpp>' "$page" | tr -d '<>')
  done
}

check_excerpts() {
  local page file line
  for page in "${pages[@]}"; do
    while IFS=$'\t' read -r file line; do
      grep -qxF -- "$line" "$file" || wrong "$page: $file has no line '$line'"
    done < <(awk '/^```/ {file = $1 == "```cpp" ? $2 : ""; next}
                  file != "" && NF && $1 != "…" {print file "\t" $0}' "$page")
  done
}

check_index() {
  local page
  for page in docs/*.md; do
    [[ $page == docs/README.md ]] || grep -qF "($(basename "$page"))" docs/README.md ||
      wrong "docs/README.md: does not name $(basename "$page")"
  done
}

check_links
check_commands
check_includes
check_excerpts
check_index
exit $bad
