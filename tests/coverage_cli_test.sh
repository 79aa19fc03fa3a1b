#!/usr/bin/env bash
# tests/coverage_cli_test.sh PLUMBLINE: what `plumbline coverage` and `plumbline validity` print, return and write.
set -uo pipefail
plumbline=$1
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
parcels() {
  cat >parcels.geojson <<'JSON'
{"type": "FeatureCollection", "name": "parcels", "features": [
 {"type": "Feature", "id": 7, "properties": {"owner": "A & B", "tags": {"x": [1, {"geometry": null}]}},
  "geometry": {"type": "Polygon", "coordinates": [[[0,0],[3,0],[3,2],[0,2],[0,0]]]}},
 {"type": "Feature", "id": 8, "properties": {"owner": "C"},
  "geometry": {"type": "Polygon", "coordinates": [[[2,0],[7,0],[7,2],[2,2],[2,0]]]}},
 {"type": "Feature", "id": 9, "properties": {"owner": "ä\"}"},
  "geometry": {"coordinates": [[[[20, 0], [21, 0], [21, 1.50], [20, 0]]]], "type": "MultiPolygon"}}
]}
JSON
}

# ---- Coverage
parcels
printf 'POLYGON ((1 0,1 1,1 3,4 0,1 0))\nPOLYGON ((0 4,1 3,1 0,0 4))\n' >triangles.wkt
printf 'POLYGON ((0 0,2 0,2 2,0 2,0 0))\nPOLYGON ((2 0,4 0,4 2,2 2,2 0))\n' >squares.wkt
printf 'POLYGON ((0 0,9 0,9 9,0 9,0 0),(4 4,4 5,5 5,5 4,4 4),(1 1,1 1.01,1.01 1.01,1.01 1,1 1))\n' >holes.wkt
expect "the first screen says how many faults, how large, where, between whom" 1 \
  '^invalid: 1 overlap, 4 unmatched vertices in 3 polygons.*1 overlap, area 2 in all, at most 1 wide.*area 2, width 1, at \(2\.5, 1\): parcels.geojson:2:2 Polygon #7, parcels.geojson:4:2 Polygon #8' \
  "$plumbline" coverage parcels.geojson
expect "a coverage is one" 0 '^valid: 2 polygons' "$plumbline" coverage squares.wkt
expect "GEOS #1525: a vertex is missing" 1 'invalid: 1 unmatched vertex.*at \(1, 1\): a corner of triangles.wkt:1:1 Polygon, none of triangles.wkt:2:1' \
  "$plumbline" coverage triangles.wkt
expect "which is all that cleaning changes" 0 '^matched: 1 unmatched vertex.*wrote' "$plumbline" coverage triangles.wkt --clean -o clean.csv
expect "so the areas stay" 0 'triangles.wkt:1:1 Polygon,4.5,4.5,.*triangles.wkt:2:1 Polygon,1.5,1.5,' cat clean.csv
expect "a summary for programs" 1 '"valid": false.*"polygons": 3.*"kind": "overlap".*"features": \["parcels.geojson:2:2 Polygon #7".*"at_exact": \["2.5", "1"\].*"area_exact": "2".*"width": 1' \
  "$plumbline" coverage parcels.geojson --json
expect "gaps have sizes" 1 'invalid: 2 gaps in 1 polygon.*area 1\.0001 in all.*area 1, width 1.*area 0\.0001, width 0\.01' "$plumbline" coverage holes.wkt
expect "of which only narrow ones may count" 1 'invalid: 1 gap .*beyond the limits: 1 gap' "$plumbline" coverage holes.wkt --width 0.5
expect "what is left is told by the exit code" 1 '^given to one polygon each: 1 gap.*left, beyond the limits: 1 gap' "$plumbline" coverage holes.wkt --clean --area 0.5
expect "from standard input" 0 '^valid: 2 polygons' bash -c "'$plumbline' coverage - <squares.wkt"
expect "a clean file" 0 '^given to one polygon each: 1 overlap.*matched: 4 unmatched vertices.*overlap to parcels.geojson:4:2 Polygon #8: area 2.*wrote clean.geojson' \
  "$plumbline" coverage parcels.geojson --clean -o clean.geojson
