#!/usr/bin/env bash
# tests/programs_cli_test.sh PLUMBLINE FAKE_ENGINE ENGINE...: programs as engines of the tool, as a user sees them. Each
# ENGINE was built with the tool.
set -uo pipefail
plumbline=$1 fake=$2
shift 2
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"

printf '0,0,4,0\n4,0,4,3\n' >tee.lines
printf '0,0,4,4\n0,4,4,0\n' >crossing.lines
mkdir path
ln -s "$fake" path/plumbline-engine-found
printf '#!/bin/sh\necho no library >&2\nexit 3\n' >path/plumbline-engine-absent
printf '#!/bin/sh\necho hello\n' >path/plumbline-engine-odd
chmod +x path/plumbline-engine-*
PATH=$PWD/path:$PATH

# ---- Verdicts
expect "a program is an engine by its path" 0 '^agree' "$plumbline" check tee.lines --engine "$fake"
expect "and by its name in PATH" 0 '^agree' "$plumbline" check tee.lines --engine found
expect "what it leaves uncut is its own" 1 '^disagree: .*where they come from.*found, crossing' "$plumbline" check crossing.lines --engine found
expect "a configuration is chosen" 0 'radius 0.25' "$plumbline" check tee.lines --engine found --set configuration=snapped
expect "so is its tolerance" 0 'radius 0.5' "$plumbline" check tee.lines --engine found --set configuration=snapped --radius 0.5
expect "not where there is none" 2 'configuration uncut of found has no tolerance' "$plumbline" check tee.lines --engine found --radius 0.5
expect "there are no others" 2 'configuration is uncut or snapped.*"magic"' "$plumbline" check tee.lines --engine found --set configuration=magic

# ---- Failures are findings
# shellcheck disable=SC2317
fails() { "$plumbline" check tee.lines --engine found --set "configuration=$1" "${@:2}"; }
printf '0,0,4,0\n0,1,4,1\n' >tee.lines
none='^disagree: no result, found'
expect "an error is told in the engine's words" 1 "$none says Sorry: no.*engine-error" fails throws
expect "a crash is one" 1 "$none crashed: SIGABRT.*engine-crash" fails dies
expect "so is an end" 1 "$none ended with code 7 instead of answering: had enough" fails exits
expect "and what takes too long" 1 "$none gave no answer within 0.4 s.*engine-timeout" fails hangs --set seconds=0.4
expect "or too much" 1 "$none needs more memory than 0.5 GB.*engine-memory" fails "eats memory" --set memory=0.5
expect "advice comes with the finding" 1 'allow it more time' fails hangs --set seconds=0.4 --list 1
expect "it is in the JSON file" 1 '"compared": "nothing"' fails throws -o -
expect "and has pictures and a page" 1 "$none" fails throws --picture f.svg --report f.html
expect "the input has a line" 1 'tee.lines: disagree.*2 drawings: 2 disagree' "$plumbline" check tee.lines crossing.lines --engine found --set configuration=throws

# ---- What is no answer is an error
expect "garbage is quoted" 2 'found does not keep to the protocol of engines.*garbage' fails garbage
expect "an engine may not be here" 2 'the engine found is not here: no such engine' fails "not here"
expect "nor its program" 2 'absent is not here: no library' "$plumbline" check tee.lines --engine absent
expect "a program must list what it is" 2 'plumbline-engine-odd does not keep to the protocol.*hello' "$plumbline" check tee.lines --engine odd
expect "it must be there" 2 'cannot start ./none: No such file' "$plumbline" check tee.lines --engine ./none
expect "an unknown name tells those that are known" 2 'there are lar, inters, plasm, files; programs found are .*absent.*found.*"luck"' "$plumbline" check tee.lines --engine luck

# ---- A tool that is ended leaves no program behind
"$plumbline" check tee.lines --engine found --set configuration=hangs >/dev/null 2>&1 &
tool=$!
faulty=$(realpath "$(dirname "$fake")/../../validation/study/tests")/faulty_adapter
children() { pgrep -cf "$faulty hangs"; } # which fails where there is none
for _ in {1..100}; do (($(children))) || sleep 0.1; done
expect "a program runs" 0 '^[1-9]' children
kill -TERM $tool
wait $tool 2>/dev/null
for _ in {1..50}; do ((!$(children))) || sleep 0.1; done
expect "its tool is gone, and so is it" 1 '^0$' children

# ---- The list
expect "engines are listed" 0 'lar repaired .float LAR.*found 1.5 .The Fake., the program .*snapped: the way snapped; snap 0.25' "$plumbline" engines
expect "those that do not run, too" 0 'absent not here: .*no library' "$plumbline" engines
expect "as JSON" 0 '"not_here": ".*"tolerance_kind": "snap"' "$plumbline" engines --json
for engine in "$@"; do
  expect "$engine was built" 0 "$engine [0-9].*, the program .*/libexec/plumbline/plumbline-engine-$engine" "$plumbline" engines
  expect "$engine answers" 0 '^agree' "$plumbline" check tee.lines --engine "$engine"
done
rm -r path
leaves "nothing else was written" crossing.lines f.html f.svg tee.lines
finish
