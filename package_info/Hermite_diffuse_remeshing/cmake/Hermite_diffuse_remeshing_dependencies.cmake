# Finds what the headers need beside CGAL, and names it in Hermite_diffuse_remeshing_DEPENDENCIES.
# Included after find_package(CGAL), which makes CGAL's support modules known: by the package's own
# CMakeLists.txt and by its installed configuration.

find_package(Eigen3 3.3 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(FATAL_ERROR "Hermite_diffuse_remeshing needs the Eigen3 library (3.3 or greater)")
endif()

find_package(TBB QUIET)
include(CGAL_TBB_support)

set(Hermite_diffuse_remeshing_DEPENDENCIES CGAL::CGAL CGAL::Eigen3_support)
if(TARGET CGAL::TBB_support)
  list(APPEND Hermite_diffuse_remeshing_DEPENDENCIES CGAL::TBB_support)
endif()

# Imported targets belong to the folder that found them; a project that adds this one as a
# subfolder links to them from another folder.
foreach(_target CGAL::Eigen3_support CGAL::TBB_support
        Eigen3::Eigen TBB::tbb TBB::tbbmalloc Threads::Threads)
  if(TARGET ${_target})
    get_target_property(_aliased ${_target} ALIASED_TARGET)
    get_target_property(_is_imported ${_target} IMPORTED)
    get_target_property(_is_global ${_target} IMPORTED_GLOBAL)
    if(_is_imported AND NOT _is_global AND NOT _aliased)
      set_target_properties(${_target} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
  endif()
endforeach()
