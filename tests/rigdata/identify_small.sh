#!/bin/sh
# Hides one effect at a time in fresh rig data and asks `phs identify` for it.
#   identify_small.sh GENERATOR PHS FOLDER
set -eu
generator=$1 phs=$2 folder=$3
failed=0
for effect in none stribeck accumulator_precharge; do
  set_folder=$folder/$effect
  [ -e "$set_folder/MANIFEST.yaml" ] || "$generator" --effect "$effect" --seed 77 --out "$set_folder"
  found=$("$phs" identify "$set_folder/MANIFEST.yaml" --out "$set_folder/result" --force --quiet |
    sed -n 's/^effect \([a-z_]*\).*/\1/p' | tr '\n' ' ')
  expected="$effect "
  [ "$effect" = none ] && expected=""
  echo "hidden $effect, found ${found:-nothing}"
  [ "$found" = "$expected" ] || failed=1
done
exit $failed
