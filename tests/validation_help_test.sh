#!/usr/bin/env bash
# validation_help_test.sh SCRIPT...: --help prints the head of each script and does nothing else: sed is all that it needs.
set -euo pipefail
only_sed=$(mktemp -d)
trap 'rm -rf "$only_sed"' EXIT
ln -s "$(command -v sed)" "$only_sed"
bash=$(command -v bash)
failed=0
for script; do
  if ! help=$(PATH=$only_sed "$bash" "$script" --help 2>&1) || [[ $script != *"${help%%[ :]*}" ]]; then
    printf '%s --help: %s\n' "$script" "$help"
    failed=1
  fi
done
exit $failed
