#!/usr/bin/env bash
# tests/verify_cli_test.sh PLUMBLINE-VERIFY PLUMBLINE CERTIFICATES [SANITIZER]: what the checker prints and returns, as a user sees it.
# Each file of the folder CERTIFICATES is an input and its certificate.
set -uo pipefail
verify=$1
plumbline=$2
certificates=$3
sanitizer=${4-}
manual=$(tr -d '\134' <"$(dirname "${BASH_SOURCE[0]}")/../src/checker/plumbline-verify.1")
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"

for file in "$certificates"/*.txt; do
  name=$(basename "$file" .txt)
  sed '/^plumbline certificate/,$d' "$file" >"$name.lines"
  sed -n '/^plumbline certificate/,$p' "$file" >"$name.certificate"
  expect "the certificate $name is proved" 0 '^Proved: .*signature is that of the content' "$verify" "$name.lines" "$name.certificate"
  "$plumbline" arrange "$name.lines" --certify again.certificate >/dev/null
  # Rows of points are no part of what `arrange` reads.
  grep -qE '^[^,]*,[^,]*$' "$name.lines" ||
    expect "the tool writes the certificate $name" 0 '^$' diff "$name.certificate" again.certificate
done

expect "help has an example" 0 'plumbline-verify plan.lines plan.certificate' "$verify" --help
for option in $("$verify" --help | grep -oE -- '^  --[a-z-]+'); do
  expect "the manual page has $option" 0 '' grep -qF -- "$option" <<<"$manual"
done
expect "no file is a usage error" 2 '^usage: plumbline-verify .*INPUT CERTIFICATE' "$verify"
expect "one file is a usage error" 2 '^usage: ' "$verify" crossing.lines
expect "three files are a usage error" 2 '^usage: ' "$verify" crossing.lines crossing.certificate more
expect "an unknown option is a usage error" 2 '^usage: ' "$verify" --fast crossing.lines
expect "a certificate of something else is refused with its line" 1 '^nested.certificate: refused: line 17: there is no segment 3' \
  "$verify" crossing.lines nested.certificate
expect "a missing file is told by name" 2 'none.lines: No such file' "$verify" none.lines crossing.certificate
expect "a missing certificate is told by name" 2 'none.certificate: No such file' "$verify" crossing.lines none.certificate
expect "a directory is told by name" 2 '\.: Is a directory' "$verify" crossing.lines .
expect "pipes are read" 0 '^Proved' "$verify" <(cat crossing.lines) <(cat crossing.certificate)
echo '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L1 1"/></svg>' >plan.svg
expect "a drawing must be made lines first, and how" 2 'line 1: .*plumbline eval plan.svg -o plan.lines' "$verify" plan.svg crossing.certificate
echo '1,2,3' >bad.lines
expect "a bad row is told with its line" 2 '^bad.lines: the input cannot be read: line 1: a row of 3 numbers' "$verify" bad.lines crossing.certificate
truncate -s 10G huge.lines
expect "a huge file of nothing is no text" 2 'huge.lines: is not a text' "$verify" huge.lines crossing.certificate
expect "so is a huge certificate" 2 'huge.lines: is not a text' "$verify" crossing.lines huge.lines
head -c 100000 /dev/urandom >noise.certificate
expect "noise is no text" 2 'noise.certificate: is not a text' "$verify" crossing.lines noise.certificate
: >empty
expect "an empty certificate is refused" 1 'empty: refused: line 1: it ends before its end' "$verify" crossing.lines empty
mkfifo nobody-writes
expect "a limit of time ends it" 2 '^plumbline-verify: timeout: more than --timeout 0.2$' \
  timeout 60 "$verify" --timeout 0.2 crossing.lines nobody-writes
for limit in "--timeout" "--timeout 0" "--timeout -1" "--timeout 1s" "--timeout nan" "--max-memory" "--max-memory 0" "--max-memory -1" \
  "--max-memory 5X" "--max-memory 99999999999999999999" "--max-memory 18446744073709551615G"; do
  # shellcheck disable=SC2086
  expect "$limit is no limit" 2 '^plumbline-verify: not a (size|positive number)' "$verify" crossing.lines crossing.certificate $limit
done
if [[ -z $sanitizer ]]; then # it takes terabytes of addresses for itself
  expect "limits that are not reached change nothing" 0 '^Proved' "$verify" --timeout 3600 --max-memory 100G crossing.lines crossing.certificate
  yes 0,0,1,1 | head -n 500000 >many.lines
  expect "a limit of memory ends it" 2 '^plumbline-verify: out of memory: more than --max-memory 16M$' \
    "$verify" --max-memory 16M many.lines crossing.certificate
fi
sed 's|^1/3 1/3|1/'"$(printf '3%.0s' {1..100000})"' 1/3|' crossing.certificate >long.certificate
expect "a number that no crossing of the input has is not read" 1 'line 6: a coordinate is longer than any' "$verify" crossing.lines long.certificate
[[ ! -e /dev/full ]] ||
  expect "a verdict that cannot be written is no success" 2 '' bash -c "'$verify' crossing.lines crossing.certificate >/dev/full"

finish
