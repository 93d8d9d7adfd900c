// Three sheets that meet in one curve, with a label for each: the result conforms, and keeps the labels. The program
// prints the numbers of triangles and of edges at which three of them meet, and the smallest quality, and writes
// sheets.off.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh_triangle_soup.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef K::Point_3                                            Point;

namespace HDR = CGAL::Hermite_diffuse_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

// Three curved sheets of n by n cells that meet in one curve: a soup with the points of the curve in common
void make_sheets(const int n, std::vector<Point>& points, std::vector<std::array<std::size_t, 3> >& triangles,
                 std::map<std::size_t, int>& labels)
{
  for(int i = 0; i <= n; ++i)
    points.push_back(Point(0.1 * std::sin(6. * i / n), 0., double(i) / n));
  for(int sheet = 0; sheet < 3; ++sheet)
  {
    const double c = std::cos(2.0943951 * sheet), s = std::sin(2.0943951 * sheet);
    const std::size_t first = points.size();
    for(int j = 1; j <= n; ++j)
      for(int i = 0; i <= n; ++i)
      {
        const double x = double(j) / n, y = 0.3 * x * x;
        points.push_back(Point(points[i].x() + c * x - s * y, s * x + c * y, points[i].z()));
      }
    const auto index = [&](const int i, const int j)
    { return j == 0 ? std::size_t(i) : first + (j - 1) * (n + 1) + i; };
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i)
        for(const bool is_lower : {true, false})
        {
          labels[triangles.size()] = sheet;
          triangles.push_back({{index(i, j), is_lower ? index(i + 1, j) : index(i + 1, j + 1),
                                is_lower ? index(i + 1, j + 1) : index(i, j + 1)}});
        }
  }
}

int main()
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::map<std::size_t, int> labels;                // of the triangles: the number of the sheet
  make_sheets(20, points, triangles, labels);

  typedef std::pair<std::size_t, std::size_t> Edge;  // the smaller index first
  std::map<Edge, HDR::Edge_class> edge_classes;
  const auto report = PMP::hermite_diffuse_remesh_triangle_soup(points, triangles,
    CGAL::parameters::approximation_error(0.005)
      .maximum_edge_length(0.1)
      .face_patch_map(boost::make_assoc_property_map(labels))
      .edge_class_map(boost::make_assoc_property_map(edge_classes)));

  std::size_t number_in_first_sheet = 0, number_of_junction_edges = 0;
  for(std::size_t i = 0; i < triangles.size(); ++i)
    number_in_first_sheet += labels[i] == 0;
  for(const auto& entry : edge_classes)
    number_of_junction_edges += entry.second == HDR::NON_MANIFOLD_EDGE;
  std::cout << triangles.size() << " triangles, " << number_in_first_sheet << " of them in the first sheet, "
            << number_of_junction_edges << " edges on the curve in common, smallest quality "
            << report.smallest_quality << std::endl;
  CGAL::IO::write_polygon_soup("sheets.off", points, triangles, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
