#!/usr/bin/env bash
# The Debian package installs on a machine that has nothing but Debian, and runs
# there. ctest calls this; it needs to be root and debootstrap, some minutes and
# 2 GB, and is skipped without them.
#
#   bare_machine.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # cmake, build, root, scratch
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "bare_machine: skipped, for it has to be root and have debootstrap"
  exit 77
fi

directory=$scratch/bare_machine
machine=$directory/machine
rm -rf "$directory"
mkdir -p "$directory"
trap 'rm -rf "$machine"' EXIT

"$(dirname "$cmake")/cpack" --config "$build/CPackConfig.cmake" -B "$directory/package" >/dev/null
debootstrap --variant=minbase bookworm "$machine" >"$directory/debootstrap.log"
cp "$directory"/package/sandglass_*.deb "$machine/root/sandglass.deb"
chroot "$machine" sh -e -c '
  cd /root
  apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends ./sandglass.deb
  timeout 300 sandglass /usr/share/sandglass/prm/quickstart.prm -o run --quiet
  sandglass-report run' >"$directory/install.log" 2>&1 ||
  { tail -20 "$directory/install.log"; exit 1; }
for file in flow_rate.csv summary.json report.html; do
  [ -s "$machine/root/run/$file" ] ||
    { echo "bare_machine: no $file"; exit 1; }
done
