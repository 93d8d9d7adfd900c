#!/usr/bin/env bash
# Checks of the sources that need no run: check_sources.sh CHECK [ARGUMENTS...]
set -u

root=$(realpath "$(dirname "$0")/..")
cd "$root/include/CGAL" || exit 1
internal=Hermite_diffuse_remeshing/internal

# expect_none MESSAGE: standard input must be empty
expect_none()
{
  local found
  found=$(cat)
  [ -z "$found" ] && return 0
  echo "FAILED: $1"
  echo "$found"
  exit 1
}

case "$1" in

# A folder may use itself and what comes before it in the flow of the data.
include_direction)
  stages=(Classification Curves Model Sizing Transformation)
  for ((user = 0; user < ${#stages[@]}; ++user)); do
    for ((used = user + 1; used < ${#stages[@]}; ++used)); do
      grep -rnE "#include.*internal/${stages[used]}/" "$internal/${stages[user]}" 2> /dev/null
    done
  done | expect_none "these includes go against the flow of the data"
  find "$internal" -mindepth 1 -maxdepth 1 -type d -printf '%f\n' \
    | grep -vxF "$(printf '%s\n' "${stages[@]}")" | expect_none "these folders are no stages"
  ;;

version_use)
  grep -rn 'CGAL_VERSION' . | grep -v "^./$internal/compatibility.h:" \
    | expect_none "only compatibility.h knows CGAL's version"
  ;;

no_output)
  grep -rnE '#include *<(iostream|fstream|cstdio|cassert|assert\.h)>|std::(cout|cerr|clog)' . \
    | expect_none "headers neither print nor use assert"
  ;;

no_abort)
  grep -rnE '(^|[^_[:alnum:]])(assert|abort|exit) *\(' . \
    | expect_none "headers throw, or use CGAL's assertions"
  ;;

guards)
  grep -rL 'SPDX-License-Identifier: GPL-3.0-or-later' . | expect_none "these have no licence line"
  find . -name '*.h' -not -path '*/internal/*' -not -path '*/license/*' \
    -exec grep -LF '#include <CGAL/license/Hermite_diffuse_remeshing.h>' {} + \
    | expect_none "these headers of users do not tell of the licence"
  find . -name '*.h' -printf '%P\n' | while read -r header; do
    guard=CGAL_$(tr '[:lower:]/.' '[:upper:]__' <<< "$header")
    grep -qx "#define $guard" "$header" || echo "$header: $guard"
  done | expect_none "these include guards are not the path in capitals"
  ;;

# Every folder with headers has its group of tests, and every test program is in one group.
tests_mirror_folders)
  tests=$root/test/Hermite_diffuse_remeshing
  groups=$(sed -n 's/^test_group(\(.*\))$/\1/p' "$tests/CMakeLists.txt")
  {
    diff <(cut -d ' ' -f 1 <<< "$groups" | sort) \
         <(cd .. && find . -name '*.h' -not -path '*/license/*' -printf '%h\n' | cut -c 3- | sort -u)
    diff <(cut -d ' ' -f 2- <<< "$groups" | tr ' ' '\n' | sort) <(basename -s .cpp "$tests"/*.cpp | sort)
  } | expect_none "the groups of test programs (<) are not the folders and programs (>)"
  ;;

# No header is too long to be read at once.
lengths)
  find . -name '*.h' -exec awk 'END { if(FNR > 400) print FILENAME ": " FNR " lines" }' {} \; \
    | expect_none "these headers are longer than 400 lines"
  awk 'END { if(FNR > 150) print FNR " lines" }' $internal/Transformation/Remesher.h \
    | expect_none "Remesher.h, the paper's section 4, is longer than 150 lines"
  ;;

# The manual prints all examples, and shows all figures.
manual_is_complete)
  cd "$root" || exit 1
  manual=doc/Hermite_diffuse_remeshing
  {
    for example in examples/Hermite_diffuse_remeshing/*_example.cpp; do
      grep -q "cgalExample{Hermite_diffuse_remeshing/$(basename "$example")}" $manual/Hermite_diffuse_remeshing.txt \
        || echo "$example"
    done
    for program in examples/Hermite_diffuse_remeshing/*.cpp; do
      grep -q "example Hermite_diffuse_remeshing/$(basename "$program")\$" $manual/examples.txt || echo "$program"
    done
    for figure in $manual/fig/*; do
      grep -q "image html $(basename "$figure") " $manual/Hermite_diffuse_remeshing.txt || echo "$figure"
    done
  } | expect_none "these are not in the manual"
  ;;

# compiles FILE COMPILER OPTIONS...: the file alone, without a warning
compiles)
  file=$2
  shift 2
  # a header is included, as users do: on its own a compiler takes its constants for unused
  echo "#include \"$root/$file\"" | "$@" -fsyntax-only -Wall -Wextra -Werror -x c++ - || exit 1
  ;;

# exact_kernel COMPILER OPTIONS...: exact constructions are refused with a sentence
exact_kernel)
  shift
  "$@" -fsyntax-only -x c++ - 2>&1 <<'END' | grep -q "need a kernel with floating point coordinates" \
    || { echo "FAILED: a kernel with exact constructions is not refused with a sentence"; exit 1; }
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Surface_mesh.h>
void f(CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>& mesh)
{
  CGAL::Polygon_mesh_processing::hermite_diffuse_remesh(mesh);
}
END
  ;;

# package WAY CMAKE_OPTIONS...: a program outside of the tree uses this package, installed or as a subfolder. One that
# compiles fast, as what is looked at is that it finds the headers and libraries.
package)
  way=$2
  shift 2
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  if [ "$way" = find_package ]; then
    cmake -S "$root" -B "$folder/package" "$@" -DHermite_diffuse_remeshing_BUILD_EXAMPLES=OFF \
          -DHermite_diffuse_remeshing_BUILD_TESTS=OFF > "$folder/log" 2>&1 \
      && cmake --install "$folder/package" --prefix "$folder/installed" >> "$folder/log" 2>&1 \
      || { cat "$folder/log"; exit 1; }
    set -- "$@" "-DCMAKE_PREFIX_PATH=$folder/installed"
    use='find_package(Hermite_diffuse_remeshing REQUIRED)'
  else
    use="add_subdirectory(\"$root\" package)"
  fi
  mkdir "$folder/user" "$folder/user/program"
  cat > "$folder/user/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.12)
project(User CXX)
$use
add_subdirectory(program)
END
  cat > "$folder/user/program/CMakeLists.txt" <<END
add_executable(user_program main.cpp)
target_link_libraries(user_program PRIVATE Hermite_diffuse_remeshing::Hermite_diffuse_remeshing)
END
  cat > "$folder/user/program/main.cpp" <<END
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>
#include <Eigen/Core>
int main()
{
  using namespace CGAL::Hermite_diffuse_remeshing;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 Point;
  const bool is_linked = CGAL::collinear(Point(0.5, 0.5), Point(12., 12.), Point(24., 24.));      // needs exact numbers
  const double ratio = length_over_radius_of_elements_per_circle(6);                              // a hexagon
  return is_linked && CGAL::abs(ratio - Eigen::Vector2d::UnitX().norm()) < 1e-12 ? 0 : 1;
}
END
  cmake -S "$folder/user" -B "$folder/build" "$@" > "$folder/log" 2>&1 \
    && cmake --build "$folder/build" >> "$folder/log" 2>&1 \
    && "$folder/build/program/user_program" || { cat "$folder/log"; exit 1; }
  [ ! -e "$folder/build/package/examples" ] \
    || { echo "FAILED: a subfolder builds its examples"; exit 1; }
  ;;

*)
  echo "there is no check $1" >&2
  exit 2
  ;;

esac
