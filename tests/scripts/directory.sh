#!/usr/bin/env bash
# The life of an output directory: who may write there, what a run that starts
# leaves of older ones, and what summary.json says of a run that ends before its
# time. ctest calls this.
#
#   directory.sh SETTINGS CASE
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, root, scratch
case=$2
scene=$root/tests/regression/restart-on-ranks.prm
directory=$scratch/directory/$case
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

fail()
{
  echo "$case: $*"
  exit 1
}

# key NAME DIRECTORY: its value in summary.json there.
key() { sed -n "s/^ *\"$1\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}$/\1/p" "$2/summary.json"; }

# expect_status STATUS DIRECTORY [TEXT OF THE MESSAGE]
expect_status()
{
  [ "$(key status "$2")" = "$1" ] || fail "status '$(key status "$2")' in $2, expected $1"
  grep -q -F -e "${3:-}" "$2/summary.json" || fail "no '$3' in $2/summary.json"
}

# expect_code CODE COMMAND...: with stderr in message.txt.
expect_code()
{
  local code=0
  "${@:2}" >screen.txt 2>message.txt </dev/null || code=$?
  if [ $code -ne "$1" ]; then
    cat message.txt
    fail "exit code $code, expected $1: ${*:2}"
  fi
}

# What runs for minutes unless it is stopped, with a table that is written often.
long_run=("$scene" --quiet -s "Particle stage/End time=100" -s "Particle stage/Time step=1e-5"
  -s "Output/History interval=1e-4" -s "Output/Checkpoint interval=0.01")
# What takes half a second.
short_run=("$scene" --quiet -s "Particle stage/End time=0.05")

# wait_for COMMAND...: until it succeeds.
wait_for()
{
  local n
  for n in $(seq 600); do
    "$@" 2>/dev/null && return
    sleep 0.05
  done
  fail "waited in vain for: $*"
}

is_running() { [ "$(key status "$1")" = running ]; }
has_rows() { [ "$(wc -l <"$1/history.csv")" -gt 10 ]; }

# files DIRECTORY: all of its files.
files() { (cd "$1" && find . -type f | sort); }

