#!/usr/bin/env bash
# Check that a page of doc/ is what the program prints; ctest calls this.
#
#   documentation.sh SETTINGS PAGE OPTION...     PAGE below doc/
set -euo pipefail
source "$1" # sandglass, mpiexec, numdiff, root, scratch
page=$2

if ! "$sandglass" "${@:3}" | diff "$root/doc/$page" -; then
  echo "doc/$page is out of date: run ./dev doc and commit it"
  exit 1
fi
