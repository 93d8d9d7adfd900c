// What tests and benchmarks measure on surface meshes with the means of CGAL.

#ifndef MESH_MEASURES_H
#define MESH_MEASURES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>     // before CGAL's distances, which need its functions
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

template <typename Mesh>
double diagonal_of_box(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin())
                   + CGAL::square(box.zmax() - box.zmin()));
}

// the side of equilateral triangles that are as many on the mesh
template <typename Mesh>
double size_for(const Mesh& mesh, const double number_of_faces)
{
  return std::sqrt(4. / std::sqrt(3.) * CGAL::Polygon_mesh_processing::area(mesh) / number_of_faces);
}

template <typename Point>
std::size_t number_of_intersections(const CGAL::Surface_mesh<Point>& mesh)
{
  typedef typename CGAL::Surface_mesh<Point>::Face_index Face;
  std::vector<std::pair<Face, Face> > pairs;
  CGAL::Polygon_mesh_processing::self_intersections(faces(mesh), mesh, std::back_inserter(pairs));
  return pairs.size();
}

// of points that are sampled on one mesh to the other
template <typename Point>
double largest_distance(const CGAL::Surface_mesh<Point>& from, const CGAL::Surface_mesh<Point>& to,
                        const std::size_t number_of_samples = 200000)
{
  std::vector<Point> samples;
  CGAL::Polygon_mesh_processing::sample_triangle_mesh(from, std::back_inserter(samples),
    CGAL::parameters::random_seed(0).number_of_points_on_faces(number_of_samples));
  return CGAL::Polygon_mesh_processing::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(samples, to);
}

#endif // MESH_MEASURES_H
