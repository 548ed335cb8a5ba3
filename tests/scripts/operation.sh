#!/usr/bin/env bash
# What filling by layers and refilling are for, on the scenes of prm/operation.
# ctest calls this.
#
#   operation.sh SETTINGS layers|steady|funnel
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, root, scratch
case=$2
directory=$scratch/operation/$case
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "operation/$case: $*"
  exit 1
}

run()
{
  "$sandglass" "$root/prm/operation/$1.prm" -o "$2" --quiet -s "Output/Particles=false" \
    -s "Output/Grid=false" "${@:3}"
}

# janssen DIRECTORY: the wall's force per metre of depth; what it is over
# Janssen's with the lateral ratio K that the run shows (the force over the
# integral of the mean vertical stress, which follows from weight and friction);
# and the same for the friction above one half width from the floor. Below it the
# floor keeps material from sliding, which Janssen's slice does not know.
janssen()
{
  awk -F, -v b=0.5 -v weight=$((1500 * 981))e-2 '
    # Forces above node `first` over those of Janssen, in `share` and `rubbed`.
    function compare(first, i, carried, stress, above, sum, k, length_, height, friction, dy)
    {
      carried = sum = force = rubbed = 0
      above = 0
      for (i = n - 1; i >= first; --i) {
        dy = y[i + 1] - y[i]
        force += (normal[i] + normal[i + 1]) / 2 * dy
        carried += (tangential[i] + tangential[i + 1]) / 2 * dy
        stress = weight * (y[n] - y[i]) - carried / b
        sum += (stress + above) / 2 * dy
        above = stress
      }
      k = force / sum
      length_ = b / (mu * k)
      height = y[n] - y[first]
      friction = weight * b * (height - length_ * (1 - exp(-height / length_)))
      share = mu * force / friction
      rubbed = carried / friction
    }
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    $c["time_s"] == 0 && $c["wall"] == "wall" {
      ++n; y[n] = $c["y_m"]; normal[n] = $c["normal_Pa"]; tangential[n] = $c["tangential_Pa"]
    }
    END {
      mu = sin(20 * atan2(0, -1) / 180) / cos(20 * atan2(0, -1) / 180)
      compare(1)
      whole = force; of_whole = share
      for (first = 1; first < n && y[first] < b - 1e-9; ++first);
      compare(first)
      print whole, of_whole, rubbed
    }' "$1/wall_traction.csv"
}

# within SHARE VALUE REFERENCE
within() { awk -v s="$1" -v a="$2" -v b="$3" 'BEGIN { exit !(a > (1 - s) * b && a < (1 + s) * b) }'; }

# keep_full [settings]: a silo that is kept full for 20 of its emptying times.
keep_full()
{
  run refill output -s "Stop/Steady within=0" -s "Output/History interval=0.05" "$@"
  # Means over one emptying time after the other, but the first
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    { ++n; t[n] = $c["time_s"]; m[n] = $c["mass_discharged_kg"]; s[n] = $c["mass_in_silo_kg"] }
    function mass(time)
    {
      while (j + 1 < n && t[j + 1] < time) ++j
      return m[j] + (time - t[j]) / (t[j + 1] - t[j]) * (m[j + 1] - m[j])
    }
    END {
      j = 1
      unit = s[1] * t[n] / m[n]
      if (!(t[n] > 20 * unit)) { print "the run ends after", t[n] / unit, "emptying times"; exit 1 }
      last = mass(unit)
      least = 1e30
      for (i = 2; i <= 20; ++i) {
        next_ = mass(i * unit)
        rate = (next_ - last) / unit
        last = next_
        sum += rate
        if (rate < least) least = rate
        if (rate > most) most = rate
      }
      for (i = 1; i <= n; ++i)
        if (s[i] < 0.97 * s[1] || s[i] > 1.03 * s[1]) { print "the mass in the silo goes to", s[i]; exit 1 }
      printf("rate %g kg/(s m) over 20 emptying times of %g s, which differ by %.2f %%\n",
             sum / 19, unit, 100 * (most - least) / (sum / 19))
      exit !(unit > 0 && (most - least) < 0.03 * sum / 19)
    }' output/history.csv || fail "the flow is not steady"
  error=$(sed -n 's/^ *"mass_balance_error": \([^,]*\),*$/\1/p' output/summary.json)
  awk -v e="$error" 'BEGIN { exit !(e != "" && e + 0 < 1e-13) }' || fail "masses differ by $error"
}

if [ "$case" = layers ]; then
  last=
  for n in 1 4 16; do
    run layers "layers-$n" -s "Scene/Layers=$n"
    read -r force share friction <<<"$(janssen "layers-$n")"
    echo "$n layers: wall force $force N/m, over Janssen's $share; friction above $friction"
    within 0.03 "$share" 1 || fail "the wall's force is not Janssen's"
    within 0.03 "$friction" 1 || fail "the friction is not Janssen's"
    [ -z "$last" ] || within 0.005 "$force" "$last" || fail "layers change the force"
    last=$force
  done
elif [ "$case" = steady ]; then
  keep_full -s "Particle stage/End time=36"
else
  # Funnel flow beside slow corners, which must not fill up.
  keep_full -s "Particle stage/End time=54" -s "Scene/Hopper height=0" \
    -s "Scene/Wall height=1" -s "Scene/Cell type=quadrilateral" -s "Scene/Element size=0.025"
fi
