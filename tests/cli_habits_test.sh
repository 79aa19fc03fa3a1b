#!/usr/bin/env bash
# tests/cli_habits_test.sh PLUMBLINE EXAMPLES: what people expect of any command line: pipes, formats, summaries for
# programs, several files, help for typing errors, completion. One line per case; fails if any case does.
set -uo pipefail
plumbline=$1
examples=$2
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
# output_of COMMAND...: what it writes to standard output alone.
# shellcheck disable=SC2317 # expect calls it, as what follows
output_of() { "$@" 2>/dev/null; }

# ---- Pipes and formats
cp "$examples/dwelling.svg" plan.svg
exact=$("$plumbline" arrange plan.svg | tail -1)
expect "a drawing is read from a pipe" 0 "$exact" bash -c "cat plan.svg | '$plumbline' arrange -"
expect "and from a file as standard input" 0 "$exact" bash -c "'$plumbline' arrange - <plan.svg"
expect "by its name, too" 0 "$exact" bash -c "cat plan.svg | '$plumbline' arrange /dev/stdin"
expect "from what a shell makes of a command" 0 "$exact" bash -c "'$plumbline' arrange <(cat plan.svg)"
mkfifo pipe.svg
cat plan.svg >pipe.svg &
expect "from a named pipe" 0 "$exact" timeout 60 "$plumbline" arrange pipe.svg
for form in geojson wkt csv wkb; do
  expect "what is written to a pipe is read from it ($form)" 0 ' 8 faces' bash -c "'$plumbline' arrange plan.svg -o - --format $form 2>/dev/null | '$plumbline' arrange -"
done
expect "a result is read from a pipe" 0 '^agree' bash -c "'$plumbline' arrange plan.svg -o - --format wkt 2>/dev/null | '$plumbline' check plan.svg --against -"
expect "what has no certain format asks for it" 2 'tell no format' bash -c "echo text | '$plumbline' info -"
expect "which --from says" 0 '1 segments' bash -c "echo 0,0,1,1 | '$plumbline' info - --from csv"
expect "or an ending that lies" 0 "$exact" bash -c "cp plan.svg plan.txt; '$plumbline' arrange plan.txt --from svg"
expect "of the formats that there are" 2 'not dwg, but svg, svgz, dxf' "$plumbline" info plan.svg --from dwg
expect "nothing at all has none" 2 'it is empty .--from' bash -c "'$plumbline' info - </dev/null"
expect "a closed standard input is no drawing" 2 '^plumbline: /dev/stdin' bash -c "'$plumbline' info - <&-"
expect "data alone are on standard output" 0 '^\{.*\}$' output_of "$plumbline" arrange plan.svg -o -
expect "in the format that is asked for" 0 '^POLYGON' output_of "$plumbline" arrange plan.svg -o - --format wkt
expect "by another name of it" 0 '^\{.*\}$' output_of "$plumbline" arrange plan.svg -o /dev/stdout
expect "what is said goes to standard error" 0 "$exact" bash -c "'$plumbline' arrange plan.svg -o - 2>&1 >/dev/null"
expect "so it is of reports" 0 '^\{.*"findings".*\}$' output_of "$plumbline" check plan.svg -o -
expect "of pictures" 0 '^<svg.*</svg>$' output_of "$plumbline" lar plan.svg -o -
expect "of structures" 0 '^<svg.*</svg>$' output_of "$plumbline" eval plan.svg -o - --format svg
expect "of random segments" 0 '^[0-9.,]+$' output_of "$plumbline" random 1
expect "a format goes before an ending" 0 '^POLYGON' bash -c "'$plumbline' arrange plan.svg -o a.txt --format wkt >/dev/null && cat a.txt"
expect "an unknown format names the known ones" 2 'not dwg, but json, svg, geojson' "$plumbline" arrange plan.svg -o - --format dwg
expect "a format is of an output" 2 'format' "$plumbline" arrange plan.svg --format wkt
expect "standard output takes one output" 2 'takes one output' "$plumbline" check plan.svg -o - --picture -
if [[ -e /dev/full ]]; then
  expect "a full disk behind standard output is told" 2 'cannot write to standard output' bash -c "'$plumbline' arrange plan.svg -o - >/dev/full"
