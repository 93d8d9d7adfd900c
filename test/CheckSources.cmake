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
file(GLOB_RECURSE _sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" include/*.h benchmark/*.cpp)
foreach(_source ${_sources})
  string(MAKE_C_IDENTIFIER "${_source}" _name)
  add_test(NAME "alone_${_name}"
    COMMAND ${_check} compiles "${_source}"
            "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options})
endforeach()
