# SPDX-License-Identifier: BSD-3-Clause
# For try_debs and try_debian13: a clean Debian made by debootstrap. To be sourced; as root; sets root, sources and start.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
sources=$(cd "${here}/../.." && pwd)
start=${SECONDS}

# Where this machine has its own Debian packages from: the archive has those of the other releases too.
host_mirror()
{
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' 'Component: main' | head -n 1
}

leave_system()
{
  umount "${root}/proc" "${root}/sys" 2> /dev/null || true
  if [[ -z "${MT_CLEAN_SYSTEM:-}" ]]; then
    rm -rf --one-file-system "${root}"
  fi
}

# make_system SUITE [MIRROR]: in a folder that goes at the end, or in MT_CLEAN_SYSTEM, which stays, for another run to go on with.
make_system()
{
  local suite=$1 mirror=${2:-$(host_mirror)}
  [[ -n "${mirror}" ]] || { echo "apt has no list of Debian's packages (apt-get update); or name a MIRROR" >&2; exit 1; }
  root=${MT_CLEAN_SYSTEM:-$(mktemp -d)}
  trap leave_system EXIT
  if [[ ! -e "${root}/etc/debian_version" ]]; then
    debootstrap --variant=minbase "${suite}" "${root}" "${mirror}" > "${root}.log" 2>&1 || { tail "${root}.log"; exit 1; }
    if [[ -e /etc/apt/apt.conf.d ]]; then
      cp -r /etc/apt/apt.conf.d/. "${root}/etc/apt/apt.conf.d/" # proxies
    fi
    echo force-unsafe-io > "${root}/etc/dpkg/dpkg.cfg.d/unsafe-io" # a thousand packages in a system that may be made again
  fi
  mountpoint -q "${root}/proc" || mount -t proc proc "${root}/proc"
  mountpoint -q "${root}/sys" || mount -t sysfs -o ro sysfs "${root}/sys" # MPI looks for processors there
  echo "a clean ${suite} after $((SECONDS - start)) s"
}

# inside COMMANDS: run by bash in the clean system.
inside()
{
  chroot "${root}" env DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root bash -euo pipefail -c "$1"
}
