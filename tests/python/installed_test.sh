#!/usr/bin/env bash
# Installs a build into a prefix of its own; the package is imported there and reads the data of that
# prefix. installed_test.sh BUILD_DIR
set -euo pipefail
build="$(cd "$1" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
prefix="$scratch/prefix"
unset PHS_DATA PYTHONPATH
fail() { echo "python.installed: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$prefix" >"$scratch/log" || { cat "$scratch/log"; fail "install"; }
cp "$prefix/share/phs/bogie_xml/phs.xml" "$prefix/share/phs/bogie_xml/only_installed.xml"
folder="$(echo "$prefix"/lib/python3*/dist-packages)"
[ -f "$folder/phs/py.typed" ] || fail "no package in $folder"
cd "$scratch"
PYTHONPATH="$folder" /usr/bin/python3 - "$prefix" <<'CODE' || fail "import"
import pathlib, sys
import phs
prefix = pathlib.Path(sys.argv[1]).resolve()
assert pathlib.Path(phs.__file__).is_relative_to(prefix), phs.__file__
run = phs.run("curve_r550", bogie="only_installed", duration_s=0.05)
assert run.status == "ok" and run.bogie == "only_installed", run
try:
    phs.run("curve_r550", bogie="only_instaled")
except phs.Error as error:
    assert "did you mean 'only_installed'" in str(error), error
else:
    sys.exit("an unknown bogie runs")
CODE

# Under /usr Debian's packages have a folder without the version; only the rules are looked at.
DESTDIR="$scratch/root" cmake --install "$build" --prefix /usr --component python >"$scratch/log" ||
  { cat "$scratch/log"; fail "install under /usr"; }
[ -f "$scratch/root/usr/lib/python3/dist-packages/phs/__init__.py" ] || fail "not in dist-packages"
ls "$scratch/root/usr/lib/python3/dist-packages/phs/"_phs.*.so >/dev/null || fail "no module"
echo "installed and imported"
