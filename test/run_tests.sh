#!/usr/bin/env bash
# Installs what is missing, builds the tests and examples with assertions on, and runs them.
# The last line is `N passed, N failed`.
#
#   test/run_tests.sh [--cgal DIR] [--build DIR] [--check-sources] [--sanitize KIND] [--coverage]
#                     [--programs LIST]
#
#   --cgal DIR       the root of an unpacked libcgal-dev package to use instead of the installed one
#   --build DIR      the build folder (build/test, or build/test-cgal with --cgal)
#   --sanitize KIND  with the address and undefined-behaviour sanitizers, KIND `address,undefined`, or with that of
#                    threads, KIND `thread`; takes many times as long. Programs with threads are test_determinism
#                    and test_diffuse_surface; those of TBB are left out, as the sanitizer does not see how they wait
#                    for each other in a library that is built without it
#   --coverage       tells at last which part of the lines and branches of include/ the tests have run: a table of the
#                    headers, with the numbers of the lines that have not run. A line of a template has run if it has
#                    in one instance. Not optimized much, so it takes several times as long
#   --programs LIST  only these programs, separated by blanks, and their tests, and that an installed package is found
#   --check-sources  also check the sources themselves: every header alone, warnings, includes
#
# CXX and CXXFLAGS are passed on to CMake.
set -euo pipefail

root=$(realpath "$(dirname "$0")/..")
. "$root/test/debian.sh"

cgal=
build=
check_sources=OFF
instruments=
optimization=-O2
coverage=OFF
programs=()
compile_once=ON
cmake_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --cgal|--build)
      [ $# -ge 2 ] || { echo "$1 needs a folder" >&2; exit 2; }
      if [ "$1" = --cgal ]; then cgal=$(realpath "$2"); else build=$(realpath -m "$2"); fi
      shift 2
      ;;
    --sanitize)
      case "${2:-}" in
        address,undefined)
          instruments="-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer"
          export UBSAN_OPTIONS="print_stacktrace=1"
          ;;
        thread)
          instruments="-fsanitize=thread"
          export TSAN_OPTIONS="history_size=4"
          cmake_options+=(-DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
          ;;
        *)
          echo "--sanitize needs address,undefined or thread" >&2
          exit 2
          ;;
      esac
      # fast to compile, and with line numbers
      optimization="-O1 -g1"
      build=${build:-$root/build/test-${2%%,*}}
      shift 2
      ;;
    --coverage)
      coverage=ON
      instruments=--coverage
      optimization=-O1
      build=${build:-$root/build/test-coverage}
      shift
      ;;
    --programs)
      [ $# -ge 2 ] || { echo "--programs needs a list" >&2; exit 2; }
      read -ra programs <<< "$2"
      compile_once=OFF                  # pays for many
      [ "$optimization" != -O2 ] || optimization=-O1    # the compiler takes longer than most of these run
      shift 2
      ;;
    --check-sources)
      check_sources=ON
      shift
      ;;
    *)
      sed -n '2,/^set /{ s/^# \{0,1\}//p }' "$0" >&2
      exit 2
      ;;
  esac
done
: "${build:=$root/build/test${cgal:+-cgal}}"

export CXXFLAGS="${CXXFLAGS:-} $instruments"

packages=(g++ cmake make libgmp-dev libmpfr-dev libboost-dev libboost-program-options-dev
          libeigen3-dev libtbb-dev)
[ $coverage = OFF ] || packages+=(gcovr)
if [ -z "$cgal" ]; then
  packages+=(libcgal-dev)
else
  config=$(find "$cgal" -path '*/cmake/CGAL/CGALConfig.cmake' -print -quit)
  [ -n "$config" ] || { echo "There is no CGALConfig.cmake below $cgal" >&2; exit 2; }
  cmake_options+=("-DCGAL_DIR=$(dirname "$config")")
fi
install_missing "${packages[@]}"
provide_data "$root/build/cgal_data"

finish()
{
  echo "$1 passed, $2 failed"
  [ "$2" -eq 0 ] && [ "$1" -gt 0 ]
}

say "configuring in $build"
mkdir -p "$build"
if ! cmake -S "$root" -B "$build" "${cmake_options[@]}" \
       -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="$optimization -UNDEBUG" \
       -DBUILD_TESTING=ON -DCGAL_DATA_DIR="$CGAL_DATA_DIR" \
       -DHermite_diffuse_remeshing_CHECK_SOURCES=$check_sources \
       -DHermite_diffuse_remeshing_COMPILE_ONCE=$compile_once \
       -DHermite_diffuse_remeshing_SELECTED_PROGRAMS="$(IFS=';'; echo "${programs[*]}")" \
       > "$build/configure.log" 2>&1; then
  cat "$build/configure.log"
  finish 0 1
  exit
fi
grep -E '^-- (CGAL [0-9]|The CXX compiler)' "$build/configure.log" || true

# The sources are checked beside the build, whose first step keeps only one processor busy.
log=$build/ctest.log
sources_log=$build/sources.log
: > "$sources_log"
if [ $check_sources = ON ]; then
  (cd "$build" && ctest -L sources --parallel "$((($(number_of_jobs) + 1) / 2))" --timeout 1200 --output-on-failure) \
    > "$sources_log" 2>&1 &
fi

# What does not compile is counted below, as a failed test.
say "building"
targets=()
selection=()
if [ ${#programs[@]} -gt 0 ]; then
  targets=(--target selected_programs)
  selection=(-R "$(IFS='|'; echo "${programs[*]}|package_by_find_package")")
fi
cmake --build "$build" --parallel "$(number_of_jobs)" "${targets[@]}" -- --keep-going || true

say "testing"
wait
cat "$sources_log"
(cd "$build" \
   && ctest -LE sources "${selection[@]}" --parallel "$(number_of_jobs)" --timeout 1200 --output-on-failure) 2>&1 \
  | tee "$log" || true

# Setting up and cleaning of the folder in which the tests run are no tests.
results=$(grep -h -E '^ *[0-9]+/[0-9]+ Test +#[0-9]+: ' "$sources_log" "$log" \
            | grep -v -E '(_SetupFixture|_CleanupFixture|check_build_system) \.+ +Passed' || true)
passed=$(grep -c -E ' Passed +[0-9.]+ sec' <<< "$results" || true)
failed=$(grep -c -v -E ' Passed +[0-9.]+ sec|^$' <<< "$results" || true)

if [ $coverage = ON ]; then
  say "coverage of include/"
  gcovr --root "$root" --filter "$root/include/" --exclude-unreachable-branches --exclude-throw-branches \
        --print-summary "$build"
fi
finish "$passed" "$failed"
