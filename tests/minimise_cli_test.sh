#!/usr/bin/env bash
# tests/minimise_cli_test.sh PLUMBLINE: what `plumbline minimise` prints, returns and writes, as a user sees it.
set -uo pipefail
plumbline=$1
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
# A triangle with a gap of 1e-12 at a corner, which a radius of 1e-9 closes, and a cross far from it.
drawing() { printf '10,10,11,10\n11,10.000000000001,11,11\n11,11,10,10\n3,30,4,40\n3,40,4,30\n' >gap.lines; }

# ---- An engine that is wrong
drawing
expect "the first screen says what, in how many, with which numbers" 1 \
  '^disagree: face invented, in 3 of 5 segments.none can be left out.*0,0,.*exact +float LAR.*radius 1e-09' \
  "$plumbline" minimise gap.lines --set radius=1e-9
expect "all is written" 1 '' "$plumbline" minimise gap.lines --set radius=1e-9 -o case.lines --report issue.md --picture case.svg
expect "which has the same finding" 1 'face' "$plumbline" check case.lines --radius 1e-9
expect "the issue tells how to reproduce it" 0 'plumbline check case.lines --engine lar --set radius=1e-09' cat issue.md
expect "and shows the picture" 0 '!\[exact, and the answer beside it\]\(case.svg\)' cat issue.md
expect "the picture magnifies the gap" 0 '>magnified ' cat case.svg
expect "what is minimised stays as it is" 0 '' cmp case.lines <("$plumbline" minimise case.lines --set radius=1e-9 -o -)
expect "a summary for programs" 1 '"kind": "face invented".*"segments": 3.*"segments_before": 5.*"one_minimal": true.*"lines": \["0,0,' \
  "$plumbline" minimise gap.lines --set radius=1e-9 --json
expect "without time it is not the least" 1 'not the least: it ended after [0-9]+ run' "$plumbline" minimise gap.lines --set radius=1e-9 --max-runs 1
leaves "the outputs are there, and nothing else" case.lines case.svg gap.lines issue.md

# ---- An engine that is right
drawing
expect "is said to be right, and nothing is written" 0 '^agree: lar is right about the drawing, 5 segments' \
  "$plumbline" minimise gap.lines --set radius=1e-14 -o case.lines --report issue.md
leaves "nothing" gap.lines

# ---- What is refused
drawing
expect "an unknown engine names the known ones" 2 'lar, inters, plasm' "$plumbline" minimise gap.lines --engine fast
expect "a parameter that the engine has not" 2 'no such parameter' "$plumbline" minimise gap.lines --set speed=1
expect "results in files" 2 'made again' "$plumbline" minimise gap.lines --engine files --set file=x.json
expect "a time that is not positive" 2 'seconds' "$plumbline" minimise gap.lines --seconds 0
expect "a report of another ending" 2 'ends in .md' "$plumbline" minimise gap.lines --report issue.html
expect "an output over the input" 2 'overwrite' "$plumbline" minimise gap.lines -o gap.lines
finish
