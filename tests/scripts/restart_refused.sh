#!/usr/bin/env bash
# Run a scene, change one thing, and restart: what has been computed must not go
# on with another silo. ctest calls this.
#
#   restart_refused.sh SETTINGS
set -euo pipefail
export LC_ALL=C

source "$1" # sandglass, root, scratch
name=restart-refused
directory=$scratch/restart_refused
rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"
cp "$root/tests/regression/$name".{prm,msh} .
cp $name.msh original.msh

"$sandglass" $name.prm --quiet
cp -r output before
later=(-s "Particle stage/End time=0.03")

# expect_refusal TEXT [ARGUMENTS]: the message must hold the text, and nothing be
# written.
expect_refusal()
{
  local code=0
  "$sandglass" $name.prm --quiet --restart "${@:2}" 2>message.txt || code=$?
  if [ $code -ne 2 ] || ! grep -qF -e "$1" message.txt || ! diff -r before output; then
    echo "exit code $code, expected 2 and: $1"
    cat message.txt
    exit 1
  fi
}

# change_mesh SED-SCRIPT
change_mesh()
{
  sed "$1" original.msh >$name.msh
}

expect_refusal "'End time', value '0.02': --restart: allowed is later than the time of 'output/checkpoint.bin', 0.02 s"
expect_refusal "'End time', value '0.01'" -s "Particle stage/End time=0.01"
expect_refusal "Walls/Friction angle = 20, and now it is 25" "${later[@]}" -s "Walls/Friction angle=25"
expect_refusal "Static stage/Load steps = 5, and now it is 6" "${later[@]}" -s "Static stage/Load steps=6"
change_mesh 's/"floor"/"hopper"/'
expect_refusal "floor 1, outlet 1" "${later[@]}"
change_mesh '/ 3 2 9 9 /s/9 9/8 8/'
expect_refusal "filled in another way" "${later[@]}"
change_mesh 's/^11 0.4 0.4 0$/11 0.4 0.45 0/'
expect_refusal "Scene/mesh = 5 cells, 11 nodes" "${later[@]}"

# What is free to change, another name of the same mesh among it.
cp original.msh renamed.msh
"$sandglass" $name.prm --quiet --restart "${later[@]}" -s "Scene/Mesh file=renamed.msh" \
  -s "Particle stage/Time step=5e-4" -s "Output/Interval=0.01"
