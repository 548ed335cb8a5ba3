#!/usr/bin/env bash
# Run the program on input that it must refuse; ctest calls this.
#
#   refused_input.sh SETTINGS NAME RANKS     (RANKS 0: without mpirun)
#
# The program must end with exit code 2, say once on stderr what every line of
# NAME.expected holds, and leave no file behind.
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, mpiexec, numdiff, root, scratch
name=$2
ranks=$3
folder=$root/tests/input
expected=$folder/$name.expected
launcher=()
if [ "$ranks" -gt 0 ]; then
  expected=$folder/$name.mpirun=$ranks.expected
  launcher=($mpiexec "$ranks")
fi

# The program runs in a directory that holds its input and one plain file,
# `a-file`, below which nothing can be written, not even by root.
directory=$scratch/input/$name.$ranks
messages=$directory.stderr
rm -rf "$directory" "$messages"*
mkdir -p "$directory"
cd "$directory"
touch a-file
for file in "$folder/$name.prm" "$folder/$name.msh"; do
  if [ -f "$file" ]; then
    cp "$file" .
  fi
done
ls -A >"$messages.before"

arguments=()
if [ -f "$folder/$name.command" ]; then
  eval "arguments=($(cat "$folder/$name.command"))"
fi
case " ${arguments[*]} " in
  *" -o "*) ;;
  *) arguments+=(-o output) ;;
esac

# Each rank writes into a file of its own: mpirun adds lines to stderr.
code=0
"${launcher[@]}" sh -c 'exec "$@" 2>"$0.${OMPI_COMM_WORLD_RANK:-0}"' "$messages" \
  "$sandglass" "$name.prm" "${arguments[@]}" \
  >"$messages.mpirun" 2>&1 </dev/null || code=$?
cat "$messages".[0-9]* >"$messages"
ls -A >"$messages.after"

failed=0
complain()
{
  echo "FAILED: $*"
  failed=1
}

if [ $code -ne 2 ]; then
  complain "the exit code is $code, expected 2"
fi
if [ ! -s "$messages" ]; then
  complain "nothing on stderr"
fi
# One message: the lines that hold an expected text are there once, and there
# is neither deal.II's own report nor an abort's. (Libraries may add warnings.)
while IFS= read -r text || [ -n "$text" ]; do
  lines=$(grep -F -e "$text" "$messages" || true)
  if [ -z "$lines" ]; then
    complain "the message lacks: $text"
  elif [ -n "$(sort <<<"$lines" | uniq -d)" ]; then
    complain "said more than once: $text"
  fi
done < <(grep -v '^[[:space:]]*$' "$expected")
if grep -E 'An error occurred in line|terminate called|MPI_ABORT|Stacktrace' "$messages"; then
  complain "the message is not the program's own"
fi
if ! diff "$messages.before" "$messages.after"; then
  complain "files were left behind"
fi

if [ $failed -ne 0 ]; then
  echo "--- stderr:"
  cat "$messages"
  exit 1
fi
