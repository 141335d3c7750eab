#!/usr/bin/env bash
# The check of includes finds what it must: one wrong include of each kind in a made-up tree.
set -euo pipefail
check="$(cd "$(dirname "$0")" && pwd)/check_includes.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/src/base" "$tree/src/rail" "$tree/src/vehicle" "$tree/plugin" "$tree/src/report"

expect() {  # expect OK|FAULT TEXT
  local found
  if found="$(bash "$check" "$tree")"; then
    [ "$1" = OK ] || { echo "not found: $2"; exit 1; }
  else
    [ "$1" = FAULT ] && grep -qF "$2" <<<"$found" || { echo "expected '$2', got: $found"; exit 1; }
  fi
}

echo '#include "base/result.h"' >"$tree/src/rail/a.cc"
echo '#include <mujoco/mujoco.h>' >"$tree/src/vehicle/a.h"
echo '#include <urdf_parser/urdf_parser.h>' >"$tree/src/vehicle/b.cc"
expect OK ""
echo '#include "rail/a.h"' >"$tree/src/base/wrong.h"
expect FAULT "src/base/wrong.h:1: src/base may not include rail/"
rm "$tree/src/base/wrong.h"
echo '#include <mujoco/mujoco.h>' >"$tree/src/rail/wrong.cc"
expect FAULT "src/rail/wrong.cc:1: only plugin/, src/vehicle/, src/view/ and src/screen/ see the engine"
rm "$tree/src/rail/wrong.cc"
mkdir "$tree/src/view" "$tree/src/screen" "$tree/src/cli"
echo '#include <GL/osmesa.h>' >"$tree/src/screen/a.cc"
echo '#include "view/stage.h"' >"$tree/src/cli/verb_view.cc"
expect OK ""
echo '#include <GL/osmesa.h>' >"$tree/src/view/wrong.cc"
expect FAULT "src/view/wrong.cc:1: only src/screen/ sees OpenGL"
rm "$tree/src/view/wrong.cc"
echo '#include "view/stage.h"' >"$tree/src/cli/verb_curve.cc"
expect FAULT "src/cli/verb_curve.cc:1: only src/film/, src/screen/ and verb_view.cc know of pictures"
rm "$tree/src/cli/verb_curve.cc"
echo '#include "../vehicle/a.h"' >"$tree/src/report/wrong.cc"
expect FAULT "src/report/wrong.cc:1: an include climbs"
rm "$tree/src/report/wrong.cc"
echo '#include <urdf_model/model.h>' >"$tree/src/vehicle/c.cc"
expect FAULT "more than one file sees urdfdom"
rm "$tree/src/vehicle/c.cc"
mkdir "$tree/src/misc"
expect FAULT "src/misc: no rule says what it may include"
rmdir "$tree/src/misc"

# Rooms of a folder.
mkdir -p "$tree/src/identify/fit" "$tree/src/identify/select"
echo '#include "identify/fit/likelihood.h"' >"$tree/src/identify/select/a.h"
expect OK ""
echo '#include "identify/select/a.h"' >"$tree/src/identify/fit/wrong.cc"
expect FAULT "src/identify/fit/wrong.cc:1: src/identify/fit may not include identify/select/"
rm "$tree/src/identify/fit/wrong.cc"
mkdir "$tree/src/identify/misc"
echo '#include "base/result.h"' >"$tree/src/identify/misc/a.h"
expect FAULT "src/identify/misc: no rule says what it may include"
rm -r "$tree/src/identify/misc"

# Two parts of a folder that include each other.
chains="$(dirname "$check")/check_chains.py"
"$chains" "$tree" || { echo "check_chains: a circle that is none"; exit 1; }
echo '#include "rail/two.h"' >"$tree/src/rail/one.h"
echo '#include "rail/one.h"' >"$tree/src/rail/two.cc"
if found="$("$chains" "$tree")"; then echo "check_chains: circle not found"; exit 1; fi
grep -qF "rail/one, rail/two" <<<"$found" || { echo "check_chains: got $found"; exit 1; }
rm "$tree/src/rail/one.h" "$tree/src/rail/two.cc"
echo '#include "identify/select/a.h"' >"$tree/src/identify/fit/one.h"
echo '#include "identify/fit/one.h"' >"$tree/src/identify/select/a.h"
if found="$("$chains" "$tree")"; then echo "check_chains: circle of two rooms not found"; exit 1; fi
grep -qF "identify/fit/one, identify/select/a" <<<"$found" || { echo "check_chains: got $found"; exit 1; }