expect "has no faults" 0 '^valid: 3 polygons' "$plumbline" coverage clean.geojson
expect "and its properties, whatever they are" 0 '"name": "parcels".*"tags": \{"x": \[1, \{"geometry": null\}\]\}\},.*"geometry": \{"type":"Polygon","coordinates":\[\[\[0,0\],\[2,0\],\[2,2\],\[0,2\],\[0,0\]\]\]\}.*ä.*' cat clean.geojson
expect "what did not change stays byte by byte" 0 '"geometry": \{"coordinates": \[\[\[\[20, 0\], \[21, 0\], \[21, 1\.50\], \[20, 0\]\]\]\], "type": "MultiPolygon"\}' cat clean.geojson
expect "by another policy" 0 'overlap to parcels.geojson:2:2 Polygon #7' "$plumbline" coverage parcels.geojson --clean --policy smallest
expect "a clean coverage stays as it is" 0 '' bash -c "'$plumbline' coverage clean.geojson --clean -o again.geojson -q && cmp clean.geojson again.geojson"
cat >digits.geojson <<'JSON'
{"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"n": 1}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[35.404040839167621,0.3],[36.007957465146603,64.546479119733903],[0,60],[0,0]]]}},
 {"type": "Feature", "properties": {"n": 2}, "geometry": {"type": "Polygon", "coordinates": [[[35.404040839167621,0.3],[70,0],[70,60],[36.007957465146603,64.546479119733903],[35.404040839167621,0.3]]]}},
 {"type": "Feature", "properties": {"n": 3}, "geometry": {"type": "Polygon", "coordinates": [[[69,0],[99,0],[99,60],[69,60],[69,0]]]}}
]}
JSON
expect "longer decimals than doubles have" 0 'wrote' "$plumbline" coverage digits.geojson --clean -o digits.clean.geojson
expect "are written alike by all neighbours" 0 '^valid: 3 polygons' "$plumbline" coverage digits.clean.geojson
expect "an unknown policy names the known ones" 2 'longest-border' "$plumbline" coverage squares.wkt --clean --policy best
expect "an output needs --clean" 2 'needs --clean' "$plumbline" coverage squares.wkt -o x.geojson
expect "nothing is written over the input" 2 'overwrite' "$plumbline" coverage parcels.geojson --clean -o parcels.geojson
expect "a limit below 0" 2 'not negative.*-1' "$plumbline" coverage squares.wkt --width=-1
expect "a file that is broken has its place" 2 'broken.wkt:2:1: not WKT' bash -c "echo 'POLYGON ((0 0,1' >broken.wkt; '$plumbline' coverage broken.wkt"
expect "a file without polygons" 2 'polygon or a closed line' bash -c "echo 'LINESTRING (0 0,1 1)' >line.wkt; '$plumbline' coverage line.wkt"

# ---- Validity
parcels
sed 's/\[3,0\],\[3,2\],\[0,2\]/[3,2],[3,0],[0,2]/' parcels.geojson >ties.geojson
printf 'POLYGON ((0 0,4 0,4 4,0 4,0 0),(1 1,1 5,2 5,2 1,1 1))\nPOLYGON ((0 0,1 1,1 0,0 1,0 0))\nPOLYGON ((0 0,1 0,1 1,0 0))\n' >three.wkt
expect "the first screen says which, why and where" 1 '^invalid: 1 of 3 polygons.*ties.geojson:2:2 Polygon #7.*Self-intersection at \(1\.5, 1\): outer ring of Polygon #7 crosses itself' \
  "$plumbline" validity ties.geojson
expect "several by reasons" 1 '^invalid: 2 of 3 polygons.* 2  Self-intersection.*three.wkt:1:1.*three.wkt:2:1' "$plumbline" validity three.wkt
expect "valid ones are" 0 '^valid: 3 polygons' "$plumbline" validity parcels.geojson
expect "a summary for programs" 1 '"valid": false.*"invalid_polygons": 1.*"kind": "crossing".*"reason": "Self-intersection".*"at": \[1.5, 1\]' "$plumbline" validity ties.geojson --json
for meaning in linework:14 structure:13 nonzero:14; do
  IFS=: read -r word area <<<"$meaning"
  expect "what is covered by $word" 1 "three.wkt:1:1 Polygon.*\"area_exact\": \"$area\".*\"area_exact\": \"0.5\"" "$plumbline" validity three.wkt --make-valid "$word" --json
done
expect "valid polygons are written" 1 'made valid: 1.*wrote valid.geojson' "$plumbline" validity ties.geojson --make-valid linework -o valid.geojson
expect "which are" 0 '^valid: 3 polygons' "$plumbline" validity valid.geojson
expect "with their properties" 0 '"owner": "A & B".*"geometry": \{"type":"MultiPolygon","coordinates":.*"type": "Polygon", "coordinates": \[\[\[2,0\]' cat valid.geojson
expect "also in other formats" 1 'wrote valid.wkt' "$plumbline" validity three.wkt --make-valid structure -o valid.wkt
expect "which are valid, too" 0 '^valid: ' "$plumbline" validity valid.wkt
printf 'POLYGON ((0 0,4 0,0 0))\nPOLYGON ((0 0,1 0,1 1,0 0))\n' >flat.wkt
expect "of what has no area nothing is left, which is said" 1 'made valid: 1; of 1 nothing is left' "$plumbline" validity flat.wkt --make-valid structure
expect "an output needs a meaning" 2 'make-valid' "$plumbline" validity three.wkt -o x.wkt
expect "an unknown meaning names the known ones" 2 'linework, structure' "$plumbline" validity three.wkt --make-valid buffer
expect "several files in a line each" 1 'parcels.geojson: valid.*three.wkt: invalid: 2 of 3' "$plumbline" validity parcels.geojson three.wkt
finish