fi
expect "a closed standard output is told" 2 'cannot write to standard output' bash -c "'$plumbline' arrange plan.svg -o - >&-"
expect "who has read enough may go" 0 '^\{' bash -c "'$plumbline' arrange '$examples/office-plan.svg' -o - 2>/dev/null | head -1"

# ---- Summaries
expect "a summary of what is arranged" 0 '^\{.*"file": "plan.svg".*"segments": 9,.*"rejected": 0,.*"vertices": 33,.*"edges": 39,.*"antennas": 18,.*"faces": 8,.*"components": 1,.*"signature": "[0-9a-f]{32}".*\}$' output_of "$plumbline" arrange plan.svg --json
expect "of what a drawing holds" 0 '^\{.*"edges": 39,.*"signature": "[0-9a-f]{32}".*"overlaps": 0.*\}$' output_of "$plumbline" info plan.svg --json
expect "of a check" 0 '^\{.*"agree": true,.*"findings": 0,.*"groups": 0,.*\}$' output_of "$plumbline" check "$examples/hospital-emergency.svg" --json
expect "also of one that disagrees" 1 '"agree": false,.*"findings": [1-9]' output_of "$plumbline" check "$examples/office-plan.svg" --json
for command in lar eval; do
  expect "of $command" 0 '^\{.*"vertices": [0-9]+,?.*\}$' output_of "$plumbline" $command plan.svg --json
done
expect "the files written are in it" 0 '"written": \["p.svg"\]' "$plumbline" arrange plan.svg --json -o p.svg
expect "where data go to standard output, it goes to standard error" 0 '^\{.*"edges": 39' bash -c "'$plumbline' arrange plan.svg --json -o - 2>&1 >/dev/null"
expect "an error is in it" 2 '"error": "none.svg: no such file"' output_of "$plumbline" info none.svg --json
expect "quiet is without a word" 0 '^$' "$plumbline" arrange plan.svg --quiet -o p.svg
expect "but for errors" 2 'no such file' "$plumbline" arrange none.svg -q
expect "verbose tells what takes how long" 0 '0\.[0-9]* s +arranging 9 segments' bash -c "'$plumbline' arrange plan.svg -v 2>&1 >/dev/null"
expect "one cannot be both" 2 'quiet' "$plumbline" arrange plan.svg -q -v

# ---- Several drawings
cp "$examples/office-plan.svg" office.svg
cp "$examples/hospital-emergency.svg" good.svg
expect "several drawings are a line each, and a count" 0 'good.svg: [0-9]+ vertices.*plan.svg: 33 vertices, 39 edges.*2 drawings: 2 done' "$plumbline" info good.svg plan.svg
expect "in the order given" 1 'office.svg: disagree: 63 findings.*good.svg: agree.*2 drawings: 1 agree, 1 disagree' "$plumbline" check office.svg good.svg
expect "the worst exit code counts, and one that is not there stops nothing" 2 'none.svg: no such file.*office.svg: disagree.*good.svg: agree.*3 drawings: 1 agree, 1 disagree, 1 refused' "$plumbline" check none.svg office.svg good.svg
expect "options may stand between" 0 '2 drawings: 2 done' "$plumbline" arrange good.svg --threads 1 plan.svg
expect "an output is of one" 2 '--output is of one drawing; here are 2' "$plumbline" check good.svg plan.svg -o a.json
expect "so is a picture" 2 'picture is of one drawing' "$plumbline" check good.svg plan.svg --picture a.svg
expect "and a result" 2 'against is of one drawing' "$plumbline" check good.svg plan.svg --against a.json
expect "the summary of several is one object" 1 '^\{.*"files": \[.*"file": "office.svg".*"agree": false,.*"exit_code": 1.*"file": "good.svg".*"agree": true.*"exit_code": 0.*\],[[:space:]]*"exit_code": 1[[:space:]]*\}$' "$plumbline" check office.svg good.svg --json
expect "quiet is quiet, too" 1 '^$' "$plumbline" check office.svg good.svg -q
rm office.svg good.svg

# ---- Help and typing errors
expect "help is a command" 0 'Commands:.*arrange.*check' "$plumbline" help
expect "of a command, too" 0 'Usage: plumbline check .OPTIONS. FILE.*Comparison:.*--radius R' "$plumbline" help check
expect "the version has a short form" 0 '^plumbline [0-9.]+$' "$plumbline" -V
expect "help is of help" 0 'Commands:' "$plumbline" help help
for command in '' arrange check coverage engines eval info lar overlay random rooms select validity; do
  expect "no line is longer than 100: help $command" 1 '^$' bash -c "'$plumbline' $command --help | grep -E '.{101}'"
