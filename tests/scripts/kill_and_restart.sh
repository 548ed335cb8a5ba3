#!/usr/bin/env bash
# End a run at random moments, go on from what it has left, and compare all
# files with those of a run at one go: they must be the same to the last bit.
# ctest calls this.
#
#   kill_and_restart.sh SETTINGS SCENE.prm RANKS MOMENTS [SEED]
#
# RANKS is 0 for a run without mpirun. Every third moment is SIGTERM's, which
# leaves a checkpoint of that moment; the others are SIGKILL's, after which the
# run goes on from an earlier one, or starts again where there is none. Every
# fourth goes on in another directory.
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, root, scratch
scene=$2
ranks=$3
moments=$4
seed=${5:-$(date +%s)}
echo "seed $seed"
RANDOM=$seed

directory=$scratch/kill_and_restart/$(basename "$scene" .prm).$ranks.$moments
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"
program=("$sandglass" "$root/$scene" --quiet)
if [ "$ranks" -gt 0 ]; then
  # Ranks that share a core take longer for a step.
  read -r -a launcher <<<"$mpiexec $ranks"
  program=("${launcher[@]}" "${program[@]}" -s "Particle stage/Time step=2.44140625e-4")
fi

fail()
{
  echo "$*; seed $seed, see $directory"
  exit 1
}

run()
{
  "${program[@]}" "$@" >>screen.txt 2>&1 </dev/null
}

# compare DIRECTORY: with the run at one go, all but what has times of the clock.
compare()
{
  local name
  for name in {history,flow_rate,wall_traction,wall_envelope,flow_profile,residence,gauges}.csv residence.vtu; do
    cmp "whole/$name" "$1/$name" || fail "moment $moment: $name differs"
  done
  diff -r whole/vtu "$1/vtu" || fail "moment $moment: the fields differ"
  for name in particles grid walls; do
    diff <(grep DataSet whole/$name.pvd) <(grep DataSet "$1/$name.pvd") ||
      fail "moment $moment: $name.pvd differs"
  done
}

# Wait until the run in a directory has begun, or has ended.
wait_for_begin()
{
  while [ ! -e "$1/summary.json" ] && kill -0 "$2" 2>/dev/null; do
    sleep 0.01
  done
}

# Moments are counted from there, or most would be before it.
run -o whole &
pid=$!
wait_for_begin whole $pid
start=$(date +%s%N)
wait $pid
nanoseconds=$(($(date +%s%N) - start))
n_from_checkpoint=0
for moment in $(seq "$moments"); do
  rm -rf first other
  # 30 bits.
  sleep_time=$(awk -v t=$nanoseconds -v r=$((RANDOM * 32768 + RANDOM)) \
    'BEGIN { printf "%.4f", t * 1e-9 * r / 2^30 }')
  signal=KILL
  [ $((moment % 3)) -ne 0 ] || signal=TERM
  "${program[@]}" -o first >>screen.txt 2>&1 </dev/null &
  pid=$!
  # One in ten may be before it all the same.
  [ $((moment % 10)) -eq 1 ] || wait_for_begin first $pid
  sleep "$sleep_time"
  hit=$pid
  if [ "$ranks" -gt 0 ]; then
    hit=$(pgrep -P $pid -x sandglass | xargs) || true
  fi
  # shellcheck disable=SC2086 # there are several
  kill -$signal $hit 2>/dev/null || true
  code=0
  wait $pid 2>/dev/null || code=$?
  if [ $code -eq 0 ] || grep -q '"status": "finished"' first/summary.json 2>/dev/null; then
    what="had finished"
    compare first
  elif [ -e first/checkpoint.bin ]; then
    what="goes on"
    n_from_checkpoint=$((n_from_checkpoint + 1))
    if [ $((moment % 4)) -eq 0 ]; then
      what="goes on elsewhere"
      run -o other --restart-from first || fail "moment $moment: no restart; $(tail -n 1 screen.txt)"
      compare other
    else
      run -o first --restart || fail "moment $moment: no restart; $(tail -n 1 screen.txt)"
      compare first
    fi
  else
    what="starts again"
    run -o first --restart && fail "moment $moment: a restart without a checkpoint"
    run -o first
    compare first
  fi
  echo "moment $moment: SIG$signal after $sleep_time s, exit code $code, $what"
done
echo "$n_from_checkpoint went on from a checkpoint"
[ "$n_from_checkpoint" -ge $((moments / 4)) ] || fail "too few to test anything"
