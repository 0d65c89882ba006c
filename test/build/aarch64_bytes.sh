#!/bin/sh
# Compares the files that tools make of a cloud on this machine with those of the same tools for
# aarch64, in an emulator. After sh cmake/bootstrap aarch64.
# usage: sh test/build/aarch64_bytes.sh FOLDER_OF_TOOLS CLOUD
set -eu

[ $# -eq 2 ] || {
  sed -n 's/^# usage/usage/p' "$0" >&2
  exit 2
}
native=$1
cloud=$2
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
emulator="qemu-aarch64 -L $root/build/aarch64-sysroot"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# run NAME PROGRAM_PREFIX FOLDER_OF_TOOLS
run() {
  mkdir "$folder/$1"
  $2 "$3/pcl_dewall_surface" --quiet "$cloud" "$folder/$1/raw.ply"
  $2 "$3/pcl_dewall_surface" --quiet --rule dense "$cloud" "$folder/$1/dense.ply"
  $2 "$3/pcl_dewall_surface" --quiet --consolidate "$cloud" "$folder/$1/consolidated.ply"
  $2 "$3/pcl_plane_extraction" --quiet --normals "$folder/$1/normals.ply" \
    --labels "$folder/$1/labels.pcd" "$cloud" "$folder/$1/planes.json"
}

run here "" "$native"
run there "$emulator" "$root/build/aarch64/bin"
for file in "$folder"/here/*; do
  name=$(basename "$file")
  if cmp -s "$file" "$folder/there/$name"; then
    echo "same:    $name"
  else
    echo "differs: $name"
  fi
done
