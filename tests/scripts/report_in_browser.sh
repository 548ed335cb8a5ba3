#!/usr/bin/env bash
# The report as a browser shows it: no error, the numbers of summary.json and of
# the tables, and a flow that plays. ctest calls this, and takes exit code 77 for
# a test that was skipped.
#
#   report_in_browser.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, sandglass_report, root, scratch
directory=$scratch/report_in_browser
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

if ! command -v chromium >/dev/null; then
  echo "skipped: there is no chromium. On Debian or Ubuntu: apt-get install chromium"
  exit 77
fi

fail()
{
  echo "report in the browser: $*"
  exit 1
}

# browse RUN [WISHES]: the page as it is after some seconds of the browser's own
# time, to page.html. --run-all-… lets animations run. A container has too little
# shared memory, and may have no home.
browse()
{
  rm -rf profile
  HOME=$directory chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage \
    --user-data-dir="$directory/profile" --window-size=1200,900 --enable-logging=stderr \
    --run-all-compositor-stages-before-draw --virtual-time-budget=4000 \
    --dump-dom "file://$directory/$1/report.html#${2:-}" 2>browser.log |
    sed '/<script/,/<\/script>/d' >page.html
  if grep -E 'CONSOLE' browser.log; then
    fail "$1: the console has messages"
  fi
  grep -q 'data-ready="yes"' page.html || fail "$1: the page is not ready"
}

# summary KEY: its value in summary.json
summary()
{
  sed -n "s/^ *\"$1\": \([^,]*\),*$/\1/p" run/summary.json
}

# figure KEY: the value of the page's tile
figure()
{
  grep -o "data-key=\"$1\" data-value=\"[^\"]*\"" page.html | sed 's/.*data-value="//; s/"//'
}

# equal NAME A B
equal()
{
  awk -v a="$2" -v b="$3" 'BEGIN { d = a - b; exit (a == "" || b == "" || d * d > 1e-24 * b * b) }' ||
    fail "$1 is $2 in the page, $3 in the run"
}

# number VALUE DIGITS: as the page shows it, below 1e7
number()
{
  awk -v v="$1" -v d="$2" 'BEGIN { printf(v >= 10^d ? "%d" : "%." d "g", v >= 10^d ? int(v + 0.5) : v) }' |
    sed -E ':a; s/^([0-9]+)([0-9]{3})/\1,\2/; ta'
}

"$sandglass" "$root/prm/quickstart.prm" -s "Particle stage/End time=1" -s "Output/Gauges=foot: 0.8 0.1, middle: 0 0.6" -o run --quiet
"$sandglass_report" run >/dev/null

# --- The numbers -------------------------------------------------------------
browse run "time=1"
for key in flow_rate_plateau_kg_per_s mass_discharged_kg mass_in_silo_kg mass_balance_error; do
  equal $key "$(figure $key)" "$(summary $key)"
done
largest=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
  $c["wall"] != "outlet" && $c["normal_Pa"] != "nan" && $c["normal_Pa"] > m { m = $c["normal_Pa"] }
  END { printf "%.17g", m / 1000 }' run/wall_traction.csv)
equal "the largest wall pressure" "$(figure largest_wall_pressure_Pa)" "$largest"
rate=$(number "$(summary flow_rate_plateau_kg_per_s)" 4)
grep -q ">$rate<small>kg/s per m" page.html || fail "the tile of the flow rate doesn't show $rate"
last=$(number "$(tail -n 1 run/flow_rate.csv | cut -d, -f3)" 4)
grep -q "<th>Flow rate</th><td>$last kg/(s m)</td>" page.html || fail "the rate at the end is not $last"
grep -q "silo 1.6 m wide, with a wall 1.7 m high, a flat bottom and a slot of 0.45 m" page.html ||
  fail "the silo is another one in words"
grep -q "data-key=\"kind_of_flow\" data-value=$(summary kind_of_flow)" page.html || fail "the kind of flow is another one"
for text in "Largest over filling pressure" "mass flow index" "Which layers leave when" "When material leaves, by its first place" \
  "Gauges: foot (x = 0.8 m, y = 0.1 m), middle" "Normal pressure on walls" "Downward speed"; do
  grep -qF "$text" page.html || fail "there is no '$text'"
done
for text in "Beverloo, fine grains" "Janssen" "EN 1991-4, discharge" "range over the run" "work of gravity" "20 degrees"; do
  grep -qF "$text" page.html || fail "there is no '$text'"
done
curves=$(grep -o '<path class="line"' page.html | wc -l)
[ "$curves" -ge 20 ] || fail "only $curves curves"
[ "$(grep -c 'NaN' page.html)" = 0 ] || fail "something is not a number"

# --- It plays ----------------------------------------------------------------
grep -q 'data-playing="false" data-frame="10"' page.html || fail "it doesn't stand at the last frame"
browse run "play&colour=speed&mesh&tractions&dark"
frame=$(grep -o 'data-frame="[0-9]*"' page.html | grep -o '[0-9]*')
[ "$frame" -ge 1 ] || fail "the frame doesn't advance"
grep -q 'data-theme="dark"' page.html || fail "it isn't dark"
[ "$(grep -o 'class="traction"' page.html | wc -l)" = 4 ] || fail "no tractions on two walls and two floors"

# --- Runs that have not finished ---------------------------------------------
cp -r run failed
sed -i 's/"status": "finished"/"status": "failed", "message": "Particle 7 <left> the grid."/' failed/summary.json
"$sandglass_report" failed >/dev/null
browse failed
grep -q 'The run has failed.*Particle 7 &lt;left&gt; the grid' page.html || fail "it doesn't say that the run has failed"
mkdir begun
cp run/parameters.prm begun
"$sandglass_report" begun >/dev/null
browse begun
grep -q 'The run is still going on' page.html || fail "it doesn't say that the run goes on"
grep -q 'no particles to show' page.html || fail "it doesn't say that there are no particles"