done
expect "a command with a typing error" 2 '"chek"; did you mean check\?' "$plumbline" chek plan.svg
expect "also where help is asked for" 2 'did you mean check\?' "$plumbline" help chek
expect "an option, told in the order given" 2 'unknown option of check: "--raduis"; did you mean --radius\?' "$plumbline" check plan.svg --raduis 3
expect "one that is begun" 2 'did you mean --tolerance\?' "$plumbline" check plan.svg --tol=3
expect "one that is nothing like any" 2 'unknown option of check: "--frobnicate" .plumbline check --help' "$plumbline" check plan.svg --frobnicate
expect "an option before the command" 2 'a command comes first, not "--radius"' "$plumbline" --radius 3 check plan.svg
expect "a value" 2 'show: not expload; did you mean explode\? It is buckets, ' "$plumbline" lar plan.svg --show expload
expect "a format" 2 'did you mean geojson\?' "$plumbline" arrange plan.svg --format geojsn -o -
expect "a radius" 2 'did you mean larlib\?' "$plumbline" check plan.svg --radius larlbi
expect "a value in capital letters is the same" 0 'wrote p.svg' "$plumbline" lar plan.svg --show Explode -o p.svg
expect "a value that is missing" 2 '--radius needs a value, R' "$plumbline" check plan.svg --radius
expect "a value of what takes none" 2 '--json takes no value' "$plumbline" info plan.svg --json=5
expect "a file that is missing" 2 'FILE is missing' "$plumbline" arrange
expect "a file too many" 2 'lar takes no further argument: "b.svg"' "$plumbline" lar plan.svg b.svg
expect "an option twice" 2 '--threads is given more than once' "$plumbline" arrange plan.svg --threads 1 --threads 2
expect "what does not go together" 2 '--quiet and --json do not go together|--json and --quiet' "$plumbline" arrange plan.svg -q --json
expect "what a terminal would obey is not shown" 1 '^$' bash -c "'$plumbline' info plan.svg \$'--\\e[31mred' 2>&1 | grep \$'\\e'"

# ---- Terminals
if command -v script >/dev/null; then
  # on_terminal ENVIRONMENT COMMAND...: what it shows on a terminal of 20 columns.
  # shellcheck disable=SC2317
  on_terminal() { env "$1" script -qec "stty cols 20; ${*:2}" /dev/null </dev/null; }
  expect "a verdict is green on a terminal" 0 $'\e\\[32magree\e' on_terminal TERM=xterm "$plumbline" check "$examples/hospital-emergency.svg"
  for plain in NO_COLOR=1 TERM=dumb; do
    expect "but not with $plain" 1 '^$' bash -c "$(declare -f on_terminal); on_terminal $plain '$plumbline' check '$examples/hospital-emergency.svg' | grep \$'\\e'"
  done
  expect "no line is longer than 100 there" 1 '^$' bash -c "$(declare -f on_terminal); on_terminal TERM=dumb '$plumbline' check '$examples/office-plan.svg' --list 9 | tr -d '\\r' | grep -E '.{101}'"
  "$plumbline" random 50000 --scaling 0.5 -q -o many.lines
  expect "progress fits a narrow terminal, with its per cent" 2 $'\rarranging +[0-9]+ % [0-9]+ s' on_terminal TERM=xterm "$plumbline" arrange many.lines --threads 1 --timeout 8
  expect "a terminal that is none is not told to wipe" 1 '^$' bash -c "$(declare -f on_terminal); on_terminal TERM=dumb '$plumbline' arrange many.lines --threads 1 --timeout 5 | grep \$'\\e'"
  rm many.lines
  expect "help fits a narrow terminal" 0 '--from FORMAT[[:space:]]+Format of' on_terminal TERM=dumb "$plumbline" check --help
fi

