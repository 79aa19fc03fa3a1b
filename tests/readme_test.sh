#!/usr/bin/env bash
# tests/readme_test.sh PLUMBLINE: the README shows the quickstart that the tests build, and the pictures that
# the tool draws today.
set -euo pipefail
plumbline=$1
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck disable=SC2016 # the backquotes are Markdown's
sed -n '/^```cpp$/,/^```$/p' README.md | sed '1d;$d' | diff - examples/quickstart.cpp
picture=$(mktemp --suffix=.svg)
trap 'rm -f "$picture"' EXIT
"$plumbline" check examples/data/office-plan.svg --picture "$picture" >/dev/null || [[ $? == 1 ]]
cmp "$picture" docs/office-plan.svg
"$plumbline" rooms examples/data/flat.dxf --walls WALLS,DOORS --picture "$picture" >/dev/null
cmp "$picture" docs/flat.svg
