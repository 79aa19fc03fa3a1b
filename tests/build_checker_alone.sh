#!/usr/bin/env bash
# tests/build_checker_alone.sh FOLDER PROGRAM [CMAKE-OPTION...]: builds the checker from a copy of its FOLDER, where nothing
# else of the project is near, and leaves what it makes at PROGRAM.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$1" "$work/checker"
cmake -S "$work/checker" -B "$work/build" "${@:3}"
cmake --build "$work/build" --parallel 2
cp "$work/build/plumbline-verify" "$2"
