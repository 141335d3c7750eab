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
  echo "$said" | grep -q "^verdict: $verdict" || { echo "expected: $verdict" && exit 1; }
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
  # The record is rounded as its instruments round; the truth has every digit, and the last of them differ
  # between processors with and without fused multiply-adds (docs/design.md, Determinism).
  python3 - "$folder/truth.json" "$records/${name}_truth.json" <<'END'
import json, math, sys

def same(a, b, place):
    if isinstance(a, dict) and isinstance(b, dict) and a.keys() == b.keys():
        return all([same(a[key], b[key], f"{place}/{key}") for key in a])
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        return all([same(x, y, f"{place}/{i}") for i, (x, y) in enumerate(zip(a, b))])
    number = isinstance(a, float) and isinstance(b, (int, float))
    if a == b or number and math.isclose(a, b, rel_tol=1e-6):
        return True
    print(f"{place}: {a} and {b}")
    return False

made, shipped = (json.load(open(name)) for name in sys.argv[1:])
sys.exit(0 if same(made, shipped, "") else 1)
END
  ;;
esac
