# Functions of examples/quickstart.sh and test/run_tests.sh for Debian and its relatives: to be
# sourced, with `set -eu` in force.

say()
{
  printf '\n== %s\n' "$*"
}

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    echo "Root's rights are needed for: $*" >&2
    return 1
  fi
}

is_installed()
{
  dpkg-query --show --showformat='${db:Status-Status}\n' "$1" 2> /dev/null | grep -qx installed
}

# install_missing PACKAGE...: calls apt-get only if one of them is missing
install_missing()
{
  local missing=() package
  if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
    echo "This is not a Debian system: the equivalents of these packages are assumed: $*"
    return 0
  fi
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  say "installing ${missing[*]}"
  as_root apt-get update -qq || echo "The lists of packages could not be updated; going on."
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "${missing[@]}"
}

# provide_data FOLDER: CGAL's own meshes, in CGAL_DATA_DIR
provide_data()
{
  local folder=$1 archive=/usr/share/doc/libcgal-demo/data.tar.gz
  if [ -n "${CGAL_DATA_DIR:-}" ] && [ -f "$CGAL_DATA_DIR/meshes/elephant.off" ]; then
    return 0
  fi
  mkdir -p "$folder"
  folder=$(realpath "$folder")
  if [ ! -f "$folder/data/meshes/elephant.off" ]; then
    install_missing libcgal-demo
    # Small systems are often set up to install no documentation, and the archive counts as such.
    if [ ! -f "$archive" ]; then
      (cd "$folder" \
         && apt-get -o "APT::Sandbox::User=$(id -un)" download -qq libcgal-demo \
         && dpkg -x libcgal-demo_*.deb unpacked)
      archive=$(find "$folder/unpacked" -name data.tar.gz -type f)
    fi
    tar -xzf "$archive" -C "$folder"
    rm -rf "$folder/unpacked" "$folder"/libcgal-demo_*.deb
  fi
  export CGAL_DATA_DIR=$folder/data
}

number_of_jobs()
{
  echo "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc 2> /dev/null || echo 1)}"
}
