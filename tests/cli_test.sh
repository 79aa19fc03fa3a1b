#!/usr/bin/env bash
# tests/cli_test.sh PLUMBLINE EXAMPLES: what the tool prints, returns and leaves behind, as a user sees it.
# One line per case; fails if any case does.
set -uo pipefail
plumbline=$1
examples=$2
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"

expect "help shows the commands and an example" 0 'arrange.*check.*info' "$plumbline" --help
expect "each command's help has an example" 0 'plumbline check plan.svg --radius' "$plumbline" check --help
expect "the version is told" 0 '^plumbline [0-9]+\.[0-9]+\.[0-9]+$' "$plumbline" --version
expect "no command is a usage error" 2 'which command.*arrange, check, coverage, engines, eval, info, lar, minimise, overlay, random, repair, rooms, select, validity' "$plumbline"
expect "an unknown command names the known ones" 2 'unknown command.*"draw".*arrange, check, coverage, engines, eval, info, lar, minimise, overlay, random, repair, rooms, select, validity' "$plumbline" draw x.svg
expect "an unknown option is a usage error" 2 'radios' "$plumbline" check a.svg --radios 1
expect "a missing file is said by name" 2 'none\.svg' "$plumbline" info none.svg
expect "a directory is no drawing" 2 'plumbline: ' "$plumbline" info .
echo text >a.txt
expect "an unknown format names the known ones" 2 'svg.*lines' "$plumbline" info a.txt
echo '<svg><line x1="1"</svg>' >bad.svg
expect "malformed XML is told with file and line" 2 'bad\.svg:1' "$plumbline" check bad.svg -o out.json --picture out.svg
leaves "an error leaves no output file" a.txt bad.svg

svg '<line x2="1e99999999999"/><line x1="0" y1="0" x2="1" y2="1"/>' >a.svg
expect "a monstrous number is rejected; that is an error, which names the way out" 2 'a.svg:2:1: not all is drawn: 1 item that looks like geometry.*line: .*--lenient' "$plumbline" arrange a.svg
expect "on which the rest goes on" 0 '1 segments, 1 rejected' "$plumbline" arrange a.svg --lenient
for command in info check lar eval; do
  expect "so it is of every command: $command" 2 '--lenient' "$plumbline" $command a.svg
done
expect "info says what it knows nevertheless" 2 '2 vertices, 1 edges' "$plumbline" info a.svg
expect "a lenient check does not say that all is well" 1 '^agree; not all was read: 1 rejected' "$plumbline" check a.svg --lenient
svg '<line x1="1" x2="1"/><image x="3"/><line x2="4" y2="1"/>' >b.svg
expect "what takes no part is listed with its line" 0 'image.*line 2' "$plumbline" info b.svg
svg '<circle r="1"/><g display="none"><line x2="4"/></g>' >c.svg
expect "curves are flattened as told, and the ledger says so" 0 '20 segments.*circle by 20 chords within 0.03' "$plumbline" arrange c.svg --flatten 0.03
expect "what is hidden is listed" 0 'hidden' "$plumbline" info c.svg
expect "or drawn" 0 '69 segments, 0 rejected' "$plumbline" info c.svg --hidden
expect "the old option for that has no effect and says so" 0 '--visible has no effect' "$plumbline" info c.svg --visible
expect "each command has these options" 0 '1 rejected' "$plumbline" lar c.svg --flatten 1/4
svg '<g id="walls"><line x2="4"/></g><g id="doors"><line x2="3" y2="1"/></g>' >d.svg
expect "layers are chosen by patterns" 0 '1 elements, 1 segments, 1 rejected' "$plumbline" info d.svg --layers 'w*,WALLS' --layers walls
expect "or left out" 0 '1 elements, 1 segments, 1 rejected' "$plumbline" info d.svg --without-layers 'Walls'
expect "a pattern without a layer is an error that names them" 2 'there are "walls", "doors": "roof"' "$plumbline" check d.svg --layers roof
expect "a certificate's command chooses the same" 0 "eval d.svg --layers 'w.*'" "$plumbline" arrange d.svg --layers 'w*' --certify d.certificate
rm d.svg d.certificate
expect "a tolerance is positive" 2 'not positive.*"0"' "$plumbline" check c.svg --flatten 0
expect "a tolerance is a number" 2 'not a number.*"fine"' "$plumbline" check c.svg --flatten fine
rm c.svg
svg '<text>Hall</text>' >texts.svg
expect "a drawing of nothing but texts is none" 2 'nothing of the file is drawn: it has no segments' "$plumbline" info texts.svg
rm texts.svg
svg '' >empty.svg
expect "an empty drawing is a drawing" 0 '0 vertices, 0 edges.*1 faces' "$plumbline" arrange empty.svg -o empty.json
expect "but nothing to agree about" 2 'nothing of the file is drawn.*--lenient' "$plumbline" check empty.svg
expect "not even for the lenient" 1 '^nothing was drawn' "$plumbline" check empty.svg --lenient --picture empty-check.svg
svg '<text>t</text>' >text.svg
printf '0,0,1,0\n1,0,x,1\n1,1,0,0\n' >bad.csv
printf '[((0,0),(1,0))]\n' >python.lines
for drawing in text.svg bad.csv python.lines; do
  expect "what cannot be read is no agreement: $drawing" 2 "$drawing:.*--lenient" "$plumbline" check $drawing
