#!/usr/bin/env bash
# Draws the picture of curvatures of the manual with f3d.
#
#   doc/draw_curvatures.sh PROGRAM       the built hermite_diffuse_curvatures_example
#
# CGAL_DATA_DIR must name the data folder of CGAL, where the program finds its mesh.
set -euo pipefail

[ $# -eq 1 ] || { sed -n '2,/^set /{ s/^# \{0,1\}//p }' "$0" >&2; exit 2; }
figures=$(realpath "$(dirname "$0")/Hermite_diffuse_remeshing/fig")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

"$1" "$CGAL_DATA_DIR/meshes/elephant.off" "$folder/curvatures.vtp"
# blue, white at zero, red; most of the mesh has a curvature within this range
xvfb-run --auto-servernum f3d "$folder/curvatures.vtp" --output "$folder/curvatures.png" --quiet \
  --scalars=mean_curvature --comp=0 --range=-40,40 --bar --bg-color=1,1,1 --resolution=1400,1100 \
  --colormap=0,0.1,0.25,0.65,0.35,0.5,0.7,0.95,0.5,0.97,0.97,0.97,0.65,0.95,0.6,0.45,1,0.65,0.05,0.1 \
  --camera-azimuth-angle=20 < /dev/null > /dev/null 2>&1 || true
convert "$folder/curvatures.png" -trim -bordercolor white -border 20 -resize 900x "$figures/curvatures.png"
