#ifndef SIZED_SURFACES_H
#define SIZED_SURFACES_H

// Surfaces whose sizes are known: irregular meshes of them, the length that a law L/R asks for at a
// point, and how well the edges of a mesh follow it.

#include "analytic_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace analytic {

// What a remeshing is asked for. The flat parts have the largest length and what the gradation, as a
// slope of the size with the distance, makes of the neighbouring sizes.
struct Sizes_asked
{
  double length_over_radius;
  double maximum_length;
  double slope;

  double graded(const double size, const double distance) const
  {
    return (std::min)(maximum_length, size + slope * distance);
  }
};

struct Sized_torus : public Torus
{
  double law(const Point&, const Sizes_asked& asked) const { return asked.length_over_radius * r; }
  double largest_radius() const { return r; }
};

// Frustum of a cone around the z axis with flat caps; a cylinder if the radii are the same.
struct Frustum
{
  double bottom = 1., top = 1., height = 2.;

  double slant() const { return std::hypot(height, bottom - top); }
  double radius_at(const double z) const { return bottom + (top - bottom) * z / height; }
  // of the side: the radius of the circle over the cosine of the slope
  double largest_radius() const { return (std::max)(bottom, top) * slant() / height; }

  double law(const Point& p, const Sizes_asked& asked) const
  {
    const double rho = std::hypot(p[0], p[1]);
    const double tolerance = 1e-9 * height;
    if(p[2] < tolerance || p[2] > height - tolerance)
    {
      const double rim = p[2] < tolerance ? bottom : top;
      return asked.graded(asked.length_over_radius * rim, rim - rho);
    }
    const double along = slant() / height, xi = asked.length_over_radius;
    return (std::min)({asked.maximum_length, xi * along * radius_at(p[2]),
                       xi * bottom + asked.slope * along * p[2], xi * top + asked.slope * along * (height - p[2])});
  }

  // caps and side share the vertices of the rims
  Triangles mesh(const int number_of_faces, const std::uint64_t seed) const
  {
    const double pi2 = 2. * pi, mean = (bottom + top) / 2.;
    // halved from ring to ring on the caps
    const int n = 1 << int(std::lround(std::log2(number_of_faces / 2. * pi2 * mean / (slant() + bottom + top)) / 2.));
    const double cell = pi2 * mean / n;
    const int rows = int(std::lround(slant() / cell));
    Triangles result = irregular_grid(n, rows, true, false, 0.5, seed, [this](const double u, const double v)
    {
      const double s = 2. * pi * u, r = radius_at(v * height);
      return Point{{r * std::cos(s), r * std::sin(s), v * height}};
    });
    add_cap(result, 0, n, 0., bottom, false, seed + 1);
    add_cap(result, rows * n, n, height, top, true, seed + 2);
    return result;
  }

private:
  // rings of n vertices towards the middle, where n falls to a half when they crowd
  static void add_cap(Triangles& mesh, const std::size_t first, const int number, const double z, const double radius,
                      const bool is_up, const std::uint64_t seed)
  {
    Random random(seed);
    std::vector<std::size_t> ring(number);
    for(int i = 0; i < number; ++i)
      ring[i] = first + i;
    const auto add = [&](const std::size_t a, const std::size_t b, const std::size_t c)
    {
      if(is_up)
        mesh.faces.push_back({{a, b, c}});
      else
        mesh.faces.push_back({{a, c, b}});
    };
    double r = radius;
    const double step = 2. * pi * radius / number;
    while(ring.size() >= 8)
    {
      const std::size_t n = ring.size();
      const double next_r = r - step;
      if(next_r < step)
        break;
      const std::size_t m = 2. * pi * next_r / double(n) < 0.7 * step ? n / 2 : n;
      std::vector<std::size_t> inner(m);
      for(std::size_t i = 0; i < m; ++i)
      {
        const double angle = 2. * pi * (double(i) + random(-0.2, 0.2)) / double(m);
        const double s = next_r + random(-0.2, 0.2) * step;
        inner[i] = mesh.points.size();
        mesh.points.push_back({{s * std::cos(angle), s * std::sin(angle), z}});
      }
      for(std::size_t i = 0; i < n; ++i)
      {
        const std::size_t j = (i + 1) % n;
        if(m == n)
        {
          add(ring[i], ring[j], inner[j]);
          add(ring[i], inner[j], inner[i]);
        }
        else
        {
          add(ring[i], ring[j], i % 2 == 0 ? inner[i / 2] : inner[((i + 1) / 2) % m]);
          if(i % 2 == 1)
            add(ring[i], inner[((i + 1) / 2) % m], inner[i / 2]);
        }
      }
      ring = inner;
      r = next_r;
    }
    mesh.points.push_back({{0., 0., z}});
    for(std::size_t i = 0; i < ring.size(); ++i)
      add(ring[i], ring[(i + 1) % ring.size()], mesh.points.size() - 1);
  }
};

struct Ellipsoid_123
{
  double a = 1., b = 2., c = 3.;

