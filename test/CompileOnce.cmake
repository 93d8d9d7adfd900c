# Most of the time in which the tests and examples are built goes into what they have in common. Here it is compiled
# once for those of them that have the same flags; the sources stay as they are.

if(NOT COMMAND target_precompile_headers)
  message(STATUS "NOTICE: CMake 3.16 is needed to compile once what the tests have in common.")
  return()
endif()

# With threads, which some of them use, all are built as with TBB where it is there.
find_package(TBB QUIET)
include(CGAL_TBB_support)
set(_threads)
if(TARGET CGAL::TBB_support)
  set(_threads CGAL::TBB_support)
endif()

add_library(compiled_once STATIC "${PROJECT_SOURCE_DIR}/test/compiled_once.cpp")
target_link_libraries(compiled_once PRIVATE CGAL::CGAL CGAL::Data CGAL::Eigen3_support ${_threads})
target_precompile_headers(compiled_once PRIVATE "${PROJECT_SOURCE_DIR}/test/compiled_once.h")

foreach(_folder examples test)
  get_directory_property(_programs DIRECTORY "${PROJECT_SOURCE_DIR}/${_folder}/Hermite_diffuse_remeshing"
                         BUILDSYSTEM_TARGETS)
  foreach(_program ${_programs})
    get_target_property(_type ${_program} TYPE)
    get_target_property(_libraries ${_program} LINK_LIBRARIES)
    # the viewer has flags of its own
    if(_type STREQUAL "EXECUTABLE" AND _libraries MATCHES "Eigen3_support" AND NOT _libraries MATCHES "viewer")
      target_link_libraries(${_program} PRIVATE compiled_once ${_threads})
      target_precompile_headers(${_program} REUSE_FROM compiled_once)
      if(NOT MSVC)
        # for what is left the compiler takes longer than it runs
        target_compile_options(${_program} PRIVATE -O1)
      endif()
    endif()
  endforeach()
endforeach()
