#ifndef MARCHING_TETRAHEDRA_H
#define MARCHING_TETRAHEDRA_H

// The zero set of a function on a regular grid, cut linearly out of six tetrahedra per cube: slivers and short edges, and
// vertices that are off a curved surface by up to an eighth of its curvature times the squared diagonal of a cube.

#include "analytic_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace analytic {

class Marching_tetrahedra
{
  typedef std::array<int, 3> Node;

  std::function<double(const Point&)> m_function;       // positive outside
  double m_first, m_step;
  std::map<std::pair<Node, Node>, std::size_t> m_cuts;

public:
  Triangles triangles;

  // in a cube around the origin, of n^3 cubes
  Marching_tetrahedra(const std::function<double(const Point&)>& function, const double half_width, const int n)
    : m_function(function), m_first(-half_width), m_step(2. * half_width / n)
  {
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        for(int k = 0; k < n; ++k)
        {
          std::array<int, 3> axes = {{0, 1, 2}};
          do
          {
            std::array<Node, 4> corners = {{{{i, j, k}}, {{i, j, k}}, {{i, j, k}}, {{i, j, k}}}};
            for(int c = 1; c < 4; ++c)
              for(int d = c; d < 4; ++d)
                ++corners[d][axes[c - 1]];
            const bool is_even = (axes[0] + 1) % 3 == axes[1];
            add_tetrahedron(corners, is_even);
          }
          while(std::next_permutation(axes.begin(), axes.end()));
        }
  }

private:
  Point point(const Node& node) const
  {
    return {{m_first + m_step * node[0], m_first + m_step * node[1], m_first + m_step * node[2]}};
  }
  double value(const Node& node) const { return m_function(point(node)); }

  std::size_t cut(const Node& a, const Node& b)
  {
    const auto inserted = m_cuts.emplace(std::minmax(a, b), triangles.points.size());
    if(inserted.second)
    {
      const Node &first = (std::min)(a, b), &second = (std::max)(a, b);
      const Point p = point(first), q = point(second);
      const double t = value(first) / (value(first) - value(second));
      triangles.points.push_back({{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}});
    }
    return inserted.first->second;
  }

  // `is_positive`: its orientation
  void add_tetrahedron(std::array<Node, 4> c, bool is_positive)
  {
    // those inside first; a transposition turns the orientation
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3 - i; ++j)
        if(value(c[j]) > 0. && !(value(c[j + 1]) > 0.))
        {
          std::swap(c[j], c[j + 1]);
          is_positive = !is_positive;
        }
    const auto number = std::count_if(c.begin(), c.end(), [&](const Node& node) { return !(value(node) > 0.); });
    if(number == 1)
      add(cut(c[0], c[1]), cut(c[0], c[2]), cut(c[0], c[3]), is_positive);
    else if(number == 3)
      add(cut(c[3], c[0]), cut(c[3], c[1]), cut(c[3], c[2]), is_positive);
    else if(number == 2)
    {
      const std::size_t ac = cut(c[0], c[2]), ad = cut(c[0], c[3]), bc = cut(c[1], c[2]), bd = cut(c[1], c[3]);
      add(ac, ad, bd, is_positive);
      add(ac, bd, bc, is_positive);
    }
  }

  void add(const std::size_t a, const std::size_t b, const std::size_t c, const bool is_positive)
  {
    if(is_positive)
      triangles.faces.push_back({{a, b, c}});
    else
      triangles.faces.push_back({{a, c, b}});
  }
};

} // namespace analytic

#endif // MARCHING_TETRAHEDRA_H
