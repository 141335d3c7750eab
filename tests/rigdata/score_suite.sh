#!/bin/sh
# Writes a suite of rig data unless it is there, and scores `phs identify` on it.
#   score_suite.sh GENERATOR SCORER PHS SUITE FOLDER [options of the scorer…]
set -eu
generator=$1 scorer=$2 phs=$3 suite=$4 folder=$5
shift 5
last=$(printf '%s/%s/complete' "$folder" "$suite")
if [ ! -e "$last" ]; then
  "$generator" --suite "$suite" --out "$folder/$suite" --jobs "$(nproc)"
  : > "$last"
fi
exec "$scorer" "$folder/$suite" --phs "$phs" --out "$folder/$suite-results" \
  --title "Suite $suite" "$@"
