#!/usr/bin/env bash
# Makes the figures of the manual from runs of the examples, with f3d, xvfb, ImageMagick and gnuplot.
#
#   doc/make_figures.sh EXAMPLES BENCHMARKS [FIGURE...]     the folders of the built programs
#
# CGAL_DATA_DIR must name the data folder of CGAL. Without names all figures are made.
set -euo pipefail

[ $# -ge 2 ] || { sed -n '2,/^set /{ s/^# \{0,1\}//p }' "$0" >&2; exit 2; }
. "$(dirname "$0")/drawing.sh"
examples=$(realpath "$1")
benchmarks=$(realpath -m "$2")
shift 2
figures=$(realpath "$(dirname "$0")/Hermite_diffuse_remeshing/fig")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
meshes=$CGAL_DATA_DIR/meshes

# blue, white in the middle of the range, red
diverging=0,0.1,0.25,0.65,0.35,0.5,0.7,0.95,0.5,0.97,0.97,0.97,0.65,0.95,0.6,0.45,1,0.65,0.05,0.1
# dark is small
sequential=0,0.2,0.05,0.35,0.33,0.15,0.45,0.55,0.66,0.4,0.75,0.4,1,0.99,0.9,0.15

# field FILE.vtp NAME RANGE COLORMAP PICTURE OPTIONS...: an array at the points, with its scale
field()
{
  local file=$1 name=$2 range=$3 colors=$4 picture=$5
  shift 5
  draw "$file" "$picture" --scalars="$name" --comp=0 --range="$range" --bar --colormap="$colors" "$@"
}

before_after()
{
  "$examples/make_sheet_metal_cup" cup.off > /dev/null
  "$examples/remesh_file" cup.off cup_remeshed.off --approximation-error 0.02 --quiet
  for mesh in cup cup_remeshed; do
    draw $mesh.off $mesh.png --edges --resolution=1800,1500 --up=+Z --camera-azimuth-angle=30 \
      --camera-elevation-angle=40
  done
  beside "$figures/before_after.png" 1200 cup.png cup_remeshed.png
}

# a free shape and one with sharp edges
examples_before_after()
{
  "$examples/remesh_file" "$meshes/elephant.off" elephant.off --approximation-error 0.05 --quiet
  "$examples/remesh_file" "$meshes/fandisk.off" fandisk.off --approximation-error 0.02 --quiet
  draw "$meshes/elephant.off" a.png --edges --resolution=1500,1500 --camera-azimuth-angle=20
  draw elephant.off b.png --edges --resolution=1500,1500 --camera-azimuth-angle=20
  draw "$meshes/fandisk.off" c.png --edges --resolution=1500,1500 --camera-azimuth-angle=40 --camera-elevation-angle=25
  draw fandisk.off d.png --edges --resolution=1500,1500 --camera-azimuth-angle=40 --camera-elevation-angle=25
  beside "$figures/examples.png" 1400 a.png b.png c.png d.png
}

curvatures()
{
  "$examples/hermite_diffuse_curvatures_example" "$meshes/elephant.off" curvatures.vtp > /dev/null
  # most of the mesh has a curvature within this range
  field curvatures.vtp mean_curvature -40,40 "$diverging" curvatures.png --resolution=1400,1100 --camera-azimuth-angle=20
  beside "$figures/curvatures.png" 900 curvatures.png
}

sizes()
{
  "$examples/make_sheet_metal_cup" cup.off > /dev/null
  "$examples/remesh_file" cup.off cup_remeshed.off --approximation-error 0.02 --fields cup.vtp --quiet
  field cup.vtp size "$(range_of size cup.vtp)" "$sequential" sizes.png --edges --resolution=1400,1100 --up=+Z \
    --camera-azimuth-angle=30 --camera-elevation-angle=40
  beside "$figures/sizes.png" 900 sizes.png
}

# values ARRAY FILE.vtp: the numbers of an array, one per line
values()
{
  awk -v name="Name=\"$1\"" 'index($0, "<DataArray") { inside = index($0, name); next }
                             index($0, "</DataArray") { inside = 0 }
                             inside { for(i = 1; i <= NF; ++i) print $i }' "$2"
}

range_of()
{
  values "$1" "$2" | awk 'NR == 1 { low = high = $1 } $1 < low { low = $1 } $1 > high { high = $1 } END { print low "," high }'
}

# parts of the faces by their quality, of joint.off and of the result
quality_histogram()
{
  "$examples/remesh_file" "$meshes/joint.off" joint.off --approximation-error 0.02 --fields after.vtp --quiet
  # a stop before the first change: the input with its qualities
  for mesh in "$meshes/joint.off" joint.off; do
    awk '/^[ \t\r]*(#|$)/ { next } /^OFF/ { next } !counts { counts = 1; points = $1; next }
         points-- > 0 { x[n] = $1; y[n] = $2; z[n++] = $3; next }
         { for(k = 0; k < 3; ++k) { i = $(2 + k); j = $(2 + (k + 1) % 3)
             l[k] = sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2 + (z[i] - z[j])^2) }
           s = (l[0] + l[1] + l[2]) / 2; m = l[0]; for(k = 1; k < 3; ++k) if(l[k] > m) m = l[k]
           a = s * (s - l[0]) * (s - l[1]) * (s - l[2]); q = a > 0 ? 2 * sqrt(3) * sqrt(a) / s / m : 0
           b = int(20 * q); if(b > 19) b = 19; ++number[b]; ++all }
         END { for(b = 0; b < 20; ++b) print (b + 0.5) / 20, number[b] / all }' "$mesh" > "$(basename "$(dirname "$mesh")")_q.txt"
  done
  mv meshes_q.txt before.txt
  mv ._q.txt after.txt
  gnuplot <<END
set terminal pngcairo size 900,420 font "sans,11"
set output "$figures/quality_histogram.png"
set style fill solid 0.8 noborder
set boxwidth 0.02
set xrange [0:1]
set xlabel "quality of a triangle: 2 sqrt(3) inscribed radius / longest edge"
set ylabel "part of the faces"
set key top center
plot "before.txt" using (\$1 - 0.011):2 with boxes lc rgb "#9a9a9a" title "joint.off", \
     "after.txt" using (\$1 + 0.011):2 with boxes lc rgb "#2a5ca8" title "remeshed, error 0.02"
END
}

