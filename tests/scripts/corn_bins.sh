#!/usr/bin/env bash
# The largest pressures on the walls of two corn bins beside those that Thompson,
# Galili and Williams (1997) have measured. ctest calls this.
#
#   corn_bins.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, root, scratch
directory=$scratch/corn_bins
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

# expect SCENE MEASURED: within 10 % of the measured pressure in Pa
expect()
{
  "$sandglass" "$root/prm/validation/$1.prm" -o "$1" --quiet
  awk -F, -v measured="$2" -v scene="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    $c["wall"] == "wall" && $c["filling_normal_Pa"] > largest { largest = $c["filling_normal_Pa"] }
    END {
      printf("%s: %.4g Pa computed, %.4g Pa measured, %+.1f %%\n", scene, largest, measured, 100 * (largest / measured - 1))
      exit !(largest > 0.9 * measured && largest < 1.1 * measured)
    }' "$1/wall_envelope.csv"
}

expect corn-bin-12.8-m 28200
expect corn-bin-11.0-m 26900
