#ifndef IRREGULAR_MESHES_H
#define IRREGULAR_MESHES_H

// Strongly irregular meshes of surfaces whose closest point, normal and curvatures are known. They
// are made irregular in the parameter plane, or on the unit sphere, and then mapped: all vertices
// lie on the surface to rounding.

#include "analytic_surfaces.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>

namespace analytic {

inline Point operator+(const Point& a, const Point& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
inline Point operator-(const Point& a, const Point& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
inline Point operator*(const double s, const Point& a) { return {{s * a[0], s * a[1], s * a[2]}}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline Point unit(const Point& a) { return 1. / norm(a) * a; }
inline Point cross(const Point& a, const Point& b)
{
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

// What is known of a surface at one of its points. A curvature is negative where the surface bends
// away from its normal.
struct Truth
{
  Point point, normal;
  double maximum, minimum;          // principal curvatures
};

// The parameter domain: points in the plane z = 0, periodic if `period` is positive, or on the unit
// sphere. Side k of a face goes from its corner k to its corner k+1.
class Parameter_mesh
{
public:
  std::vector<Point> points;
  std::vector<std::array<int, 3> > faces;
  bool is_sphere = false;
  double period[2] = {0., 0.};

private:
  std::vector<std::array<int, 3> > m_neighbors;     // 3 * face + side across a side, or -1
  std::vector<char> m_is_border;

public:
  // `nu` by `nv` unit cells
  static Parameter_mesh grid(const int nu, const int nv, const bool is_periodic_u, const bool is_periodic_v)
  {
    Parameter_mesh mesh;
    mesh.period[0] = is_periodic_u ? nu : 0.;
    mesh.period[1] = is_periodic_v ? nv : 0.;
    const int columns = is_periodic_u ? nu : nu + 1, rows = is_periodic_v ? nv : nv + 1;
    for(int j = 0; j < rows; ++j)
      for(int i = 0; i < columns; ++i)
        mesh.points.push_back({{double(i), double(j), 0.}});
    const auto vertex = [&](const int i, const int j) { return j % rows * columns + i % columns; };
    for(int j = 0; j < nv; ++j)
      for(int i = 0; i < nu; ++i)
      {
        mesh.faces.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)}});
        mesh.faces.push_back({{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)}});
      }
    return mesh;
  }

  // an icosahedron, every face of it in n^2 faces
  static Parameter_mesh icosphere(const int n)
  {
    Parameter_mesh mesh;
    mesh.is_sphere = true;
    const double g = (1. + std::sqrt(5.)) / 2.;
    std::vector<Point> corners;
    for(int axis = 0; axis < 3; ++axis)
      for(const double s : {-1., 1.})
        for(const double t : {-g, g})
        {
          Point p;
          p[axis] = 0.;
          p[(axis + 1) % 3] = s;
          p[(axis + 2) % 3] = t;
          corners.push_back(p);
        }
    std::map<std::array<long, 3>, int> known;
    const auto vertex = [&](const Point& p)
    {
      const Point q = unit(p);
      const std::array<long, 3> key = {{std::lround(1e8 * q[0]), std::lround(1e8 * q[1]), std::lround(1e8 * q[2])}};
      const auto inserted = known.insert(std::make_pair(key, int(mesh.points.size())));
      if(inserted.second)
        mesh.points.push_back(q);
      return inserted.first->second;
    };
    for(int a = 0; a < 12; ++a)
      for(int b = a + 1; b < 12; ++b)
        for(int c = b + 1; c < 12; ++c)
        {
          const Point p = corners[a];
          Point u = corners[b] - p, v = corners[c] - p;
          if(norm(u) > 2.1 || norm(v) > 2.1 || norm(u - v) > 2.1)   // edges have length 2
            continue;
          if(dot(cross(u, v), p) < 0.)
            std::swap(u, v);
          const auto at = [&](const int i, const int j) { return vertex(p + double(i) / n * u + double(j) / n * v); };
          for(int i = 0; i < n; ++i)
            for(int j = 0; i + j < n; ++j)
            {
              mesh.faces.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)}});
              if(i + j + 1 < n)
                mesh.faces.push_back({{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
            }
        }
    return mesh;
  }

  void make_irregular(const std::uint64_t seed)
  {
    Random random(seed);
    const std::size_t number_of_faces = faces.size();
    for(std::size_t f = 0; f < number_of_faces; ++f)
      if(random(0., 1.) < 0.1)
        insert_vertex(int(f), random);
    connect();
    for(int pass = 0; pass < 3; ++pass)
      flip_better(1., random);
    jitter(0.4, random);
    flip_better(0.7, random);
    jitter(0.3, random);
    flip_random(0.12, random);
  }

