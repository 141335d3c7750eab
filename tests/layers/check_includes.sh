#!/usr/bin/env bash
# Which folder may include which (docs/design.md), who sees the engine and who sees urdfdom.
# check_includes.sh ROOT: prints every include that is not allowed; exit code 1 if there is one.
set -euo pipefail
cd "${1:-.}"

declare -A allowed=(
  [src/base]="base"
  [src/hydraulics]="base hydraulics"
  [src/effects]="base hydraulics effects"
  [src/phs_model]="base hydraulics effects phs_model"
  [src/rigs]="base hydraulics effects phs_model rigs"
  [src/rail]="base rail"
  [plugin]="base hydraulics effects phs_model rail plugin"
  [src/vehicle]="base hydraulics effects phs_model rail plugin vehicle"
  [src/analysis]="base hydraulics effects phs_model rail plugin vehicle analysis"
  [src/measurement]="base hydraulics effects phs_model rigs measurement"
  [src/identify]="base hydraulics effects phs_model rigs rail plugin vehicle measurement identify"
  [src/validate]="base hydraulics effects phs_model rigs rail plugin vehicle analysis measurement identify validate"
  [src/sweep]="base hydraulics effects phs_model rigs rail plugin vehicle analysis measurement report sweep"
  [src/report]="base report"
  [src/view]="base hydraulics effects phs_model rail plugin vehicle view"
  [src/film]="base hydraulics effects phs_model rail plugin vehicle view report film"
  [src/screen]="base hydraulics effects phs_model rail plugin vehicle view screen"
  [src/jobs]="base hydraulics effects phs_model rigs rail plugin vehicle analysis measurement identify sweep report film jobs"
  [python]="base rail plugin vehicle identify sweep jobs python"
  [src/cli]="base hydraulics effects phs_model rigs rail plugin vehicle analysis measurement identify validate sweep report jobs view film cli"
)
own="base|hydraulics|effects|phs_model|rigs|rail|plugin|vehicle|analysis|measurement|identify|validate|sweep|report|jobs|python|view|film|screen|cli"
failed=0

complain() { echo "$1"; failed=1; }

# Every folder of sources is in the list above.
for folder in src/*/; do
  folder="${folder%/}"
  [ -n "${allowed[$folder]:-}" ] || complain "$folder: no rule says what it may include"
done

for folder in "${!allowed[@]}"; do
  [ -d "$folder" ] || continue
  while IFS=: read -r file line text; do
    target="${text#*\"}"
    target="${target%%/*}"
    [[ " ${allowed[$folder]} " == *" $target "* ]] ||
      complain "$file:$line: $folder may not include $target/ (allowed: ${allowed[$folder]})"
  done < <(grep -rnE "#include \"($own)/" --include='*.cc' --include='*.h' "$folder" || true)
done

# The rooms of a folder that has some, and whom of them each may include.
declare -A rooms=(
  [src/identify/fit]="fit"
  [src/identify/discrepancy]="fit discrepancy"
  [src/identify/models]="fit discrepancy models"
  [src/identify/select]="fit discrepancy select"
  [src/identify/result]="fit discrepancy models select result"
  [src/identify/next_test]="fit discrepancy models select result next_test"
  [src/identify/run]="fit discrepancy models select result next_test run"
)
for room in src/*/*/; do
  room="${room%/}"
  [ -d "$room" ] || continue
  [ -n "$(find "$room" -maxdepth 1 \( -name '*.cc' -o -name '*.h' \) -print -quit)" ] || continue
  [ -n "${rooms[$room]:-}" ] || complain "$room: no rule says what it may include"
done
for room in "${!rooms[@]}"; do
  [ -d "$room" ] || continue
  folder="${room#src/}"
  folder="${folder%/*}"
  while IFS=: read -r file line text; do
    target="${text#*\"$folder/}"
    target="${target%%/*}"
    [[ " ${rooms[$room]} " == *" $target "* ]] ||
      complain "$file:$line: $room may not include $folder/$target/ (allowed: ${rooms[$room]})"
  done < <(grep -rnE "#include \"$folder/" --include='*.cc' --include='*.h' "$room" || true)
done

# Within the sources a file is named by its folder, never by a path that climbs.
while IFS=: read -r file line _; do
  complain "$file:$line: an include climbs with '..'"
done < <(grep -rnE '#include "\.\./' --include='*.cc' --include='*.h' src plugin || true)

while IFS=: read -r file line _; do
  [[ "$file" == plugin/* || "$file" == src/vehicle/* || "$file" == src/view/* ||
     "$file" == src/screen/* ]] ||
    complain "$file:$line: only plugin/, src/vehicle/, src/view/ and src/screen/ see the engine"
done < <(grep -rnE '#include <mujoco/' --include='*.cc' --include='*.h' src plugin || true)

# Pictures stay apart from what calculates: one verb starts them, and OpenGL is the program's alone.
while IFS=: read -r file line _; do
  [[ "$file" == src/view/* || "$file" == src/film/* || "$file" == src/screen/* ||
     "$file" == src/cli/verb_view.cc ]] ||
    complain "$file:$line: only src/film/, src/screen/ and verb_view.cc know of pictures"
done < <(grep -rnE '#include "(view|screen)/' --include='*.cc' --include='*.h' src plugin || true)
while IFS=: read -r file line _; do
  [[ "$file" == src/screen/* ]] || complain "$file:$line: only src/screen/ sees OpenGL and libpng"
done < <(grep -rnE '#include <(GL|GLFW|EGL)/|#include <png\.h>' --include='*.cc' --include='*.h' src plugin || true)

urdf_files="$(grep -rlE '#include <urdf' --include='*.cc' --include='*.h' src plugin || true)"
if [ "$(grep -c . <<<"$urdf_files")" -gt 1 ]; then
  complain "more than one file sees urdfdom: $(tr '\n' ' ' <<<"$urdf_files")"
fi
exit "$failed"
