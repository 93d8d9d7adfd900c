#ifndef SOUPS_H
#define SOUPS_H

// Non-manifold surfaces as soups of triangles.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soups {

constexpr double pi = 3.14159265358979323846;

typedef std::array<double, 3> Point;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::vector<int> labels;

  // joins points that are equal up to rounding
  std::size_t point(const Point& p)
  {
    std::array<long long, 3> key;
    for(int i = 0; i < 3; ++i)
      key[i] = std::llround(p[i] * 1e7);
    const auto found = m_index.insert(std::make_pair(key, points.size()));
    if(found.second)
      points.push_back(p);
    return found.first->second;
  }

  void triangle(const std::size_t a, const std::size_t b, const std::size_t c, const int label)
  {
    if(a == b || b == c || c == a)
      return;
    triangles.push_back({{a, b, c}});
    labels.push_back(label);
  }

  // the image of a grid of m by n cells over the unit square; cells that meet in a point become triangles
  void sheet(const int m, const int n, const int label, const std::function<Point(double, double)>& f,
             const bool is_turned = false)
  {
    const auto at = [&](const int i, const int j) { return point(f(double(i) / m, double(j) / n)); };
    for(int i = 0; i < m; ++i)
      for(int j = 0; j < n; ++j)
      {
        std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        if(is_turned)
          std::swap(b, d);
        triangle(a, b, c, label);
        triangle(a, c, d, label);
      }
  }

private:
  std::map<std::array<long long, 3>, std::size_t> m_index;
};

// three bent sheets on one curve
inline Soup three_sheets(const int n)
{
  Soup soup;
  for(int k = 0; k < 3; ++k)
    soup.sheet(n, n, k, [k](const double u, const double v)
    {
      const double angle = 2. * pi * k / 3., x = v, y = 0.3 * v * v;
      const double cx = 0.2 * std::sin(2. * u), cy = 0.15 * u * (1. - u);
      return Point{{cx + std::cos(angle) * x - std::sin(angle) * y, cy + std::sin(angle) * x + std::cos(angle) * y,
                    1.5 * u}};
    }, k == 1);       // one is turned over
  return soup;
}

// a plate that stands on the middle line of another
inline Soup t_of_plates(const int n)
{
  Soup soup;
  soup.sheet(2 * n, 2 * n, 0, [](const double u, const double v) { return Point{{2. * u - 1., 2. * v - 1., 0.}}; });
  soup.sheet(2 * n, n, 1, [](const double u, const double v) { return Point{{2. * u - 1., 0., v}}; });
  return soup;
}

// two unit cubes with a common face
inline Soup two_cubes(const int n)
{
  Soup soup;
  const auto box = [&](const double x, const bool has_left_face, const int label)
  {
    soup.sheet(n, n, label, [x](const double u, const double v) { return Point{{x + u, v, 0.}}; }, true);
    soup.sheet(n, n, label, [x](const double u, const double v) { return Point{{x + u, v, 1.}}; });
    soup.sheet(n, n, label, [x](const double u, const double v) { return Point{{x + u, 0., v}}; });
    soup.sheet(n, n, label, [x](const double u, const double v) { return Point{{x + u, 1., v}}; }, true);
    soup.sheet(n, n, label, [x](const double u, const double v) { return Point{{x + 1., u, v}}; });
    if(has_left_face)
      soup.sheet(n, n, label, [x](const double u, const double v) { return Point{{x, u, v}}; }, true);
  };
  box(0., true, 0);
  box(1., false, 1);
  return soup;
}

// two cones whose tips touch, with bases
inline Soup two_cones(const int n)
{
  Soup soup;
  for(const int side : {-1, 1})
  {
    soup.sheet(4 * n, n, side, [side](const double u, const double v)
    { return Point{{0.7 * v * std::cos(2. * pi * u), 0.7 * v * std::sin(2. * pi * u), side * v}}; }, side > 0);
    soup.sheet(4 * n, n, side, [side](const double u, const double v)
    { return Point{{0.7 * v * std::cos(2. * pi * u), 0.7 * v * std::sin(2. * pi * u), double(side)}}; }, side < 0);
  }
  return soup;
}

inline Soup moebius_strip(const int n)
{
  Soup soup;
  soup.sheet(10 * n, n, 0, [](const double u, const double v)
  {
    const double s = 2. * pi * u, w = 0.6 * (v - 0.5);
    return Point{{(1. + w * std::cos(s / 2.)) * std::cos(s), (1. + w * std::cos(s / 2.)) * std::sin(s),
                  w * std::sin(s / 2.)}};
  });
  return soup;
}

// Three balls in a row that overlap, each with its own sphere, and the lenses between them divided by flat walls:
// along each of the two circles three sheets meet.
inline Soup three_balls(const int n)
{
  Soup soup;
  const double distance = 1.4, radius = 1., half = distance / 2., circle = std::sqrt(radius * radius - half * half);
  const double opening = std::acos(half / radius);
  const auto on_sphere = [=](const double center, const double polar, const double u)
  {
    return Point{{center + radius * std::cos(polar), radius * std::sin(polar) * std::cos(2. * pi * u),
                  radius * std::sin(polar) * std::sin(2. * pi * u)}};
  };
  const auto wall = [=](const double x, const double u, const double v)
  { return Point{{x, circle * v * std::cos(2. * pi * u), circle * v * std::sin(2. * pi * u)}}; };
  soup.sheet(6 * n, 2 * n, 1, [=](const double u, const double v)
  { return on_sphere(-distance, opening + v * (pi - opening), u); });
  soup.sheet(6 * n, 2 * n, 2, [=](const double u, const double v)
  { return on_sphere(0., opening + v * (pi - 2. * opening), u); });
  soup.sheet(6 * n, 2 * n, 3, [=](const double u, const double v)
  { return on_sphere(distance, v * (pi - opening), u); });
  for(const double x : {-half, half})
    soup.sheet(6 * n, n, 4, [=](const double u, const double v) { return wall(x, u, v); });
  return soup;
}

} // namespace soups

#endif // SOUPS_H
