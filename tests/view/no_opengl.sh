#!/usr/bin/env bash
# Who only calculates loads no OpenGL: no_opengl.sh PROGRAM… names each that does.
set -euo pipefail
failed=0
for program in "$@"; do
  [ -s "$program" ] || { echo "$program is missing"; exit 1; }
  # The engine's own library names OpenGL only when a context is made.
  found="$(ldd "$program" | grep -E 'libOSMesa|libglfw|libGLX?[.]|libOpenGL|libEGL|libpng' || true)"
  [ -z "$found" ] || { echo "$(basename "$program") loads:"; echo "$found"; failed=1; }
done
exit "$failed"
