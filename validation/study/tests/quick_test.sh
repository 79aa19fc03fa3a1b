#!/usr/bin/env bash
# validation/study/tests/quick_test.sh BUILD ENGINE...: runs the quick study with these engines, which BUILD has made, for
# less than a minute. Fails where one of them has no rows, or rows of failures alone. PYTHON and PLUMBLINE_STUDY are as in
# validation/study/run.
set -euo pipefail
usage() { sed -n '2,/^[^#]/s/^# \?//p' "$0"; }
[[ ${1-} != --help ]] || { usage && exit; }
(($# >= 2)) || { usage >&2 && exit 2; }
build=$(realpath "$1")
shift
study=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chosen=()
for engine in "$@"; do chosen+=(--engine "$engine"); done
BUILD=$build "$study/run" --quick "${chosen[@]}" --minutes 0.4 --results "$scratch/quick.parquet"
PYTHONPATH=$study PYTHONDONTWRITEBYTECODE=1 "$PYTHON" - "$scratch/quick.parquet" "$@" <<'CHECK'
import collections
import pathlib
import sys

from study import results
from study.words import LOUD

outcomes = collections.defaultdict(collections.Counter)
for row in results.load(pathlib.Path(sys.argv[1])).to_pylist():
    outcomes[row["engine"]][row["outcome"]] += 1
for engine in sys.argv[2:]:
    counts = outcomes[engine]
    print(f"{engine}: {dict(sorted(counts.items()))}")
    if not counts:
        sys.exit(f"{engine} has no rows")
    if not set(counts) - set(LOUD):
        sys.exit(f"{engine} does nothing but fail")
CHECK