  // of a point near the surface, up to its square: the value of the implicit form over the length of the gradient
  double distance(const Point& p) const
  {
    const double axes[3] = {a, b, c};
    double value = -1., square = 0.;
    for(int i = 0; i < 3; ++i)
    {
      const double s = axes[i] * axes[i];
      value += p[i] * p[i] / s;
      square += 4. * p[i] * p[i] / (s * s);
    }
    return std::abs(value) / std::sqrt(square);
  }

  // F. R. Gauss' formulae for the implicit form; the point is first scaled onto the surface
  double largest_curvature_at(const Point& q) const
  {
    const double axes[3] = {a, b, c};
    double value = 0.;
    for(int i = 0; i < 3; ++i)
      value += q[i] * q[i] / (axes[i] * axes[i]);
    double g = 0., square = 0., sum = 0., product = 1.;
    for(int i = 0; i < 3; ++i)
    {
      const double x2 = q[i] * q[i] / value, s = axes[i] * axes[i];
      g += x2 / (s * s);
      square += x2;
      sum += s;
      product *= s;
    }
    const double K = 1. / (product * g * g), H = std::abs(square - sum) / (2. * product * std::pow(g, 1.5));
    return H + std::sqrt((std::max)(0., H * H - K));
  }

  double law(const Point& p, const Sizes_asked& asked) const
  {
    return (std::min)(asked.maximum_length, asked.length_over_radius / largest_curvature_at(p));
  }
  // where the longest axes span the surface
  double largest_radius() const { return c * c / a; }

  // a cube whose six faces are grids, seen from its centre
  Triangles mesh(const int number_of_faces, const std::uint64_t seed) const
  {
    const int n = int(std::lround(std::sqrt(number_of_faces / 12.)));
    Random random(seed);
    Triangles result;
    std::map<std::array<int, 3>, std::size_t> known;
    const auto vertex = [&](const std::array<int, 3>& key)
    {
      const auto inserted = known.insert(std::make_pair(key, result.points.size()));
      if(inserted.second)
      {
        double d[3], norm2 = 0.;
        for(int i = 0; i < 3; ++i)
        {
          // vertices of the cube's edges slide along them
          const double shift = random(-0.25, 0.25);
          d[i] = std::tan(pi / 4. * (2. * (key[i] + (key[i] > 0 && key[i] < n ? shift : 0.)) / n - 1.));
          norm2 += d[i] * d[i];
        }
        const double norm = std::sqrt(norm2);
        result.points.push_back({{a * d[0] / norm, b * d[1] / norm, c * d[2] / norm}});
      }
      return inserted.first->second;
    };
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            const auto at = [&](const int u, const int v)
            {
              std::array<int, 3> key;
              key[axis] = side * n;
              key[(axis + 1) % 3] = side == 1 ? u : v;
              key[(axis + 2) % 3] = side == 1 ? v : u;
              return vertex(key);
            };
            result.add_quadrangle({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}}, random);
          }
    return result;
  }
};

// How the edges follow the lengths that they should have.
struct Size_statistics
{
  double half_to_twice = 0.;            // part of the edges
  double within_sqrt2 = 0.;             // part between 1/sqrt(2) and sqrt(2)
  double mean_log2 = 0.;                // of length over law
  double adjacent_ratio_99 = 0.;        // 99th percentile, of the mean edge lengths of adjacent faces
};

// `law(p)`: the length at the middle of an edge
template <typename Mesh, typename PointOfVertex, typename Law>
Size_statistics size_statistics(const Mesh& mesh, const PointOfVertex& point, const Law& law)
{
  Size_statistics result;
  const auto length = [&](const auto h)
  {
    const Point p = point(source(h, mesh)), q = point(target(h, mesh));
    return std::sqrt((p[0]-q[0]) * (p[0]-q[0]) + (p[1]-q[1]) * (p[1]-q[1]) + (p[2]-q[2]) * (p[2]-q[2]));
  };
  const auto perimeter = [&](const auto h)
  { return length(h) + length(next(h, mesh)) + length(next(next(h, mesh), mesh)); };
  std::vector<double> ratios;
  double number = 0.;
  for(const auto e : edges(mesh))
  {
    const auto h = halfedge(e, mesh);
    const Point p = point(source(h, mesh)), q = point(target(h, mesh));
    const double log2 = std::log2(length(h) / law(Point{{(p[0]+q[0]) / 2., (p[1]+q[1]) / 2., (p[2]+q[2]) / 2.}}));
    ++number;
    result.half_to_twice += std::abs(log2) <= 1.;
    result.within_sqrt2 += std::abs(log2) <= 0.5;
    result.mean_log2 += log2;
    if(is_border(h, mesh) || is_border(opposite(h, mesh), mesh))
      continue;
    const double s = perimeter(h), t = perimeter(opposite(h, mesh));
    ratios.push_back((std::max)(s / t, t / s));
  }
  result.half_to_twice /= number;
  result.within_sqrt2 /= number;
  result.mean_log2 /= number;
  std::sort(ratios.begin(), ratios.end());
  if(!ratios.empty())
    result.adjacent_ratio_99 = ratios[std::size_t(0.99 * double(ratios.size() - 1))];
  return result;
}

} // namespace analytic

#endif // SIZED_SURFACES_H