done
rm text.svg bad.csv python.lines
echo 'POLYGON((0 0,4 0,4 4))' >open.wkt
expect "what is drawn with a remark is no error" 0 '0 rejected, 1 remark.*remark: 1 x Polygon: ring is not closed' "$plumbline" info open.wkt
echo '[[[0,0],[4,0]],[[4,0],[4,4]],[[4,4],[0,0]]]' >bare.json
expect "a bare list of segments is a drawing" 0 '3 vertices, 3 edges' "$plumbline" arrange bare.json
expect "and a result" 0 '^agree' "$plumbline" check bare.json --against bare.json
rm open.wkt bare.json
leaves "the outputs are there, and nothing else" a.svg b.svg empty-check.svg empty.json empty.svg

expect "a certificate comes with the command that checks it" 0 'eval .*dwelling.svg --flatten 0.5 -o x.certificate.lines && plumbline-verify x.certificate.lines x.certificate' "$plumbline" arrange "$examples/dwelling.svg" --flatten 0.5 --certify x.certificate
expect "the segments are written exactly" 0 '9 segments' "$plumbline" eval "$examples/dwelling.svg" -o segments.lines
expect "their certificate is that of the drawing" 0 'plumbline-verify segments.lines y' bash -c "'$plumbline' arrange segments.lines --certify y.certificate && cmp x.certificate y.certificate && rm x.certificate y.certificate segments.lines"
expect "an unknown output format is refused before the work" 2 'json.*svg.*out\.txt' "$plumbline" arrange "$examples/dwelling.svg" -o out.txt
expect "an empty output name is refused" 2 'output' "$plumbline" arrange "$examples/dwelling.svg" -o ''
expect "a picture is an .svg file" 2 'ends in \.svg.*p\.json' "$plumbline" check "$examples/dwelling.svg" --picture p.json
cp "$examples/dwelling.svg" in.svg
ln -s p.svg q.svg
expect "an output is not overwritten by way of a link to it" 2 'overwrite.*q.svg' "$plumbline" check in.svg --picture p.svg --plot q.svg
rm q.svg
expect "a drawing is not overwritten" 2 'overwrite.*in\.svg' "$plumbline" arrange in.svg -o ./in.svg
expect "nor by a picture" 2 'overwrite' "$plumbline" check in.svg --picture in.svg
expect "the drawing is what it was" 0 '^$' cmp in.svg "$examples/dwelling.svg"
printf '0,0,1e-320,0\n0,0,0,1e-320\n1e-320,0,0,1e-320\n' >tiny.lines
expect "features below the least double's square root have a size" 0 'nearest vertices 9\.99989e-321 apart' "$plumbline" info tiny.lines
expect "a tiny drawing has a picture" 0 'agree' "$plumbline" check tiny.lines --picture tiny.svg
expect "without coordinates that are no numbers" 1 '^$' grep -E 'nan|inf' tiny.svg
printf '0,0,420.34,0\n420.34000000000003,0,420.34000000000003,9\n' >printed.lines
expect "info counts what printed doubles leave open" 0 'drift +printed doubles: 1 place, at most 3e-14 apart' "$plumbline" info printed.lines
expect "findings of that alone are findings, but the drawing's own" 1 '^agree but for the file.s own drift: 1 finding.*drawing, below-the-digits: 1 ' "$plumbline" check printed.lines --radius 1e-8
expect "short decimals leave nothing to find" 0 '^agree.*1 number was replaced, by at most 3e-14 units' "$plumbline" check printed.lines --radius 1e-8 --shortest-decimals
rm -f in.svg tiny.lines tiny.svg printed.lines
expect "an output that cannot be written is an error" 2 'none/out\.json' "$plumbline" arrange "$examples/dwelling.svg" -o none/out.json
expect "a negative radius is refused" 2 'radius' "$plumbline" check "$examples/dwelling.svg" --radius -1
expect "a radius has a name and a value" 0 'radius 0.361176 .larlib: 0.001 on the unit square., tol' "$plumbline" check "$examples/dwelling.svg" --radius larlib
expect "the report says which was used" 0 '"radius_from": "plasm"' bash -c "'$plumbline' check '$examples/dwelling.svg' --radius plasm -o p.json; grep radius_from p.json; rm p.json"
expect "also of one stage after the other" 0 'radius 1e-08 .plasm.' "$plumbline" lar "$examples/dwelling.svg" --radius plasm
expect "a radius that is no number is refused" 2 'radius' "$plumbline" check "$examples/dwelling.svg" --radius much
expect "nan is no tolerance" 2 'tolerance' "$plumbline" check "$examples/dwelling.svg" --tolerance nan
expect "agreement is exit code 0" 0 '^agree' "$plumbline" check "$examples/hospital-emergency.svg"
expect "disagreement is exit code 1" 1 '^disagree' "$plumbline" check "$examples/office-plan.svg" -o a.json --picture a.svg
expect "the drawing's exact counts are shown" 1 'vertices +370 .*edges +475 .*faces +108 ' "$plumbline" check "$examples/office-plan.svg"
expect "info names overlaps and antennas" 0 '3 pairs of different segments.*100 antennas' "$plumbline" info "$examples/office-plan.svg"
expect "it shows and plots the tolerance ladder" 0 '0\.087 +357 +462 +108  vertices .*and 249 more steps' "$plumbline" info "$examples/office-plan.svg" --ladder --plot l.svg
expect "the plot is a picture" 0 'tolerance ladder' grep -o 'tolerance ladder' l.svg
expect "a plot is an SVG file" 2 'svg.*"l.png"' "$plumbline" info "$examples/office-plan.svg" --plot l.png
expect "check advises radii" 1 'float LAR is right with --radius [0-9.e-]*, and with all tried from .* to 0\.08656' "$plumbline" check "$examples/office-plan.svg" --plot l.svg
expect "unless told not to" 1 'nearer to another one.[[:space:]]+as authored' "$plumbline" check "$examples/office-plan.svg" --no-advice
rm -f l.svg
expect "both engines agree on a drawing" 0 '370 vertices' "$plumbline" arrange "$examples/office-plan.svg" --exact-engine cgal --both-engines
expect "their old names still work, and say so" 0 'verify is --both-engines now.*engine is --exact-engine now' "$plumbline" arrange "$examples/office-plan.svg" --engine cgal --verify
expect "an unknown exact engine names the known ones" 2 'not fast, but bucket or cgal' "$plumbline" info "$examples/dwelling.svg" --exact-engine fast
expect "by its old name, too" 2 'bucket and cgal: "fast"' "$plumbline" info "$examples/dwelling.svg" --engine fast
expect "an unknown engine names the known ones" 2 'lar, inters, plasm, files.*: "fast"' "$plumbline" check "$examples/dwelling.svg" --engine fast
expect "any engine can be checked, with its parameters" 1 'LAR inters.*radius 0.01,' "$plumbline" check "$examples/dwelling.svg" --engine inters --set radius=0.01 --set decimals=3
expect "the short forms mean the same" 1 'LAR inters.*radius 0.01,' "$plumbline" check "$examples/dwelling.svg" --variant published --radius 0.01 --decimals 3
expect "a parameter that an engine has not is refused, with those that it has" 2 'lar has no such parameter; it has radius: "decimals"' "$plumbline" check "$examples/dwelling.svg" --decimals 3
expect "so is a value that it cannot have" 2 'larFromLines or allComponents or cells: "all"' "$plumbline" check "$examples/dwelling.svg" --engine inters --set result=all
printf '0,0,4,0\n4,0,4,4\n4,4,0,0\n' >c.lines
: >empty.lines
echo '1,1,5,1' >flat.lines
echo 'POLYGON((0 0,4 0,4 4,0 0))' >c.wkt
expect "a right result of another program agrees" 0 '^agree' "$plumbline" check c.lines --against c.wkt
expect "a file of it is an engine, too" 0 'the result' "$plumbline" check c.lines --engine files --set file=c.wkt
echo 'LINESTRING(0 0,4 0,4 4)' >c.wkt
echo 'POLYGON((0 0,4 0,4 4,0 0))' >c.wkt
printf '0,0,4,0\n4,0,4,4\n4,4,0,0\n4,4,5,5\n2,0,2,-1\n' >dangles.lines
expect "polygons claim faces, not what dangles" 0 '^agree .the result has polygons alone: 2 edges' "$plumbline" check dangles.lines --against c.wkt
printf '0,0,4,0\n4,0,4,4\n4,4,0,0\n0,0,0,4\n0,4,4,4\n' >two.lines
expect "some of the faces are some of them" 0 '^agree .1 of the result' "$plumbline" check two.lines --against c.wkt --some-faces
expect "all of them are not" 1 '^disagree' "$plumbline" check two.lines --against c.wkt
expect "it takes a result to have some" 2 'against' "$plumbline" check two.lines --some-faces
rm dangles.lines two.lines
echo 'LINESTRING(0 0,4 0,4 4)' >c.wkt
expect "nor has it faces without any" 2 'of a result with faces' "$plumbline" check c.lines --against c.wkt --some-faces
expect "one without faces is compared by its edges" 1 '^disagree: 1 finding.*no faces.*edge missing' "$plumbline" check c.lines --against c.wkt
expect "a result has no radius" 2 'radius' "$plumbline" check c.lines --against c.wkt --radius 1
echo '{"V": [[0,0]], "EV": [[0,1]]}' >c.json
expect "a malformed result is an error with its place" 2 'c\.json:1:2.*no such vertex' "$plumbline" check c.lines --against c.json
expect "compact JSON is written" 0 'wrote compact.json' "$plumbline" arrange c.lines --compact -o compact.json
expect "and read as a result" 0 '^agree' "$plumbline" check c.lines --against compact.json
expect "compact is of JSON alone" 2 'ends in .json' "$plumbline" arrange c.lines --compact -o compact.svg
expect "compact is not of --safe" 2 'safe' "$plumbline" arrange c.lines --compact --safe -o compact.json
rm compact.json
expect "a drawing is no result" 2 'unknown file name ending of a result.*\.svg' "$plumbline" check c.lines --against "$examples/dwelling.svg"
rm -f c.wkt c.json
expect "lines files are drawings" 0 '3 vertices, 3 edges .0 antennas., 2 faces' "$plumbline" arrange c.lines
expect "the float pipeline runs as repaired" 0 'repaired.*3 vertices, 3 edges .0 antennas., 2 faces' "$plumbline" lar c.lines
expect "and as published" 0 'published: 4 decimals.*larFromLines 3 vertices, 3 edges, 1 faces' "$plumbline" lar c.lines --variant published --trace t.json
expect "its trace has the original's keys" 0 'larFromLines' grep larFromLines t.json
expect "a stage that fails is told, with its function" 2 'buckets: IndexError in centroid.*fails on this drawing' "$plumbline" lar empty.lines --variant published
expect "an unknown variant names the known ones" 2 'published' "$plumbline" lar c.lines --variant best
expect "decimals are the published variant's" 2 'published' "$plumbline" lar c.lines --decimals 3
expect "too many decimals are refused" 2 '12.*"13"' "$plumbline" lar c.lines --variant published --decimals 13
expect "the published radius is positive" 2 'radius.*"0"' "$plumbline" lar c.lines --variant published --radius 0
expect "a picture shows components" 0 'wrote p.svg' "$plumbline" lar c.lines --show components -o p.svg
expect "a picture shows single polylines" 0 'wrote p.svg' "$plumbline" lar c.lines --show polylines -o p.svg
expect "and the boundary of chosen faces" 0 'wrote p.svg' "$plumbline" lar c.lines --show boundary --faces 0 -o p.svg
expect "a face that is not there is refused" 2 'no such face.*"1"' "$plumbline" lar c.lines --show boundary --faces 0,1 -o p.svg
expect "chosen faces belong to that picture" 2 'boundary' "$plumbline" lar c.lines --faces 0 -o p.svg
expect "it runs on one thread" 0 'wrote 1.json' "$plumbline" lar c.lines --trace 1.json --threads 1
expect "and on two" 0 'wrote 2.json' "$plumbline" lar c.lines --trace 2.json --threads 2
expect "with the same trace" 0 '' cmp 1.json 2.json
expect "random segments are a drawing" 0 'wrote r.lines' "$plumbline" random 100 --scaling 0.5 --seed 4 -o r.lines
expect "of as many segments" 0 '100 segments, 0 rejected' "$plumbline" lar r.lines
"$plumbline" random 100 --scaling 0.5 --seed 4 >printed
expect "the same seed prints the same rows" 0 '' cmp printed r.lines
rm -f printed 1.json 2.json r.lines
expect "coordinates must be, too" 2 'scaling.*beyond the largest double' "$plumbline" random 5 --scaling 1e308
expect "a scaling must be finite" 2 'scaling.*inf' "$plumbline" random 1 --scaling inf
expect "random segments go to a .lines file" 2 'lines' "$plumbline" random 1 -o r.svg
structures=$examples/../structures
expect "a structure is evaluated" 0 'instances +500.*dimension +2.*vertices +2000.cells +500' "$plumbline" eval "$structures/tables.json" -o t.json
expect "to a LAR model" 0 '"CV"' grep -o '"CV"' t.json
expect "which is a drawing" 0 '2000 vertices, 2000 edges' "$plumbline" arrange "$structures/tables.json" --verify
expect "a structure of space has a picture" 0 'box +0 0 0 .. 100 30 30.vertices +31451.cells +33900' "$plumbline" eval "$structures/cubes.json" --merge-cells -o p.svg
expect "a plan is embedded in space" 0 'dimension +3.box +-24 -3 0 .. 24 24 0' "$plumbline" eval "$structures/dwelling.json" --embed 1
expect "a boundary has facets" 0 'cells +36' "$plumbline" eval "$structures/dwelling.json" --boundary -o p.svg
expect "but no arrangement" 2 'dimension 3' "$plumbline" arrange "$structures/cubes.json"
expect "a category is a part" 0 'instances +400' "$plumbline" eval "$structures/tables.json" --category chair
expect "a drawing is a structure" 0 'wrote s.json' "$plumbline" eval "$examples/dwelling.svg" --structure -o s.json
expect "with the same complex" 0 'signature' bash -c "'$plumbline' arrange s.json | grep signature | grep -f <('$plumbline' arrange '$examples/dwelling.svg' | grep signature)"
expect "a rotation that was replaced is told" 0 'rotation by 30 degrees.*within 1e-15 rad' "$plumbline" eval "$structures/robot_arm.json"
echo '{"root": "S", "defs": {"S": {"body": [{"ref": "T"}]}, "T": {"body": [{"ref": "S"}]}}}' >cycle.json
expect "a cycle is told by its names" 2 'cycle of references: "S/T/S"' "$plumbline" eval cycle.json -o t.json
rm -f t.json p.svg s.json cycle.json
expect "an unknown picture names the known ones" 2 'pruning' "$plumbline" lar c.lines --show rooms -o p.svg
expect "the unit square is for drawings with extent, as published" 2 'width and height' "$plumbline" lar flat.lines --variant published --unit-square
expect "and for all drawings, as repaired" 0 '2 vertices, 1 edges' "$plumbline" lar flat.lines --unit-square
rm -f t.json p.svg empty.lines flat.lines
printf '0,0,10,0\n10,0,10,10\n10,10,0,10\n0,10,0,0\n5,0,5,9.75\n' >short.lines
expect "a diagnosis names defects, sizes and elements" 0 '1 undershoot.*a line ends 0.25 short of another one.*short.lines:5' "$plumbline" info short.lines --diagnose --within 1/4 -o d.json --picture d.svg
expect "the search distance decides" 0 '1 dangle' "$plumbline" info short.lines --diagnose --within 0.2
expect "as many of each kind as asked for" 0 'undershoot: 1.*short.lines:3' "$plumbline" info short.lines --diagnose --within 1/4 --list 1
expect "the defects as a layer" 0 '^$|matters' "$plumbline" info short.lines --diagnose --within 1/4 --findings d.geojson
expect "which has their ranks" 0 '"rank":1' cat d.geojson
expect "or for CAD, on layers by kind" 0 '^undershoot$' bash -c "'$plumbline' info short.lines --diagnose --within 1/4 --findings d.dxf >/dev/null && grep -m1 undershoot d.dxf"
rm -f d.dxf
expect "the lesser of which comes first" 2 'lesser one first.*2..1' "$plumbline" info short.lines --diagnose --doors 2..1
expect "doors have two widths" 2 'LEAST..MOST.*3' "$plumbline" info short.lines --diagnose --doors 3
expect "the diagnosis as JSON" 0 'plumbline diagnosis 1' cat d.json
expect "a negative search distance is refused" 2 'negative.*-1' "$plumbline" info short.lines --diagnose --within -1
expect "a search distance is for the diagnosis" 2 'diagnose' "$plumbline" info short.lines --within 1
expect "a diagnosis does not overwrite its drawing" 2 'ends in .json' "$plumbline" info short.lines --diagnose -o short.lines
rm -f d.json d.svg d.geojson short.lines
printf '0,0,3,1\n1,0.2,1,5\n' >cross.lines
expect "nearest doubles are proven to form the same complex" 0 'rounded to nearest doubles: same incidences, proven; largest movement [0-9.]+e-17' "$plumbline" arrange cross.lines --safe -o s.json
expect "the file says so" 0 '"same_incidences": true' grep same_incidences s.json
printf '0,0,3,1\n1,0.33333333333333333333333333334,1,5\n' >above.lines
expect "where they do not, snap rounding does" 0 'snap rounded to multiples of 8.88e-16: 1 edges bent by at most [0-9.]+e-16; .*verified' "$plumbline" arrange above.lines --safe -o s.json
expect "and the counts are of what is written" 0 'written: 4 vertices, 3 edges' "$plumbline" arrange above.lines --safe -o s.json
expect "and the file lists what it did" 0 '"bent_edges"' grep bent_edges s.json
expect "decimals are rounded safely too" 0 'rounded to 3 decimals: same incidences' "$plumbline" arrange cross.lines --safe --decimals 3 -o s.json
expect "in the numbers of the file" 0 '"nearest": .1, 0.333.' grep 0.333 s.json
expect "rounded edges are a drawing" 0 'wrote s.lines' "$plumbline" arrange above.lines --safe --decimals 1 -o s.lines
expect "with the same complex" 0 '4 vertices, 3 edges' "$plumbline" arrange s.lines
expect "edges that are no decimals are written safely" 0 'proven' "$plumbline" arrange cross.lines -o s.lines
printf '0,0,2,1\n1,-1,1,5\n' >halves.lines
"$plumbline" arrange halves.lines -o s.lines >halves.txt
expect "decimals as they are" 0 '^0,0,1,0.5' cat s.lines
expect "without rounding" 1 '^$' grep proven halves.txt
rm halves.lines halves.txt
expect "decimals belong to --safe" 2 'safe' "$plumbline" arrange above.lines --decimals 3 -o s.json
"$plumbline" arrange "$examples/office-plan.svg" --safe -o rounded.lines >/dev/null
for kind in geojson wkt csv wkb; do
  expect "faces are written as polygons ($kind)" 0 "same incidences, proven.*wrote rooms.$kind" "$plumbline" arrange "$examples/office-plan.svg" -o "rooms.$kind"
  expect "which are the drawing's faces" 0 "^agree" "$plumbline" check "$examples/office-plan.svg" --against "rooms.$kind"
  expect "and those of the rounded one at tolerance 0" 0 "^agree" "$plumbline" check rounded.lines --against "rooms.$kind" --tolerance 0
  rm -f "rooms.$kind"
