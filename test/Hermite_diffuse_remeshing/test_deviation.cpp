// The largest deviation that is asked for is met, or reported as not met with the faces; and what is reported
// is what CGAL measures between the result and a fine sampling of the model.

#include "sampled_model.h"
#include "sized_surfaces.h"
#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/distance.h>

#include <algorithm>

typedef Surface_mesh::Face_index Face_index;
typedef Surface_mesh::Edge_index Edge_index;

double diagonal(const Surface_mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin())
                   + CGAL::square(box.zmax() - box.zmin()));
}

// `part`: of the diagonal; CGAL's measure takes long, on small meshes too
void test_contract(const Surface_mesh& input, const double part, const double least_quality, const bool is_compared)
{
  Surface_mesh mesh = input;
  const double bound = part * diagonal(input);
  const auto parameters = params::approximation_error(0.1).maximum_deviation(bound);
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters);
  check_result(input, mesh);
  assert(report.is_maximum_deviation_met && report.largest_deviation <= bound);
  assert(report.faces_above_maximum_deviation.empty());
  assert(report.stop_reason != HDR::DEVIATION_NOT_MET);
  assert(report.smallest_quality >= least_quality);

  if(!is_compared)
    return;
  // The report's samples are where facets deviate most, which on bent surfaces are the middles; the
  // sampled model and the measure have an error each.
  const double tolerance = 0.1 * bound;
  const Surface_mesh model = sampled_model(input, parameters, tolerance);
  typedef CGAL::Sequential_tag Tag;
  const double to_model = PMP::bounded_error_Hausdorff_distance<Tag>(mesh, model, tolerance);
  assert(std::abs(to_model - report.largest_deviation) <= 0.3 * bound);
}

// edges that may not change decide where the bound cannot be met
void test_protected_edges()
{
  analytic::Frustum cylinder;
  Surface_mesh mesh = make_mesh<Surface_mesh>(cylinder.mesh(1000, 3));
  const auto is_on_rim = [](const Point_3& p)
  { return std::abs(std::hypot(p.x(), p.y()) - 1.) < 1e-9 && (p.z() < 1e-9 || p.z() > 2. - 1e-9); };
  auto is_constrained = mesh.add_property_map<Edge_index, bool>("e:constrained", false).first;
  for(const Edge_index e : edges(mesh))
    is_constrained[e] = is_on_rim(mesh.point(source(e, mesh))) && is_on_rim(mesh.point(target(e, mesh)));
  auto deviations = mesh.add_property_map<Face_index, double>("f:deviation", 0.).first;
  const double bound = 1e-3;
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(bound)
    .edge_is_constrained_map(is_constrained).protect_constraints(true).face_deviation_map(deviations));
  assert(!report.is_maximum_deviation_met && report.largest_deviation > bound);
  assert(report.stop_reason == HDR::DEVIATION_NOT_MET);
  assert(!report.faces_above_maximum_deviation.empty());
  for(const Face_index f : report.faces_above_maximum_deviation)
  {
    assert(deviations[f] > bound);
    int number_on_rim = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      number_on_rim += is_on_rim(mesh.point(v));
    assert(number_on_rim >= 1);
  }
}

// a bound that no mesh can meet ends at the budget
void test_absurd_deviation()
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(analytic::Torus().mesh(1000, 3));
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(1e-12).maximum_number_of_faces(5000));
  assert(!report.is_maximum_deviation_met && report.stop_reason == HDR::FACE_BUDGET);
  assert(report.number_of_faces <= 5000);
  assert(!report.faces_above_maximum_deviation.empty());
}

// The model has no steps inside faces: where neighbouring normals are turned by a right angle, and between
// two apices.
void test_continuity()
{
  using namespace HDR::internal;
  const Surface_mesh mesh = read_data<Surface_mesh>("elephant.off");
  const CGAL::Hermite_diffuse_surface<Surface_mesh> surface(mesh);
  constexpr int number_of_steps = 100;
  for(const Face_index f : faces(mesh))
  {
    double longest = 0.;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)))));
    for(int k = 0; k < 3; ++k)
    {
      Point_3 before;
      for(int i = 0; i <= number_of_steps; ++i)
      {
        std::array<double, 3> coordinates;
        coordinates[k] = double(i) / number_of_steps;
        coordinates[next(k)] = coordinates[previous(k)] = (1. - coordinates[k]) / 2.;
        const Point_3 p = surface.point(std::make_pair(f, coordinates));
        // the way along the facet is one step; a break of the surface is many
        assert(i == 0 || std::sqrt(CGAL::squared_distance(before, p)) <= 4. * longest / number_of_steps);
        before = p;
      }
    }
  }
}

int main()
{
  test_continuity();
  analytic::Ellipsoid_123 ellipsoid;
  test_contract(make_mesh<Surface_mesh>(analytic::Torus().mesh(1000, 3)), 4e-3, 0.6, true);
  test_contract(make_mesh<Surface_mesh>(analytic::Frustum().mesh(1000, 3)), 4e-3, 0.5, false);
  test_contract(make_mesh<Surface_mesh>(ellipsoid.mesh(3000, 3)), 1e-3, 0.6, false);
  test_contract(read_data<Surface_mesh>("joint.off"), 2e-3, 0.4, false);
  test_protected_edges();
  test_absurd_deviation();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
