#!/bin/sh
# The records with something hidden that ship (models/rigs/hidden).
#   shipped_record.sh verdict PHS NAME FOLDER VERDICT EFFECT…   what `phs identify NAME` says
#   shipped_record.sh bits GENERATOR RECORDS NAME FOLDER        the recorded command makes it again
set -eu
what=$1
shift
case "$what" in
verdict)
  phs=$1 name=$2 folder=$3 verdict=$4
  shift 4
  said=$("$phs" identify "$name" --out "$folder" --force --quiet)
  echo "$said"
  case "$said" in "verdict: $verdict"*) ;; *) echo "expected: $verdict" && exit 1 ;; esac
  found=$(echo "$said" | sed -n 's/^effect \([a-z_]*\)\( on [A-Z0-9]*\)*.*/\1\2/p' | sort | tr '\n' ',')
  expected=$(printf '%s\n' "$@" | sort | tr '\n' ',')
  [ "$found" = "$expected" ] || { echo "found $found expected $expected" && exit 1; }
  ;;
bits)
  generator=$1 records=$2 name=$3 folder=$4
  command=$(sed -n 's/^ "command": "generate_rig_data \(.*\)",$/\1/p' "$records/${name}_truth.json")
  rm -rf "$folder"
  # The words of the command are options without spaces in them.
  "$generator" $command --out "$folder"
  cmp "$folder/run.csv" "$records/$name.csv"
  cmp "$folder/truth.json" "$records/${name}_truth.json"
  ;;
esac
