#!/usr/bin/env bash
# tests/schema_test.sh PLUMBLINE FITS-SCHEMA SOURCES: what the tool writes as JSON fits the schemas in docs/, which
# refuse what is nearly the same.
set -uo pipefail
plumbline=$1
fits_schema=$2
sources=$3
data=$sources/examples/data
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
# fits SCHEMA COMMAND...: the output of the tool fits.
# shellcheck disable=SC2317 # expect calls it, as what follows
fits() {
  local schema=$1
  shift
  "$plumbline" "$@" 2>/dev/null | "$fits_schema" "$sources/docs/$schema.schema.json"
  return "${PIPESTATUS[1]}"
}
# summary_fits COMMAND...: so does what is said with --json, as that command's.
# shellcheck disable=SC2317
summary_fits() {
  "$plumbline" "$@" --json 2>/dev/null | "$fits_schema" "$sources/docs/summary.schema.json" "$1"
  return "${PIPESTATUS[1]}"
}
# damaged SCHEMA SED-PROGRAM: what the program makes of the file plan.json does not fit.
# shellcheck disable=SC2317
damaged() {
  local text
  text=$(sed -zE "$2" plan.json)
  [[ $text != "$(<plan.json)" ]] || { echo "nothing is changed" && return 2; }
  "$fits_schema" "$sources/docs/$1.schema.json" <<<"$text"
}

# ---- Files
printf '0,0,9,0\n0,0,1e400,1\n' >far.lines
printf '0,0,3,1\n0,1,3,0\n0,0,0.4,0.3\n1,0,1.2,0.1\n0,1,1e-9,2\n' >narrow.lines
: >empty.lines
sed 's|<svg[^>]*>|&<path d="M0 0L7 3m1 1l0 0"/><path id="x" d="M0 0a3 4 30 0 0 7 1"/><text x="3" y="4">a \& b</text><image/>|' \
  "$data/dwelling.svg" >mixed.svg
for drawing in "$data"/{dwelling,hospital-ward,office-plan}.svg "$data"/{flat.dxf,rooms.geojson,rooms.json} \
  "$sources"/examples/structures/tables.json narrow.lines far.lines empty.lines mixed.svg; do
  name=$(basename "$drawing")
  for options in '' --compact --safe '--safe --decimals 0'; do
    [[ $name != far.lines || -z $options || $options == --compact ]] || continue # beyond doubles
    # shellcheck disable=SC2086 # several options
    expect "arrange $options $name" 0 '^$' fits arrange arrange "$drawing" --lenient $options -o - --format json
  done
  expect "rooms $name" 0 '^$' fits rooms rooms "$drawing" --lenient -o - --format json
  [[ $name == far.lines ]] || expect "repair $name" 0 '^$' fits repair repair "$drawing" --lenient --tolerance 0.01 --doors 0.6..1.2 --log -
  expect "diagnosis $name" 0 '^$' fits diagnosis info "$drawing" --lenient --diagnose -o -
  expect "check $name" 0 '^$' fits check check "$drawing" --lenient -o -
done

# ---- Summaries
for drawing in "$data/flat.dxf" mixed.svg; do
  for command in arrange info check lar rooms repair; do
    expect "summary of $command" 0 '^$' summary_fits $command "$drawing" --lenient
  done
