#!/usr/bin/env bash
# What is installed runs from where it is, and the Debian package holds the same
# and names the libraries that it needs. ctest calls this.
#
#   installation.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # cmake, build, scratch
directory=$scratch/installation
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "installation: $*"
  exit 1
}

# try_programs PREFIX
try_programs()
{
  "$1/bin/sandglass" --version >/dev/null || fail "$1: sandglass doesn't start"
  "$1/bin/sandglass" "$1/share/sandglass/prm/quickstart.prm" \
    -s "Particle stage/End time=0.02" -o "$directory/run" --quiet ||
    fail "$1: the scene doesn't run"
  "$1/bin/sandglass-report" "$directory/run" >/dev/null || fail "$1: no report"
  for file in share/doc/sandglass/README.md share/doc/sandglass/doc/user-guide.md \
              share/sandglass/prm/paper/plane-section-5.3.prm; do
    [ -s "$1/$file" ] || fail "$1: no $file"
  done
}

"$cmake" --install "$build" --prefix "$directory/prefix" >/dev/null
try_programs "$directory/prefix"

"$(dirname "$cmake")/cpack" --config "$build/CPackConfig.cmake" -B "$directory/package" >/dev/null
package=$(ls package/sandglass_*.deb)
depends=$(dpkg-deb -f "$package" Depends)
for library in libdeal.ii libvtk9 libgmsh libtrilinos; do
  case $depends in
  *$library*) ;;
  *) fail "the package doesn't depend on $library: $depends" ;;
  esac
done
dpkg-deb -x "$package" unpacked
try_programs "$directory/unpacked/usr"
