// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_POLYNOMIAL_MOMENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_POLYNOMIAL_MOMENTS_H

#include <Eigen/Core>

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What follows is inlined at any price: compilers that count it as a large function would leave it out in programs of some
// size, and values in registers would go through the memory.
template <int First, typename Visit, int... Index>
BOOST_FORCEINLINE void visit_constants(const Visit& visit, std::integer_sequence<int, Index...>)
{
  (visit(std::integral_constant<int, First + Index>()), ...);
}

// calls `visit` with the integers from First to Last - 1 as types, which leaves no loop and no recursion to be inlined
template <int First, int Last, typename Visit>
BOOST_FORCEINLINE void for_each_constant(const Visit& visit)
{
  visit_constants<First>(visit, std::make_integer_sequence<int, (First < Last ? Last - First : 0)>());
}

// Monomials x^(order-j) y^j are numbered by order, then by j.
constexpr int number_of_monomials(const int degree) { return (degree + 1) * (degree + 2) / 2; }
constexpr int monomial(const int order, const int j) { return order * (order + 1) / 2 + j; }
constexpr int order_of(const int monomial)
{
  int order = 0;
  while(number_of_monomials(order) <= monomial)
    ++order;
  return order;
}

// m[0] is set already; of a number, or of two at once. Each order is made of the one below.
template <typename Number, std::size_t Size>
BOOST_FORCEINLINE void find_monomials(const Number& x, const Number& y, std::array<Number, Size>& m)
{
  for_each_constant<1, order_of(static_cast<int>(Size))>([&](const auto index)
  {
    constexpr int order = decltype(index)::value, lower = monomial(order - 1, 0), first = monomial(order, 0);
    for(int j = 0; j < order; ++j)
      m[first + j] = x * m[lower + j];
    m[first + order] = y * m[first - 1];
  });
}

// How the normal matrix of a polynomial of the given degree is made of the moments of the data. With
// M and N the sums of w x^a y^b over positions and slopes, the entry of x^a y^b and x^c y^d is
//   M(a+c,b+d) + ac N(a+c-2,b+d) + bd N(a+c,b+d-2),
// and the right-hand side of x^a y^b is  Z(a,b) + a P(a-1,b) + b Q(a,b-1)  with the sums Z, P, Q of
// w z x^a y^b and so on. A product that is absent has factor 0 and any moment. The combined equations of
// `Local_polynomial` with the order n multiply a monomial of order o by n - o: they add moments of their
// own with the factor (n-a-b)(n-c-d), and n-a-b on the right-hand side.
template <int Degree>
struct Moment_table
{
  struct Entry { int position, slope_x, slope_y; double factor_x, factor_y, combined_factor; };

  static constexpr int size = number_of_monomials(Degree);
  // the lowest even order above the degree
  static constexpr int combined_order = 2 * (Degree / 2) + 2;
  Entry matrix[size][size] = {};         // symmetric
  Entry rhs[size] = {};

  constexpr Moment_table()
  {
    for(int o = 0; o <= Degree; ++o)
      for(int j = 0; j <= o; ++j)
      {
        const int row = monomial(o, j);
        rhs[row].slope_x = o > j ? monomial(o - 1, j) : 0;
        rhs[row].slope_y = j > 0 ? monomial(o - 1, j - 1) : 0;
        rhs[row].factor_x = o - j;
        rhs[row].factor_y = j;
        for(int p = 0; p <= Degree; ++p)
          for(int k = 0; k <= p; ++k)
          {
            Entry& entry = matrix[row][monomial(p, k)];
            entry.position = monomial(o + p, j + k);
            entry.factor_x = (o - j) * (p - k);
            entry.factor_y = j * k;
            entry.combined_factor = (combined_order - o) * (combined_order - p);
            entry.slope_x = entry.factor_x > 0. ? monomial(o + p - 2, j + k) : 0;
            entry.slope_y = entry.factor_y > 0. ? monomial(o + p - 2, j + k - 2) : 0;
          }
      }
  }
};

// The normal equations of `Local_polynomial`, of which the data are entered by their moments alone: that costs a third of
// adding up the products of equations. Two data are added at a time, one in each half of the vector registers.
template <int Degree>
class Polynomial_moments
{
public:
  typedef Eigen::Array2d Pair;

private:
  static constexpr Moment_table<Degree> table = Moment_table<Degree>();
  static constexpr int combined_order = Moment_table<Degree>::combined_order;
  // Moments of the slopes go up to this order. Of higher orders there are products of two fixed orders only, so that the
  // moments of the positions and of the combined equations can be added up together.
  static constexpr int order_of_slopes = 2 * Degree - 2;

  template <int Order>
  using Moments = std::array<Pair, number_of_monomials(Order)>;

  struct Datum { double x, y, z, weight, p, q, slope_weight, combined_weight; };

