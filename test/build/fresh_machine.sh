#!/bin/sh
# Runs both commands of the README in bare systems, from a clean checkout of the last commit,
# as somebody would who has just found acmap. Tells the minutes of each part, and checks that
# the second command compiles nothing again. Needs root, debootstrap, the network, 12 GB and
# an hour for each release; therefore ctest does not run it.
set -eu

usage="usage: sh test/build/fresh_machine.sh [RELEASE...]    [bookworm trixie]"
source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
[ $# -gt 0 ] || set -- bookworm trixie
case $1 in
-*)
  echo "$usage" >&2
  exit 2
  ;;
esac
work=$source/build/bare
. "$source/test/build/bare_system.sh"

# minutes_of NAME: runs the script on stdin in the bare system; a line for the table.
minutes_of() {
  say "$release: $1"
  started=$(date +%s)
  inside
  seconds=$(($(date +%s) - started))
  table="$table$(printf '| %-9s | %-34s | %7d |' "$release" "$1" $(((seconds + 30) / 60)))
"
}

try_release() {
  root=$work/$release
  make_root
  mkdir "$root/acmap"
  git -C "$source" archive HEAD | tar -C "$root/acmap" -xf -
  minutes_of "packages" <<'END'
cd /acmap
sh cmake/bootstrap deps build picture
END
  minutes_of "bootstrap demo" <<'END'
cd /acmap
sh cmake/bootstrap demo
find build/release -name '*.o' -printf '%p %T@\n' | sort >/objects
for file in map/map.glb map/map.html map/report.html map/pictures/outside.png; do
  test -s "acmap-demo/$file"
done
END
  minutes_of "more packages" <<'END'
cd /acmap
sh cmake/bootstrap deps
END
  minutes_of "bootstrap test" <<'END'
cd /acmap
sh cmake/bootstrap test
find build/release -name '*.o' -printf '%p %T@\n' | sort >/objects_after
END
  again=$(comm -23 "$root/objects" "$root/objects_after" | wc -l)
  table="$table$(printf '| %-9s | %-34s | %7d |' "$release" "objects compiled again by the test" "$again")
"
}

table=
for release in "$@"; do
  try_release
done
say "all passed"
printf '| release   | part                               | minutes |\n%s' "$table"
