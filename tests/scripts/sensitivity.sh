#!/usr/bin/env bash
# What a stored reference sees, and what it must not; ctest calls this.
#
#   sensitivity.sh SETTINGS NAME
#
# With wall friction, gravity, density or internal friction 1 % off, each in
# turn, the comparison with NAME.output must fail (a line `blind Section/Name`
# of NAME.check excepts one of them). Rounding is what two ranks make of it:
# they must agree with the reference to a tenth of the tolerance.
set -euo pipefail
export LC_ALL=C

source "$1" # root, scratch
name=$2
check=$root/tests/regression/$name.check
regression=$root/tests/scripts/regression.sh

# Apart from what the same comparison in another test writes.
directory=$scratch/sensitivity/$name
mkdir -p "$directory"
settings=$directory/settings.sh
{
  cat "$1"
  echo "scratch='$directory'"
} >"$settings"

# The comparison must pass with the scene as it is; what it was is read there.
bash "$regression" "$settings" compare "$name" 0
cp "$directory/regression/$name.compare.0/output/parameters.prm" "$directory"

# The numbers of the parameter $1/$2, 1 % larger.
off_by_one_percent()
{
  awk -F ' *[=#] *' -v section="subsection $1" -v entry="set $2" '
    /^subsection/ { is_there = $0 ~ "^" section "$" }
    { sub(/^ */, ""); sub(/ *$/, "", $1) }
    is_there && $1 == entry {
      n = split($2, values, /, */)
      for (i = 1; i <= n; ++i)
        printf "%s%.15g", (i > 1 ? ", " : ""), 1.01 * values[i]
    }' "$directory/parameters.prm"
}

failed=0
for parameter in "Walls/Friction angle" "Scene/Gravity" "Material/Density" \
  "Material/Internal friction angle"; do
  value=$(off_by_one_percent "${parameter%/*}" "${parameter#*/}")
  code=0
  bash "$regression" "$settings" compare "$name" 0 -s "$parameter=$value" \
    >"$directory/screen.txt" || code=$?
  is_blind=$(grep -cx "blind $parameter *\(#.*\)\?" "$check" || true)
  case $code$is_blind in
    10)
      echo "$name: $parameter = $value is seen," \
        "columns by phase: $(grep -o '^phase [0-9]*' "$directory/screen.txt" |
          sort | uniq -c | awk '{ print $1 }' | xargs)"
      ;;
    01)
      echo "$name: $parameter = $value isn't seen, as it is to be"
      ;;
    *)
      failed=1
      cat "$directory/screen.txt"
      echo "FAILED: $name: $parameter = $value, exit code $code"
      ;;
  esac
done

bash "$regression" "$settings" margin "$name" 2 || failed=1
exit $failed
