#ifndef ANALYTIC_SURFACES_H
#define ANALYTIC_SURFACES_H

// Irregular triangulations of surfaces whose points, normals and curvatures are known. All
// vertices lie on the surface to rounding. The irregularity is made by a generator of its own, so
// that every platform gets the same meshes.

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace analytic {

const double pi = 3.14159265358979323846;

struct Random
{
  std::uint64_t state;

  explicit Random(const std::uint64_t seed) : state(seed * 2862933555777941757ull + 3037000493ull) {}

  double operator()(const double low, const double high)
  {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return low + (high - low) * double(state >> 11) / 9007199254740992.;
  }
};

typedef std::array<double, 3> Point;

struct Triangles
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > faces;

  // as two triangles, by one of its diagonals
  void add_quadrangle(const std::array<std::size_t, 4>& v, Random& random)
  {
    const std::size_t first = random(0., 1.) < 0.5 ? 0 : 1;
    faces.push_back({{v[0], v[1], v[2 + first]}});
    faces.push_back({{v[first], v[2], v[3]}});
  }
};

// Rings of triangles around the z axis through points (radius, height), from below outwards and up; with a radius of zero
// there is one vertex on the axis.
inline Triangles surface_of_revolution(const int number_of_columns, const std::vector<std::array<double, 2> >& profile,
                                       Random& random)
{
  Triangles t;
  std::vector<std::size_t> first;
  for(const std::array<double, 2>& ring : profile)
  {
    first.push_back(t.points.size());
    for(int i = 0; i < (ring[0] > 0. ? number_of_columns : 1); ++i)
    {
      const double a = 2. * pi * i / number_of_columns;
      t.points.push_back({{ring[0] * std::cos(a), ring[0] * std::sin(a), ring[1]}});
    }
  }
  for(std::size_t j = 1; j < profile.size(); ++j)
    for(int i = 0; i < number_of_columns; ++i)
    {
      const auto at = [&](const std::size_t ring, const int column)
      { return profile[ring][0] > 0. ? first[ring] + column % number_of_columns : first[ring]; };
      if(!(profile[j-1][0] > 0.))
        t.faces.push_back({{at(j - 1, i), at(j, i + 1), at(j, i)}});
      else if(!(profile[j][0] > 0.))
        t.faces.push_back({{at(j - 1, i), at(j - 1, i + 1), at(j, i)}});
      else
        t.add_quadrangle({{at(j - 1, i), at(j - 1, i + 1), at(j, i + 1), at(j, i)}}, random);
    }
  return t;
}

// Two tubes along axes that meet in the origin, one of them from the left, the other turned upwards by an angle: `rows`
// rings of facets on each, all as long as the tubes if it is one. The points between are the seam's: of all, those from
// `rows` times the number of columns on.
inline Triangles mitred_tubes(const int columns, const int rows, const double radius, const double length,
                              const double bend, Random& random)
{
  Triangles t;
  for(int row = -rows; row <= rows; ++row)
    for(int i = 0; i < columns; ++i)
    {
      const double a = 2. * pi * i / columns, up = radius * std::cos(a), aside = radius * std::sin(a);
      // from the end of the tube to the plane that halves the angle between them
      const double part = std::abs(double(row)) / rows, angle = row > 0 ? bend : 0.;
      const double seam = up * std::tan(bend / 2.);
      const double along = row > 0 ? part * length + (1. - part) * seam : -(part * length + (1. - part) * seam);
      t.points.push_back({{along * std::cos(angle) - up * std::sin(angle),
                           along * std::sin(angle) + up * std::cos(angle), aside}});
    }
  for(int row = 0; row < 2 * rows; ++row)
    for(int i = 0; i < columns; ++i)
    {
      const std::size_t a = row * columns + i, b = row * columns + (i + 1) % columns;
      t.add_quadrangle({{a, b, b + columns, a + columns}}, random);
    }
  return t;
}

