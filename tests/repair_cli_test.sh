#!/usr/bin/env bash
# tests/repair_cli_test.sh PLUMBLINE: what `plumbline repair` prints, returns and writes, as a user sees it.
set -uo pipefail
plumbline=$1
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
# signature FILE: that of its arrangement.
# shellcheck disable=SC2317 # expect calls it, as what follows
signature() { "$plumbline" info "$1" | grep '^signature'; }
# same A B: the two have the same arrangement.
# shellcheck disable=SC2317
same() { [[ $(signature "$1") == "$(signature "$2")" && -n $(signature "$1") ]]; }
# shellcheck disable=SC2317
differ() { ! same "$@"; }

# ---- The list
printf '0,0,10.03,0\n10,0.02,10,8\n10,8,0,8\n0,8,0,0\n' >corner.lines
expect "without -o it is a dry run, which says so" 0 'a dry run' "$plumbline" repair corner.lines --tolerance 0.05
expect "with it, too, where --dry-run says so" 0 'a dry run' "$plumbline" repair corner.lines --tolerance 0.05 --dry-run -o no.lines --log dry.json
expect "which writes the log" 0 '"kind": "grow"' cat dry.json
leaves "and nothing else" corner.lines dry.json
printf '0,0,10.03,0\n10,0.02,10,8\n10,8,0,8\n0,8,0,0\n' >corner.lines
expect "edits are counted, with sizes" 0 '^2 edits: 1 end grown by 0.02, 1 dangle of 0.03 trimmed' "$plumbline" repair corner.lines --tolerance 0.05
expect "with place and element" 0 'grow +0.02 +\(10, 0.02\) +closed 80 +corner.lines:2 row' "$plumbline" repair corner.lines --tolerance 0.05
expect "one number is for all" 0 'weld 0.05, grow 0.05, trim 0.05, sliver 0.05' "$plumbline" repair corner.lines --tolerance 0.05
expect "what is said of one wins, before it, too" 0 'weld off, grow 1/30, trim 0.05' "$plumbline" repair corner.lines --grow 1/30 --weld 0 --tolerance 0.05
expect "off is off" 0 'grow off, trim off.*snap off' "$plumbline" repair corner.lines --tolerance off
expect "--compare tells what LAR's pruning makes of it" 0 'LAR pruning +[0-9]+ +[0-9]+ +1 ' "$plumbline" repair corner.lines --tolerance 0.05 --compare
expect "and nothing at 0" 0 'no rule to compare' "$plumbline" repair corner.lines --tolerance 0 --compare
expect "--quiet says nothing" 0 '^$' "$plumbline" repair corner.lines --tolerance 0.05 -q

# ---- Files
expect "a .lines file is written" 0 'wrote fixed.lines' "$plumbline" repair corner.lines --tolerance 0.05 -o fixed.lines --log log.json
expect "which is repaired" 0 '0,0,10,0' cat fixed.lines
expect "the log undoes it" 0 '2 changes undone' "$plumbline" repair fixed.lines --undo log.json -o undone.lines
expect "exactly" 0 '' same corner.lines undone.lines
expect "the wrong drawing is not undone" 2 'not the drawing that the repair of the log made' "$plumbline" repair corner.lines --undo log.json -o no.lines
expect "what is no log is refused" 2 'corner.lines:1' "$plumbline" repair fixed.lines --undo corner.lines -o no.lines
expect "nor is another JSON one" 2 'not a log of .plumbline repair.' "$plumbline" repair fixed.lines --undo <(echo '{"format": "plumbline rooms 1"}') -o no.lines
printf '0,0,3,0.0001\n1,1,2,-0.99\n0,5,2,5\n2,1/3,2,5.001\n' >thirds.lines
"$plumbline" repair thirds.lines --tolerance 0.01 -q -o thirds-fixed.lines --log thirds.json
"$plumbline" repair thirds-fixed.lines --undo thirds.json -q -o thirds-undone.lines
expect "fractions come back, too" 0 '' same thirds.lines thirds-undone.lines
printf '0,0,3,1\n1,1,1,0.34\n' >slanted.lines
expect "what is rounded is said" 0 '^.*1 line with ends at fractions' "$plumbline" repair slanted.lines --grow 0.01 -o slanted.svg
for format in geojson topojson csv wkt wkb dxf svg; do
  expect "lines are written as .$format" 0 "wrote fixed.$format" "$plumbline" repair corner.lines --tolerance 0.05 -o fixed.$format
