#!/usr/bin/env bash
# tests/cli_hostile_test.sh PLUMBLINE [SANITIZER]: files, disks and arguments at their worst. The tool says in a line what is wrong,
# returns 2, and leaves nothing behind.
# shellcheck disable=SC2016 # expressions in single quotes are for the shell within
set -uo pipefail
plumbline=$1
sanitizer=${2-}
memory=(--max-memory 500M)
[[ -z $sanitizer ]] || memory=() # it takes terabytes of addresses for itself
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"
triangle='0,0,4,0\n4,0,4,4\n4,4,0,0\n'
triangle() { printf '%b' "$triangle"; }

# ---- Disks
triangle >a.lines
svg '<line x2="1"/>' >a.svg
if [[ -e /dev/full ]]; then
  expect "a full disk under an output" 2 'dev/full: .*No space left' "$plumbline" arrange a.lines -o /dev/full
  expect "a full disk under a picture" 2 'dev/full: .*No space left' "$plumbline" check a.lines --picture /dev/full
  for command in "info a.lines" "arrange a.lines" "check a.lines" "lar a.lines" "eval a.svg" "random 9" "--help" "--version"; do
    # shellcheck disable=SC2086
    expect "a full disk under what $command prints" 2 'cannot write to standard output' bash -c '"$@" >/dev/full' - "$plumbline" $command
  done
fi
"$plumbline" random 2000 -o big.lines >/dev/null
expect "a file beyond the user's limit" 2 'out\.json: cannot write the file .File too large' bash -c 'ulimit -f 100; "$@"' - "$plumbline" arrange big.lines -o out.json
mkdir disk
if mount -t tmpfs -o size=128k tmpfs disk 2>/dev/null; then
  expect "a disk that becomes full" 2 'disk/out\.json: cannot write the file .No space left' "$plumbline" arrange big.lines -o disk/out.json
  expect "keeps no part" 0 '^0$' bash -c 'ls -A disk | wc -l'
  echo old >disk/out.json
  expect "one that becomes full under an old file" 2 'No space left' "$plumbline" arrange big.lines -o disk/out.json
  expect "keeps the old one" 0 '^old$' cat disk/out.json
  mount -o remount,ro disk
  expect "a disk that is read only" 2 'Read-only file system' "$plumbline" arrange a.lines -o disk/new.json
  umount disk
else
  echo "skipped: a small disk can be mounted by root only"
fi
rmdir disk
leaves "full disks leave nothing" a.lines a.svg big.lines