private:
  Point difference(const int from, const int to) const
  {
    Point d = points[to] - points[from];
    for(int i = 0; i < 2; ++i)
      if(period[i] > 0.)
        d[i] -= period[i] * std::round(d[i] / period[i]);
    return d;
  }

  Point up(const int v) const { return is_sphere ? points[v] : Point{{0., 0., 1.}}; }

  // in degrees; negative if the face is turned over
  double smallest_angle(const int a, const int b, const int c) const
  {
    const int v[3] = {a, b, c};
    double smallest = 180.;
    for(int k = 0; k < 3; ++k)
    {
      const Point d = difference(v[k], v[(k + 1) % 3]), e = difference(v[k], v[(k + 2) % 3]);
      const Point n = cross(d, e);
      smallest = (std::min)(smallest, std::atan2(dot(n, up(v[k])) > 0. ? norm(n) : -norm(n), dot(d, e)) * 180. / pi);
    }
    return smallest;
  }
  double smallest_angle(const int f) const { return smallest_angle(faces[f][0], faces[f][1], faces[f][2]); }

  void insert_vertex(const int f, Random& random)
  {
    double l[3], sum = 0.;
    for(double& x : l)
      sum += x = random(0.2, 1.);
    const std::array<int, 3> t = faces[f];
    Point p = points[t[0]] + l[1] / sum * difference(t[0], t[1]) + l[2] / sum * difference(t[0], t[2]);
    if(is_sphere)
      p = unit(p);
    const int v = int(points.size());
    points.push_back(p);
    faces[f] = {{t[0], t[1], v}};
    faces.push_back({{t[1], t[2], v}});
    faces.push_back({{t[2], t[0], v}});
  }

  void connect()
  {
    std::map<std::pair<int, int>, int> sides;
    for(int f = 0; f < int(faces.size()); ++f)
      for(int k = 0; k < 3; ++k)
        sides[std::make_pair(faces[f][k], faces[f][(k + 1) % 3])] = 3 * f + k;
    m_neighbors.assign(faces.size(), {{-1, -1, -1}});
    m_is_border.assign(points.size(), 0);
    for(const auto& side : sides)
    {
      const auto twin = sides.find(std::make_pair(side.first.second, side.first.first));
      if(twin != sides.end())
        m_neighbors[side.second / 3][side.second % 3] = twin->second;
      else
        m_is_border[side.first.first] = m_is_border[side.first.second] = 1;
    }
  }

  // the other diagonal of the two faces of a side; false if the faces would get worse than `guard`,
  // or, with `must_improve`, not better
  bool flip(const int f, const int k, const double guard, const bool must_improve)
  {
    const int twin = m_neighbors[f][k];
    if(twin == -1)
      return false;
    const int g = twin / 3, l = twin % 3;
    const int a = faces[f][k], b = faces[f][(k + 1) % 3], c = faces[f][(k + 2) % 3], d = faces[g][(l + 2) % 3];
    const double after = (std::min)(smallest_angle(c, d, b), smallest_angle(d, c, a));
    if(after < guard || (must_improve && after <= (std::min)(smallest_angle(f), smallest_angle(g))))
      return false;
    // is there an edge c d already?
    int h = f, s = (k + 1) % 3;                     // side b c
    for(;;)
    {
      const int next = m_neighbors[h][(s + 1) % 3]; // around c
      if(next == -1)
        break;
      h = next / 3;
      s = next % 3;                                 // its side starts at c
      if(faces[h][(s + 1) % 3] == d)
        return false;
      s = (s + 2) % 3;                              // the side that ends at c
      if(faces[h][s] == d)
        return false;
      if(h == f)
        break;
    }
    const int bc = m_neighbors[f][(k + 1) % 3], ca = m_neighbors[f][(k + 2) % 3];
    const int ad = m_neighbors[g][(l + 1) % 3], db = m_neighbors[g][(l + 2) % 3];
    faces[f] = {{c, d, b}};
    faces[g] = {{d, c, a}};
    const auto link = [this](const int s1, const int s2)
    {
      m_neighbors[s1 / 3][s1 % 3] = s2;
      if(s2 != -1)
        m_neighbors[s2 / 3][s2 % 3] = s1;
    };
    link(3 * f, 3 * g);
    link(3 * f + 1, db);
    link(3 * f + 2, bc);
    link(3 * g + 1, ca);
    link(3 * g + 2, ad);
    return true;
  }

  void flip_better(const double probability, Random& random)
  {
    for(int f = 0; f < int(faces.size()); ++f)
      for(int k = 0; k < 3; ++k)
        if(random(0., 1.) < probability)
          flip(f, k, 0., true);
  }

  void flip_random(const double probability, Random& random)
  {
    for(int f = 0; f < int(faces.size()); ++f)
      for(int k = 0; k < 3; ++k)
        if(3 * f + k < m_neighbors[f][k] && random(0., 1.) < probability)
          flip(f, k, 18., false);
  }

  // vertices of the border slide along it, its corners stay
  void jitter(const double amplitude, Random& random)
  {
    std::vector<std::vector<int> > faces_of(points.size());
    for(int f = 0; f < int(faces.size()); ++f)
      for(const int v : faces[f])
        faces_of[v].push_back(f);
    for(int v = 0; v < int(points.size()); ++v)
    {
      double shortest = 1e30;
      Point along = {{0., 0., 0.}};
      int number_of_directions = 0;
      for(const int f : faces_of[v])
        for(int k = 0; k < 3; ++k)
          if(faces[f][k] == v)
            for(const int l : {(k + 1) % 3, (k + 2) % 3})
            {
              const Point d = difference(v, faces[f][l]);
              shortest = (std::min)(shortest, norm(d));
              if(!m_is_border[v] || m_neighbors[f][l == (k + 1) % 3 ? k : l] != -1)
                continue;
              if(number_of_directions > 0 && std::abs(dot(unit(d), along)) < 0.99)
                number_of_directions = 3;
              else
                ++number_of_directions;
              along = unit(d);
            }
      const double angle = random(0., 2. * pi), length = amplitude * shortest * std::sqrt(random(0., 1.));
      if(m_is_border[v] && number_of_directions != 2)
        continue;
      const Point old = points[v];
      const Point e = m_is_border[v] ? along
                    : is_sphere ? unit(cross(old, std::abs(old[0]) < 0.6 ? Point{{1., 0., 0.}} : Point{{0., 1., 0.}}))
                                : Point{{1., 0., 0.}};
      const Point f = m_is_border[v] ? Point{{0., 0., 0.}} : cross(up(v), e);
      for(double scale = 1.; scale > 0.2; scale /= 2.)
      {
        points[v] = old + scale * length * (std::cos(angle) * e + std::sin(angle) * f);
        if(is_sphere)
          points[v] = unit(points[v]);
        bool is_good = true;
        for(const int g : faces_of[v])
          is_good = is_good && smallest_angle(g) >= 12.;
        if(is_good)
          break;
        points[v] = old;
      }
    }
  }
};