// A box whose edges and corners are rounded by parts of cylinders and of spheres, n facets around a quarter of a circle;
// its sides are of two triangles.
inline Triangles rounded_box(const Point& half_sides, const double radius, const int n, Random& random)
{
  Triangles t;
  const int columns = 4 * (n + 1), rows = 2 * (n + 1);
  // at the poles, where a quarter of all columns is one vertex
  const auto is_pole = [&](const int row) { return row == 0 || row == rows - 1; };
  std::vector<std::size_t> first;
  for(int row = 0; row < rows; ++row)
  {
    first.push_back(t.points.size());
    const bool is_upper = row > n;
    const double latitude = pi / 2. * (is_upper ? row - n - 1 : row - n) / n;
    for(int column = 0; column < columns; column += is_pole(row) ? n + 1 : 1)
    {
      const int quarter = column / (n + 1);
      const double longitude = pi / 2. * (quarter + double(column % (n + 1)) / n);
      const Point corner = {{(half_sides[0] - radius) * (quarter == 0 || quarter == 3 ? 1 : -1),
                             (half_sides[1] - radius) * (quarter < 2 ? 1 : -1),
                             (half_sides[2] - radius) * (is_upper ? 1 : -1)}};
      const double r = is_pole(row) ? 0. : radius * std::cos(latitude);
      t.points.push_back({{corner[0] + r * std::cos(longitude), corner[1] + r * std::sin(longitude),
                           corner[2] + radius * std::sin(latitude)}});
    }
  }
  const auto at = [&](const int row, const int column)
  { return first[row] + (is_pole(row) ? column % columns / (n + 1) : column % columns); };
  for(int row = 1; row < rows; ++row)
    for(int column = 0; column < columns; ++column)
    {
      const std::array<std::size_t, 4> v = {{at(row - 1, column), at(row - 1, column + 1), at(row, column + 1),
                                             at(row, column)}};
      if(v[0] == v[1])
        t.faces.push_back({{v[0], v[2], v[3]}});
      else if(v[2] == v[3])
        t.faces.push_back({{v[0], v[1], v[2]}});
      else
        t.add_quadrangle(v, random);
    }
  const std::size_t top = first[rows - 1];
  t.add_quadrangle({{3, 2, 1, 0}}, random);
  t.add_quadrangle({{top, top + 1, top + 2, top + 3}}, random);
  return t;
}

// A grid over [0,1]^2, nu by nv cells, with jittered inner vertices and random diagonals, mapped by
// `surface(u,v)`; periodic directions are closed.
template <typename Surface>
Triangles irregular_grid(const int nu, const int nv, const bool periodic_u, const bool periodic_v,
                         const double jitter, const std::uint64_t seed, const Surface& surface)
{
  Random random(seed);
  Triangles result;
  const int columns = periodic_u ? nu : nu + 1, rows = periodic_v ? nv : nv + 1;
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
    {
      const bool inner_u = periodic_u || (i > 0 && i < nu), inner_v = periodic_v || (j > 0 && j < nv);
      const double du = random(-jitter, jitter) / 2., dv = random(-jitter, jitter) / 2.;
      // vertices of the border stay on it and slide along it
      result.points.push_back(surface((i + (inner_u ? du : 0.)) / nu, (j + (inner_v ? dv : 0.)) / nv));
    }
  const auto vertex = [&](const int i, const int j)
  { return std::size_t(j % rows) * columns + std::size_t(i % columns); };
  for(int j = 0; j < nv; ++j)
    for(int i = 0; i < nu; ++i)
      result.add_quadrangle({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}}, random);
  return result;
}

struct Torus
{
  double R = 1., r = 0.4;

  Point operator()(const double u, const double v) const
  {
    const double s = 2. * pi * u, t = 2. * pi * v, w = R + r * std::cos(t);
    return {{w * std::cos(s), w * std::sin(s), r * std::sin(t)}};
  }

  double distance(const Point& p) const
  {
    return std::abs(std::hypot(std::hypot(p[0], p[1]) - R, p[2]) - r);
  }

  // principal curvatures with the sign of the fits: negative where the body is convex
  std::pair<double, double> curvatures(const Point& p) const
  {
    const double rho = std::hypot(p[0], p[1]);
    const double k = -(rho - R) / r / rho;
    return std::make_pair(k, -1. / r);
  }

  double largest_curvature() const { return (std::max)(1. / r, 1. / (R - r)); }

  Triangles mesh(const int number_of_faces, const std::uint64_t seed) const
  {
    // cells about square in the middle
    const int nv = int(std::lround(std::sqrt(number_of_faces / 2. * r / R)));
    const int nu = int(std::lround(number_of_faces / 2. / nv));
    return irregular_grid(nu, nv, true, true, 0.5, seed, *this);
  }
};

} // namespace analytic

#endif // ANALYTIC_SURFACES_H
