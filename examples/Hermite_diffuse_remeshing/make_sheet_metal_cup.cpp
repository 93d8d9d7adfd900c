// Writes a deep-drawn sheet-metal cup as a triangle mesh with one border: flat bottom, punch
// fillet, slightly conical wall, die fillet, and a flat square flange with rounded corners.
// Every vertex lies on the exact surface; the triangulation is irregular, as that of a forming
// simulation, and is the same in every run.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel          K;
typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, K>  Vertex_base;
typedef CGAL::Triangulation_data_structure_2<Vertex_base>            Tds;
typedef CGAL::Delaunay_triangulation_2<K, Tds>                       Delaunay;
typedef std::vector<K::Point_3>                                      Points;
typedef std::vector<std::array<std::size_t, 3> >                     Triangles;

const double pi = 3.14159265358979323846;

// millimetres
const double bottom_radius = 32.;        // of the flat part
const double punch_fillet_radius = 8.;
const double die_fillet_radius = 6.;
const double wall_draft = 4. * pi / 180.;
const double wall_length = 28.;
const double flange_half_width = 75.;
const double flange_corner_radius = 25.;

// Each section of the profile is met at a tangent by the next one.
enum Section { BOTTOM, PUNCH_FILLET, WALL, DIE_FILLET, FLANGE };

struct Profile_point { double r, z; };

const double fillet_angle = 0.5 * pi - wall_draft;

double section_length(const Section section)
{
  switch(section)
  {
    case BOTTOM:       return bottom_radius;
    case PUNCH_FILLET: return punch_fillet_radius * fillet_angle;
    case WALL:         return wall_length;
    case DIE_FILLET:   return die_fillet_radius * fillet_angle;
    case FLANGE:       break;
  }
  return 0.; // ends at the border, which is no circle
}

// the point at arc length `s` from the beginning of the section
Profile_point profile_point(const Section section, const double s)
{
  switch(section)
  {
    case BOTTOM:
      return { s, 0. };
    case PUNCH_FILLET:
    {
      const double angle = s / punch_fillet_radius;
      return { bottom_radius + punch_fillet_radius * std::sin(angle),
               punch_fillet_radius * (1. - std::cos(angle)) };
    }
    case WALL:
    {
      const Profile_point begin = profile_point(PUNCH_FILLET, section_length(PUNCH_FILLET));
      return { begin.r + s * std::cos(fillet_angle), begin.z + s * std::sin(fillet_angle) };
    }
    case DIE_FILLET:
    {
      const Profile_point begin = profile_point(WALL, section_length(WALL));
      const double angle = fillet_angle - s / die_fillet_radius;
      return { begin.r + die_fillet_radius * (std::sin(fillet_angle) - std::sin(angle)),
               begin.z + die_fillet_radius * (std::cos(angle) - std::cos(fillet_angle)) };
    }
    case FLANGE:
      break;
  }
  const Profile_point begin = profile_point(DIE_FILLET, section_length(DIE_FILLET));
  return { begin.r + s, begin.z };
}

// fillets are meshed finer than flat parts and the wall
double relative_size(const Section section)
{
  return (section == PUNCH_FILLET || section == DIE_FILLET) ? 0.6 : 1.;
}

// the rounded square: distance of the border from the axis in the direction `angle`
double border_radius(const double angle)
{
  const double x = std::abs(std::cos(angle));
  const double y = std::abs(std::sin(angle));
  const double straight = flange_half_width - flange_corner_radius;
  const double to_side = flange_half_width / (std::max)(x, y);
  if(to_side * (std::min)(x, y) <= straight)
    return to_side;
  // the ray through the arc about (straight, straight)
  const double along = straight * (x + y);
  return along + std::sqrt(along * along - 2. * straight * straight
                           + flange_corner_radius * flange_corner_radius);
}

// points at equal distances on the border, given as angles
std::vector<double> border_angles(const double size)
{
  const int steps = 20000;
  std::vector<double> length(1, 0.);
  for(int i = 0; i < steps; ++i)
  {
    const double a = 2. * pi * i / steps, b = 2. * pi * (i + 1) / steps;
    const double ra = border_radius(a), rb = border_radius(b);
    length.push_back(length.back() + std::hypot(rb * std::cos(b) - ra * std::cos(a),
                                                rb * std::sin(b) - ra * std::sin(a)));
  }
  const std::size_t n = static_cast<std::size_t>(std::ceil(length.back() / size));
  std::vector<double> angles;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double wanted = length.back() * static_cast<double>(i) / static_cast<double>(n);
    const auto it = std::upper_bound(length.begin(), length.end(), wanted);
    angles.push_back(2. * pi * static_cast<double>(it - length.begin() - 1) / steps);
  }
  return angles;
}

// uniform in [-1, 1]; written out because the distributions of <random> differ between libraries
class Jitter
{
  std::uint64_t state = 88172645463325252ull;

public:
  double operator()()
  {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return 2. * static_cast<double>(state >> 11) / 9007199254740992. - 1.;
  }
};

// The cup as points in space, each with its image in the plane by a map that keeps angles:
// a Delaunay triangulation of the images is then a good triangulation of the cup.
struct Cup
{
  Points points;
  std::vector<K::Point_2> images;

