#!/usr/bin/env bash
# The report of a run: it holds what the run has written, loads nothing, also
# where it is installed and of a run on two ranks; and what can't be reported is
# refused. ctest calls this.
#
#   report.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, sandglass_report, cmake, build, mpiexec, root, scratch
directory=$scratch/report
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "report: $*"
  exit 1
}

# unpack NAME FILE: what the page FILE holds of the run's file NAME. gzip's head
# in place of zlib's; gzip misses its own end then, and says so.
unpack()
{
  sed -n "s|.*data-file=\"$1\">\([^<]*\)</script>.*|\1|p" "$2" | base64 -d | tail -c +3 |
    { printf '\037\213\010\0\0\0\0\0\0\003'; cat; } | gzip -dc 2>/dev/null || true
}

"$sandglass" "$root/prm/quickstart.prm" -s "Particle stage/End time=0.4" -o run --quiet
# shellcheck disable=SC2086 # it is several words
$mpiexec 2 "$sandglass" "$root/prm/quickstart.prm" -s "Particle stage/End time=0.1" -o ranks --quiet

# --- What it holds -----------------------------------------------------------
for run in run ranks; do
  [ "$("$sandglass_report" $run)" = $run/report.html ] || fail "$run: the report's name isn't printed"
  for name in summary.json parameters.prm {history,flow_rate,wall_traction,wall_envelope,flow_profile,residence}.csv; do
    unpack $name $run/report.html | cmp - $run/$name || fail "$run: $name is another in the report"
  done
  particles=$(sed -n 's/.*"particles": \([0-9]*\),/\1/p' $run/summary.json)
  unpack particles.json $run/report.html | grep -q "\"particles\": $particles, \"of_particles\": $particles," ||
    fail "$run: not $particles particles"
done
unpack particles.json run/report.html | grep -qE '"of_frames": 5, "times": \[0, 0\.1[0-9.]*, 0\.2[0-9.]*, 0\.[0-9.]*, 0\.4[0-9.]*\]' ||
  fail "not the five times of output"
frames=5
bytes=$(unpack particles.bin run/report.html | wc -c)
[ "$bytes" = $((1388 * (1 + 2 + 2 + frames * 5 * 2))) ] || fail "$bytes bytes of particles"
grep -q '"edges"' <(unpack mesh.json run/report.html) || fail "no mesh"
grep -q '"share": \[' <(unpack residence.json run/report.html) || fail "no map of residence"
ls run | grep -q 'report.html.new' && fail "the draft is left"

# --- Walls in three dimensions: where the cut of the particles meets them -----
"$sandglass" "$root/prm/three-dimensions/round-flat-bottom.prm" -s "Scene/Refinement=0.5" \
  -s "Particle stage/End time=0.01" -o body --quiet
"$sandglass_report" body >/dev/null
farthest=$(unpack walls.json body/report.html | grep -oE '\[[-0-9.e]+,' | tr -d '[,' | sort -g | tail -n 1)
[ "$farthest" = 0.5 ] || fail "the wall is drawn at x = $farthest"

# --- One file ----------------------------------------------------------------
if grep -oE '(src|href|action)="[^"]*"|@import[^;]*|url\([^)]*\)' run/report.html | grep -v '^href="data:,"$'; then
  fail "it loads something"
fi
grep -q 'Redistribution and use in source and binary forms' run/report.html || fail "no licence of D3"
grep -q '{{' <(sed -n '/<body>/,/<main>/p' run/report.html) && fail "a place of the template is left"

# --- Where it is installed ---------------------------------------------------
"$cmake" --install "$build" --component report --prefix "$directory/prefix" >/dev/null
cp -r run installed
rm installed/report.html
prefix/bin/sandglass-report installed >/dev/null
[ -s installed/report.html ] || fail "the installed program has made none"

# --- A run that goes on ------------------------------------------------------
mkdir begun
cp run/parameters.prm begun
"$sandglass_report" begun >/dev/null || fail "no report of a run that has just begun"
cp -r run going-on
printf '0.41,12' >>going-on/flow_rate.csv # as a row is being written
"$sandglass_report" going-on >/dev/null
unpack flow_rate.csv going-on/report.html | cmp - run/flow_rate.csv || fail "half a row is in the report"

# --- What is refused ---------------------------------------------------------

# expect_refusal TEXT DIRECTORY
expect_refusal()
{
  local code=0
  "$sandglass_report" "${@:2}" >output.txt 2>message.txt || code=$?
  if [ $code -ne 2 ] || [ -s output.txt ] || ! grep -qF -e "$1" message.txt || [ -e "${2:-.}/report.html" ]; then
    echo "exit code $code, expected 2 and: $1"
    cat output.txt message.txt
    exit 1
  fi
}

# damaged: a copy of the run to be damaged
damaged()
{
  rm -rf damaged
  cp -r run damaged
  rm damaged/report.html
}

expect_refusal "which directory?"
expect_refusal "'nowhere' doesn't exist." nowhere
mkdir empty
expect_refusal "'empty' holds no run" empty
expect_refusal "is not a directory" run/summary.json
mkdir element-test study
echo '{"status": "finished", "law": "Lade"}' >element-test/summary.json
expect_refusal "holds an element test" element-test
echo '{"status": "finished", "runs": 3}' >study/summary.json
touch study/study.csv
expect_refusal "holds a study" study
damaged && head -c 200 run/summary.json >damaged/summary.json
expect_refusal "'damaged/summary.json' is damaged: line" damaged
damaged && sed -i '5s/,[^,]*$//' damaged/wall_traction.csv
expect_refusal "'damaged/wall_traction.csv' is damaged: line 5 has 12 values for 13 columns." damaged
damaged && sed -i '1s/normal_Pa/normal/' damaged/wall_traction.csv
expect_refusal "'damaged/wall_traction.csv' has no column 'normal_Pa'" damaged
damaged && head -c 300 run/residence.vtu >damaged/residence.vtu
expect_refusal "'damaged/residence.vtu' is damaged" damaged
damaged && rm damaged/vtu/particles_00002.vtu
expect_refusal "'damaged/vtu/particles_00002.vtu' is missing." damaged
damaged && truncate -s -3000 damaged/vtu/particles_00002.vtu
expect_refusal "'damaged/vtu/particles_00002.vtu' is damaged" damaged
damaged && head -c 300 run/particles.pvd >damaged/particles.pvd
expect_refusal "'damaged/particles.pvd' is damaged" damaged
