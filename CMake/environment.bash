# SPDX-License-Identifier: BSD-3-Clause
# For ./quickstart and ./runtests: the system, its packages, and how many compilers it can carry. To be sourced.

fail()
{
  echo "${0##*/}: $*" >&2
  exit 1
}

# Sets debian_release: 12 or 13.
require_debian()
{
  local id=""
  debian_release=""
  if [[ -r /etc/os-release ]]; then
    id=$(. /etc/os-release && echo "${ID:-}")
    debian_release=$(. /etc/os-release && echo "${VERSION_ID:-}")
  fi
  if [[ "${id}" != debian || ! "${debian_release}" =~ ^1[23]$ ]]; then
    fail "this script is made for Debian 12 (bookworm) and 13 (trixie); this is '${id:-unknown} ${debian_release}'." \
      "Elsewhere install what corresponds to CMake/packages-debian.txt (VTK 9.1, CGAL 5.5 or later), then:" \
      "cmake -S . -B build && cmake --build build && ctest --test-dir build"
  fi
}

# packages_of GROUP...: the names listed under these groups for this release.
packages_of()
{
  local group
  for group in "$@"; do
    awk -v group="[${group}]" -v release="${debian_release}" \
      '/^#/ || !NF { next } /^\[/ { on = ($1 == group); next } on && (NF == 1 || $2 == release) { print $1 }' \
      CMake/packages-debian.txt
  done
}

# install_packages GROUP...: with apt-get, and only what is missing, so that a second call needs neither rights nor network.
install_packages()
{
  local wanted missing=() package
  mapfile -t wanted < <(packages_of "$@")
  for package in "${wanted[@]}"; do
    if [[ "$(dpkg-query -W -f='${db:Status-Status}' "${package}" 2> /dev/null || true)" != installed ]]; then
      missing+=("${package}")
    fi
  done
  if ((${#missing[@]} == 0)); then
    return
  fi
  local as_root=()
  if ((EUID != 0)); then
    command -v sudo > /dev/null || fail "these packages are missing, and there is no sudo to install them:" "${missing[@]}"
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# As many jobs as there are processors, but no more than one for each 2 GB of memory: CGAL and VTK sources need it.
build_jobs()
{
  local processors memory jobs
  processors=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 2000000) }' /proc/meminfo)
  jobs=$((memory < processors ? memory : processors))
  echo $((jobs < 1 ? 1 : jobs))
}