  void add(const Profile_point& p, const double angle, const double image_radius)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    points.emplace_back(p.r * c, p.r * s, p.z);
    images.emplace_back(image_radius * c, image_radius * s);
  }
};

// d(image radius) / image radius = ds / r keeps angles; the midpoint rule is accurate enough for
// choosing a triangulation
double next_image_radius(const Section section, const double from, const double to, double radius)
{
  const int steps = 64;
  const double step = (to - from) / steps;
  for(int i = 0; i < steps; ++i)
    radius *= std::exp(step / profile_point(section, from + (i + 0.5) * step).r);
  return radius;
}

Cup sample_cup(const double size)
{
  const double row_height = 0.5 * std::sqrt(3.) * size;
  Jitter jitter;
  Cup cup;
  cup.add(profile_point(BOTTOM, 0.), 0., 0.);

  // rows of circles up to the flange
  double image_begin = 1.;
  for(const Section section : { BOTTOM, PUNCH_FILLET, WALL, DIE_FILLET })
  {
    const double length = section_length(section);
    const double height = row_height * relative_size(section);
    const int rows = (std::max)(2, static_cast<int>(std::lround(length / height)));
    for(int row = (section == BOTTOM) ? 1 : 0; row < rows; ++row)
    {
      const double r = profile_point(section, length * row / rows).r;
      const int n = (std::max)(6, static_cast<int>(std::lround(
                                    2. * pi * r / (size * relative_size(section)))));
      for(int i = 0; i < n; ++i)
      {
        const double angle = 2. * pi * (i + 0.5 * (row % 2) + 0.28 * jitter()) / n;
        const double s = (std::max)(length * (row + 0.28 * jitter()) / rows, 0.);
        const double image_radius = (section == BOTTOM)
          ? s / bottom_radius : next_image_radius(section, 0., s, image_begin);
        cup.add(profile_point(section, s), angle, image_radius);
      }
    }
    if(section != BOTTOM)
      image_begin = next_image_radius(section, 0., length, image_begin);
  }

  // the flange, flat: rows that turn from the circle into the border
  const Profile_point inner = profile_point(FLANGE, 0.);
  const double scale = image_begin / inner.r;
  const int rows = (std::max)(2, static_cast<int>(std::lround((flange_half_width - inner.r)
                                                              / row_height)));
  const std::vector<double> on_border = border_angles(size);
  for(int row = 0; row <= rows; ++row)
  {
    const double perimeter = size * static_cast<double>(on_border.size());
    const double t_row = static_cast<double>(row) / rows;
    const int n = static_cast<int>((row == rows) ? on_border.size() : std::lround(
                    ((1. - t_row) * 2. * pi * inner.r + t_row * perimeter) / size));
    for(int i = 0; i < n; ++i)
    {
      const bool is_on_border = (row == rows);
      const double angle = is_on_border
        ? on_border[static_cast<std::size_t>(i)]
        : 2. * pi * (i + 0.5 * (row % 2) + 0.28 * jitter()) / n;
      const double t = is_on_border ? 1. : (std::max)((row + 0.28 * jitter()) / rows, 0.);
      const double r = inner.r + t * (border_radius(angle) - inner.r);
      cup.add({ r, inner.z }, angle, scale * r);
    }
  }
  return cup;
}

Triangles triangulate(const Cup& cup)
{
  Delaunay delaunay;
  for(std::size_t i = 0; i < cup.images.size(); ++i)
    delaunay.insert(cup.images[i])->info() = i;

  Triangles triangles;
  for(const auto f : delaunay.finite_face_handles())
  {
    // Rounding may leave flat triangles outside, on the straight parts of the border.
    const K::Triangle_2 image = delaunay.triangle(f);
    double longest = 0.;
    for(int i = 0; i < 3; ++i)
      longest = (std::max)(longest, CGAL::squared_distance(image[i], image[i + 1]));
    if(image.area() < 1e-6 * longest)
      continue;

    std::array<std::size_t, 3> triangle = {{ f->vertex(0)->info(), f->vertex(1)->info(),
                                             f->vertex(2)->info() }};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    triangles.push_back(triangle);
  }
  // the order of the faces of a triangulation is not part of its contract
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

int main(int argc, char* argv[])
{
  const int wanted = (argc > 2) ? std::atoi(argv[2]) : 3000;
  if(argc < 2 || argc > 3 || wanted < 500)
  {
    std::cerr << "Usage: make_sheet_metal_cup OUTPUT [NUMBER_OF_POINTS, at least 500]" << std::endl;
    return 2;
  }

  // the number of points is inversely proportional to the square of the size
  double size = 4.;
  for(int i = 0; i < 4; ++i)
    size *= std::sqrt(static_cast<double>(sample_cup(size).points.size()) / wanted);

  const Cup cup = sample_cup(size);
  const Triangles triangles = triangulate(cup);
  if(!CGAL::IO::write_polygon_soup(argv[1], cup.points, triangles,
                                   CGAL::parameters::stream_precision(17).use_binary_mode(false)))
  {
    std::cerr << "make_sheet_metal_cup: cannot write " << argv[1] << std::endl;
    return 2;
  }
  std::cout << cup.points.size() << " vertices and " << triangles.size() << " faces in " << argv[1]
            << std::endl;
  return EXIT_SUCCESS;
}
