// What nearly all tests and examples include and instantiate, for a build in which it is compiled once: the stages of
// the remeshing for the two types of mesh that they use, the fits, and the files of the most used type. The compiler
// instantiates inline functions all the same: what is meant to be left out here is defined outside of its class.

#ifndef HERMITE_DIFFUSE_REMESHING_TEST_COMPILED_ONCE_H
#define HERMITE_DIFFUSE_REMESHING_TEST_COMPILED_ONCE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace compiled_once {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

typedef CGAL::Hermite_diffuse_remeshing::internal::User_mesh<CGAL::Surface_mesh<Kernel::Point_3> > Surface_mesh_user;
typedef CGAL::Hermite_diffuse_remeshing::internal::User_mesh<CGAL::Polyhedron_3<Kernel> > Polyhedron_user;

} // namespace compiled_once

// `PREFIX`: extern, or nothing where it is compiled
#define COMPILED_ONCE_STAGES(PREFIX, USER)                                                                   \
  PREFIX template void CGAL::Hermite_diffuse_remeshing::internal::run_stages<USER>(                          \
    const USER&, const std::vector<Working_mesh<USER>::face_descriptor>&, const Side_marks&,                 \
    const std::vector<char>&, const Stage_options&, const std::function<std::unique_ptr<Input_model>()>&,    \
    const std::function<void()>&,                                                                            \
    const std::function<void(const Working_mesh<USER>&, const decltype(Deviations<USER>::faces)&)>&,         \
    Remeshing_report<USER::TriangleMesh>&);

COMPILED_ONCE_STAGES(extern, compiled_once::Surface_mesh_user)
COMPILED_ONCE_STAGES(extern, compiled_once::Polyhedron_user)

#define COMPILED_ONCE_MODEL(PREFIX, MODEL)                                                                   \
  PREFIX template std::unique_ptr<CGAL::Hermite_diffuse_remeshing::internal::MODEL>                          \
  CGAL::Hermite_diffuse_remeshing::internal::make_model<CGAL::Hermite_diffuse_remeshing::internal::MODEL>(   \
    const Indexed_triangles&, const Feature_options&, const Model_options&, const Read_edge_mark&,           \
    const Read_vertex_constraint&, const std::vector<Vector>&, const Progress&);

COMPILED_ONCE_MODEL(extern, Input_surface)
COMPILED_ONCE_MODEL(extern, Input_model)

#define COMPILED_ONCE_REPAIRS(PREFIX)                                                                        \
  PREFIX template CGAL::Hermite_diffuse_remeshing::internal::Repaired_triangles                              \
  CGAL::Hermite_diffuse_remeshing::internal::repair_triangles<                                               \
    CGAL::Hermite_diffuse_remeshing::internal::Repair_planner>(                                              \
    const Indexed_triangles&, const Side_marks&, double, double, const std::vector<char>&,                   \
    const std::vector<char>&);

COMPILED_ONCE_REPAIRS(extern)

#define COMPILED_ONCE_FITS(PREFIX, DEGREE)                                                                   \
  PREFIX template double CGAL::Hermite_diffuse_remeshing::internal::Normal_fitter::add_fit<DEGREE>(          \
    const Node_frame&, double, Fitted_normal&) const;                                                        \
  PREFIX template double CGAL::Hermite_diffuse_remeshing::internal::Reference_surface::fit_of_degree<DEGREE>(\
    const Location&, const Blended&, Local_quadric&) const;

#define COMPILED_ONCE_SMOOTHING(PREFIX)                                                                      \
  PREFIX template CGAL::Hermite_diffuse_remeshing::internal::Vector                                          \
  CGAL::Hermite_diffuse_remeshing::internal::smoothed_normal<2>(                                             \
    const Cut_mesh&, const std::vector<Node>&, const std::vector<Vector>&, int);

COMPILED_ONCE_SMOOTHING(extern)
COMPILED_ONCE_FITS(extern, 2)
COMPILED_ONCE_FITS(extern, 3)
COMPILED_ONCE_FITS(extern, 4)

#define COMPILED_ONCE_FILES(PREFIX, MESH)                                                                    \
  PREFIX template bool CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(                                 \
    const std::string&, MESH&, const CGAL::parameters::Default_named_parameters&);                           \
  PREFIX template bool CGAL::IO::write_polygon_mesh(                                                         \
    const std::string&, MESH&, const decltype(CGAL::parameters::stream_precision(17))&);

COMPILED_ONCE_FILES(extern, CGAL::Surface_mesh<compiled_once::Kernel::Point_3>)

#endif // HERMITE_DIFFUSE_REMESHING_TEST_COMPILED_ONCE_H
