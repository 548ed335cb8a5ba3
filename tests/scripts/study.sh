#!/usr/bin/env bash
# A convergence study of a small silo: what it writes, on one rank and on two,
# and what is left of one that fails. ctest calls this.
#
#   study.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, root, scratch
scene=$root/tests/regression/study.prm
directory=$scratch/study
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "study: $*"
  exit 1
}

# column NUMBER FILE: that column of a table, without its head.
column() { tail -n +2 "$2" | cut -d , -f "$1"; }

# key NAME FILE: its value in a JSON file.
key() { sed -n "s/^ *\"$1\": \(.*[^,]\),*$/\1/p" "$2"; }

# agree WHAT A B TOLERANCE: two numbers, relative to the second.
agree()
{
  awk -v a="$2" -v b="$3" -v tolerance="$4" \
    'BEGIN { d = (a - b) / b; exit !(d < tolerance && d > -tolerance) }' ||
    fail "$1: $2, expected $3"
}

"$sandglass" --study convergence "$scene" -o one >one.txt
cat one.txt

head=element_size_m,particle_steps,seconds,flow_rate_kg_per_s,error_percent
[[ $(head -n 1 one/study.csv) == $head,* ]] || fail "the head of study.csv isn't $head"
[ "$(column 1 one/study.csv | xargs)" = "0.1 0.07142857142857144 0.05 0.03571428571428572 0.025" ] ||
  fail "the sizes are $(column 1 one/study.csv | xargs)"
grep -qF 'On cells of size zero: ' one.txt || fail "the screen lacks the extrapolated rate"
grep -q '^Warning: The outlet is only' one/refinement-0.5/sandglass.log ||
  fail "the log of the coarsest mesh has no warning"
grep -q '</svg>' one/study.svg || fail "there is no plot"

# Each run is what it would be by itself, up to the history's rows.
for refinement in 0.5 0.7 1 1.4 2; do
  grep -q '"status": "finished"' one/refinement-$refinement/summary.json ||
    fail "the run of refinement $refinement has not finished"
done
"$sandglass" one/refinement-1/parameters.prm -o alone --quiet
cmp alone/history.csv one/refinement-1/history.csv

# The rate is that of the table of the run's own: 3 to 5 times sqrt(D / g).
rate=$(awk -F , '
  NR > 1 && $1 >= 0.42835 && !start { start = $1; mass = $2 }
  NR > 1 { end = $1; last = $2 }
  END { print (last - mass) / (end - start) }' one/refinement-2/flow_rate.csv)
agree "the last rate" "$(column 4 one/study.csv | tail -n 1)" "$rate" 0.02

# What is extrapolated is near the finest meshes' rates, and the errors are
# relative to it.
limit=$(key extrapolated_flow_rate_kg_per_s one/summary.json)
agree "the extrapolated rate" "$limit" "$rate" 0.3
awk -F , -v limit="$limit" '
  NR > 1 { d = 100 * ($4 / limit - 1) - $5; if (d > 1e-6 || d < -1e-6) exit 1 }' one/study.csv ||
  fail "errors are not relative to $limit"

# shellcheck disable=SC2086 # it is several words
$mpiexec 2 "$sandglass" --study convergence "$scene" -o two --quiet >two.txt
[ ! -s two.txt ] || fail "--quiet prints"
for row in 1 2 3 4 5; do
  agree "the rate of mesh $row on two ranks" "$(column 4 two/study.csv | sed -n ${row}p)" \
    "$(column 4 one/study.csv | sed -n ${row}p)" 0.1
done

# A step that is stable on the coarse meshes only.
code=0
"$sandglass" --study convergence "$scene" -o failed --quiet \
  -s "Particle stage/Time step=3e-3" 2>message.txt || code=$?
cat message.txt
[ $code -eq 1 ] || fail "the exit code of a study that fails is $code, expected 1"
grep -q '"status": "failed"' failed/summary.json || fail "failure is not in summary.json"
grep -q "^Refinement 1.4: Step .*Try a smaller" message.txt || fail "the message does not say which run failed"
rows=$(column 1 failed/study.csv | wc -l)
[ "$rows" -ge 1 ] && [ "$rows" -lt 5 ] || fail "$rows runs are left of a study that fails"
