#!/usr/bin/env bash
# tests/cxx17_test.sh COMPILER INCLUDE-OPTION...: every public header, compiled as C++17, is refused in one error that
# says what it needs, whatever else is wrong with the file that includes it.
set -uo pipefail
compiler=$1
shift
cd "$(dirname "${BASH_SOURCE[0]}")/../include" || exit 2
failures=0
for header in plumbline/*.hpp plumbline/*/*.hpp; do
  [[ $header != plumbline/cgal.hpp ]] || continue # CGAL takes seconds, and then comes complex.hpp
  said=$(printf '#include "%s"\nint main() { return plumbline::nothing; }\n' "$header" |
    LC_ALL=C "$compiler" -std=c++17 -I. "$@" -fsyntax-only -x c++ - 2>&1)
  if [[ $(grep -c 'error: ' <<<"$said") != 1 || $said != *'error: '*'plumbline needs C++20'* ]]; then
    echo "FAILED: $header as C++17 says:"
    head -n 5 <<<"$said"
    failures=$((failures + 1))
  fi
done
exit "$((failures > 0))"
