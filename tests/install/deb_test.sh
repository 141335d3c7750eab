#!/usr/bin/env bash
# The Debian packages of a build: made, unpacked into a folder and used there; nothing that lintian
# minds, where it is. deb_test.sh BUILD_DIR
set -euo pipefail
build="$(cd "$1" && pwd)"
here="$(cd "$(dirname "$0")" && pwd)"
packaging="$here/../../packaging"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
fail() { echo "deb: $*" >&2; exit 1; }

# Packages that nobody fetches need not be small: two thirds less time.
DPKG_DEB_COMPRESSOR_LEVEL=1 "$packaging/build_deb" --from "$build" --out "$scratch/deb" 2>"$scratch/log" || { cat "$scratch/log"; fail "build"; }
packages=(phs libphs-dev)
[ ! -d "$build/python/phs" ] || packages+=(python3-phs)
for package in "${packages[@]}"; do
  file="$(echo "$scratch"/deb/${package}_*.deb)"
  [ -s "$file" ] || fail "no package $package"
  dpkg-deb -x "$file" "$scratch/root"
  dpkg-deb -f "$file" Depends >"$scratch/$package.depends"
done
grep -q 'libmujoco2.2.2' "$scratch/phs.depends" || fail "phs does not depend on the engine"
grep -q 'phs (= ' "$scratch/libphs-dev.depends" || fail "libphs-dev does not depend on its phs"
grep -q 'models/profiles/S1002.prw' "$scratch/root/usr/share/doc/phs/copyright" ||
  fail "the copyright file does not name the profiles"
if command -v lintian >/dev/null; then
  # A build that is no distribution's has no multiarch folder.
  lintian --allow-root --suppress-tags pkg-config-unavailable-for-cross-compilation \
    --fail-on error,warning "$scratch"/deb/*.deb || fail "lintian"
fi
"$packaging/try_installed" "$scratch/root/usr" "$here/consumer"
if [ -d "$build/python/phs" ]; then
  dpkg-deb --ctrl-tarfile "$scratch"/deb/python3-phs_*.deb | tar -t | grep -q prerm ||
    fail "python3-phs would leave behind what Python compiled"
  grep -q 'phs (= .*python3 (<< 3' "$scratch/python3-phs.depends" || fail "python3-phs: $(cat "$scratch/python3-phs.depends")"
  cd "$scratch"
  PYTHONPATH="$scratch/root/usr/lib/python3/dist-packages" /usr/bin/python3 -c '
import phs
run = phs.run("curve_r550", bogie="phs", duration_s=0.05)
assert run.status == "ok" and phs.__file__.startswith("'"$scratch"'"), phs.__file__' || fail "the Python package"
fi
