# shellcheck shell=bash
# Shared by the scripts beside it, which source it: `. "$(dirname "$0")/common.sh"`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
mesh=$build/demo/refined_elephant.off
zoo=$build/zoo

say() {
  printf '\n==> %s\n' "$*"
}

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

as_root() {
  if [[ $EUID -eq 0 ]]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    die "installing packages needs root: run this as root, or install sudo"
  fi
}

install_dependencies() {
  "$root/Scripts/install-dependencies"
}

# The default preset, into build/. CMake's long list of what VTK found goes to a log.
build_tree() {
  local log=$build/configure.log
  mkdir -p "$build"
  say "Configuring in build/"
  (cd "$root" && cmake --preset default) > "$log" 2>&1 || {
    cat "$log" >&2
    die "CMake could not configure the tree; its output is above and in $log"
  }
  say "Building in build/"
  cmake --build "$build"
}

download_package() {
  mkdir -p "$build/demo"
  cd "$build/demo"
  apt-get -q download libcgal-demo || {
    as_root apt-get -q update
    apt-get -q download libcgal-demo
  }
  dpkg-deb -x libcgal-demo_*.deb package
}

# CGAL's data files are an archive in libcgal-demo's documentation; slim installations leave
# documentation out, and then the package is unpacked once more beside the build.
find_archive() {
  local archive
  archive=$(dpkg -L libcgal-demo | grep '/data\.tar\.gz$' || true)
  if [[ ! -r $archive ]]; then
    echo "libcgal-demo is installed without its documentation: downloading the package" >&2
    (download_package) >&2
    archive=$(find "$build/demo/package" -name data.tar.gz)
  fi
  [[ -r $archive ]] || die "libcgal-demo holds no data.tar.gz; give a mesh of yours to build/bin/vtkshadows"
  echo "$archive"
}

forget_package() {
  rm -rf "$build/demo/package" "$build/demo"/libcgal-demo_*.deb
}

unpack_mesh() {
  local archive
  [[ ! -s $mesh ]] || return 0
  say "Unpacking $(basename "$mesh"), a scanned mesh, from Debian's libcgal-demo"
  mkdir -p "$(dirname "$mesh")"
  archive=$(find_archive)
  tar -xzOf "$archive" "data/meshes/$(basename "$mesh")" > "$mesh.part"
  mv "$mesh.part" "$mesh"
  forget_package
}

# Every file of data/meshes, flat in build/zoo: whole or not there.
unpack_zoo() {
  local archive
  [[ ! -d $zoo ]] || return 0
  say "Unpacking the meshes of Debian's libcgal-demo"
  rm -rf "$zoo.part"
  mkdir -p "$zoo.part"
  archive=$(find_archive)
  tar -xzf "$archive" -C "$zoo.part" --strip-components=2 data/meshes
  mv "$zoo.part" "$zoo"
  forget_package
}
