// The surface model alone: points, normals, curvatures, and projection.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;
typedef CGAL::Hermite_diffuse_surface<Mesh>                   Surface;

int main()
{
  // a coarse mesh of the unit sphere: 320 faces
  const K::Point_3 center(0., 0., 0.);
  Mesh mesh;
  CGAL::make_icosahedron(mesh, center, 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  for(const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = center + (mesh.point(v) - center) / std::sqrt(CGAL::squared_distance(mesh.point(v), center));

  const Surface surface(mesh);

  // in the middle of a face: 0.016 below the sphere, but the surface is not
  const Surface::Face_location middle(*mesh.faces().begin(), {{1. / 3., 1. / 3., 1. / 3.}});
  const K::Point_3 p = surface.point(middle);
  const K::Vector_3 n = surface.normal(middle);
  const auto curvatures = surface.principal_curvatures(middle);
  const double radius = std::sqrt(CGAL::squared_distance(p, center));
  std::cout << "distance to the sphere " << radius - 1. << ", cosine between the normals " << n * (p - center) / radius
            << ", principal curvatures " << curvatures.first << ", " << curvatures.second << std::endl;

  // the closest point of the surface to a point far outside
  const K::Point_3 query(1., 2., 3.);
  const Surface::Face_location foot = surface.project(query);
  const K::Vector_3 expected = (query - center) / std::sqrt(14.);
  std::cout << "the projection is wrong by "
            << std::sqrt((surface.point(foot) - center - expected).squared_length()) << std::endl;

  const auto principal = surface.principal_curvatures_and_directions(foot);
  std::cout << "mean curvature " << principal.mean_curvature() << ", Gaussian " << principal.Gaussian_curvature()
            << std::endl;
  return std::abs(principal.Gaussian_curvature() - 1.) < 0.05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
