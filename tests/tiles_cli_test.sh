#!/usr/bin/env bash
# tests/tiles_cli_test.sh PLUMBLINE DATA: `plumbline arrange --tiles` says of a drawing what `arrange` says, whatever happens
# on the way.
set -uo pipefail
plumbline=$1
data=$2
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
# of KEY COMMAND...: the value of the key in the summary.
of() {
  local key=$1
  shift
  "$plumbline" "$@" --json | sed -nE "s/^ *\"$key\": \"?([^\",]*)\"?,?$/\1/p"
}
# same NAME A B
same() { if [[ -n $2 && $2 == "$3" ]]; then echo "ok: $1"; else failed "$1: $2, not $3"; fi; }

# ---- The same as in one piece
"$plumbline" random 3000 --scaling 0.05 -o random.lines -q
whole=$(of signature2 arrange random.lines)
expect "numbers of cells, tiles and processes are told" 0 '[0-9]+ vertices, .* components.3000 segments in 7 tiles, by 2 processes.signature2 [0-9a-f]{32}' \
  "$plumbline" arrange random.lines --tiles 7 --workers 2
for tiles in 1 2 7 64; do
  for workers in 1 3; do
    same "$tiles tiles, $workers at a time" "$(of signature2 arrange random.lines --tiles $tiles --workers $workers)" "$whole"
  done
done
for key in vertices edges faces components holes; do
  same "$key" "$(of $key arrange random.lines --tiles 5)" "$(of $key arrange random.lines)"
done
shuf --random-source=<(yes) random.lines >shuffled.lines
same "in any order of rows" "$(of signature2 arrange shuffled.lines --tiles 4)" "$whole"
for drawing in "$data"/{building.svg,flat.dxf,rooms.geojson}; do
  same "$(basename "$drawing")" "$(of signature2 arrange "$drawing" --tiles 6)" "$(of signature2 arrange "$drawing")"
done
for ((i = 0; i < 300; i += 2)); do echo "$i,0,$i,300" && echo "0,$i,300,$i" && echo "0,$i,$((300 - i)),300"; done >grid.lines
same "lines through lattice points, of which cuts keep clear" "$(of signature2 arrange grid.lines --tiles 9)" "$(of signature2 arrange grid.lines)"
for ((i = 1; i < 40; ++i)); do echo "5,$i,5,$((i + 2))"; done >upright.lines
same "all on one upright line" "$(of signature2 arrange upright.lines --tiles 9)" "$(of signature2 arrange upright.lines)"
printf '1/3,0,2/3,1\n1/3,1,2/3,0\n0,1/7,1,1/7\n' >fractions.lines
same "fractions" "$(of signature2 arrange fractions.lines --tiles 3)" "$(of signature2 arrange fractions.lines)"

# ---- Stages that end half-way go on
"$plumbline" arrange random.lines --tiles 8 -o kept -q
same "what is done stays done" "$(of signature2 arrange random.lines --tiles 8 -o kept)" "$whole"
"$plumbline" arrange random.lines --tiles 8 -o killed -q &
driver=$!
for _ in $(seq 100); do [[ -e killed/manifest ]] || sleep 0.02; done
kill -9 $driver 2>/dev/null
wait $driver 2>/dev/null
same "the driver killed" "$(of signature2 arrange random.lines --tiles 8 -o killed)" "$whole"
"$plumbline" arrange random.lines --tiles 8 -o torn -q &
driver=$!
for _ in $(seq 100); do [[ -e torn/0.part ]] || sleep 0.02; done
kill -9 $driver 2>/dev/null
wait $driver 2>/dev/null
[[ ! -e torn/0.segments ]] || truncate -s -5 torn/0.part
[[ ! -e torn/0.segments ]] || same "a part that is not whole is made again" "$(of signature2 arrange random.lines --tiles 8 -o torn)" "$whole"
truncate -s -5 kept/3.part
expect "a part that is lost when its segments are gone is no answer" 2 '3\.segments' "$plumbline" arrange random.lines --tiles 8 -o kept
expect "a folder of another drawing is refused" 2 'tiles of another drawing' "$plumbline" arrange grid.lines --tiles 8 -o kept

# gone: no folder for temporary files is left, at once or soon.
# shellcheck disable=SC2317 # expect calls it
gone() { for _ in $(seq 100); do compgen -G 'tmp/*' >/dev/null || return 0; sleep 0.05; done; return 1; }
mkdir tmp
for signal in INT TERM KILL; do
  TMPDIR=$PWD/tmp "$plumbline" arrange random.lines --tiles 64 -q &
  driver=$!
  for _ in $(seq 100); do compgen -G 'tmp/*/manifest' >/dev/null || sleep 0.02; done
  kill -$signal $driver 2>/dev/null
  wait $driver 2>/dev/null
  expect "ended by $signal it leaves nothing behind" 0 '^$' gone
done

# ---- What is refused
expect "what tiles do not make" 2 'not with --tiles.*--both-engines' "$plumbline" arrange random.lines --tiles 2 --both-engines
expect "a number of tiles" 2 'tiles' "$plumbline" arrange random.lines --tiles 0
expect "no drawing" 2 'nothing.lines' "$plumbline" arrange nothing.lines --tiles 2
printf '0,0,1,1\n0,0,x,1\n' >broken.lines
expect "a row that is none, with its line" 2 'broken.lines:2' "$plumbline" arrange broken.lines --tiles 2
expect "goes on where that is wanted" 0 '2 vertices, 1 edges' "$plumbline" arrange broken.lines --tiles 2 --lenient
"$plumbline" arrange broken.lines --tiles 2 -o broken.tiles -q 2>/dev/null
expect "nor is what is lost forgotten in its folder" 2 'not all of the drawing.*1 items' "$plumbline" arrange broken.lines --tiles 2 -o broken.tiles
expect "tiles of a drawing that is read in another way are others" 2 'another way' "$plumbline" arrange broken.lines --tiles 2 -o broken.tiles --shortest-decimals --lenient
: >empty.lines
expect "nothing" 2 'no segments' "$plumbline" arrange empty.lines --tiles 2
finish