# ---- Completion and manual pages, made from the options
rm -f a.txt p.svg plan.txt pipe.svg
"$plumbline" completion bash >complete.bash
expect "the completion is bash" 0 '^$' bash -n complete.bash
# completes WORD...: what bash makes of the last one.
# shellcheck disable=SC2317
completes() {
  bash -c 'source ./complete.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _plumbline; echo "${COMPREPLY[@]}"' - "$@"
}
expect "commands are completed" 0 '^check$' completes plumbline ch
expect "all of them" 0 '^arrange check minimise info rooms overlay select coverage validity repair lar eval random engines help --help --version$' completes plumbline ''
expect "of help, too" 0 '^check$' completes plumbline help ch
expect "options" 0 '^--picture$' completes plumbline check plan.svg --pic
expect "values" 0 '^geojson$' completes plumbline arrange plan.svg --format geo
expect "behind an equals sign" 0 '^geojson$' completes plumbline arrange --format = geo
expect "files" 0 '^plan.svg$' completes plumbline arrange pl
expect "files of options" 0 '^plan.svg$' completes plumbline check -o pl
expect "nothing where a number is asked for" 0 '^$' completes plumbline arrange --threads ''
"$plumbline" completion zsh >_plumbline
"$plumbline" completion fish >plumbline.fish
expect "zsh's has the same options" 0 'picture' cat _plumbline
expect "fish's, too" 0 'complete -c plumbline -n .__fish_seen_subcommand_from check. -l picture -r -F' cat plumbline.fish
command -v zsh >/dev/null && expect "the completion is zsh" 0 '^$' zsh -n _plumbline
command -v fish >/dev/null && expect "the completion is fish" 0 '^check[[:space:]]' fish --no-config -c 'source plumbline.fish; complete -C "plumbline ch"'
expect "an unknown shell" 2 'not csh; did you mean zsh\? It is bash, zsh or fish' "$plumbline" completion csh
for page in '' arrange check coverage eval info lar overlay random rooms select validity; do
  "$plumbline" man $page >page.1
  expect "the manual has a page: plumbline $page" 0 '^.TH PLUMBLINE.*.SH SYNOPSIS.*.SH EXAMPLES' cat page.1
  command -v man >/dev/null && expect "man has nothing to say against it" 0 '^$' bash -c 'LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l page.1 2>&1 >/dev/null'
  # An empty date is the wish to have the same bytes always; pages refer to pages of this program.
  command -v mandoc >/dev/null && expect "nor mandoc" 1 '^$' bash -c 'mandoc -T lint page.1 | grep -v "missing date"'
done
rm -f complete.bash _plumbline plumbline.fish page.1

# Rooms.
flat=$examples/flat.dxf
expect "rooms are a table" 0 '^3 rooms, 3 with a name, 81\.57 m2 in all.* 1 +24\.03 m2  Kitchen +2d 3d +DOORS, WALLS' "$plumbline" rooms "$flat" --walls WALLS,DOORS
expect "furniture parts rooms where it is not left out" 0 '^4 rooms.*left out: 9 areas not 0\.5 m wide' "$plumbline" rooms "$flat"
expect "units may be said" 0 '^0 rooms.*a drawing unit is 0\.001 m \(mm\)' "$plumbline" rooms "$flat" --unit mm
expect "no layer of a name is an error with those that there are" 2 'no layer of this name; there are "DOORS", "FURNITURE", "WALLS".*"nosuch"' "$plumbline" rooms "$flat" --walls nosuch
expect "sizes are not negative" 2 'not negative.*"-1"' "$plumbline" rooms "$flat" --min-width -1
expect "which units there are" 2 'unit is mm, cm, dm, m, km, in or ft' "$plumbline" rooms "$flat" --unit mn
expect "a summary has areas as numbers and exact texts" 0 '"rooms": .*"names": ."Kitchen".*"layers": ."DOORS", "WALLS".*"area": 24\.0.*"area_exact": "' output_of "$plumbline" rooms "$flat" --json
for format in geojson topojson csv wkt wkb dxf json svg html; do
  expect "rooms as $format" 0 '^wrote rooms\.'"$format" bash -c "'$plumbline' rooms '$flat' -o rooms.$format | tail -1"
  rm "rooms.$format"
done
expect "on standard output, the table elsewhere" 0 '^."type":"FeatureCollection"' bash -c "'$plumbline' rooms '$flat' -o - 2>/dev/null"
expect "a plan and a page beside it" 0 'wrote p\.svg.*wrote p\.html' "$plumbline" rooms "$flat" --picture p.svg --report p.html
rm p.svg p.html

rm plan.svg
leaves "nothing else was written"
finish
