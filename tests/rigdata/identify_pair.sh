#!/bin/sh
# Two effects in fresh rig data, where the form of the stronger one could stand for the other: both are named.
#   identify_pair.sh GENERATOR PHS FOLDER SEED EFFECT EFFECT
set -eu
generator=$1 phs=$2 folder=$3 seed=$4 one=$5 other=$6
[ -e "$folder/MANIFEST.yaml" ] ||
  "$generator" --effect "$one+$other" --grade strong+strong --seed "$seed" --out "$folder"
found=$("$phs" identify "$folder/MANIFEST.yaml" --out "$folder/result" --force --quiet |
  sed -n 's/^effect \([a-z_]*\).*/\1/p' | sort | tr '\n' ' ')
expected=$(printf '%s\n' "$one" "$other" | sort | tr '\n' ' ')
echo "hidden $expected, found ${found:-nothing}"
[ "$found" = "$expected" ]
