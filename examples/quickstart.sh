#!/usr/bin/env bash
# Installs what is missing, builds the command line program, and remeshes three meshes with it:
# elephant and fandisk from CGAL's data, and a sheet-metal cup. Results, reports and before/after
# pictures are left in build/quickstart/.
set -euo pipefail

root=$(realpath "$(dirname "$0")/..")
build=$root/build
out=$build/quickstart
. "$root/test/debian.sh"
. "$root/doc/drawing.sh"

# ---- what is needed ----
install_missing g++ cmake make libcgal-dev libcgal-demo libeigen3-dev \
                libboost-program-options-dev libtbb-dev
install_missing f3d xvfb xauth imagemagick || true
pictures=yes
for tool in f3d xvfb-run; do
  command -v $tool > /dev/null || pictures=no
done
mkdir -p "$out"
provide_data "$build/cgal_data"

# ---- build ----
say "building (Release)"
cmake -S "$root" -B "$build/release" -DCMAKE_BUILD_TYPE=Release \
      -DHermite_diffuse_remeshing_BUILD_TESTS=OFF > "$build/configure.log" \
  || { cat "$build/configure.log"; exit 1; }
cmake --build "$build/release" --parallel "$(number_of_jobs)" \
      --target remesh_file make_sheet_metal_cup
programs=$build/release/examples/Hermite_diffuse_remeshing

# ---- run ----
cp "$CGAL_DATA_DIR/meshes/elephant.off" "$CGAL_DATA_DIR/meshes/fandisk.off" "$out/"
"$programs/make_sheet_metal_cup" "$out/cup.off" > /dev/null

remesh()
{
  local name=$1
  shift
  say "remesh_file $name.off ${name}_remeshed.off $*"
  "$programs/remesh_file" "$out/$name.off" "$out/${name}_remeshed.off" "$@" \
    --report "$out/$name.json" --fields "$out/${name}_fields.vtp"
}

remesh elephant --approximation-error 0.02
remesh fandisk  --approximation-error 0.02 --sharp-angle 40
remesh cup      --approximation-error 0.02

# ---- pictures ----
# picture NAME CAMERA...: both meshes with their edges, from the same side
picture()
{
  local name=$1 mesh
  shift
  for mesh in "$name" "${name}_remeshed"; do
    if ! draw "$out/$mesh.off" "$out/$mesh.png" --edges --resolution=1800,1500 "$@"; then
      echo "f3d could not draw $mesh: there is no picture of it."
      return 0
    fi
  done
  if command -v convert > /dev/null; then
    beside "$out/${name}_before_after.png" 1600 "$out/$name.png" "$out/${name}_remeshed.png"
  fi
}

if [ $pictures = yes ]; then
  say "drawing"
  picture elephant --camera-azimuth-angle=20
  picture fandisk  --camera-azimuth-angle=40 --camera-elevation-angle=25
  picture cup      --up=+Z --camera-azimuth-angle=30 --camera-elevation-angle=40
else
  say "no pictures: they need f3d and xvfb-run"
fi

say "meshes, reports and pictures are in $out"
ls "$out"
