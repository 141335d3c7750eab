#!/usr/bin/env bash
# Installs a build into a prefix of its own, builds a project that finds it there, and runs the
# installed program and plugin from another directory, on data that only the prefix holds.
# install_test.sh BUILD_DIR
set -euo pipefail
build="$(cd "$1" && pwd)"
here="$(cd "$(dirname "$0")" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
prefix="$scratch/prefix"
unset PHS_DATA LD_PRELOAD

fail() { echo "install: $*" >&2; exit 1; }
step() { echo "== $*"; }

step "install"
cmake --install "$build" --prefix "$prefix" >"$scratch/log" || { cat "$scratch/log"; fail "install"; }
# A bogie that exists nowhere else: whoever finds it reads the installed data.
cp "$prefix/share/phs/bogie_xml/phs.xml" "$prefix/share/phs/bogie_xml/only_installed.xml"

step "consumer"
cmake -S "$here/consumer" -B "$scratch/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "find_package(phs)"; }
cmake --build "$scratch/consumer" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "consumer"; }
cd "$scratch"
PHS_DATA="$prefix/share/phs" consumer/use_physics | tee physics.txt
grep -q "data $prefix/share/phs/models/phs/bo_bo.yaml" physics.txt || fail "data of another place"
consumer/use_plugin "$prefix/share/phs/bogie_xml/only_installed.xml" 200 | tee plugin.txt
grep -q "^phs [0-9.]*: outputs [1-9]" plugin.txt || fail "the plugin gives no outputs"
version="$("$prefix/bin/phs" --version)"
grep -q "^$version: " plugin.txt || fail "the library is not of the program's version $version"

step "program"
"$prefix/bin/phs" --version
"$prefix/bin/phs" modes --bogie only_installed --out "$scratch/modes" --quiet
[ -s "$scratch/modes/modes.json" ] || fail "no modes.json"
code=0
"$prefix/bin/phs" modes --bogie only_instaled 2>error.txt || code=$?
[ "$code" -eq 3 ] || fail "an unknown bogie ends with $code instead of 3"
grep -q "did you mean 'only_installed'" error.txt || fail "message: $(cat error.txt)"

step "preloaded plugin"
if command -v mujoco-testspeed >/dev/null; then
  LD_PRELOAD="$(ls "$prefix"/lib*/libphs_mujoco.so "$prefix"/lib/*/libphs_mujoco.so 2>/dev/null |
    head -n 1)" mujoco-testspeed "$prefix/share/phs/bogie_xml/only_installed.xml" 200 >speed.txt ||
    { cat speed.txt; fail "mujoco-testspeed with the plugin"; }
fi
echo "== done"
