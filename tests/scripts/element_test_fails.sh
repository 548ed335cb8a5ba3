#!/usr/bin/env bash
# An element test that can't go on: one message, exit code 1, and the rows so
# far are kept. ctest calls this.
#
#   element_test_fails.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, root, scratch
directory=$scratch/element-test-fails
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "element test that fails: $*"
  exit 1
}

# So stiff that rounding of the strains is more than the stress to be held.
cat >scene.prm <<'END'
subsection Material
  set Young modulus = 1e30
end
subsection Element test
  set Kind = triaxial
end
END
for launcher in "" "$mpiexec 2"; do
  code=0
  # shellcheck disable=SC2086 # it is several words
  $launcher "$sandglass" --element-test scene.prm -o output --quiet 2>message.txt || code=$?
  cat message.txt
  [ $code -eq 1 ] || fail "the exit code is $code, expected 1"
  [ "$(grep -c "^Element test of the law 'Drucker-Prager', step .*Steps\.$" message.txt)" = 1 ] ||
    fail "the message isn't there once"
  grep -q '"status": "failed"' output/summary.json || fail "failure is not in summary.json"
  rows=$(($(wc -l <output/element_test.csv) - 1))
  [ "$rows" -ge 1 ] || fail "$rows rows are left"
  grep -q "step $rows of 1000" message.txt || fail "the message doesn't name step $rows"
done
