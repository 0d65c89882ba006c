#!/bin/sh
# Applies the diff blocks of a page to the programs of this folder.
# Usage: apply_diffs.sh PAGE FOLDER COUNT
# Writes the changed programs into FOLDER. Fails unless there are COUNT blocks, each of
# which changes at most 5 lines; a line that is replaced counts once.
set -eu
page=$1 folder=$2 count=$3
rm -rf "$folder"
mkdir -p "$folder"
awk -v folder="$folder" -v count="$count" '
  function endOfRun() {
    changed += removed > added ? removed : added
    removed = added = 0
  }
  /^```diff$/ { inside = 1; changed = 0; name = ""; next }
  inside && /^```$/ {
    endOfRun()
    inside = 0
    ++blocks
    print name ": " changed " lines are changed"
    if (changed == 0 || changed > 5)
      failed = 1
  }
  !inside { next }
  /^--- a\// { name = substr($2, 3) }
  { print > (folder "/" name ".diff") }
  /^(---|\+\+\+) / { next }
  /^-/ { ++removed; next }
  /^\+/ { ++added; next }
  { endOfRun() }
  END {
    if (blocks != count)
      print blocks " blocks of " count
    exit failed || blocks != count
  }' "$page"
for change in "$folder"/*.diff; do
  name=$(basename "$change" .diff)
  patch --quiet --fuzz=0 --output="$folder/$name" "$name" "$change"
done
