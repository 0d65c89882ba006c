#!/bin/sh
# Tests the Debian packages in a minimal Debian of this machine's release: do the tools
# run, can other projects build with the headers, does anything remain after removing
# the packages? Needs root, debootstrap, the network, 4 GB and ten minutes; therefore
# ctest does not run it.
set -eu

usage="usage: sh test/build/packages.sh [FOLDER]    FOLDER: of the .deb files [build/package]"
source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
packages=$(CDPATH='' cd -- "${1:-$source/build/package}" && pwd) || {
  echo "$usage" >&2
  exit 2
}
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
work=$source/build/bare
root=$work/root

. "$source/test/build/bare_system.sh"

# with_helpers: the script on stdin inside the bare system can use: get PACKAGE..., never
# COMMAND...
with_helpers() {
  {
    cat <<'END'
get() {
  apt-get -q -y -o Dpkg::Options::=--force-unsafe-io -o Dpkg::Use-Pty=0 \
    install --no-install-recommends "$@"
}
never() {
  if "$@"; then
    echo "packages.sh: that should not be" >&2
    exit 1
  fi
}
END
    cat
  } | inside
}

# list_files FILE: existing files, except those of the kernel and of this test.
list_files() {
  (cd "$root" && find . \( -path ./proc -o -path ./sys -o -path ./dev -o -path ./try \) \
    -prune -o -print) | LC_ALL=C sort >"$1"
}

# Acts as a user who only needs the tools.
use_tools() {
  say "libraries and tools"
  with_helpers <<'END'
apt-get -q update
get /try/libacmap[0-9]*.deb /try/acmap-tools_*.deb
for tool in $(dpkg -L acmap-tools | grep ^/usr/bin/); do
  echo "$($tool --version) in $tool"
done
cd /try
pcl_simulated_rig -o clouds --observations 2 --clouds
pcl_simulated_rig -o raw --observations 1 --patterns 4 --cameras /usr/share/acmap/rigs/digiclops_built.yaml
pcl_active_stereo raw -o observations
pcl_dewall_surface clouds/observation_0000.pcd mesh.ply --consolidate
pcl_plane_extraction mesh.ply planes.json
get $(dpkg-query -W -f '${Suggests}' acmap-tools | tr -d ,)
xvfb-run -a -s "-screen 0 1280x960x24" pcl_compact_viewer mesh.ply --screenshot mesh.png
xvfb-run -a -s "-screen 0 1280x960x24" pcl_compact_mapping clouds -o map
get openmpi-bin
mpirun --allow-run-as-root --oversubscribe -n 2 pcl_compact_mapping clouds -o ranks --no-pictures
cmp map/map.json ranks/map.json
END
}

# Acts as a programmer: builds an outside project, and each example.
use_headers() {
  say "headers"
  with_helpers <<'END'
get /try/libacmap-dev_*.deb g++ cmake make
readelf -d /usr/bin/pcl_* /usr/lib/*/libacmap_* >/try/dynamic.txt
never grep -E 'RPATH|RUNPATH' /try/dynamic.txt
cd /try
for project in consumer consumer_mpi examples/[0-9]*; do
  cmake -S "$project" -B build/"$project" -DCMAKE_BUILD_TYPE=Release
  cmake --build build/"$project"
done
build/consumer/mesh_grid
mpirun --allow-run-as-root --oversubscribe -n 2 build/consumer_mpi/pass_around
END
}

use_module() {
  [ -e "$(echo "$packages"/python3-acmap_*.deb)" ] || return 0
  say "Python module"
  with_helpers <<'END'
get /try/python3-acmap_*.deb
python3 -c 'import acmap; print(acmap.__file__)'
END
}

# purge: removes our packages and their dependencies, then lists what remains of them.
purge() {
  say "purge"
  with_helpers <<'END'
ours=$(dpkg-query -W -f '${Package}\n' | grep acmap)
for package in $ours; do
  dpkg -L "$package"
done | sort -u >/try/owned.txt
apt-get -q -y -o Dpkg::Use-Pty=0 purge $ours
dpkg-query -W >/try/packages.txt
ldconfig -p >/try/libraries.txt
never grep acmap /try/packages.txt /try/libraries.txt
apt-get -q -y -o Dpkg::Use-Pty=0 autoremove --purge >/dev/null
END
  list_files "$work/after.txt"
  LC_ALL=C comm -13 "$work/before.txt" "$work/after.txt" >"$work/stayed.txt"
  sed 's/^/./' "$root/try/owned.txt" >"$work/owned.txt"
  if grep -Fx -f "$work/owned.txt" "$work/stayed.txt" || grep acmap "$work/stayed.txt"; then
    echo "packages.sh: that stays of acmap" >&2
    exit 1
  fi
  echo "nothing stays of acmap; of the packages it needed, $(wc -l <"$work/stayed.txt") files"
}

make_root
mkdir "$root/try"
cp "$packages"/*.deb "$source/test/consumer" "$source/test/consumer_mpi" "$source/share/examples" \
  "$root/try" -r
list_files "$work/before.txt"
use_tools
use_headers
use_module
purge
say "all passed; pictures and results are in $root/try"
