#!/usr/bin/env bash
# Check that doc/parameters.md is what the program prints; ctest calls this.
set -euo pipefail
source "$1" # sandglass, mpiexec, numdiff, root, scratch

if ! "$sandglass" --print-parameters md | diff "$root/doc/parameters.md" -; then
  echo "doc/parameters.md is out of date: run ./dev doc and commit it"
  exit 1
fi
