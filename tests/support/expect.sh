# shellcheck shell=bash
# Sourced by tests of the tool: cases in an empty directory of their own, one line each.

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
failures=0

# failed MESSAGE...
failed() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
# expect NAME EXIT-CODE PATTERN COMMAND...: the command's output (both streams) matches the pattern.
expect() {
  local name=$1 code=$2 pattern=$3 output status=0
  shift 3
  output=$("$@" 2>&1) || status=$?
  if [[ $status == "$code" && $output =~ $pattern ]]; then
    echo "ok: $name"
  else
    failed "$name: exit $status, expected $code; output, expected /$pattern/:"
    echo "$output" | head -20
  fi
}
# leaves NAME FILE...: exactly these files are in the directory, which is then emptied.
leaves() {
  local name=$1
  shift
  if [[ $(ls -A) == "$(printf '%s\n' "$@")" ]]; then
    echo "ok: $name"
  else
    failed "$name: found: $(ls -A)"
  fi
  rm -rf ./* ./.[!.]*
}
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg">\n%s\n</svg>\n' "$1"; }
# The last line of a test, which fails if a case did.
finish() {
  echo "$failures failed"
  exit $((failures > 0))
}
