// The least that models of the package's concepts provide.

#ifndef ARCHETYPES_H
#define ARCHETYPES_H

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>

namespace archetype {

struct Point
{
  explicit Point(const double x, const double y, const double z) : c{{x, y, z}} {}
  std::array<double, 3> c;
};
struct Vector
{
  Vector() : Vector(0., 0., 0.) {}
  explicit Vector(const double x, const double y, const double z) : c{{x, y, z}} {}
  std::array<double, 3> c;
};

// how often functors have been called
struct Calls
{
  std::size_t reads = 0, constructions = 0;
};

// A functor only comes from an object of the traits, and counts for it.
template <int I>
class Compute
{
  Calls* m_calls;

public:
  explicit Compute(Calls* calls) : m_calls(calls) {}
  double operator()(const Point& p) const { count(); return p.c[I]; }
  double operator()(const Vector& v) const { count(); return v.c[I]; }

private:
  void count() const
  {
    if(m_calls)
      ++m_calls->reads;
  }
};

template <typename T>
class Construct
{
  Calls* m_calls;

public:
  explicit Construct(Calls* calls) : m_calls(calls) {}
  T operator()(const double x, const double y, const double z) const
  {
    if(m_calls)
      ++m_calls->constructions;
    return T(x, y, z);
  }
};

// of HermiteDiffuseRemeshingTraits
class Traits
{
  Calls* m_calls = nullptr;

public:
  typedef double FT;
  typedef Point Point_3;
  typedef Vector Vector_3;
  typedef Compute<0> Compute_x_3;
  typedef Compute<1> Compute_y_3;
  typedef Compute<2> Compute_z_3;
  typedef Construct<Point> Construct_point_3;
  typedef Construct<Vector> Construct_vector_3;

  Traits() {}
  explicit Traits(Calls& calls) : m_calls(&calls) {}

  Compute_x_3 compute_x_3_object() const { return Compute_x_3(m_calls); }
  Compute_y_3 compute_y_3_object() const { return Compute_y_3(m_calls); }
  Compute_z_3 compute_z_3_object() const { return Compute_z_3(m_calls); }
  Construct_point_3 construct_point_3_object() const { return Construct_point_3(m_calls); }
  Construct_vector_3 construct_vector_3_object() const { return Construct_vector_3(m_calls); }
};

// of HermiteDiffuseSizeField
class Size_field
{
  double m_size;

public:
  explicit Size_field(const double size) : m_size(size) {}
  Size_field(const Size_field&) = default;
  Size_field& operator=(const Size_field&) = delete;

  double operator()(const Point&) const { return m_size; }
};

// of HermiteDiffuseRemeshingVisitor; it has no names for the types of the elements
template <typename TriangleMesh>
class Visitor
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename Graph_traits::face_descriptor Face;

public:
  std::size_t number_of_stages = 0, number_of_splits = 0;

  Visitor() {}
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  void stage_begins(const char*) { ++number_of_stages; }
  void progress(double) {}
  void stage_ends(const char*) {}
  bool is_stop_requested() { return false; }
  void before_edge_split(Edge) {}
  void after_edge_split(Vertex) { ++number_of_splits; }
  void after_face_split(Face, Face) {}
  void before_edge_collapse(Halfedge) {}
  void after_edge_collapse(Vertex) {}
  void before_edge_flip(Edge) {}
  void after_edge_flip(Edge) {}
  void before_vertex_removal(Vertex) {}
  void after_vertex_removal() {}
  void before_vertex_relocation(Vertex) {}
  void after_vertex_relocation(Vertex) {}
};

} // namespace archetype

#endif // ARCHETYPES_H
