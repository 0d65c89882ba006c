# A bare system of a release of Debian or Ubuntu, to try acmap in as somebody who has just
# installed it; to be sourced. Needs root, debootstrap (sh cmake/bootstrap deps fresh) and the
# network. Variables: source, the checkout; release; work, a folder for it; root, the system.

say() {
  printf '\n== %s\n' "$*"
}

# Creates the bare system once and keeps it packed, then unpacks it anew.
make_root() {
  mkdir -p "$work"
  if [ ! -e "$work/$release.tar" ]; then
    debootstrap --variant=minbase "$release" "$work/new" >"$work/$release.log"
    # a proxy, and what else apt needs to reach its archives from here
    cp /etc/apt/apt.conf.d/* "$work/new/etc/apt/apt.conf.d"
    tar -C "$work/new" -cf "$work/new.tar" .
    mv "$work/new.tar" "$work/$release.tar"
    rm -rf "$work/new"
  fi
  rm -rf "$root"
  mkdir "$root"
  tar -C "$root" -xf "$work/$release.tar"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
}

# Runs the script on stdin in the bare system, in its own process namespace: no process
# outlives it. It has /proc, /sys and /dev, as any system: without /sys, MPI tells that it
# knows no processors.
inside() {
  unshare --mount --pid --fork sh -eu -c '
    mount -t proc proc "$1/proc"
    mount --rbind /sys "$1/sys"
    mount --rbind /dev "$1/dev"
    exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
      DEBIAN_FRONTEND=noninteractive sh -eu' inside "$root"
}
