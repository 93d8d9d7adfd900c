#!/usr/bin/env bash
# Builds the speed benchmark, runs it, prints its tables and saves them with plots.
#
#   run_benchmark.sh [--cgal DIR] [--results DIR] [TABLE [NUMBER OF FACES | MESH]...]
#
#   --cgal DIR     the root of an unpacked libcgal-dev package to use instead of the installed one
#   --results DIR  where TABLE.csv and TABLE.svg go (build/benchmark)
#   TABLE          comparison, adaptive, scaling or regimes; all of them if none is named, which takes about an hour
#
# CGAL_DATA_DIR names CGAL's data. Plots need gnuplot.
set -euo pipefail

folder=$(realpath "$(dirname "$0")")
root=$(realpath "$folder/../..")
results=$root/build/benchmark
options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --cgal)
      config=$(find "$(realpath "${2:?}")" -path '*/cmake/CGAL/CGALConfig.cmake' -print -quit)
      options+=("-DCGAL_DIR=$(dirname "${config:?there is no CGALConfig.cmake below $2}")")
      shift 2
      ;;
    --results)
      results=$(realpath -m "${2:?}")
      shift 2
      ;;
    -*)
      sed -n '2,/^set /{ s/^# \{0,1\}//p }' "$0" >&2
      exit 2
      ;;
    *) break ;;
  esac
done

mkdir -p "$results"
cmake -S "$root" -B "$results/build" "${options[@]}" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O3 -DNDEBUG" \
      -DHermite_diffuse_remeshing_BUILD_BENCHMARKS=ON -DHermite_diffuse_remeshing_BUILD_EXAMPLES=OFF \
      -DHermite_diffuse_remeshing_BUILD_TESTS=OFF > "$results/configure.log"
cmake --build "$results/build" --target hermite_diffuse_remesh_benchmark > "$results/build.log"
program=$(find "$results/build" -type f -name hermite_diffuse_remesh_benchmark -print -quit)

run()
{
  echo "== $1"
  "$program" "$@" | tee "$results/$1.csv"
  if command -v gnuplot > /dev/null; then
    gnuplot -e "table='$results/$1.csv'; plot_file='$results/$1.svg'" "$folder/plot_benchmark.gp"
  else
    echo "gnuplot was not found: $1.svg is not drawn" >&2
  fi
}

if [ $# -gt 0 ]; then
  run "$@"
else
  for table in comparison adaptive scaling regimes; do
    run $table
  done
fi
