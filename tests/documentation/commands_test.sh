#!/usr/bin/env bash
# commands_test.sh LAUNCHER SOURCE: the commands of moat that documents name exist, and have the options that follow.
set -euo pipefail

launcher=$1
source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
moat() { "$launcher" "$source" "$work/no_build" "$work" "$@"; }

known=$(moat --help)
while read -r command; do
  grep -qE "^  $command " <<<"$known" || { echo "FAILED: there is no command $command" && failed=1; }
done < <(grep -ohE '(^| |`)\./moat [a-z]+' "$source"/README.md "$source"/CONTRIBUTING.md "$source"/docs/*.md "$source"/docs/*/*.md |
  sed -E 's/.*moat //' | sort -u)

# Options behind a command that is no script; scripts are another test's.
while read -r command option; do
  moat "$command" --help | grep -qe "$option" || { echo "FAILED: $command has no option $option" && failed=1; }
done < <(grep -ohE '\./moat (test|bench|check|study|new|motion|report)[^`|#]*' "$source"/README.md \
  "$source"/CONTRIBUTING.md "$source"/docs/*.md "$source"/docs/*/*.md |
  awk '{ for (i = 3; i <= NF; ++i) if ($i ~ /^--[a-z]/) { sub(/[^a-z0-9-].*$/, "", $i); print $2, $i } }' | sort -u)
exit "$failed"
