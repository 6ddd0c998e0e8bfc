# SPDX-License-Identifier: BSD-3-Clause
# ParaView (5.11 on Debian 12, 5.13 on 13) for ./runtests, beside Debian's VTK: python3-paraview cannot be installed where
# python3-vtk9 is, and paraview-dev's CMake files look for it beside themselves. So what they need is installed, and the three
# packages themselves are only unpacked, into a folder of their own. To be sourced after environment.bash.

# Where ParaView is unpacked: MT_PARAVIEW_PREFIX, or a folder in the build tree.
paraview_prefix()
{
  echo "${MT_PARAVIEW_PREFIX:-${PWD}/build-paraview-prefix}"
}

# Debian 13's packaging renames Python's modules (NAME.cpython-313-x86_64-linux-gnu.so), and paraview-dev's CMake files stop
# where NAME.so is not there.
name_python_modules()
{
  local module
  while IFS= read -r -d '' module; do
    [[ -e "${module%.cpython-*}.so" ]] || ln -s "${module##*/}" "${module%.cpython-*}.so"
  done < <(find "$1/usr/lib/python3/dist-packages" -name '*.cpython-*.so' -print0)
}

# Installs and unpacks what is not there yet: a second call needs neither rights nor network.
install_paraview()
{
  local prefix packages
  prefix=$(paraview_prefix)
  install_packages build paraview
  if [[ -e "${prefix}/complete" ]]; then
    return
  fi
  echo "Unpacking ParaView into ${prefix}"
  rm -rf "${prefix}"
  packages=$(mktemp -d)
  # apt's own user has to write there.
  chmod 755 "${packages}"
  (cd "${packages}" && apt-get download -q paraview paraview-dev python3-paraview) > "${packages}/log" 2>&1 || true
  local package names=("${packages}"/*.deb)
  if ((${#names[@]} != 3)); then
    cat "${packages}/log" >&2
    fail "apt-get could not download paraview, paraview-dev and python3-paraview"
  fi
  mkdir -p "${prefix}"
  for package in "${names[@]}"; do
    dpkg -x "${package}" "${prefix}" || fail "${package} could not be unpacked into ${prefix}"
  done
  rm -r "${packages}"
  name_python_modules "${prefix}"
  touch "${prefix}/complete"
}

# What programs of that ParaView need to find their libraries, modules and each other.
enter_paraview()
{
  local prefix
  prefix=$(paraview_prefix)
  export PATH="${prefix}/usr/bin:${PATH}"
  export LD_LIBRARY_PATH="${prefix}/usr/lib/x86_64-linux-gnu${LD_LIBRARY_PATH:+:${LD_LIBRARY_PATH}}"
  export PYTHONPATH="${prefix}/usr/lib/python3/dist-packages${PYTHONPATH:+:${PYTHONPATH}}"
}
