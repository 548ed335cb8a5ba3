#!/usr/bin/env bash
# Run a scene and compare its results; ctest calls this.
#
#   regression.sh SETTINGS compare  NAME RANKS   with the stored reference
#   regression.sh SETTINGS generate NAME RANKS   write that reference
#   regression.sh SETTINGS ranks    NAME         on several numbers of ranks, with each other
#
# RANKS is 0 for a run without mpirun (reference NAME.output), otherwise the
# reference is NAME.mpirun=RANKS.output. CONTRIBUTING.md describes NAME.check.
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, numdiff, root, scratch
mode=$2
name=$3
folder=$root/tests/regression
check=$folder/$name.check

# The words after `keyword` in the check file.
setting() { sed -n "s/ *#.*//; s/^$1 *//p" "$check"; }

# Run the scene on $1 ranks (0: without mpirun) in a fresh directory and write
# the chosen results to result.txt there; $directory is that directory.
run()
{
  local ranks=$1 scene arguments=() launcher=()
  directory=$scratch/regression/$name.$mode.$ranks
  scene=$(setting prm)
  scene=${scene:+$root/$scene}
  scene=${scene:-$folder/$name.prm}
  if [ -f "$folder/$name.command" ]; then
    eval "arguments=($(cat "$folder/$name.command"))"
  fi
  if [ "$ranks" -gt 0 ]; then
    launcher=($mpiexec "$ranks")
  fi

  rm -rf "$directory"
  mkdir -p "$directory"
  cd "$directory"
  if [ -f "$folder/$name.msh" ]; then
    cp "$folder/$name.msh" .
  fi
  if ! "${launcher[@]}" "$sandglass" "$scene" -o output --quiet "${arguments[@]}" \
    >screen.txt 2>&1 </dev/null; then
    tail -n 40 screen.txt
    echo "$name: the run on $ranks ranks failed; its output is in $directory"
    exit 1
  fi
  awk -v directory=output -f "$root/tests/scripts/extract.awk" "$check" >result.txt
}

# Compare the results $2 with the expected ones $1. The tolerances refer to
# values that extract.awk has divided by their scale.
compare()
{
  local tolerance
  read -r -a tolerance <<<"$(setting tolerance)"
  if ! "$numdiff" -a "${tolerance[0]:-1e-12}" -r "${tolerance[1]:-1e-9}" "$1" "$2" >numdiff.txt; then
    head -n 60 numdiff.txt
    echo "$name: $2 differs from $1"
    exit 1
  fi
}

case $mode in
  ranks)
    first=
    for ranks in $(setting ranks); do
      run "$ranks"
      if [ -z "$first" ]; then
        first=$directory/result.txt
      else
        compare "$first" "$directory/result.txt"
      fi
    done
    ;;
  compare | generate)
    ranks=$4
    reference=$folder/$name.output
    if [ "$ranks" -gt 0 ]; then
      reference=$folder/$name.mpirun=$ranks.output
    fi
    run "$ranks"
    if [ "$mode" = generate ]; then
      cp result.txt "$reference"
    else
      compare "$reference" "$directory/result.txt"
    fi
    ;;
  *)
    echo "regression.sh: unknown mode $mode"
    exit 1
    ;;
esac
