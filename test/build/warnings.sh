#!/bin/sh
# Compiles product and tests with each compiler of a Debian, at -O2 and -O3, in a bare system;
# tells the number of warnings of each. Needs root, debootstrap, the network, 6 GB and ten
# minutes for each compiler and level; therefore neither ctest nor CI run it.
set -eu

usage="usage: sh test/build/warnings.sh [COMPILER...]    of trixie [g++-12 g++-13 g++-14 clang++-19]"
source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
[ $# -gt 0 ] || set -- g++-12 g++-13 g++-14 clang++-19
case $1 in
-*)
  echo "$usage" >&2
  exit 2
  ;;
esac
release=${ACMAP_RELEASE:-trixie}
work=$source/build/bare
root=$work/warnings
. "$source/test/build/bare_system.sh"

make_root
mkdir "$root/acmap"
git -C "$source" archive HEAD | tar -C "$root/acmap" -xf -
say "$release: packages"
inside <<END
cd /acmap
sh cmake/bootstrap deps build python test
apt-get -q -y -o Dpkg::Use-Pty=0 install --no-install-recommends \
  $(echo "$@" | sed 's/clang++/clang/g') >/dev/null
END

table=
total=0
for compiler in "$@"; do
  for level in 2 3; do
    say "$compiler -O$level"
    log=$work/warnings_${compiler}_O$level.log
    inside >"$log" 2>&1 <<END || true
cd /acmap
rm -rf tree
cmake -S . -B tree -G Ninja -DCMAKE_CXX_COMPILER=$compiler -DCMAKE_C_COMPILER=$(echo "$compiler" | sed 's/++-/-/; s/^g-/gcc-/') \
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O$level -DNDEBUG" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 \
  -DACMAP_BUILD_PYTHON=ON
CCACHE_DISABLE=1 ninja -C tree -j 2 -k 0
END
    # Programs of an older compiler may not be linked with libraries of the release's own.
    if ! grep -q 'Building CXX' "$log" || grep -q '^FAILED: .*\.o ' "$log"; then
      tail -n 20 "$log"
      echo "warnings.sh: $compiler -O$level does not compile, see $log" >&2
      exit 1
    fi
    count=$(grep -c 'warning: ' "$log" || true)
    total=$((total + count))
    grep 'warning: ' "$log" | sort | uniq -c || true
    table="$table$(printf '| %-10s | -O%d | %8d |' "$compiler" "$level" "$count")
"
  done
done
printf '\n| compiler   |     | warnings |\n|------------|-----|----------|\n%s' "$table"
[ "$total" -eq 0 ]
