#!/usr/bin/env bash
# Holds what libphs_mujoco.so shows against the list, and its file name against PHS_ABI.
# exported_symbols.sh LIBRARY FOLDER_OF_THE_PLUGIN ABI
set -euo pipefail
has="$(nm -D --defined-only "$1" | awk '{print $3}' | LC_ALL=C sort)"
listed="$(grep -v '^#' "$2/exported_symbols.txt")"
if ! diff <(echo "$listed") <(echo "$has"); then
  echo "exported_symbols: < stands in plugin/exported_symbols.txt, > in the library. A name that" \
       "goes or changes raises PHS_ABI (CMakeLists.txt); then mend the list" >&2
  exit 1
fi
# Every function of the C API's header is there.
for name in $(grep -o 'phs_[a-z_]*(' "$2/phs_mujoco.h" | tr -d '(' | sort -u); do
  grep -qx "$name" <<<"$has" || { echo "exported_symbols: $name is declared but not there" >&2; exit 1; }
done
soname="$(objdump -p "$1" | awk '/SONAME/ {print $2}')"
[ "$soname" = "libphs_mujoco.so.$3" ] || { echo "exported_symbols: SONAME is $soname" >&2; exit 1; }
