#!/usr/bin/env bash
# Count the instructions that a step takes for each particle, and fail if they
# have become more: a time would say little on a machine that does other work.
# ctest calls this.
#
#   counted_work.sh SETTINGS SCENE.prm EXPECTED    SCENE.prm below the repository
#
# Only what the particle stage's step() calls is counted, not the start of the
# program. valgrind passes on what instructions the processor has, up to AVX2;
# without AVX2 the loop runs other code, and there is nothing to compare with.
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, valgrind, root, scratch
scene=$2
expected=$3          # instructions per particle-step, by the compiler of Debian 12
largest_increase=1.1 # times the expected number
smallest_count=0.5   # below it something else was counted than step()
skipped=77

if ! grep -qw avx2 /proc/cpuinfo; then
  echo "this processor has no AVX2"
  exit $skipped
fi

directory=$scratch/counted_work
rm -rf "$directory"
mkdir -p "$directory"

if ! "$valgrind" --tool=callgrind --callgrind-out-file="$directory/callgrind.out" \
  --toggle-collect='*ExplicitParticleStage*::step()' \
  "$sandglass" "$root/$scene" -o "$directory/output" --quiet \
  >"$directory/screen.txt" 2>&1; then
  tail -n 40 "$directory/screen.txt"
  exit 1
fi

instructions=$(awk '$1 == "totals:" { print $2 }' "$directory/callgrind.out")
steps=$(sed -n 's/^ *"particle_steps": \([^,]*\),\{0,1\}$/\1/p' "$directory/output/summary.json")
awk -v instructions="$instructions" -v steps="$steps" -v expected="$expected" \
  -v increase="$largest_increase" -v smallest="$smallest_count" '
  BEGIN {
    count = instructions / steps
    printf "%.1f instructions per particle-step; expected: %s\n", count, expected
    if (!(count <= increase * expected)) { print "more work than before"; exit 1 }
    if (!(count >= smallest * expected)) {
      print "much less: is it step() that was counted? Then store the new number."
      exit 1
    }
  }'
