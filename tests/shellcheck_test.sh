#!/usr/bin/env bash
# tests/shellcheck_test.sh: shellcheck finds nothing in any shell script of the project, known by its first line or name.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t scripts < <(
  find . \( -path ./.git -o -path './build*' \) -prune -o -type f \
    -exec awk '/^#!.*sh$/ || FILENAME ~ /\.sh$/ { print FILENAME } { nextfile }' {} + | sort
)
printf '%s\n' "${scripts[@]}"
shellcheck -x "${scripts[@]}"
