# Tests of the sources themselves, registered by the package's CMakeLists.txt on request.

set(_check bash "${PROJECT_SOURCE_DIR}/test/check_sources.sh")
foreach(_name include_direction version_use no_output no_abort guards lengths tests_mirror_folders
        manual_is_complete)
  add_test(NAME "source_${_name}" COMMAND ${_check} ${_name})
endforeach()

# The other compiler has its say here: the build itself uses ${CMAKE_CXX_COMPILER}.
find_program(Hermite_diffuse_remeshing_CHECK_COMPILER NAMES clang++ clang++-14 ${CMAKE_CXX_COMPILER}
             DOC "Compiler that checks every source alone")
set(_options -std=c++17 -DCGAL_EIGEN3_ENABLED -I "${PROJECT_SOURCE_DIR}/include")
foreach(_folder ${CGAL_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIR} ${EIGEN3_INCLUDE_DIRS})
  if(NOT _folder STREQUAL "/usr/include")
    list(APPEND _options -isystem "${_folder}")
  endif()
endforeach()

add_test(NAME source_exact_kernel
  COMMAND ${_check} exact_kernel "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options})

# Not the examples: the build has compiled them, and they call what the benchmarks call.
file(GLOB _users_headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
     include/CGAL/*.h include/CGAL/Polygon_mesh_processing/*.h include/CGAL/Hermite_diffuse_remeshing/*.h)
file(GLOB_RECURSE _sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" include/*.h benchmark/*.cpp)

# The libraries' headers take most of the time. Only the headers that users include must bring all of theirs; the others
# are seen after them, which clang compiles once for all.
set(_libraries_of_internal_headers)
if(Hermite_diffuse_remeshing_CHECK_COMPILER MATCHES "clang")
  set(_library_headers)
  foreach(_source ${_sources})
    if(_source MATCHES "^include/")
      file(STRINGS "${PROJECT_SOURCE_DIR}/${_source}" _lines REGEX "^#include <(CGAL|boost|Eigen|unsupported)/")
      list(FILTER _lines EXCLUDE REGEX "[Hh]ermite_diffuse")
      list(APPEND _library_headers ${_lines})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES _library_headers)
  string(REPLACE ";" "\n" _library_headers "${_library_headers}\n")
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/libraries.h" "${_library_headers}")
  set(_precompiled "${CMAKE_CURRENT_BINARY_DIR}/libraries.pch")
  add_test(NAME precompile_libraries
    COMMAND "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options} -x c++-header
            "${CMAKE_CURRENT_BINARY_DIR}/libraries.h" -o "${_precompiled}")
  set_tests_properties(precompile_libraries PROPERTIES FIXTURES_SETUP precompiled_libraries)
  set(_libraries_of_internal_headers -include-pch "${_precompiled}")
endif()

foreach(_source ${_sources})
  string(MAKE_C_IDENTIFIER "${_source}" _name)
  set(_libraries)
  if(_libraries_of_internal_headers AND NOT _source IN_LIST _users_headers)
    set(_libraries ${_libraries_of_internal_headers})
  endif()
  add_test(NAME "alone_${_name}"
    COMMAND ${_check} compiles "${_source}"
            "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options} ${_libraries})
  if(_libraries)
    set_tests_properties("alone_${_name}" PROPERTIES FIXTURES_REQUIRED precompiled_libraries)
  endif()
endforeach()