// A surface with its truth and its meshes.
struct Test_surface
{
  std::string name;
  double largest_curvature;                               // for errors relative to it
  std::function<Parameter_mesh(int)> base;                // of about so many faces, before insertion
  std::function<Point(const Point&, const Parameter_mesh&)> map;      // domain to surface
  std::function<Truth(const Point&)> truth;               // at the closest point

  // about `number_of_faces` faces, a tenth of the regular ones having been split in three
  Triangles mesh(const int number_of_faces, const std::uint64_t seed) const
  {
    Parameter_mesh domain = base(int(number_of_faces / 1.2));
    const Parameter_mesh regular = domain;
    domain.make_irregular(seed);
    Triangles result;
    for(const Point& q : domain.points)
      result.points.push_back(map(q, regular));
    for(const std::array<int, 3>& f : domain.faces)
      result.faces.push_back({{std::size_t(f[0]), std::size_t(f[1]), std::size_t(f[2])}});
    return result;
  }
};

namespace detail {

// a grid of cells with sides in the given ratio (u to v) over a domain of given sides
inline std::function<Parameter_mesh(int)> grid_over(const double length_u, const double length_v, const double ratio,
                                                    const bool is_periodic_u, const bool is_periodic_v)
{
  return [=](const int number_of_faces)
  {
    const double side = std::sqrt(2. * length_u * length_v / (ratio * number_of_faces));   // of a cell, along v
    const int nu = int((std::max)(3l, std::lround(length_u / (ratio * side))));
    const int nv = int((std::max)(3l, std::lround(length_v / side)));
    return Parameter_mesh::grid(nu, nv, is_periodic_u, is_periodic_v);
  };
}

inline std::function<Parameter_mesh(int)> icosphere()
{
  return [](const int number_of_faces)
  { return Parameter_mesh::icosphere(int(std::lround(std::sqrt(number_of_faces / 20.)))); };
}

// u and v in [0,1] of a point of a grid
inline std::array<double, 2> unit_coordinates(const Point& q, const Parameter_mesh& grid)
{
  const Point& last = grid.points.back();
  std::array<double, 2> result;
  for(int i = 0; i < 2; ++i)
    result[i] = q[i] / (grid.period[i] > 0. ? grid.period[i] : last[i]);
  return result;
}

// from the gradient and the second derivatives (xx, yy, zz, xy, yz, zx) of F at a zero of F
inline Truth implicit(const Point& p, const Point& g, const std::array<double, 6>& h)
{
  const double length = norm(g);
  const Point n = 1. / length * g;
  const Point hn = {{h[0] * n[0] + h[3] * n[1] + h[5] * n[2], h[3] * n[0] + h[1] * n[1] + h[4] * n[2],
                     h[5] * n[0] + h[4] * n[1] + h[2] * n[2]}};
  const double mean = -(h[0] + h[1] + h[2] - dot(n, hn)) / (2. * length);
  // Gaussian curvature: n . adj(Hessian) n / |g|^2
  const double a00 = h[1] * h[2] - h[4] * h[4], a11 = h[0] * h[2] - h[5] * h[5], a22 = h[0] * h[1] - h[3] * h[3];
  const double a01 = h[5] * h[4] - h[3] * h[2], a12 = h[3] * h[5] - h[0] * h[4], a20 = h[3] * h[4] - h[1] * h[5];
  const double gauss = (a00 * n[0] * n[0] + a11 * n[1] * n[1] + a22 * n[2] * n[2]
                        + 2. * (a01 * n[0] * n[1] + a12 * n[1] * n[2] + a20 * n[2] * n[0])) / (length * length);
  const double root = std::sqrt((std::max)(0., mean * mean - gauss));
  return {p, n, mean + root, mean - root};
}

// a height and its derivatives x, y, xx, xy, yy
typedef std::array<double, 6> Jet;

inline Truth graph_truth(const Point& p, const std::function<Jet(double, double)>& height)
{
  double x = p[0], y = p[1];
  for(int i = 0; i < 20; ++i)
  {
    const Jet f = height(x, y);
    const double e = f[0] - p[2];
    const double gx = x - p[0] + e * f[1], gy = y - p[1] + e * f[2];
    const double hxx = 1. + f[1] * f[1] + e * f[3], hxy = f[1] * f[2] + e * f[4], hyy = 1. + f[2] * f[2] + e * f[5];
    const double det = hxx * hyy - hxy * hxy;
    const double dx = (hyy * gx - hxy * gy) / det, dy = (hxx * gy - hxy * gx) / det;
    x -= dx;
    y -= dy;
    if(dx * dx + dy * dy < 1e-30)
      break;
  }
  const Jet f = height(x, y);
  return implicit({{x, y, f[0]}}, {{-f[1], -f[2], 1.}}, {{-f[3], -f[5], 0., -f[4], 0., 0.}});
}

inline Truth torus_truth(const Point& p, const Torus& torus)
{
  const double rho = std::hypot(p[0], p[1]);
  const Point center = {{torus.R * p[0] / rho, torus.R * p[1] / rho, 0.}};
  const Point n = unit(p - center), q = center + torus.r * n;
  const std::pair<double, double> k = torus.curvatures(q);
  return {q, n, (std::max)(k.first, k.second), (std::min)(k.first, k.second)};
}

inline Truth ellipsoid_truth(const Point& p, const Point& axes)
{
  // x_i = a_i^2 p_i / (a_i^2 + t) with sum (x_i/a_i)^2 = 1
  double t = 0.;
  for(int i = 0; i < 50; ++i)
  {
    double value = -1., slope = 0.;
    for(int k = 0; k < 3; ++k)
    {
      const double a2 = axes[k] * axes[k], s = axes[k] * p[k] / (a2 + t);
      value += s * s;
      slope -= 2. * s * s / (a2 + t);
    }
    const double step = value / slope;
    t -= step;
    if(std::abs(step) < 1e-16)
      break;
  }
  Point q, g;
  std::array<double, 6> h = {{0., 0., 0., 0., 0., 0.}};
  for(int k = 0; k < 3; ++k)
  {
    const double a2 = axes[k] * axes[k];
    q[k] = a2 * p[k] / (a2 + t);
    g[k] = 2. * q[k] / a2;
    h[k] = 2. / a2;
  }
  return implicit(q, g, h);
}

// radius r0 + slope * z around the z axis
inline Truth cone_truth(const Point& p, const double r0, const double slope)
{
  const double rho = std::hypot(p[0], p[1]), w = std::sqrt(1. + slope * slope);
  const double excess = (rho - r0 - slope * p[2]) / w;
  const Point n = {{p[0] / (rho * w), p[1] / (rho * w), -slope / w}};
  const Point q = p - excess * n;
  return {q, n, 0., -1. / (w * std::hypot(q[0], q[1]))};
}

} // namespace detail

