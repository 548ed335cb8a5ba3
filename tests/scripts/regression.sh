#!/usr/bin/env bash
# Run a scene and compare its results; ctest calls this.
#
#   regression.sh SETTINGS compare  NAME RANKS [ARGUMENTS]
#                                                with the stored reference
#   regression.sh SETTINGS margin   NAME RANKS   with a tenth of the tolerance
#   regression.sh SETTINGS generate NAME RANKS   write that reference
#   regression.sh SETTINGS ranks    NAME         on several numbers of ranks, with each other
#
# RANKS is 0 for a run without mpirun (reference NAME.output), otherwise the
# reference is NAME.mpirun=RANKS.output; `margin` takes NAME.output always.
# ARGUMENTS go to sandglass. The exit code is 1 where results differ, 2 where
# there are none. CONTRIBUTING.md describes NAME.check.
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, numdiff, root, scratch
mode=$2
name=$3
folder=$root/tests/regression

fail()
{
  echo "$name: $*"
  exit 2
}

# The check file, with the files that it includes.
mkdir -p "$scratch/regression"
check=$scratch/regression/$name.$mode.${4:-ranks}.check
awk -v folder="$folder" '
  $1 != "include" { print; next }
  {
    lines = 0
    while ((getline line < (folder "/" $2)) > 0) { print line; ++lines }
    if (!lines) { print FILENAME " includes what is not there: " $2; exit 1 }
  }' "$folder/$name.check" >"$check" || fail "$(tail -n 1 "$check")"

# The words after `keyword` in the check file.
setting() { sed -n "s/ *#.*//; s/^$1 *//p" "$check"; }

# launch RANKS [ARGUMENTS]: the scene once, to the directory `output`.
launch()
{
  local scene launcher=()
  scene=$(setting prm)
  scene=${scene:+$root/$scene}
  if [ "$1" -gt 0 ]; then
    launcher=($mpiexec "$1")
  fi
  if ! "${launcher[@]}" "$sandglass" "${scene:-$folder/$name.prm}" -o output --quiet \
    "${@:2}" >screen.txt 2>&1 </dev/null; then
    tail -n 40 screen.txt
    fail "the run on $1 ranks failed; its output is in $directory"
  fi
}

# run RANKS [ARGUMENTS]: run the scene (0 ranks: without mpirun) in a fresh
# directory and write the chosen results to result.txt there; $directory is that
# directory.
run()
{
  local ranks=$1 end arguments=()
  directory=$scratch/regression/$name.$mode.$ranks
  if [ -f "$folder/$name.command" ]; then
    eval "arguments=($(cat "$folder/$name.command"))"
  fi
  arguments+=("${@:2}")

  rm -rf "$directory"
  mkdir -p "$directory"
  cd "$directory"
  if [ -f "$folder/$name.msh" ]; then
    cp "$folder/$name.msh" .
  fi
  end=$(setting restart)
  if [ -n "$end" ]; then
    launch "$ranks" "${arguments[@]}" -s "Particle stage/End time=$end" \
      -s "Output/Checkpoint interval=$end"
    arguments+=(--restart)
  fi
  launch "$ranks" "${arguments[@]}"
  awk -v directory=output -f "$root/tests/scripts/extract.awk" "$check" >result.txt ||
    fail "there is nothing to compare in $directory"
}

# Phase $1 of the results $2: what is below their $1-th "# phase".
phase() { awk -v phase="$1" '$0 == "# phase" { ++n } n == phase' "$2"; }

# compare EXPECTED RESULTS [SHARE]: phase by phase, with this share of the
# tolerances. These refer to values that extract.awk has divided by their scale.
compare()
{
  local n=0 absolute relative differs=0
  while read -r absolute relative; do
    n=$((n + 1))
    phase $n "$1" >"$directory/expected.$n"
    phase $n "$2" >"$directory/found.$n"
    "$numdiff" -a "$absolute" -r "$relative" "$directory/expected.$n" "$directory/found.$n" \
      >"$directory/numdiff.$n" 2>&1 && continue
    differs=1
    head -n 30 "$directory/numdiff.$n"
    # numdiff names lines; the column is that of the header above.
    awk -v phase=$n '
      NR == FNR { if ($1 ~ /^##[0-9]/) differs[substr($1, 3)]; next }
      /^#/ { column = $2 }
      FNR in differs && !said[column]++ { print "phase " phase " differs: " column }' \
      "$directory/numdiff.$n" "$directory/expected.$n"
  done < <({ setting tolerance | grep . || echo 1e-12 1e-9; } |
    awk -v share="${3:-1}" '{ print $1 * share, $2 * share }')
  if [ $n -eq 0 ] || [ $differs -ne 0 ]; then
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
    run "$ranks" "${@:5}"
    if [ "$mode" = generate ]; then
      cp result.txt "$reference"
    else
      compare "$reference" "$directory/result.txt"
    fi
    ;;
  margin)
    run "$4"
    compare "$folder/$name.output" "$directory/result.txt" 0.1
    ;;
  *)
    fail "regression.sh: unknown mode $mode"
    ;;
esac