textures()
{
  "$examples/hermite_diffuse_attributes_example" > /dev/null
  convert \( pattern:checkerboard -crop 30x30+0+0 +repage -scale 64x64! -colorspace gray -auto-level \
             +level 55%,100% -write mpr:tile +delete -size 512x512 tile:mpr:tile \) \
          \( -size 512x512 gradient:orange-lightblue \) -compose multiply -composite textured.png
  for mesh in textured_input textured_output; do
    draw $mesh.obj $mesh.png --edges --resolution=1100,1300 --up=+Z --camera-azimuth-angle=35 --camera-elevation-angle=15 \
      --geometry-only --texture-base-color=textured.png --color=1,1,1 --roughness=1
  done
  beside "$figures/textures.png" 900 textured_input.png textured_output.png
}

region()
{
  "$examples/hermite_diffuse_remesh_region_example" "$meshes/elephant.off" > /dev/null
  draw region.off region.png --edges --resolution=2400,2400 --camera-azimuth-angle=20
  convert region.png -trim +repage -gravity north -crop 100%x40%+0+0 +repage region.png
  beside "$figures/region.png" 600 region.png
}

# distance of the model's points to the true surface against the number of faces
convergence()
{
  "$benchmarks/model_accuracy" 500 2000 8000 32000 > accuracy.txt
  awk '/^Points of faces/ { n = $(NF - 1) } n && $1 == "torus" && NF >= 7 { print n, $2, $3, $4, $5, $6; n = 0 }' accuracy.txt > torus.txt
  gnuplot <<END
set terminal pngcairo size 900,520 font "sans,11"
set output "$figures/convergence.png"
set logscale xy
set format y "10^{%L}"
set xlabel "faces of the irregular torus"
set ylabel "rms distance to the torus / mean edge length"
set key outside right
set grid
array names[5] = ["facets", "PN-triangles", "the paper's model", "degree 2", "degree 3"]
plot for [i = 2:6] "torus.txt" using 1:i with linespoints lw 2 pt 7 title names[i - 1]
END
}

all=(before_after examples_before_after curvatures sizes quality_histogram textures region convergence)
[ $# -gt 0 ] || set -- "${all[@]}"
for figure in "$@"; do
  echo "$figure"
  $figure
done