inline Test_surface sphere(const double squeeze = 1.)
{
  return {squeeze == 1. ? "sphere" : "sphere stretched", 1., detail::icosphere(),
          [=](const Point& q, const Parameter_mesh&) { return unit({{q[0], q[1], squeeze * q[2]}}); },
          [](const Point& p) { return Truth{unit(p), unit(p), -1., -1.}; }};
}

inline Test_surface torus(const double stretch = 1.)
{
  const Torus torus;
  return {stretch == 1. ? "torus" : "torus stretched", torus.largest_curvature(),
          detail::grid_over(torus.R, torus.r, stretch, true, true),
          [=](const Point& q, const Parameter_mesh& grid)
          { const auto u = detail::unit_coordinates(q, grid); return torus(u[0], u[1]); },
          [=](const Point& p) { return detail::torus_truth(p, torus); }};
}

inline Test_surface ellipsoid()
{
  const Point axes = {{1., 2., 3.}};
  return {"ellipsoid", axes[2] / (axes[0] * axes[0]), detail::icosphere(),
          [=](const Point& q, const Parameter_mesh&)
          { return Point{{axes[0] * q[0], axes[1] * q[1], axes[2] * q[2]}}; },
          [=](const Point& p) { return detail::ellipsoid_truth(p, axes); }};
}

