#!/usr/bin/env bash
# tests/overlay_cli_test.sh PLUMBLINE DATA: what `plumbline overlay` and `plumbline select` print, return and write.
set -uo pipefail
plumbline=$1
data=$2
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
# GEOS issue 1525: CoverageCleaner gave the triangles 6 and 0. And the squares of GeoPandas's manual.
layers() {
  echo 'POLYGON ((1 0,1 1,1 3,4 0,1 0))' >a.wkt
  echo 'POLYGON ((0 4,1 3,1 0,0 4))' >b.wkt
  printf 'POLYGON ((0 0,2 0,2 2,0 2,0 0))\nPOLYGON ((2 2,4 2,4 4,2 4,2 2))\n' >first.wkt
  printf 'POLYGON ((1 1,3 1,3 3,1 3,1 1))\nPOLYGON ((3 3,5 3,5 5,3 5,3 3))\n' >second.wkt
}

# ---- Overlay
layers
expect "the first screen says what of what, how many, how large" 0 \
  '^intersection of 2 polygons and 2 polygons: 3 pieces, area 3.*1 +1 +first.wkt:1.* second.wkt:1' "$plumbline" overlay first.wkt second.wkt
for how in intersection:3:3 union:7:13 difference:2:5 symmetric_difference:4:10 identity:5:8; do
  IFS=: read -r name pieces area <<<"$how"
  expect "$name of the manual's example" 0 "^$name .*: $pieces pieces, area $area"$'\n' "$plumbline" overlay first.wkt second.wkt --how "$name"
done
expect "triangles that share an edge have areas 4.5 and 1.5" 0 '"area_exact": "1\.5".*"area_exact": "4\.5"' "$plumbline" overlay a.wkt b.wkt --how union --json
expect "and nothing in common" 0 '0 pieces, area 0' "$plumbline" overlay a.wkt b.wkt
expect "a layer and itself" 0 '0 pieces, area 0' "$plumbline" overlay a.wkt a.wkt --how symmetric_difference
expect "one of them from standard input" 0 '3 pieces' bash -c "'$plumbline' overlay first.wkt - <second.wkt"
expect "pieces are features that know theirs" 0 'wrote c.geojson' "$plumbline" overlay first.wkt second.wkt -o c.geojson --picture c.svg
expect "with elements and exact areas" 0 '"first":"first.wkt:1:1 Polygon","second":"second.wkt:1:1 Polygon","area":1,"area_exact":"1"' cat c.geojson
expect "which the tool reads again" 0 '3 polygons.*area 3'$'\n' "$plumbline" overlay c.geojson first.wkt
expect "the picture has a legend" 0 'in both' cat c.svg
printf 'POLYGON ((0 0,9 9,9 0,0 9,0 0))\n' >crossed.wkt
printf 'POLYGON ((0 0,9 0,9 9,0 9,0 0),(1 1,8 1,8 8,1 8,1 1))\n' >frame.wkt
expect "a fill rule decides what is inside" 0 'area 81'$'\n' "$plumbline" overlay frame.wkt frame.wkt --rule nonzero
expect "evenodd by default" 0 'area 32'$'\n' "$plumbline" overlay frame.wkt frame.wkt
expect "a bow tie is two triangles" 0 '1 piece, area 40\.5' "$plumbline" overlay crossed.wkt crossed.wkt
printf 'LINESTRING (0 0,1 0)\n' >line.wkt
cat line.wkt first.wkt >mixed.wkt
expect "what closes nothing is said" 0 'left out: 1 segment that closes nothing, the first of mixed.wkt:1' "$plumbline" overlay mixed.wkt second.wkt
expect "a layer without polygons is no answer" 2 'line.wkt.*no.*polygon' bash -c "'$plumbline' overlay first.wkt line.wkt 2>&1 | sed 's/nothing/no/'; exit \${PIPESTATUS[0]}"
echo '{"type":"FeatureCollection","features":[]}' >empty.geojson
expect "of nothing and a layer the layer stays" 0 'union of 2 polygons and 0 polygons: 2 pieces, area 8' "$plumbline" overlay first.wkt empty.geojson --how union
expect "and nothing is in both" 0 '0 pieces, area 0' "$plumbline" overlay empty.geojson first.wkt
expect "lines count as nothing where that is wanted" 0 'difference of 2 polygons and 0 polygons: 2 pieces' "$plumbline" overlay first.wkt line.wkt --how difference --lenient
expect "an unknown word names the known ones" 2 'intersection, union' "$plumbline" overlay first.wkt second.wkt --how both
expect "one layer is not enough" 2 'SECOND is missing' "$plumbline" overlay first.wkt
expect "neither input is overwritten" 2 'overwrite' "$plumbline" overlay first.wkt second.wkt -o second.wkt
expect "a broken layer has its place" 2 'second.wkt:2:1: not WKT' bash -c "echo 'POLYGON ((0 0,1' >second.wkt; '$plumbline' overlay first.wkt second.wkt"

# ---- Select
cat >plan.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">
<g inkscape:groupmode="layer" inkscape:label="WALLS"><rect width="10" height="10"/><line x1="20" y1="0" x2="30" y2="0"/></g>
<g inkscape:groupmode="layer" inkscape:label="DOORS"><rect x="4" y="-1" width="2" height="3"/></g>
<g inkscape:groupmode="layer" inkscape:label="my beams"><rect x="5" y="5" width="20" height="1"/></g>
</svg>
SVG
expect "walls without doors and beams" 0 '1 polygon of 3 regions by 3 names, area 91'$'\n.*left out: 1 segment.*WALLS' \
  "$plumbline" select plan.svg "WALLS - (DOORS | 'my beams')"
expect "what lies in two" 0 'area 9'$'\n' "$plumbline" select plan.svg 'count >= 2'
expect "either" 0 '"area_exact": "98"' "$plumbline" select plan.svg 'WALLS ^ DOORS' --json
expect "nothing is an answer" 0 '^0 polygons' "$plumbline" select plan.svg "DOORS & 'my beams'"
expect "what is no name" 2 'WINDOWS' "$plumbline" select plan.svg 'WALLS - WINDOWS'
expect "what is no expression has its place" 2 'name is missing.*"\)"' "$plumbline" select plan.svg 'WALLS - )'
expect "polygons for others" 0 'wrote walls.geojson' "$plumbline" select plan.svg 'WALLS - DOORS' -o walls.geojson --picture walls.svg
expect "with their areas" 0 '"polygon":1,"area":96,"area_exact":"96"' cat walls.geojson
expect "of a real plan" 0 '1 polygon of 3 regions.*9'$'\n.*left out: 33 segments' "$plumbline" select "$data/flat.dxf" 'WALLS - FURNITURE'
finish