done
expect "a LAR model is exact" 0 "wrote m.lar.json" "$plumbline" arrange "$examples/office-plan.svg" -o m.lar.json
expect "and has all cells" 0 "^agree" "$plumbline" check "$examples/office-plan.svg" --against m.lar.json
"$plumbline" arrange "$examples/office-plan.svg" --safe --format lar -o m.json >/dev/null
expect "or rounded" 0 "^agree" "$plumbline" check rounded.lines --against m.json --tolerance 0
expect "DXF has the edges" 0 "same incidences, proven.*wrote e.dxf" "$plumbline" arrange "$examples/office-plan.svg" -o e.dxf
"$plumbline" arrange e.dxf --safe -o back.lines >/dev/null
expect "which are read as they were" 0 '^$' cmp rounded.lines back.lines
expect "TopoJSON has the faces" 0 "same incidences, proven.*wrote f.topojson" "$plumbline" arrange "$examples/office-plan.svg" -o f.topojson
expect "OBJ has triangles" 0 "same incidences, proven.*wrote f.obj" "$plumbline" arrange "$examples/office-plan.svg" -o f.obj
rm -f rounded.lines back.lines m.lar.json m.json e.dxf f.topojson f.obj
expect "edges and vertices are layers" 0 'wrote c.geojson' "$plumbline" arrange "$examples/dwelling.svg" --cells edges,vertices -o c.geojson
expect "that say which they are" 0 '"layer":"vertices"' grep -m1 -o '"layer":"vertices"' c.geojson
expect "in decimals as well" 0 'wrote c.geojson' "$plumbline" arrange "$examples/dwelling.svg" --decimals 3 -o c.geojson
rm -f c.geojson
expect "a CSV file holds one kind of cells" 2 'one kind' "$plumbline" arrange "$examples/dwelling.svg" --cells edges,faces -o c.csv
expect "too many decimals are refused" 2 '19' "$plumbline" arrange above.lines --safe --decimals 19 -o s.json
expect "what is safe is written to a file" 2 'output' "$plumbline" arrange above.lines --safe
rm -f s.json s.lines cross.lines above.lines
if [[ -e /dev/full ]]; then
  expect "a full disk is an error" 2 'standard output' bash -c "'$plumbline' info c.lines >/dev/full"
fi
"$plumbline" check "$examples/office-plan.svg" -o b.json --picture b.svg >/dev/null
expect "the same input gives the same bytes" 0 '^$' bash -c 'cmp a.json b.json && cmp a.svg b.svg'
leaves "nothing else was written" a.json a.svg b.json b.svg c.lines
finish