inline Test_surface frustum(const std::string& name, const double r0, const double slope, const double height,
                            const double stretch)
{
  const double length = height * std::sqrt(1. + slope * slope), middle = r0 + slope * height / 2.;
  return {name, 1. / ((std::min)(r0, r0 + slope * height) * std::sqrt(1. + slope * slope)),
          detail::grid_over(2. * pi * middle, length, 1. / stretch, true, false),
          [=](const Point& q, const Parameter_mesh& grid)
          {
            const auto u = detail::unit_coordinates(q, grid);
            const double z = height * u[1], r = r0 + slope * z;
            return Point{{r * std::cos(2. * pi * u[0]), r * std::sin(2. * pi * u[0]), z}};
          },
          [=](const Point& p) { return detail::cone_truth(p, r0, slope); }};
}

inline Test_surface cylinder() { return frustum("cylinder", 1., 0., 2., 1.); }
inline Test_surface long_thin_cylinder() { return frustum("cylinder stretched", 1., 0., 2., 6.); }
inline Test_surface cone() { return frustum("cone", 1., -0.5, 1.5, 1.); }

inline Test_surface graph(const std::string& name, const double half_side, const double stretch,
                          const double largest_curvature, const std::function<detail::Jet(double, double)>& height)
{
  return {name, largest_curvature, detail::grid_over(2. * half_side, 2. * half_side, stretch, false, false),
          [=](const Point& q, const Parameter_mesh& grid)
          {
            const auto u = detail::unit_coordinates(q, grid);
            const double x = half_side * (2. * u[0] - 1.), y = half_side * (2. * u[1] - 1.);
            return Point{{x, y, height(x, y)[0]}};
          },
          [=](const Point& p) { return detail::graph_truth(p, height); }};
}

inline Test_surface sin_cos(const double stretch = 1.)
{
  const std::string name = stretch == 1. ? "sin x cos y" : "sin x cos y stretched";
  return graph(name, pi, stretch, 1., [](const double x, const double y)
  {
    const double sx = std::sin(x), cx = std::cos(x), sy = std::sin(y), cy = std::cos(y);
    return detail::Jet{{sx * cy, cx * cy, -sx * sy, -sx * cy, -cx * sy, -sx * cy}};
  });
}

inline Test_surface bump()
{
  return graph("bump", 2., 1., 2., [](const double x, const double y)
  {
    const double f = std::exp(-x * x - y * y);
    return detail::Jet{{f, -2. * x * f, -2. * y * f, (4. * x * x - 2.) * f, 4. * x * y * f, (4. * y * y - 2.) * f}};
  });
}

inline std::vector<Test_surface> all_test_surfaces()
{
  return {sphere(), torus(), ellipsoid(), cylinder(), cone(), sin_cos(), bump(),
          torus(6.), sphere(5.), sin_cos(5.), long_thin_cylinder()};
}

} // namespace analytic

#endif // IRREGULAR_MESHES_H
