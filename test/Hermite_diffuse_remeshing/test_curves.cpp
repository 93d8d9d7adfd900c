#include "test_helpers.h"

using namespace HDR::internal;

std::vector<Vector> circle(const int n, const double radius, const double part = 1.)
{
  std::vector<Vector> points;
  for(int i = 0; i < n; ++i)
  {
    const double s = 2. * analytic::pi * part * i / n;
    points.push_back(radius * Vector(std::cos(s), std::sin(s), 0.));
  }
  return points;
}

void test_straight()
{
  const Vector start(0.1, -0.3, 0.7), direction(1., 2., -0.5);
  std::vector<Vector> points;
  for(const double t : {0., 0.1, 0.15, 0.6, 1.})
    points.push_back(start + t * direction);
  const Feature_spline spline(points, false);
  assert(std::abs(spline.length() - direction.norm()) < 1e-14);
  for(int i = 0; i <= 100; ++i)
  {
    const Vector p = spline.point(i / 100. * spline.length());
    assert((p - start).cross(direction).norm() < 1e-14);
    assert(spline.curvature(i / 100. * spline.length()) < 1e-12);
  }
}

// distance to the circle is of order six in the angle of a segment
void test_circle_convergence()
{
  double previous_error = 0.;
  for(const int n : {12, 24, 48})
  {
    const double radius = 3.;
    const Feature_spline spline(circle(n, radius), true);
    double error = 0.;
    for(int i = 0; i < 10 * n; ++i)
    {
      const double s = spline.length() * i / (10. * n);
      error = (std::max)(error, std::abs(spline.point(s).norm() - radius) / radius);
      assert(std::abs(spline.curvature(s) * radius - 1.) < 0.02);
    }
    assert(std::abs(spline.length() / (2. * analytic::pi * radius) - 1.) < 1e-4);
    if(previous_error > 0.)
      assert(std::log2(previous_error / error) > 5.5);
    previous_error = error;
  }
  assert(previous_error < 1e-7);
}

// an open arc reaches its ends with the circle's tangent
void test_arc()
{
  const Feature_spline spline(circle(17, 1., 0.4), false);
  for(int i = 0; i <= 200; ++i)
    assert(std::abs(spline.point(spline.length() * i / 200.).norm() - 1.) < 1e-6);
}

// a long straight edge between two fillets stays straight
void test_slot()
{
  std::vector<Vector> points;
  const double r = 0.1;
  for(const int side : {0, 1})
    for(int i = 0; i <= 8; ++i)
    {
      const double s = analytic::pi * (i / 8. + side - 0.5);
      points.push_back(Vector((side == 0 ? 5. : -5.) + r * std::cos(s), r * std::sin(s), 0.));
    }
  const Feature_spline spline(points, true);
  for(int i = 0; i < 2000; ++i)
  {
    const Vector p = spline.point(spline.length() * i / 2000.);
    const double x = (std::max)(0., std::abs(p[0]) - 5.);
    assert(std::abs(std::hypot(x, p[1]) - r) < 2e-4 * r);
  }
}

// An arc of which the first segment may not turn, as at the corner with a chord: only this one is straight. It takes no
// longer with many segments: where one after the other became straight it was the square of their number.
void test_straight_end()
{
  for(const int n : {12, 15, 40, 20000})
  {
    const double step = 2. * analytic::pi / (n == 12 ? 12 : 15), pitch = n > 15 ? 0.1 : 0.;
    std::vector<Vector> points;
    for(int i = 0; i <= n; ++i)
      points.push_back(Vector(std::cos(step * i), std::sin(step * i), pitch * i));
    if(n <= 15)
      points.pop_back();
    const Feature_spline spline(points, false, {{0.1, largest_credible_turn}});
    for(int i = 0; i < 10; ++i)
      for(int segment = 0; segment < spline.number_of_segments(); ++segment)
      {
        const double u = (i + 0.5) / 10.;
        const Vector p = spline.point((1. - u) * spline.parameter(segment) + u * spline.parameter(segment + 1));
        const double error = std::abs(std::hypot(p[0], p[1]) - 1.);
        assert(error < (segment == 0 ? 1.01 * (1. - std::cos(step / 2.)) : 5e-4));
      }
  }
}

void test_zigzag()
{
  std::vector<Vector> points;
  for(int i = 0; i < 12; ++i)
    points.push_back(Vector(i, i % 2 == 0 ? 0. : 0.5, 0.));
  const Feature_spline spline(points, false);
  for(int i = 0; i <= 500; ++i)
  {
    const Vector p = spline.point(spline.length() * i / 500.);
    assert(p[1] > -1e-12 && p[1] < 0.5 + 1e-12);
  }
}

// the spline stays within a bound of its chords, with the curvatures of the chain
void test_bounded_distance()
{
  constexpr int n = 12;
  constexpr double radius = 3.;
  const Feature_spline free(circle(n, radius), true);
  const double sagitta = radius * (1. - std::cos(analytic::pi / n));
  for(const double bound : {0., 0.2 * sagitta, sagitta, 100. * sagitta})
  {
    const Feature_spline spline(circle(n, radius), true, {{1., 1.}}, Saturation(bound));
    double largest = 0.;
    for(int i = 0; i <= 50 * n; ++i)
    {
      const double s = spline.length() * i / (50. * n);
      const double middle = 2. * analytic::pi / n * (std::floor((i + 0.5) / 50.) + 0.5);
      const double distance_to_chord = spline.point(s).dot(Vector(std::cos(middle), std::sin(middle), 0.))
                                     - (radius - sagitta);
      largest = (std::max)(largest, distance_to_chord);
      assert(distance_to_chord >= -1e-9 && distance_to_chord <= bound + 1e-9);
      assert(std::abs(spline.curvature(s) - free.curvature(s)) < 1e-12);
      if(bound > 10. * sagitta)
        assert((spline.point(s) - free.point(s)).norm() < 1e-8 * radius);
    }
    const double expected = bound > 0. ? sagitta / std::pow(1. + std::pow(sagitta / bound, 4), 0.25) : 0.;
    assert(std::abs(largest - expected) < 1e-3 * sagitta);
  }
}

// a loop without corner becomes two curves of equal length
void test_chaining()
{
  std::vector<Vector> points = circle(48, 1.);
  points.push_back(Vector::Zero());
  Indexed_triangles disk;
  disk.points = points;
  for(int i = 0; i < 48; ++i)
    disk.triangles.push_back({{48, i, (i + 1) % 48}});
  const Input_model model(disk, Feature_options{0.7, 1., 0.5}, Model_options(), [](int, int) { return HDR::internal::UNMARKED_EDGE; },
                          [](int) { return false; });
  const std::vector<Feature_curve>& curves = model.curves.curves;
  assert(curves.size() == 2);
  assert(curves[0].edges.size() == 24 && curves[1].edges.size() == 24);
  assert(std::abs(curves[0].spline.length() - curves[1].spline.length()) < 1e-12);
  assert(curves[0].vertices.front() == curves[1].vertices.back());
  assert(curves[0].vertices.back() == curves[1].vertices.front());
  // locations are on the side of the face that the spline is next to
  for(const Feature_curve& curve : curves)
    for(int i = 0; i <= 50; ++i)
    {
      const double s = curve.spline.length() * i / 50.;
      const Vector p = disk.point(curve.location(s, disk, model.edges));
      assert((p - curve.spline.point(s)).norm() < 3e-3);
    }
}

int main()
{
  test_straight();
  test_circle_convergence();
  test_arc();
  test_slot();
  test_straight_end();
  test_zigzag();
  test_bounded_distance();
  test_chaining();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
