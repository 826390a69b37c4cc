# shellcheck shell=bash
# Shared by the scripts beside it, which source it: `. "$(dirname "$0")/common.sh"`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

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
