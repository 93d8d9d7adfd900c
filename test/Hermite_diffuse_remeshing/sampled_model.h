#ifndef SAMPLED_MODEL_H
#define SAMPLED_MODEL_H

// The smooth model of a mesh as a fine mesh, for measures that know nothing of the package's own.

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Reference.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

// Every face of the input is cut into n^2 parts with their corners on the model, n such that facets and
// model are about `tolerance` apart. The parts of two faces need not match along their edge: they are
// as close to the model, and so to each other, as that. Each part has its own vertices.
template <typename Mesh, typename Parameters>
Mesh sampled_model(const Mesh& input, const Parameters& parameters, const double tolerance,
                   const int largest_number = 64)
{
  using namespace CGAL::Hermite_diffuse_remeshing::internal;
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type
    Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;

  const auto& named = pack(parameters);
  const auto input_mesh = read_input<Kernel>(input, named);
  const Indexed_triangles& triangles = input_mesh.triangles;
  const std::unique_ptr<Input_model> model = read_model(input_mesh, named);
  Size_options options;
  options.minimum_length = options.maximum_length = model_diameter(triangles);
  Size_map sizes(model->surface, model->edges, model->curves, options);
  const Feature_displacements displacements(model->surface, model->edges, model->curves, Progress());
  const Reference reference{model->edges, model->edge_classes, model->vertex_classes, model->curves,
                            model->surface, model->locator, displacements, sizes};

  Mesh result;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
  {
    const auto at = [&](const double u, const double v)
    {
      Location location;
      location.face = f;
      location.coordinates = {{(std::max)(0., 1. - u - v), u, v}};
      return reference.surface_point(location);
    };
    // The surface is bent like a cubic at most: what n = 4 leaves between its points falls with n^2.
    constexpr int probes = 4;
    double gap = 0.;
    for(int i = 0; i < probes; ++i)
      for(int j = 0; i + j < probes; ++j)
      {
        const double h = 1. / probes, u = h * i, v = h * j;
        const Vector a = at(u, v), b = at(u + h, v), c = at(u, v + h);
        gap = (std::max)({gap, (at(u + h / 2., v) - (a + b) / 2.).norm(), (at(u, v + h / 2.) - (a + c) / 2.).norm(),
                          (at(u + h / 2., v + h / 2.) - (b + c) / 2.).norm(),
                          (at(u + h / 3., v + h / 3.) - (a + b + c) / 3.).norm()});
      }
    const int n = (std::min)(largest_number, (std::max)(1, int(std::ceil(probes * std::sqrt(gap / tolerance)))));
    const auto vertex = [&](const int i, const int j)
    {
      const Vector p = at(double(i) / n, double(j) / n);
      const auto v = add_vertex(result);
      put(CGAL::vertex_point, result, v, Point(p[0], p[1], p[2]));
      return v;
    };
    std::vector<std::vector<typename Graph_traits::vertex_descriptor> > grid(n + 1);
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        grid[i].push_back(vertex(i, j));
    for(int i = 0; i < n; ++i)
      for(int j = 0; i + j < n; ++j)
      {
        CGAL::Euler::add_face(std::array<typename Graph_traits::vertex_descriptor, 3>
                              {{grid[i][j], grid[i+1][j], grid[i][j+1]}}, result);
        if(i + j + 1 < n)
          CGAL::Euler::add_face(std::array<typename Graph_traits::vertex_descriptor, 3>
                                {{grid[i+1][j], grid[i+1][j+1], grid[i][j+1]}}, result);
      }
  }
  return result;
}

#endif // SAMPLED_MODEL_H
