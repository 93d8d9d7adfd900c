#!/usr/bin/env bash
# The walk of a newcomer: what the page of the manual and README.md print is taken out of them, as one would copy it.
#
#   check_examples.sh print HTML_FOLDER               every example is printed as it is in the folder of the examples
#   check_examples.sh compile HTML_FOLDER [OPTIONS]   and compiles against the installed package, with the lines of
#                                                     CMake that the page prints; OPTIONS are those of CMake
set -euo pipefail

mode=$1
html=$(realpath "$2")
shift 2
root=$(realpath "$(dirname "$0")/..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/page" "$work/user"

# every frame with code of the page as a file: with the name that is printed above it, or with a number
awk -v folder="$work/page" '
  /<b>File<\/b>/ { name = $0; sub(/.*<b>File<\/b> [^ ]*\//, "", name); sub(/ .*/, "", name) }
  /<div class="fragment">/ { inside = 1; file = folder "/" (name == "" ? "part_" ++n : name); name = ""
                             sub(/.*<div class="fragment">/, "") }
  inside { line = $0; last = sub(/<\/div><!-- fragment -->.*/, "", line)
           if(line ~ /<div class="line">/) { sub(/<div class="line">/, "", line); sub(/<\/div>$/, "", line)
             gsub(/<[^>]*>/, "", line); gsub(/&lt;/, "<", line); gsub(/&gt;/, ">", line); gsub(/&quot;/, "\"", line)
             gsub(/&#39;/, "\047", line); gsub(/&#160;|&nbsp;/, " ", line); gsub(/&amp;/, "\\&", line)
             sub(/ +$/, "", line); print line > file }
           if(last) { inside = 0; close(file) } }' "$html/index.html"
sed -n '/^```cpp/,/^```/ { /^```/d; p }' "$root/README.md" > "$work/page/readme.cpp"

number=0
for example in "$root"/examples/Hermite_diffuse_remeshing/*_example.cpp; do
  printed=$work/page/$(basename "$example")
  if ! diff <(sed 's/ *$//' "$example") "$printed"; then
    echo "FAILED: the manual does not print $(basename "$example") as it is"
    exit 1
  fi
  number=$((number + 1))
done
echo "$number examples are printed as they are"
[ "$mode" = compile ] || exit 0

# what is no program is a few lines that belong into one
for part in "$work"/page/part_*; do
  if grep -q find_package "$part"; then
    mv "$part" "$work/printed.cmake"
  else
    {
      echo '#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>'
      echo '#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>'
      echo '#include <CGAL/Surface_mesh.h>'
      echo '#include <cmath>'
      echo 'typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;'
      echo 'int main() { CGAL::Surface_mesh<Point_3> mesh;'
      cat "$part"
      echo '}'
    } > "$part.cpp"
  fi
done

cmake -S "$root" -B "$work/package" "$@" -DHermite_diffuse_remeshing_BUILD_EXAMPLES=OFF \
      -DHermite_diffuse_remeshing_BUILD_TESTS=OFF > "$work/log" 2>&1 \
  && cmake --install "$work/package" --prefix "$work/installed" >> "$work/log" 2>&1 \
  || { cat "$work/log"; exit 1; }
cp "$work"/page/*.cpp "$work/user"
{
  echo 'cmake_minimum_required(VERSION 3.12)'
  echo 'project(Newcomer CXX)'
  grep find_package "$work/printed.cmake"
  # the viewer needs more, and sizing fields came with CGAL 6
  echo 'if(CGAL_VERSION VERSION_LESS 6)'
  echo '  find_package(CGAL QUIET OPTIONAL_COMPONENTS Qt5)'
  echo 'else()'
  echo '  find_package(CGAL QUIET OPTIONAL_COMPONENTS Qt6)'
  echo 'endif()'
  for program in "$work"/user/*.cpp; do
    name=$(basename "$program" .cpp)
    case $name in
      draw_hermite_diffuse_remeshing_example)     condition='CGAL_Qt5_FOUND OR CGAL_Qt6_FOUND' ;;
      isotropic_remeshing_with_curvature_example) condition='NOT CGAL_VERSION VERSION_LESS 6' ;;
      *)                                          condition=TRUE ;;
    esac
    echo "if($condition)"
    grep -v find_package "$work/printed.cmake" | sed "s/\bmy_program\b/$name/g"
    [ "$name" != draw_hermite_diffuse_remeshing_example ] \
      || echo "target_link_libraries($name PRIVATE CGAL::CGAL_Basic_viewer)"
    echo 'endif()'
  done
} > "$work/user/CMakeLists.txt"
cmake -S "$work/user" -B "$work/build" "-DCMAKE_PREFIX_PATH=$work/installed" "$@" > "$work/log" 2>&1 \
  || { cat "$work/log"; exit 1; }
if ! cmake --build "$work/build" -- --keep-going > "$work/log" 2>&1; then
  grep -E 'error|Error' "$work/log"
  exit 1
fi
grep 'Built target' "$work/log" | sed 's/.*target //' | grep -v CGAL_Qt | tr '\n' ' '
echo "compile as they are printed: $(grep -c 'Linking CXX executable' "$work/log") programs"