case $case in
  lock)
    "$sandglass" "${long_run[@]}" -o output &
    first=$!
    trap 'kill -9 $first 2>/dev/null || true' EXIT
    wait_for has_rows output
    expect_code 2 "$sandglass" "${short_run[@]}" -o output
    grep -q "another run is writing there" message.txt || fail "$(cat message.txt)"
    # shellcheck disable=SC2086 # it is several words
    expect_code 2 $mpiexec 2 "$sandglass" "${short_run[@]}" -o output --restart
    [ "$(grep -c "another run is writing there" message.txt)" = 1 ] || fail "$(cat message.txt)"
    expect_status running output
    # It goes with the process, and what was there is still said to run.
    kill -9 $first
    wait $first || true
    expect_status running output
    "$sandglass" "${short_run[@]}" -o output
    expect_status finished output
    ;;

  stale)
    # All that the program writes, from several runs and ranks, and the user's.
    outputs=(-s "Output/Particles=true" -s "Output/Grid=true" -s "Output/Walls=true")
    static=(-s "Static stage/Enabled=true" -s "Output/Interval=0.01")
    # shellcheck disable=SC2086 # it is several words
    OMP_NUM_THREADS=1 $mpiexec 2 "$sandglass" "${short_run[@]}" -o output "${outputs[@]}" "${static[@]}"
    "$sandglass" "${short_run[@]}" -o more "${outputs[@]}" "${static[@]}"
    mv more/vtu/* output/vtu/
    cp output/checkpoint.bin output/checkpoint-before.bin
    "$sandglass" --element-test "$root/prm/element-tests/oedometer.prm" -o element --quiet \
      -s "Element test/Steps=10"
    cp element/element_test.csv output
    (cd output && touch study.csv study.svg report.html summary.json.new history.csv.new \
      summary.json.1 particles.pvd.new checkpoint-before.bin.new)
    ours=$(files output | wc -l)
    mkdir output/own output/vtu/own
    (cd output && touch notes.txt own/history.csv vtu/own.vtu vtu/own/particles_00000.vtu \
      history.csv.bak my_history.csv vtu/particles.vtu)
    user=$(find output -empty -type f -newer element/element_test.csv | wc -l)

    # Input that is refused changes nothing.
    cp -r output before
    expect_code 2 "$sandglass" "${short_run[@]}" -o output -s "Material/Density=-1"
    expect_code 2 "$sandglass" "${short_run[@]}" -o output -s "Scene/Element size=0.5"
    diff -r before output || fail "refused input has changed the directory"

    "$sandglass" "${short_run[@]}" -o fresh
    "$sandglass" "${short_run[@]}" -o output
    files output >left.txt
    (files fresh; printf './%s\n' notes.txt own/history.csv vtu/own.vtu vtu/own/particles_00000.vtu \
      history.csv.bak my_history.csv vtu/particles.vtu) | sort >expected.txt
    diff expected.txt left.txt || fail "$ours files of ours and $user others: these are wrong"

    # Old files are gone before anything else: here, in the state at rest.
    "$sandglass" "${short_run[@]}" -o output "${outputs[@]}" "${static[@]}"
    "$sandglass" "$root/prm/quickstart.prm" --quiet -o output -s "Scene/Element size=0.01" &
    first=$!
    trap 'kill -9 $first 2>/dev/null || true' EXIT
    wait_for is_running output
    for name in history.csv flow_rate.csv checkpoint.bin particles.pvd; do
      [ ! -e output/$name ] || fail "$name of an older run is there while another one runs"
    done
    kill -9 $first
    wait $first || true
    ;;

  study)
    # The same of a study and its runs.
    mkdir -p output/refinement-0.7/vtu output/refinement-9 output/other
    echo '{"status": "finished"}' | tee output/summary.json >output/refinement-9/summary.json
    touch output/study.svg output/refinement-9/history.csv output/refinement-0.7/notes.txt \
      output/refinement-0.7/vtu/particles_00000.vtu output/other/history.csv
    cp -r output before
    expect_code 2 "$sandglass" --study convergence "$scene" -o output -s "Scene/Outlet=closed"
    diff -r before output || fail "refused input has changed the directory"
    "$sandglass" --study convergence "$root/tests/regression/study.prm" --quiet -o output \
      -s "Particle stage/Time step=1e-6" &
    first=$!
    trap 'kill -9 $first 2>/dev/null || true' EXIT
    wait_for test -s output/refinement-0.5/history.csv
    expect_status running output
    for name in study.svg refinement-9 refinement-0.7/vtu; do
      [ ! -e output/$name ] || fail "$name of an older study is there"
    done
    [ -e output/refinement-0.7/notes.txt ] && [ -e output/other/history.csv ] ||
      fail "the user's files are gone"
    expect_code 2 "$sandglass" --study convergence "$root/tests/regression/study.prm" -o output
    grep -q "another run is writing there" message.txt || fail "$(cat message.txt)"
    kill -TERM $first
    code=0
    wait $first || code=$?
    [ $code -eq 143 ] || fail "exit code $code, expected 143"
    expect_status stopped output "Stopped by SIGTERM"
    ;;

  signals)
    # signal_run SIGNAL CODE RANKS: to one rank only.
    signal_run()
    {
      local output=$1.$3 launcher=() pid code=0
      [ "$3" -eq 0 ] || read -r -a launcher <<<"$mpiexec $3"
      # A shell's background jobs ignore SIGINT unless jobs are controlled.
      set -m
      "${launcher[@]}" "$sandglass" "${long_run[@]}" -o "$output" 2>"$output.txt" </dev/null &
      pid=$!
      set +m
      wait_for has_rows "$output"
      if [ "$3" -eq 0 ]; then
        kill -"$1" $pid
      else
        kill -"$1" "$(pgrep -P $pid -x sandglass | tail -n 1)"
      fi
      wait $pid || code=$?
      [ $code -eq "$2" ] || fail "$1 on $3 ranks: exit code $code, expected $2"
      expect_status stopped "$output" "Stopped by SIG$1 at t = "
      [ "$(grep -c "Stopped by SIG$1 at t = .*--restart" "$output.txt")" = 1 ] ||
        fail "the message isn't there once"
      [ -s "$output/checkpoint.bin" ] || fail "$1 on $3 ranks: there is no checkpoint"
      expect_code 0 "${launcher[@]}" "$sandglass" "${long_run[@]}" -o "$output" --restart \
        -s "Particle stage/End time=$(awk -v t="$(key end_time_s "$output")" 'BEGIN { print t + 1e-4 }')"
      expect_status finished "$output"
    }
    signal_run TERM 143 0
    signal_run INT 130 0
    signal_run TERM 143 2

    # In the state at rest there is no checkpoint yet.
    "$sandglass" "$root/prm/quickstart.prm" --quiet -o rest -s "Scene/Element size=0.01" \
      2>message.txt &
    pid=$!
    wait_for is_running rest
    kill -TERM $pid
    code=0
    wait $pid || code=$?
    [ $code -eq 143 ] || fail "exit code $code in the state at rest, expected 143"
    expect_status stopped rest "before the state at rest was found"
    [ ! -e rest/checkpoint.bin ] || fail "a checkpoint of no state"
    ;;

  disk)
    # A file system of its own, where that is allowed.
    if [ "${3:-}" != inside ]; then
      as=()
      [ "$(id -u)" -eq 0 ] || as=(-r)
      if ! unshare "${as[@]}" -m mount -t tmpfs none "$directory" 2>/dev/null; then
        echo "no file system can be mounted here"
        exit 77
      fi
      exec unshare "${as[@]}" -m bash "$root/tests/scripts/directory.sh" "$1" disk inside
    fi
    mkdir disk
    mount -t tmpfs -o size=200k none disk
    expect_code 1 "$sandglass" "${short_run[@]}" -o disk/run -s "Output/Particles=true" \
      -s "Output/Interval=0.002" -s "Output/Checkpoint interval=0"
    grep -q "^The disk is full: 'disk/run/.*Make room" message.txt || fail "$(cat message.txt)"
    expect_status failed disk/run "The disk is full: 'disk/run/"
    # What is there is whole.
    [ "$(tail -c 1 disk/run/history.csv | xxd -p)" = 0a ] || fail "history.csv ends in a row"
    ls disk/run/*.new disk/run/vtu/*.new 2>/dev/null && fail "unfinished files are left"
    # With a checkpoint that doesn't fit.
    expect_code 1 "$sandglass" "${short_run[@]}" -o disk/run -s "Scene/Element size=0.02" \
      -s "Output/Checkpoint interval=1e-3"
    expect_status failed disk/run "The disk is full: 'disk/run/checkpoint.bin'"
    # Not even a summary.
    rm -r disk/run
    dd if=/dev/zero of=disk/all bs=1k 2>/dev/null || true
    expect_code 1 "$sandglass" "${short_run[@]}" -o disk/run
    grep -q "^The disk is full: " message.txt || fail "$(cat message.txt)"
    umount disk
    ;;

  memory)
    # What there is of it is halved in between what is too little to begin, and
    # enough, until it runs out in the middle. Libraries may abort then.
    too_little=100
    enough=3000
    n_failed=0
    while [ $((enough - too_little)) -gt 10 ]; do
      megabytes=$(((too_little + enough) / 2))
      rm -rf output
      code=0
      (ulimit -c 0 && ulimit -v $((megabytes * 1024)) && exec "$sandglass" "${short_run[@]}" \
        -s "Particle stage/Time step=auto" -o output -s "Scene/Element size=0.004") \
        >screen.txt 2>message.txt </dev/null || code=$?
      echo "$megabytes MB: exit code $code, $(head -n 1 message.txt)"
      if [ ! -e output/summary.json ]; then
        too_little=$megabytes
        continue
      fi
      enough=$megabytes
      case $code in
        0) expect_status finished output ;;
        1)
          expect_status failed output "There is not enough memory. Try larger cells"
          grep -q "^There is not enough memory" message.txt || fail "$(cat message.txt)"
          n_failed=$((n_failed + 1))
          ;;
        *) expect_status running output ;;
      esac
    done
    [ $n_failed -gt 0 ] || fail "it has never run out in the middle"
    ;;

  elsewhere)
    # A run that goes on in another directory takes along what there is, and
    # what it went on from stays as it was.
    outputs=(-s "Output/Particles=true" -s "Output/Grid=true" -s "Output/Walls=true"
      -s "Output/Interval=0.02" -s "Output/Checkpoint interval=0.03")
    "$sandglass" "${short_run[@]}" "${outputs[@]}" -o whole -s "Particle stage/End time=0.1"
    "$sandglass" "${short_run[@]}" "${outputs[@]}" -o first -s "Particle stage/End time=0.07"
    cp -r first before
    mkdir other
    touch other/notes.txt other/checkpoint.bin other/summary.json
    # From the one before the last, which is that of t = 0.06 s.
    "$sandglass" "${short_run[@]}" "${outputs[@]}" -o other \
      -s "Particle stage/End time=0.1" --restart-from first/checkpoint-before.bin
    diff -r before first || fail "what it went on from has changed"
    for name in history.csv flow_rate.csv vtu; do
      diff -r whole/$name other/$name || fail "$name differs"
    done
    grep -q "Goes on from first/checkpoint-before.bin, t = 0.06" other/sandglass.log ||
      fail "the log doesn't say from where"
    [ -e other/notes.txt ] || fail "the user's file is gone"

    # Back in the first directory, with another end: fields after it are gone.
    "$sandglass" "${short_run[@]}" "${outputs[@]}" -o whole --restart-from whole/checkpoint-before.bin \
      -s "Particle stage/End time=0.095" -s "Output/Interval=1"
    listed=$(grep -c DataSet whole/particles.pvd)
    [ "$(find whole/vtu -name 'particles_*' | wc -l)" = "$listed" ] || fail "fields that no .pvd lists"

    # Tables that the checkpoint doesn't belong to.
    cp -r before table
    expect_restart_refusal()
    {
      cp -r table table.before
      expect_code 2 "$sandglass" "${short_run[@]}" "${outputs[@]}" -o table --restart \
        -s "Particle stage/End time=0.2"
      grep -q "$1" message.txt || fail "$(cat message.txt)"
      diff -r table.before table || fail "a refused restart has changed something"
      rm -rf table table.before
      cp -r before table
    }
    sed -i '1s/,/,another_column,/' table/history.csv
    expect_restart_refusal "'table/history.csv' is not the table .* other columns"
    head -n 3 before/flow_rate.csv >table/flow_rate.csv
    expect_restart_refusal "'table/flow_rate.csv' is not the table .* it is shorter"
    rm table/wall_traction.csv
    expect_restart_refusal "'table/wall_traction.csv' is not the table .* it isn't there"
    rm table/checkpoint.bin
    expect_restart_refusal "there is no 'table/checkpoint.bin'.* --restart-from table/checkpoint-before.bin"
    printf x | dd of=table/checkpoint.bin bs=1 seek=2000 conv=notrunc 2>/dev/null
    expect_restart_refusal "'table/checkpoint.bin' is damaged.* --restart-from table/checkpoint-before.bin"
    expect_code 2 "$sandglass" "${short_run[@]}" -o nowhere --restart
    [ ! -e nowhere ] || fail "a refused restart has made a directory"
    ;;

  empty)
    expect_code 2 "$sandglass" "${short_run[@]}" -o ""
    grep -q "^Command line: --output ''" message.txt || fail "$(cat message.txt)"
    expect_code 2 "$sandglass" "${short_run[@]}" -s "Output/Directory="
    grep -q "parameter 'Directory', value ''" message.txt || fail "$(cat message.txt)"
    [ "$(ls)" = "$(printf 'message.txt\nscreen.txt')" ] || fail "files are left"
    ;;

  tells)
    scene_and_settings=("$root/prm/quickstart.prm" -s "Particle stage/End time=0.6"
      -s "Output/Progress interval=0.001" -s "Output/Interval=0.2")
    "$sandglass" "${scene_and_settings[@]}" -o told >screen.txt
    cat screen.txt
    for text in "^Results go to told$" "^State at rest: .* % of the weight, .* left$" \
      "^t = .* of 0.6 s, .* left$" "^Discharged .* of 4080 kg/m; .* still in the silo" \
      "^Flow rate 1[0-9]*\(\.[0-9]*\)\? kg/(s m) .*Beverloo's is 15" \
      "^Largest wall pressure .* kPa on '.*' at x = .* m, y = .* m, t = .* s" \
      "^Results are in told; .*: sandglass-report told$"; do
      grep -q "$text" screen.txt || fail "the screen lacks $text"
    done
    diff <(grep -v "^t = \|^State at rest" screen.txt) \
      <(grep -v "^t = \|^State at rest" told/sandglass.log) || fail "the log has another text"
    "$sandglass" "${scene_and_settings[@]}" -o told --quiet >screen.txt
    [ ! -s screen.txt ] || fail "--quiet prints"
    # shellcheck disable=SC2086 # it is several words
    $mpiexec 2 "$sandglass" "${scene_and_settings[@]}" -o told >screen.txt
    [ "$(grep -c "Results go to told" screen.txt)" = 1 ] || fail "two ranks speak"
    [ "$(grep -c "sandglass-report told" screen.txt)" = 1 ] || fail "two ranks speak"
    # The largest pressure is one of the table's.
    awk -F , -v wanted="$(key largest_wall_pressure_Pa told)" '
      NR > 1 && !($1 == 0 && $2 == "outlet") && $6 > largest { largest = $6 }
      END { print largest, wanted; exit !(largest == wanted) }' told/wall_traction.csv ||
      fail "the largest pressure is another"
    ;;

  *)
    fail "directory.sh: unknown case"
    ;;
esac
