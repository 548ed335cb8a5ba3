#!/usr/bin/env bash
# The smallest outlet of a small cohesive silo lies between what flows and what
# stands; without cohesion all outlets flow. ctest calls this.
#
#   smallest_outlet.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, root, scratch
scene=$root/tests/regression/study.prm
directory=$scratch/smallest_outlet
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "smallest-outlet: $*"
  exit 1
}

# key NAME FILE: its value in a JSON file.
key() { sed -n "s/^ *\"$1\": \(.*[^,]\),*$/\1/p" "$2"; }

"$sandglass" --study smallest-outlet "$scene" -o cohesive -s "Material/Cohesion=500" \
  -s "Scene/Headroom=0.1" -s "Scene/Element size=0.02" >cohesive.txt
cat cohesive.txt cohesive/study.csv
[ "$(head -n 1 cohesive/study.csv)" = outlet_half_width_m,flows,flow_rate_kg_per_s ] ||
  fail "the head of study.csv is wrong"
summary=cohesive/summary.json
grep -q '"status": "finished"' $summary || fail "the study has not finished"
awk -v flows="$(key smallest_flowing_half_width_m $summary)" \
  -v stands="$(key largest_arrested_half_width_m $summary)" \
  -v jenike="$(key jenike_outlet_width_m $summary)" 'BEGIN {
    print "flows from", flows, "stands at", stands, "Jenike", jenike / 2
    # f_c = 2 c cos / (1 - sin) over rho g, in a slot with a flat bottom.
    exit !(flows > stands && flows <= 1.05 * stands &&
           jenike > 0.1066 && jenike < 0.1068) }' ||
  fail "the widths are wrong"
awk -F , -v stands="$(key largest_arrested_half_width_m $summary)" \
  'NR > 1 && ($2 == 0) != ($1 <= stands) { exit 1 }' cohesive/study.csv ||
  fail "a row contradicts the bounds"

"$sandglass" --study smallest-outlet "$scene" -o loose -s "Scene/Headroom=0.1" -s "Scene/Element size=0.02" \
  -s "Scene/Outlet half width=0.15" -s "Particle stage/End time=0.3" >loose.txt
grep -q "flows through every outlet tried" loose.txt || fail "loose material stands"
grep -q '"largest_arrested_half_width_m": null' loose/summary.json ||
  fail "loose material is said to stand"
