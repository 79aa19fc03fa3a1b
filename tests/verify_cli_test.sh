#!/usr/bin/env bash
# tests/verify_cli_test.sh PLUMBLINE-VERIFY PLUMBLINE CERTIFICATES: what the checker prints and returns, as a user sees it. Each file of
# the folder CERTIFICATES is an input and its certificate.
set -uo pipefail
verify=$1
plumbline=$2
certificates=$3
# shellcheck source-path=SCRIPTDIR source=support/expect.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/expect.sh"

for file in "$certificates"/*.txt; do
  name=$(basename "$file" .txt)
  sed '/^plumbline certificate/,$d' "$file" >"$name.lines"
  sed -n '/^plumbline certificate/,$p' "$file" >"$name.certificate"
  expect "the certificate $name is proved" 0 '^Proved: .*signature is that of the content' "$verify" "$name.lines" "$name.certificate"
  "$plumbline" arrange "$name.lines" --certify again.certificate >/dev/null
  # Points inside faces are the writer's choice; rows of points are no part of what `arrange` reads.
  grep -qE '^[^,]*,[^,]*$' "$name.lines" ||
    expect "the tool writes the certificate $name" 0 '^$' diff <(sed 's/inside .*//' "$name.certificate") <(sed 's/inside .*//' again.certificate)
done

expect "help has an example" 0 'plumbline-verify plan.lines plan.certificate' "$verify" --help
expect "no file is a usage error" 2 '^usage: plumbline-verify INPUT CERTIFICATE' "$verify"
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
[[ ! -e /dev/full ]] ||
  expect "a verdict that cannot be written is no success" 2 '' bash -c "'$verify' crossing.lines crossing.certificate >/dev/full"

finish
