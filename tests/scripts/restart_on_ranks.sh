#!/usr/bin/env bash
# Run a scene in pieces, each from the checkpoint that the last one has left at
# its end, and at one go: the tables must be the same to the last bit. The
# checkpoints lie where ranks look whether they should share the cells out anew,
# and they do so on the way. ctest calls this.
#
#   restart_on_ranks.sh SETTINGS SCENE.prm RANKS      SCENE.prm below the repository
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, root, scratch
scene=$2
ranks=$3
# In s, every 200 steps of 1/2048 s, which add up without rounding: the end cuts
# no step short.
ends=(0.09765625 0.1953125 0.29296875 0.390625 0.48828125)

directory=$scratch/restart_on_ranks/$ranks
rm -rf "$directory"
mkdir -p "$directory"

# go_to END OUTPUT [ARGUMENTS]
go_to()
{
  # shellcheck disable=SC2086
  if ! $mpiexec "$ranks" "$sandglass" "$root/$scene" --quiet -o "$directory/$2" \
    -s "Particle stage/End time=$1" "${@:3}" >>"$directory/screen.txt" 2>&1; then
    tail -n 40 "$directory/screen.txt"
    exit 1
  fi
}

go_to "${ends[-1]}" whole
go_to "${ends[0]}" pieces
for end in "${ends[@]:1}"; do
  go_to "$end" pieces --restart
done

count=$(grep -c "share the cells out anew" "$directory/whole/sandglass.log" || true)
echo "$count new partitions"
if [ "$count" -lt 2 ]; then
  echo "too few of them to test anything"
  exit 1
fi
for table in history.csv flow_rate.csv; do
  cmp "$directory/whole/$table" "$directory/pieces/$table"
done