# ---- Files that are no drawing
triangle >a.lines
for ending in svg svgz dxf lines json geojson wkt wkb csv; do
  : >empty.$ending
  expect "an empty .$ending is refused or empty" "$([[ $ending =~ ^(lines|wkt|wkb|csv)$ ]] && echo 0 || echo 2)" '(plumbline: empty|0 vertices)' "$plumbline" arrange empty.$ending
  # Bytes of every value, in an order that repeats after 64 KB.
  awk 'BEGIN { x = 1; for (i = 0; i < 65536; ++i) { x = (75 * x + 74) % 65537; printf "\\x%02x", x % 256 } }' >codes
  printf '%b' "$(cat codes)" >noise.$ending 2>/dev/null
  expect "binary noise as .$ending is refused" 2 '^plumbline: noise' bash -c '"$@" 2>&1 | head -c 2000; exit "${PIPESTATUS[0]}"' - "$plumbline" arrange noise.$ending
  mkdir "dir.$ending"
  expect "a directory as .$ending is refused" 2 'is a directory' "$plumbline" info "dir.$ending"
  expect "a missing .$ending is told by its name" 2 "none\\.$ending: no such file" "$plumbline" info none.$ending
  mkfifo pipe.$ending
  : >pipe.$ending &
  expect "an empty pipe as .$ending is an empty file" 2 '^plumbline: pipe' timeout 120 "$plumbline" check pipe.$ending
  truncate -s 10G sparse.$ending
  expect "10 GB of nothing as .$ending are refused in 500 MB" 2 '^plumbline: (sparse|out of memory)' timeout 600 "$plumbline" info sparse.$ending "${memory[@]}"
  rm -rf ./*."$ending" codes
done
triangle >a.lines
for ending in json geojson wkt wkb csv; do
  : >empty.$ending
  expect "an empty .$ending as a result is refused or differs" "$([[ $ending =~ ^(wkt|wkb|csv)$ ]] && echo 1 || echo 2)" '(plumbline: empty|disagree)' "$plumbline" check a.lines --against empty.$ending
  truncate -s 10G sparse.$ending
  expect "10 GB of nothing as a result in .$ending" 2 '^plumbline: (sparse|out of memory)' timeout 600 "$plumbline" check a.lines --against sparse.$ending "${memory[@]}"
  rm -f ./*."$ending"
done
expect "a device is no drawing" 2 'not a regular file' timeout 120 "$plumbline" info /dev/zero
ln -s loop.lines loop.lines
expect "a link to itself is no drawing" 2 'loop\.lines' "$plumbline" info loop.lines
expect "nor an output" 2 'loop\.json' bash -c 'ln -s loop.json loop.json; "$@"' - "$plumbline" arrange a.lines -o loop.json
long=$(printf 'n%.0s' {1..300})
expect "a name that is too long to read" 2 'nnn' "$plumbline" info "$long.lines"
expect "or to write" 2 'File name too long' "$plumbline" arrange a.lines -o "$long.json"
longest=$(printf 'n%.0s' {1..250}).json
expect "the longest name of all is written" 0 'wrote n' "$plumbline" arrange a.lines -o "$longest"
rm -f "$longest" loop.*
if ((EUID != 0)); then
  chmod 000 a.lines
  expect "a file that must not be read" 2 'cannot be read' "$plumbline" info a.lines
  chmod 600 a.lines
  mkdir closed && chmod 500 closed
  expect "a directory that must not be written to" 2 'Permission denied' "$plumbline" arrange a.lines -o closed/out.json
  rmdir closed
elif [[ -r /proc/self/mem ]]; then
  # Root may read every file, but not this one: it fails at the first byte.
  ln -s /proc/self/mem unread.lines
  expect "a file that fails when it is read" 2 'unread\.lines' "$plumbline" info unread.lines
  rm unread.lines
  echo "skipped: root may read and write where permissions say no"
fi
leaves "they leave nothing" a.lines

# ---- Limits
"$plumbline" random 5000 -o many.lines >/dev/null
if [[ -z $sanitizer ]]; then
  for size in 1K 1M 4M 8M 12M 16M 20M 22M 24M 26M 28M 30M 32M 36M 40M 48M; do
    status=0
    output=$("$plumbline" check many.lines -o out.json --max-memory $size 2>&1) || status=$?
    [[ $status -lt 2 || ($status == 2 && $output == *"out of memory: more than --max-memory $size"*) ]] ||
      failed "--max-memory $size: exit $status: $(tail -c 300 <<<"$output")"
    rm -f out.json
  done
  expect "little memory is too little" 2 '^plumbline: out of memory: more than --max-memory 4M$' "$plumbline" info many.lines --max-memory 4M
  expect "much is enough" 0 '5000 segments' "$plumbline" info many.lines --max-memory 2GiB
fi
expect "segments up to the limit are read" 0 '5000 segments' "$plumbline" info many.lines --max-segments 5000
for command in info arrange check lar; do
  expect "one more is not: $command" 2 'more than 4999 segments' "$plumbline" $command many.lines --max-segments 4999
done
expect "nor cells: eval" 2 'more than 4999 segments or cells' "$plumbline" eval many.lines --max-segments 4999
{
  printf '{"root": "s60", "defs": {"s0": {"lines": [[[0, 0], [1, 1]]]}'
  for i in {1..60}; do printf ', "s%d": {"body": [{"ref": "s%d"}, {"ref": "s%d"}]}' "$i" $((i - 1)) $((i - 1)); done
  printf '}}'
} >bomb.json
for command in info arrange check lar eval; do
  expect "2^60 segments of a small file are refused at once: $command" 2 'more than 1000000 segments' timeout 600 "$plumbline" $command bomb.json --max-segments 1000000 "${memory[@]}"
  expect "and in time without a limit of theirs: $command" 2 'timeout|too large|out of memory' timeout 600 "$plumbline" $command bomb.json --timeout 0.5 "${memory[@]}"
done
rm many.lines bomb.json

# ---- Contents
deep() { # deep OPEN CLOSE: 100,000 of each
  printf "%0.s$1" {1..100000}
  printf "%0.s$2" {1..100000}
}
deep '[' ']' >deep.json
expect "100,000 nested arrays are no drawing" 2 'deep\.json' "$plumbline" info deep.json
deep '{"a":' '}' >deep.geojson
expect "nor are as many objects, left open" 2 'deep\.geojson' "$plumbline" info deep.geojson
{ printf '<svg>' && deep '<g>' '</g>' && printf '</svg>'; } >deep.svg
expect "100,000 nested groups are an empty drawing" 0 '0 segments' "$plumbline" arrange deep.svg
{ deep 'GEOMETRYCOLLECTION(' ')'; } >deep.wkt
expect "100,000 nested collections are refused or empty" 2 'deep\.wkt' "$plumbline" arrange deep.wkt
digits=$(printf '9%.0s' {1..100000})
for _ in {1..10}; do printf '%s' "$digits"; done >million
printf '%s,0,1,1\n0,0,1,1\n' "$(cat million)" >digits.lines
expect "a number of a million digits is rejected, the rest goes on" 0 '1 segments, 1 rejected' "$plumbline" arrange digits.lines --lenient
printf '{"V": [[%s, 0], [1, 1]], "EV": [[0, 1]]}' "$(cat million)" >digits.json
expect "or refused in JSON" 2 'digits\.json' "$plumbline" arrange digits.json
triangle >a.lines
expect "or in a result" 2 'digits\.json' "$plumbline" check a.lines --against digits.json
for number in 1e999999999 -1e999999999 1e-999999999 NaN nan Infinity -inf 0x1p3 1e 1/0; do
  for kind in '{"V": [[%s, 0], [1, 1]], "EV": [[0, 1]]}' '{"type": "LineString", "coordinates": [[%s, 0], [1, 1]]}' \
    '{"root": "a", "defs": {"a": {"lines": [[[%s, 0], [1, 1]]]}}}'; do
    # shellcheck disable=SC2059
    printf "$kind" "$number" >number.json
    status=0
    output=$("$plumbline" arrange number.json 2>&1) || status=$?
    [[ $status == 2 || ($status == 0 && $output == *"1 rejected"*) ]] || failed "$(cat number.json): exit $status: $output"
    status=0
    output=$("$plumbline" check a.lines --against number.json 2>&1) || status=$?
    [[ $status == 2 || ($status == 1 && $output == *rejected*) ]] || failed "against $(cat number.json): exit $status: $output"
  done
done
echo '{"V": [], "EV": [], "FV": []}' >nothing.json
expect "a result of nothing differs" 1 'disagree' "$plumbline" check a.lines --against nothing.json
echo '{"root": "a", "defs": {"a": {"body": []}}}' >nothing.json
expect "a structure of nothing is an empty drawing" 0 '0 segments' "$plumbline" arrange nothing.json
echo '{"root": "", "defs": {"": {"body": [{"ref": ""}]}}}' >nothing.json
expect "a structure within itself, without a name" 2 'cycle of references' "$plumbline" arrange nothing.json
rm ./*

# ---- Outputs
triangle >a.lines
echo old >old.json
expect "an output into a directory that is not there" 2 'none/out\.json: cannot create the file .No such file' "$plumbline" arrange a.lines -o none/out.json
expect "an output below a file" 2 'Not a directory' "$plumbline" arrange a.lines -o a.lines/out.json
mkdir d.json
expect "an output that is a directory" 2 'd\.json: .*Is a directory' "$plumbline" arrange a.lines -o d.json
ln -s a.lines alias.lines
expect "the input by another name is not overwritten" 2 'overwrite' "$plumbline" eval a.lines -o alias.lines
expect "the same output twice is refused" 2 'overwrite' "$plumbline" info a.lines --diagnose --plot p.svg --picture ./p.svg
ln -s old.json link.json
ln -s new.json dangling.json
chmod 640 old.json
expect "a link" 0 'wrote' "$plumbline" arrange a.lines -o link.json
expect "stays a link, to the new file, which has the permissions of the old one" 0 '^symbolic link 640$' bash -c 'echo "$(stat -c %F link.json) $(stat -c %a old.json)"'
expect "a link to nothing" 0 'wrote' bash -c 'umask 027; "$@"' - "$plumbline" arrange a.lines -o dangling.json
expect "makes what it names, as the umask says" 0 '^640$' stat -c %a new.json
mkfifo out.svg
expect "a pipe as output is written to" 0 '</svg>' bash -c '"$1" arrange a.lines -o out.svg >/dev/null & timeout 120 cat out.svg; wait $!' - "$plumbline"
"$plumbline" arrange a.lines -o was.json >/dev/null
expect "two at a time do not meet" 0 '^$' bash -c 'for i in {1..6}; do "$1" arrange a.lines -o was.json >/dev/null & done; wait; cmp was.json old.json' - "$plumbline"
leaves "nothing else is there" a.lines alias.lines d.json dangling.json link.json new.json old.json out.svg was.json

# ---- An input that changes under the tool: it is open, so it is read to its end.
"$plumbline" random 100000 -o gone.lines >/dev/null
"$plumbline" eval gone.lines >was 2>&1 &
pid=$!
sleep 0.05
rm -f gone.lines
status=0
wait $pid || status=$?
[[ $status == 0 || ($status == 2 && $(cat was) =~ gone.lines) ]] || failed "an input that is deleted: exit $status: $(cat was)"
rm was

# ---- What a terminal would obey
name=$'a\033[31m\nb\xff.lines'
triangle >"$name"
printf 'bad' >"$name.svg"
for command in "info" "arrange" "rooms" "check" "lar" "eval"; do
  for file in "$name" "$name.svg" "none$name"; do
    output=$("$plumbline" $command "$file" 2>&1)
    [[ $output != *$'\033'* && $output != *$'a\n'* ]] || failed "$command prints a name as it is: $output"
  done
done
expect "an argument is not obeyed either" 2 'red' "$plumbline" info "$name" $'--red\033[31m'
expect "nor an argument that is no text" 2 '.' "$plumbline" info "$name" --flatten $'\xff\xfe'
! "$plumbline" info "$name" $'--red\033[31m' 2>&1 | grep -q $'\033' || failed "an option is printed as it is"
! "$plumbline" $'r\033[31m' 2>&1 | grep -q $'\033' || failed "a command is printed as it is"
"$plumbline" arrange "$name" -o name.json >/dev/null
expect "a JSON file is UTF-8 whatever the name" 0 '^$' iconv -f UTF-8 -t UTF-8 -o /dev/null name.json
rm -f name.json "$name" "$name.svg"

# ---- Arguments
triangle >a.lines
svg '<circle r="1"/>' >a.svg
# Numbers that no option takes.
for option in "info a.svg --flatten" "info a.svg --angle" "info a.lines --threads" "info a.lines --diagnose --within" \
  "info a.lines --max-segments" "info a.lines --max-memory" "info a.lines --timeout" "check a.lines --radius" \
  "check a.lines --tolerance" "check a.lines --list" "check a.lines --variant published --decimals" \
  "lar a.lines --radius" "lar a.lines --variant published --radius" "lar a.lines --variant published --decimals" \
  "lar a.lines --show explode -o x.svg --factor" "lar a.lines --show boundary -o x.svg --faces" "eval a.lines --decimals" "eval a.lines --embed" \
  "random" "random 3 --scaling" "random 3 --seed"; do
  for value in '' nan -nan NaN inf -inf Infinity abc 1e999999999 -1e999999999  1,5 '1 2' 1x $'\xff' 0x1p9999 --; do
    status=0
    # shellcheck disable=SC2086
    output=$(timeout 600 "$plumbline" $option "$value" 2>&1) || status=$?
    [[ $status == 2 && -n $output && $output != *internal* ]] || failed "$option '$value': exit $status: $output"
  done
  # Numbers that some do: nothing but an answer or an error.
  for value in 0 -0 -1 1 1e-300 1e300 1e9999 99999999999999999999999999999999 -99999999999999999999999999999999 18446744073709551615 18446744073709551616 2147483648 0x10 1/3 1/0 007 +1; do
    status=0
    # shellcheck disable=SC2086
    output=$(timeout 600 "$plumbline" $option "$value" "${memory[@]}" 2>&1 | tail -c 2000; exit "${PIPESTATUS[0]}") || status=$?
    [[ $status -le 2 && $output != *internal* ]] || failed "$option '$value': exit $status: $output"
  done
  # shellcheck disable=SC2086
  expect "without its number: $option" 2 '.' "$plumbline" $option
done
rm -f x.svg
expect "an option twice" 2 'radius' "$plumbline" check a.lines --radius 1 --radius 2
expect "an empty name" 2 '.' "$plumbline" info ''
expect "an empty command" 2 '.' "$plumbline" ''
expect "two drawings" 2 'b\.lines' "$plumbline" info a.lines b.lines
expect "two commands" 2 '.' "$plumbline" info arrange a.lines
expect "an unknown short option" 2 'x' "$plumbline" info a.lines -x
expect "a thousand options" 2 '.' bash -c '"$@" $(printf -- "--x%.0s " {1..1000})' - "$plumbline" info a.lines
expect "an argument of 100 KB" 2 '.' bash -c '"$@" "$(printf "9%.0s" {1..100000})" 2>&1 | tail -c 500; exit "${PIPESTATUS[0]}"' - "$plumbline" check a.lines --radius
expect "a config file is not read" 2 '.' "$plumbline" --config a.lines info a.lines
leaves "arguments leave nothing" a.lines a.svg

finish
