#!/usr/bin/env bash
# An element test of a file: it comes to its end, on one rank and on two, with
# the same rows, and leaves what it should. ctest calls this.
#
#   element_test.sh SETTINGS FILE.prm      FILE.prm below the repository
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, root, scratch
scene=$2
directory=$scratch/element-tests/$(basename "$scene" .prm)
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "element test: $*"
  exit 1
}

"$sandglass" --element-test "$root/$scene" -o one >one.txt 2>&1 || fail "$(cat one.txt)"
cat one.txt
head=axial_strain,volumetric_strain,shear_strain,axial_stress_Pa,lateral_stress_Pa,out_of_plane_stress_Pa,shear_stress_Pa,void_ratio
[ "$(head -n 1 one/element_test.csv)" = $head ] || fail "the head of element_test.csv isn't $head"
files=$(ls one | xargs)
[ "$files" = "element_test.csv parameters.prm sandglass.log summary.json" ] ||
  fail "the files are $files"
grep -q '"status": "finished"' one/summary.json || fail "summary.json doesn't say finished"
rows=$(($(wc -l <one/element_test.csv) - 1))
grep -q "\"rows\": $rows," one/summary.json || fail "summary.json doesn't know of $rows rows"
grep -q '^Results are in one' one.txt || fail "the screen doesn't say where the results are"

# What it leaves repeats it; on two ranks as well, and without a word.
# shellcheck disable=SC2086 # it is several words
$mpiexec 2 "$sandglass" --element-test one/parameters.prm -o two --quiet >two.txt
[ ! -s two.txt ] || fail "--quiet prints"
cmp one/element_test.csv two/element_test.csv