  // set by the first pair
  Moments<2 * Degree> m_positions;
  Moments<order_of_slopes> m_slopes, m_combined;
  Moments<Degree> m_z;                  // with that of the combined equations
  Moments<Degree - 1> m_p, m_q;
  std::array<Datum, 2> m_waiting;       // to be added together
  int m_number_waiting = 0;
  bool m_is_empty = true;

public:
  // f(x,y) = z, f_x(x,y) = p and f_y(x,y) = q, and the combined equation
  void add(const double x, const double y, const double z, const double weight,
           const double p, const double q, const double slope_weight, const double combined_weight)
  {
    // one by one: a copy of a datum that was made elsewhere would have to wait for it
    Datum& datum = m_waiting[m_number_waiting];
    datum.x = x;
    datum.y = y;
    datum.z = z;
    datum.weight = weight;
    datum.p = p;
    datum.q = q;
    datum.slope_weight = slope_weight;
    datum.combined_weight = combined_weight;
    if(++m_number_waiting == 2)
      add_waiting();
  }

  void add_two(const Pair& x, const Pair& y, const Pair& z, const Pair& weight,
               const Pair& p, const Pair& q, const Pair& slope_weight, const Pair& combined_weight)
  {
    const auto enter = [&](const auto& add)
    { add_two(x, y, z, weight, p, q, slope_weight, combined_weight, add); };
    if(m_is_empty)
      enter([](Pair& sum, const Pair& term) { sum = term; });
    else
      enter([](Pair& sum, const Pair& term) { sum += term; });
    m_is_empty = false;
  }

  // after the last datum
  void finish()
  {
    if(m_number_waiting > 0 || m_is_empty)
      add_waiting();
  }

  // \name The normal equations
  template <int Row, int Column>
  double matrix_entry() const
  {
    constexpr auto e = table.matrix[Row][Column];
    Pair sum = m_positions[e.position];
    if constexpr(e.position < number_of_monomials(order_of_slopes))
      sum += e.combined_factor * m_combined[e.position];
    if constexpr(e.factor_x != 0.)
      sum += e.factor_x * m_slopes[e.slope_x];
    if constexpr(e.factor_y != 0.)
      sum += e.factor_y * m_slopes[e.slope_y];
    return sum.sum();
  }

  template <int Row>
  double right_hand_side() const
  {
    constexpr auto e = table.rhs[Row];
    Pair sum = m_z[Row];
    if constexpr(e.factor_x != 0.)
      sum += e.factor_x * m_p[e.slope_x];
    if constexpr(e.factor_y != 0.)
      sum += e.factor_y * m_q[e.slope_y];
    return sum.sum();
  }

private:
  // with data of no weight in place of those that are missing
  void add_waiting()
  {
    for(; m_number_waiting < 2; ++m_number_waiting)
      m_waiting[m_number_waiting] = Datum();
    const Datum& a = m_waiting[0];
    const Datum& b = m_waiting[1];
    add_two(Pair(a.x, b.x), Pair(a.y, b.y), Pair(a.z, b.z), Pair(a.weight, b.weight), Pair(a.p, b.p), Pair(a.q, b.q),
            Pair(a.slope_weight, b.slope_weight), Pair(a.combined_weight, b.combined_weight));
    m_number_waiting = 0;
  }

  // `add(sum, term)`
  template <typename Add>
  void add_two(const Pair& x, const Pair& y, const Pair& z, const Pair& weight, const Pair& p, const Pair& q,
               const Pair& slope_weight, const Pair& combined_weight, const Add& add)
  {
    Moments<2 * Degree> m;
    m[0] = Pair::Ones();
    find_monomials(x, y, m);
    const auto add_all = [&](const Pair& w, auto& sums)
    {
      for(std::size_t i = 0; i < sums.size(); ++i)
        add(sums[i], w * m[i]);
    };
    if(!m_is_empty && !(slope_weight > 0.).any())
    {
      add_all(weight, m_positions);
      add_all(weight * z, m_z);
      return;
    }
    // on noisy meshes there are none
    const bool is_combined = (combined_weight != 0.).any();
    const Pair weighted_z = weight * z;
    const Pair weighted_combined_z = combined_weight * (double(combined_order) * z - x * p - y * q);
    for_each_constant<0, 2 * Degree + 1>([&](const auto order)
    {
      constexpr int o = decltype(order)::value;
      Pair w = weight;
      if constexpr(o > order_of_slopes)
        w += double((combined_order - Degree) * (combined_order - (o - Degree))) * combined_weight;
      for(int i = monomial(o, 0); i <= monomial(o, o); ++i)
        add(m_positions[i], w * m[i]);
      if constexpr(o <= Degree)
      {
        const Pair w_z = weighted_z + double(combined_order - o) * weighted_combined_z;
        for(int i = monomial(o, 0); i <= monomial(o, o); ++i)
          add(m_z[i], w_z * m[i]);
      }
    });
    if(is_combined || m_is_empty)
      add_all(combined_weight, m_combined);
    add_all(slope_weight, m_slopes);
    add_all(slope_weight * p, m_p);
    add_all(slope_weight * q, m_q);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_POLYNOMIAL_MOMENTS_H
