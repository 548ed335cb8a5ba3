#!/usr/bin/env bash
# Run a scene to its end: no material may be lost on the way, and the masses
# must add up. ctest calls this.
#
#   scene_to_end.sh SETTINGS SCENE.prm      SCENE.prm below the repository
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, root, scratch
scene=$2
largest_balance_error=1e-12 # of the initial mass: rounding of a sum

directory=$scratch/scenes/$(basename "$scene" .prm)
rm -rf "$directory"
mkdir -p "$directory"

# The fields of the long runs take gigabytes and are of no use here.
if ! "$sandglass" "$root/$scene" -o "$directory/output" --quiet \
  -s "Output/Particles=false" -s "Output/Grid=false" >"$directory/screen.txt" 2>&1; then
  tail -n 40 "$directory/screen.txt"
  echo "$scene breaks down; its output is in $directory"
  exit 1
fi

# A number of summary.json.
value() { sed -n "s/^ *\"$1\": \([^,]*\),\{0,1\}$/\1/p" "$directory/output/summary.json"; }

lost=$(value mass_lost_kg)
error=$(value mass_balance_error)
awk -v lost="$lost" -v error="$error" -v largest="$largest_balance_error" '
  BEGIN {
    if (lost == "" || error == "") { print "summary.json lacks the masses"; exit 1 }
    if (lost + 0 != 0) { print "lost mass: " lost " kg"; exit 1 }
    if (!(error + 0 < largest)) { print "the masses do not add up: " error; exit 1 }
  }' || { echo "$scene: see $directory/output"; exit 1; }
