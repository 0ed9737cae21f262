# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Releases of Debian in folders, for tools/compat, tools/package-test and tools/wheel-test; to be sourced by bash. They lie in
# $MESHQUALITY_COMPAT (default ~/.cache/meshquality/compat). Needs root, for chroot and mount.

roots="${MESHQUALITY_COMPAT:-${XDG_CACHE_HOME:-$HOME/.cache}/meshquality/compat}"

# own_mounts SCRIPT ARGUMENT...: starts the script anew, with mounts that only it and its children see and with no child
# that outlives it: however it ends, nothing stays mounted, and nothing that clears a folder reaches the machine's /dev.
own_mounts() {
    local program
    if ((EUID != 0)); then
        echo "$1: needs root, for chroot and mount" >&2
        exit 2
    fi
    for program in debootstrap git unshare; do
        if [[ -z $(command -v "$program") ]]; then
            echo "$1: $program is not installed" >&2
            exit 2
        fi
    done
    if [[ -z ${MESHQUALITY_OWN_MOUNTS:-} ]]; then
        MESHQUALITY_OWN_MOUNTS=1 exec unshare --mount --propagation private --pid --fork --kill-child bash "$@"
    fi
}

# The mirror of Debian itself among the sources of this machine's apt.
mirror() {
    local found
    found="$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' \
        2>/dev/null | head -n 1 || true)"
    echo "${found:-http://deb.debian.org/debian}"
}

# install_release RELEASE FOLDER: the least of a release, unless it is there. The debootstrap of an older Debian knows a
# newer release by the script alone that serves all of them: sid's.
install_release() {
    local release="$1" root="$2"
    if [[ -f $root/.installed ]]; then
        return
    fi
    rm -rf "$root"
    mkdir -p "$root"
    debootstrap --variant=minbase --include=ca-certificates "$release" "$root" "$(mirror)" \
        /usr/share/debootstrap/scripts/sid
    # No service may start, no manual is read here, and a mirror may be some weeks behind.
    printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"
    chmod +x "$root/usr/sbin/policy-rc.d"
    printf 'path-exclude=/usr/share/man/*\npath-exclude=/usr/share/doc/*\n' >"$root/etc/dpkg/dpkg.cfg.d/small"
    echo force-unsafe-io >>"$root/etc/dpkg/dpkg.cfg.d/small" # a root that is lost can be made again
    echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/mirror"
    touch "$root/.installed"
}

# mount_system ROOT: what programs need to run in it.
mount_system() {
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    cp -L /etc/resolv.conf "$1/etc/resolv.conf"
}

# mount_data ROOT: $MESHQUALITY_DATA in it, to be read alone, as /data.
mount_data() {
    if [[ -n ${MESHQUALITY_DATA:-} ]]; then
        mkdir -p "$1/data"
        mount --bind "$MESHQUALITY_DATA" "$1/data"
        mount -o remount,ro,bind "$1/data"
    fi
}

# enter ROOT FOLDER [NAME=VALUE...] -- COMMAND...: runs it there, with an environment that owes nothing to this machine.
enter() {
    local root="$1" folder="$2" variables=()
    shift 2
    while [[ $1 != -- ]]; do
        variables+=("$1")
        shift
    done
    shift
    chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "${variables[@]}" \
        bash -c 'cd "$0" && "$@"' "$folder" "$@"
}
