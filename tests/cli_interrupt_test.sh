#!/usr/bin/env bash
# tests/cli_interrupt_test.sh PLUMBLINE SLOW-DISK: the tool is ended, by signals and limits, at many moments; it
# leaves a whole output or none, and nothing else. SLOW-DISK: tests/support/slow_disk.cpp, to preload.
set -uo pipefail
plumbline=$1
slow_disk=$2
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"

# starts COMMAND...: in the background, as a terminal would start it; its number is in $pid.
starts() {
  env --default-signal=INT,QUIT,TERM,HUP "$@" >printed 2>&1 &
  pid=$!
}
# ends NAME STATUS...: the command ends with one of these.
ends() {
  local name=$1 status=0
  shift
  wait "$pid" 2>/dev/null || status=$?
  rm -f printed
  [[ " $* " == *" $status "* ]] || failed "$name: exit $status, expected one of: $*"
}

# waits NAME COMMAND...: until the command succeeds, however busy the machine is.
waits() {
  local name=$1
  shift
  for _ in {1..30000}; do
    ! "$@" || return 0
    sleep 0.01
  done
  failed "$name: waited for in vain"
}

"$plumbline" random 3000 --scaling 0.3 --seed 1 -o in.lines >printed || failed "a drawing is made"
"$plumbline" arrange in.lines -o whole.json >printed
size=$(stat -c %s whole.json)

# At many moments of reading, arranging, validating and writing.
began=$(date +%s%N)
"$plumbline" arrange in.lines -o out.json >printed
milliseconds=$((($(date +%s%N) - began) / 1000000))
rm -f out.json printed
for i in {1..24}; do
  starts "$plumbline" arrange in.lines -o out.json
  sleep "$(printf '0.%06d' $((1000 * milliseconds * i / 22 % 1000000)))"
  kill -INT "$pid" 2>/dev/null
  ends "interrupted after $i / 22 of the time" 130 0
  [[ ! -e out.json || $(stat -c %s out.json) == "$size" ]] || failed "a part of a file after $i / 22"
  rm -f out.json
done
echo "ok: interrupted at 24 moments"
leaves "they leave nothing but the inputs" in.lines whole.json

# While the temporary file is there.
slowly=(env LD_PRELOAD="$slow_disk" ASAN_OPTIONS=verify_asan_link_order=0 "$plumbline")
printf '0,0,4,0\n4,0,4,4\n4,4,0,0\n' >a.lines
for case in INT=130 TERM=143 HUP=129 QUIT=131; do
  signal=${case%=*}
  touch hold
  starts "${slowly[@]}" arrange a.lines -o out.json
  waits "SIG$signal: a temporary file" compgen -G '.plumbline-*' >/dev/null
  kill "-$signal" "$pid"
  ends "SIG$signal while a file is written" "${case#*=}"
  rm hold
  [[ $(ls -A) == a.lines ]] || failed "SIG$signal: left: $(ls -A)"
done
echo "ok: four signals while a file is written"
echo old >out.json
touch hold
expect "a timeout while a file is written" 2 'timeout: more than --timeout 0.5 seconds' \
  "${slowly[@]}" arrange a.lines --timeout 0.5 -o out.json
rm hold
expect "keeps the old file" 0 '^old$' cat out.json
leaves "and leaves nothing new" a.lines out.json

# While it waits for another process.
mkfifo pipe.lines
svg '<line x2="1"/>' >a.svg
mkfifo out.svg
starts "$plumbline" arrange a.svg -o out.svg
sleep 0.3
kill -TERM "$pid"
ends "SIGTERM while nobody reads the pipe" 143
expect "a timeout while nobody reads the pipe" 2 'timeout' "$plumbline" arrange a.svg -o out.svg --timeout 0.3
starts bash -c "'$plumbline' random 100000 | sleep 600"
waits "the tool waits for the pipe" pgrep -P "$pid" -x plumbline >found
kill -INT "$(cat found)"
tail --pid="$(cat found)" -f /dev/null # until an interrupt has ended it
pkill -P "$pid"
wait "$pid" 2>/dev/null
rm -f printed found
leaves "pipes are left as they are" a.svg out.svg pipe.lines

# A signal that is ignored stays so; ended by a signal means ended by it.
printf '0,0,4,0\n4,0,4,4\n4,4,0,0\n' >a.lines
touch hold
env --ignore-signal=HUP "${slowly[@]}" arrange a.lines -o out.json >printed &
pid=$!
waits "nohup: a temporary file" compgen -G '.plumbline-*' >/dev/null
kill -HUP "$pid"
rm hold
ends "nohup goes on" 0
[[ -s out.json ]] || failed "nohup: no output"
expect "a reader that goes away ends it quietly" 0 '^1$' bash -c "'$plumbline' random 100000 | head -1 | wc -l"
leaves "nothing else is left" a.lines out.json

finish
