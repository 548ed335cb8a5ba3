#!/usr/bin/env bash
# A small silo comes to rest and discharges with each law that the program
# offers: nothing is lost, and a user's own subroutine gives what the built-in
# law does. ctest calls this.
#
#   laws.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, root, scratch
scene=$root/tests/regression/study.prm
directory=$scratch/laws
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "laws: $*"
  exit 1
}

# key NAME FILE: its value in a JSON file.
key() { sed -n "s/^ *\"$1\": \(.*[^,]\),*$/\1/p" "$2"; }

# run NAME SETTING...: the scene with these settings, into the directory NAME.
run()
{
  local name=$1
  shift
  local settings=()
  for setting in "$@"; do
    settings+=(-s "$setting")
  done
  "$sandglass" "$scene" -o "$name" --quiet "${settings[@]}" \
    -s "Particle stage/End time=0.3" -s "Scene/Headroom=0.1" ||
    fail "$name: exit code $?"
  local summary=$name/summary.json
  grep -q '"status": "finished"' "$summary" || fail "$name has not finished"
  awk -v lost="$(key mass_lost_kg "$summary")" \
    -v error="$(key mass_balance_error "$summary")" \
    -v out="$(key mass_discharged_kg "$summary")" \
    -v all="$(key mass_initial_kg "$summary")" 'BEGIN {
      printf "%s of %s kg out, %s kg lost, balance %s\n", out, all, lost, error
      exit !(lost == 0 && error < 1e-12 && error > -1e-12 &&
             out > 0.02 * all && out < all) }' ||
    fail "$name: masses are wrong"
}

for law in "Drucker-Prager" "mu(I)" "von Wolffersdorff" "Wu-Bauer" "Kolymbas" "Lade"; do
  echo "$law"
  run "$law" "Material/Model=$law" "Material/Yield cone=Matsuoka-Nakai"
done
run cohesive "Material/Yield cone=Matsuoka-Nakai" "Material/Cohesion=20"
run green-naghdi "Material/Stress rate=Green-Naghdi"
run box "Walls/Box depth=0.2"

library=$scratch/umat_drucker_prager.so
if [ -e "$library" ]; then
  # The slope of the paper's cone for 25 degrees. Which particles take an
  # averaged strain is decided by density with the built-in law, and by stress
  # with a law of which nothing is known.
  run umat "Material/Model=UMAT" "Material/UMAT library=$library" \
    "Material/UMAT constants=1e6, 0.3, 0.8623499732157968" \
    "Material/UMAT state variables=1" "Particle stage/Volumetric strain=element"
  run built-in "Material/Yield cone=paper" "Particle stage/Volumetric strain=element"
  paste -d , <(tail -n 1 umat/flow_rate.csv) <(tail -n 1 built-in/flow_rate.csv) |
    awk -F , '{ n = NF / 2; d = $2 / $(n + 2) - 1; print "mass out over that of the built-in law - 1:", d
                exit !(d < 1e-6 && d > -1e-6) }' ||
    fail "the user's law does not give what the built-in one does"
else
  echo "no Fortran compiler: the user's law is left out"
fi

# A law that fails names the particle, and keeps the results so far.
code=0
"$sandglass" "$scene" -o failed --quiet -s "Material/Model=UMAT" \
  -s "Material/UMAT library=$scratch/libumat_probe.so" \
  -s "Material/UMAT constants=4" -s "Static stage/Enabled=false" \
  2>message.txt || code=$?
cat message.txt
[ $code -eq 1 ] || fail "a law that fails: exit code $code, expected 1"
grep -q "^Step 0, t = 0 s, .*: particle [0-9]* at (.*) m: the law UMAT failed: it called XIT" message.txt ||
  fail "the message does not name step, particle and cause"
grep -q '"status": "failed"' failed/summary.json || fail "failure is not in summary.json"
