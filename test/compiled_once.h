// What nearly all tests and examples include and instantiate, for a build in which it is compiled once: the stages of
// the remeshing for the two types of mesh that they use, called without constraints or patches, and for soups, the fits,
// and the files of the most used type.

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

template <typename TriangleMesh>
using User = CGAL::Hermite_diffuse_remeshing::internal::User_mesh<
  TriangleMesh, typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type,
  CGAL::Static_boolean_property_map<typename boost::graph_traits<TriangleMesh>::edge_descriptor, false>,
  CGAL::Constant_property_map<typename boost::graph_traits<TriangleMesh>::face_descriptor, int>, Kernel,
  CGAL::Hermite_diffuse_remeshing::internal::Supervisor<TriangleMesh> >;

typedef User<CGAL::Surface_mesh<Kernel::Point_3> > Surface_mesh_user;
typedef User<CGAL::Polyhedron_3<Kernel> > Polyhedron_user;

// what triangle soups are remeshed as
typedef CGAL::Surface_mesh<Kernel::Point_3> Soup_mesh;
typedef CGAL::Hermite_diffuse_remeshing::internal::User_mesh<
  Soup_mesh, boost::property_map<Soup_mesh, CGAL::vertex_point_t>::type,
  CGAL::Static_boolean_property_map<boost::graph_traits<Soup_mesh>::edge_descriptor, false>,
  Soup_mesh::Property_map<Soup_mesh::Face_index, int>, Kernel,
  CGAL::Hermite_diffuse_remeshing::internal::Supervisor<Soup_mesh> > Soup_user;

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
COMPILED_ONCE_STAGES(extern, compiled_once::Soup_user)

#define COMPILED_ONCE_FITS(PREFIX, DEGREE)                                                                   \
  PREFIX template class CGAL::Hermite_diffuse_remeshing::internal::Local_polynomial<DEGREE>;                 \
  PREFIX template double CGAL::Hermite_diffuse_remeshing::internal::Local_polynomial<DEGREE>::solve<0>();    \
  PREFIX template double CGAL::Hermite_diffuse_remeshing::internal::Local_polynomial<DEGREE>::solve<1>();

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