done
for format in geojson csv wkt wkb dxf svg; do
  expect "and read again: .$format" 0 '' same fixed.$format fixed.lines
done
expect "edits as points" 0 '"kind":"trim"' "$plumbline" repair corner.lines --tolerance 0.05 --findings -
expect "a picture of them" 0 '>closed 80<' "$plumbline" repair corner.lines --tolerance 0.05 --picture -
expect "a page, and no drawing" 0 'wrote corner.html.*dry run' "$plumbline" repair corner.lines --tolerance 0.05 --report corner.html
expect "of one format only" 2 '' "$plumbline" repair corner.lines --report corner.svg

# ---- Files that are kept
svg '<rect width="9" height="9"/><path id="wall" stroke="red" d="M3 0V8.98"><title>Hall</title></path><circle cx="6" cy="5" r="1"/>' >plan.svg
expect "an SVG stays as it is" 0 'all but 1 element stay.*now lines: 1 path' "$plumbline" repair plan.svg --grow 0.05 -o kept.svg --log kept.json
expect "but for what is edited" 0 'circle cx="6".*<path id="wall" stroke="red" d="M3 0L3 9"><title>Hall' cat kept.svg
expect "which undoing finds" 0 'wrote back.svg' "$plumbline" repair kept.svg --undo kept.json -o back.svg
expect "exactly, where numbers are decimals" 0 '' same plan.svg back.svg
expect "so that the repair was something" 0 '' differ plan.svg kept.svg
cat >plan.dxf <<'DXF'
0
SECTION
2
ENTITIES
0
LINE
8
WALLS
62
3
10
0
20
0
11
10.03
21
0
0
LINE
8
WALLS
10
10
20
0.02
11
10
21
8
0
ARC
8
ROUND
10
3
20
3
40
1
50
0
51
180
0
ENDSEC
0
EOF
DXF
expect "so does a DXF" 0 'all but 2 elements stay' "$plumbline" repair plan.dxf --tolerance 0.05 --weld 0 -o kept.dxf --log kept.json
expect "with its ARC and colours" 0 'WALLS.62.3 *.*ARC' tr '\n' '.' <kept.dxf
expect "of a pipe all lines are written" 0 'lines alone are written' "$plumbline" repair - --from dxf --tolerance 0.05 --weld 0 -o anew.dxf < <(cat plan.dxf)
expect "from a DXF to an SVG all lines are written" 0 'lines alone are written.*made of a .dxf' "$plumbline" repair plan.dxf --tolerance 0.05 --weld 0 -o kept.svg

# ---- What is wrong
expect "a tolerance is a number, auto or off" 2 '--grow is a number of 0 or more.*"wide"' "$plumbline" repair corner.lines --grow wide
expect "not negative" 2 '--tolerance is a number of 0 or more' "$plumbline" repair corner.lines --tolerance=-1
expect "snapping is never automatic" 2 '--snap has no automatic size' "$plumbline" repair corner.lines --snap auto
expect "doors have a least and a largest width" 2 'LEAST..MOST' "$plumbline" repair corner.lines --doors 1
expect "an output does not overwrite the input" 2 'corner.lines' "$plumbline" repair corner.lines -o corner.lines
expect "nor another one" 2 '' "$plumbline" repair corner.lines -o a.json --log a.json
expect "undoing needs an output" 2 'undo' "$plumbline" repair fixed.lines --undo log.json
finish
