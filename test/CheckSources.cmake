# Tests of the sources themselves, with the label `sources`, registered by the package's CMakeLists.txt on request.

set(_check bash "${PROJECT_SOURCE_DIR}/test/check_sources.sh")

# `seen_first`: what `precompile()` has been given under this name is seen by the compiler before anything else; may be
# empty, and is nothing where nothing is precompiled
function(add_source_test name seen_first)
  set(_command ${ARGN})
  set(_fixtures)
  if(seen_first AND TEST "precompile_${seen_first}")
    list(APPEND _command -include-pch "${CMAKE_CURRENT_BINARY_DIR}/${seen_first}.pch")
    set(_fixtures FIXTURES_REQUIRED "precompiled_${seen_first}")
  endif()
  add_test(NAME "${name}" COMMAND ${_command})
  set_tests_properties("${name}" PROPERTIES LABELS sources ${_fixtures})
endfunction()

foreach(_name include_direction version_use no_output no_abort guards lengths tests_mirror_folders
        manual_is_complete)
  add_source_test("source_${_name}" "" ${_check} ${_name})
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

# Not the examples: the build has compiled them, and they call what the benchmarks call.
file(GLOB _users_headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
     include/CGAL/*.h include/CGAL/Polygon_mesh_processing/*.h include/CGAL/Hermite_diffuse_remeshing/*.h)
file(GLOB_RECURSE _sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" include/*.h benchmark/*.cpp)

# clang compiles only once what they have in common. Only the headers that users include must bring all libraries' headers
# of theirs: these are seen after those internal ones, and the remeshing, that they include themselves, in the order in
# which they build on each other. The internal ones are seen after all libraries' headers, and after the model and the
# working mesh if they include these. Benchmarks are seen after what they share with the tests.
set(_input include/CGAL/Hermite_diffuse_remeshing/internal/read_input.h)
set(_model include/CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h)
set(_stages include/CGAL/Hermite_diffuse_remeshing/internal/run_stages.h)
set(_working_mesh include/CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h)
set(_remeshing include/CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h)

# whether `source` includes `header`, or is it
function(includes_header source header result)
  get_property(_known GLOBAL PROPERTY "${source} includes ${header}")
  if("${_known}" STREQUAL "")
    set(_known NO)
    if(source STREQUAL header)
      set(_known YES)
    endif()
    file(STRINGS "${PROJECT_SOURCE_DIR}/${source}" _lines REGEX "^#include <CGAL/.*[Hh]ermite_diffuse")
    foreach(_line ${_lines})
      string(REGEX REPLACE "^#include <(.*)>.*" "include/\\1" _included "${_line}")
      if(NOT _known AND NOT _included STREQUAL source)
        includes_header("${_included}" "${header}" _known)
      endif()
    endforeach()
    set_property(GLOBAL PROPERTY "${source} includes ${header}" ${_known})
  endif()
  set(${result} ${_known} PARENT_SCOPE)
endfunction()

# a test that precompiles the lines
function(precompile name seen_first lines)
  string(REPLACE ";" "\n" _lines "${lines}\n")
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${name}.h" "${_lines}")
  add_source_test("precompile_${name}" "${seen_first}"
    "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options} -fpch-instantiate-templates -x c++-header
    "${CMAKE_CURRENT_BINARY_DIR}/${name}.h" -o "${CMAKE_CURRENT_BINARY_DIR}/${name}.pch")
  # the others wait for it
  set_tests_properties("precompile_${name}" PROPERTIES FIXTURES_SETUP "precompiled_${name}" COST 900)
endfunction()

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
  precompile(libraries "" "${_library_headers}")
  precompile(libraries_and_model libraries "#include \"${PROJECT_SOURCE_DIR}/${_model}\"")
  precompile(libraries_and_mesh libraries_and_model "#include \"${PROJECT_SOURCE_DIR}/${_working_mesh}\"")
  set(_before "")
  foreach(_header input model stages remeshing)
    precompile(${_header} "${_before}" "#include \"${PROJECT_SOURCE_DIR}/${_${_header}}\"")
    set(_before ${_header})
  endforeach()
  precompile(tests remeshing "#include \"${PROJECT_SOURCE_DIR}/test/compiled_once.h\"")
endif()

foreach(_source ${_sources})
  string(MAKE_C_IDENTIFIER "${_source}" _name)
  foreach(_header input model stages working_mesh remeshing)
    includes_header("${_source}" "${_${_header}}" _includes_${_header})
  endforeach()
  set(_precompiled)
  if(_source STREQUAL _remeshing)
    # alone indeed, in the order of its includes
  elseif(_source MATCHES "^benchmark/")
    set(_precompiled tests)
  elseif(_source IN_LIST _users_headers)
    foreach(_header input model stages remeshing)
      if(NOT _includes_${_header})
        break()
      endif()
      set(_precompiled ${_header})
    endforeach()
  elseif(_includes_working_mesh AND NOT _source STREQUAL _working_mesh)
    set(_precompiled libraries_and_mesh)
  elseif(_includes_model AND NOT _source STREQUAL _model)
    set(_precompiled libraries_and_model)
  else()
    set(_precompiled libraries)
  endif()

  add_source_test("alone_${_name}" "${_precompiled}"
    ${_check} compiles "${_source}" "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options})
endforeach()

add_source_test(source_exact_kernel remeshing
  ${_check} exact_kernel "${Hermite_diffuse_remeshing_CHECK_COMPILER}" ${_options})
