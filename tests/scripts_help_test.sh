#!/usr/bin/env bash
# tests/scripts_help_test.sh: every script of scripts/ prints its help for --help and -h, refuses an option that it does not
# know with the same text (scripts/test gives those to ctest), and does nothing else.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{project,home,programs}
cp -r scripts "$work/project"
touch "$work/out" "$work/err"
# Whatever builds, installs or formats leaves its name.
for program in cmake ctest ninja apt-get apt-cache dpkg-query sudo npm clang-format clang-tidy gcovr; do
  printf '#!/bin/sh\ntouch %q\nexit 1\n' "$work/called-$program" >"$work/programs/$program"
  chmod +x "$work/programs/$program"
done
cd "$work/home" || exit 2
failures=0

# expect NAME OPTION EXIT-CODE HELP OTHER: the help is in the one file, nothing in the other, and nothing was done.
expect() {
  local status=0 before after
  rm -f "$work"/called-*
  before=$(find "$work" | sort)
  HOME=$PWD PATH=$work/programs:$PATH "$work/project/scripts/$1" "$2" >"$work/out" 2>"$work/err" || status=$?
  after=$(find "$work" | sort)
  if [[ $status == "$3" && $(<"$work/$4") =~ ^scripts/$1[:\ ] && ! -s $work/$5 && $after == "$before" ]]; then
    echo "ok: scripts/$1 $2"
  else
    echo "FAILED: scripts/$1 $2: exit $status, expected $3; output, and what was left:"
    cat "$work/out" "$work/err"
    comm -13 <(echo "$before") <(echo "$after")
    failures=$((failures + 1))
  fi
}

for script in "$work"/project/scripts/*; do
  name=$(basename "$script")
  expect "$name" --help 0 out err
  expect "$name" -h 0 out err
  [[ $name == test ]] || expect "$name" --no-such-option 2 err out
done

exit "$((failures > 0))"
