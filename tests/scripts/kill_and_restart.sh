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

directory=$scratch/kill_and_restart/$ranks.$moments
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"
launcher=()
[ "$ranks" -eq 0 ] || read -r -a launcher <<<"$mpiexec $ranks"

fail()
{
  echo "$*; seed $seed, see $directory"
  exit 1
}

run()
{
  "${launcher[@]}" "$sandglass" "$root/$scene" --quiet "$@" >>screen.txt 2>&1 </dev/null
}

# compare DIRECTORY: with the run at one go, all but what has times of the clock.
compare()
{
  local name
  for name in history.csv flow_rate.csv wall_traction.csv; do
    cmp "whole/$name" "$1/$name" || fail "moment $moment: $name differs"
  done
  diff -r whole/vtu "$1/vtu" || fail "moment $moment: the fields differ"
  for name in particles grid walls; do
    diff <(grep DataSet whole/$name.pvd) <(grep DataSet "$1/$name.pvd") ||
      fail "moment $moment: $name.pvd differs"
  done
}

start=$(date +%s%N)
run -o whole
nanoseconds=$(($(date +%s%N) - start))
n_from_checkpoint=0
for moment in $(seq "$moments"); do
  rm -rf first other
  # 30 bits.
  sleep_time=$(awk -v t=$nanoseconds -v r=$((RANDOM * 32768 + RANDOM)) \
    'BEGIN { printf "%.4f", t * 1e-9 * r / 2^30 }')
  signal=KILL
  [ $((moment % 3)) -ne 0 ] || signal=TERM
  # In a group of their own, that all ranks be hit.
  setsid "${launcher[@]}" "$sandglass" "$root/$scene" --quiet -o first >>screen.txt 2>&1 </dev/null &
  pid=$!
  sleep "$sleep_time"
  if [ "$signal" = TERM ] && [ "$ranks" -gt 0 ]; then
    pkill -TERM -P $pid -x sandglass || true
  else
    kill -$signal -- -$pid || true
  fi
  code=0
  wait $pid || code=$?
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