done
expect "of a repair that is written" 0 '^$' summary_fits repair "$data/dwelling.svg" -o repaired.svg --log repaired.json
expect "of one that is undone" 0 '^$' summary_fits repair repaired.svg --undo repaired.json -o undone.svg
expect "of the same with more to tell" 0 '^$' summary_fits info "$data/dwelling.svg" --diagnose --ladder
expect "of LAR's module as published" 0 '^$' summary_fits lar "$data/dwelling.svg" --variant published
expect "of an engine without a radius" 0 '^$' summary_fits check "$data/rooms.geojson" --against "$data/rooms.wkt"
expect "of a minimised drawing" 0 '^$' summary_fits minimise "$data/office-plan.svg" --set radius=2
expect "of one with which the engine is right" 0 '^$' summary_fits minimise "$data/dwelling.svg"
printf 'POLYGON ((0 0,2 0,2 2,0 2,0 0))\nLINESTRING (7 0,8 0)\n' >first.wkt
expect "of an overlay" 0 '^$' summary_fits overlay first.wkt "$data/rooms.geojson" --how union
expect "of a selection" 0 '^$' summary_fits select "$data/flat.dxf" 'WALLS - FURNITURE'
expect "of a drawing in tiles" 0 '^$' fits summary arrange "$data/dwelling.svg" --tiles 3 --json
printf 'POLYGON ((0 0,3 0,3 2,0 2,0 0))\nPOLYGON ((2 0,4 0,4 2,2 2,2 0))\nPOLYGON ((9 9,8 8,9 8,8 9,9 9))\n' >layer.wkt
expect "of a coverage" 0 '^$' summary_fits coverage layer.wkt
expect "of a clean one" 0 '^$' summary_fits coverage layer.wkt --clean -o clean.geojson
expect "of valid polygons" 0 '^$' summary_fits validity layer.wkt --make-valid nonzero
expect "of nothing" 0 '^$' summary_fits info empty.lines --lenient
expect "of files that are written" 0 '^$' summary_fits arrange "$data/dwelling.svg" -o plan.json
expect "of a structure" 0 '^$' summary_fits eval "$data/dwelling.svg"
expect "of a structure as lines" 0 '^$' summary_fits eval "$data/dwelling.svg" -o flat.lines
expect "of random segments" 0 '^$' summary_fits random 3 -o random.lines
expect "of engines" 0 '^$' summary_fits engines
expect "of an error" 0 '^$' fits summary info nothing.svg --json
expect "of several drawings" 0 '^$' fits summary info "$data"/*.svg nothing.svg --json

# ---- What does not fit
expect "an edge whose antenna is a number" 1 ':' damaged arrange 's/"antenna": (false|true)/"antenna": 0/'
expect "an edge of no segment" 1 ':' damaged arrange 's/"segments": \[[0-9 ,]+\]/"segments": []/'
expect "an edge counted from 0" 1 ':' damaged arrange 's/"outer": \[-?[0-9]+/"outer": [0/'
expect "a coordinate as a number" 1 ':' damaged arrange 's/"exact": \["([^"]*)"/"exact": [\1/'
expect "another format" 1 ':' damaged arrange 's/arrangement 1"/arrangement 0"/'
expect "a key that is no more" 1 ':' damaged arrange 's/"ledger":/"ledgers":/'
expect "a key that is new" 1 ':' damaged arrange 's/"exact": true/"exact": true, "more": 1/'
"$plumbline" rooms "$data/flat.dxf" -o plan.json >/dev/null
expect "an area as text" 1 ':' damaged rooms 's/"area": ([0-9.]+)/"area": "\1"/'
expect "a room counted from 0" 1 ':' damaged rooms 's/"room": 1/"room": 0/'
expect "a name that is none" 1 ':' damaged rooms 's/"names": \[[^]]*\]/"names": [1]/'
printf '0,0,10.03,0\n10,0.02,10,8\n' >corner.lines
"$plumbline" repair corner.lines --tolerance 0.05 --log plan.json >/dev/null
expect "an edit of another kind" 1 ':' damaged repair 's/"kind": "grow"/"kind": "cut"/'
expect "an edit counted from 0" 1 ':' damaged repair 's/"number": 1/"number": 0/'
expect "a size as text alone" 1 ':' damaged repair 's/"size": ([0-9.]+)/"size": "\1"/'
"$plumbline" arrange "$data/flat.dxf" --json >plan.json
expect "a summary with half a vertex" 1 ':' damaged summary 's/"vertices": [0-9]+/&.5/'
expect "a summary of another command's keys" 1 ':' damaged summary 's/"signature"/"agree"/'
finish
