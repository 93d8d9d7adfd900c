// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H

#include <Eigen/Core>
#include <Eigen/Householder>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Monomials x^(order-j) y^j are numbered by order, then by j.
constexpr int number_of_monomials(const int degree) { return (degree + 1) * (degree + 2) / 2; }
constexpr int monomial(const int order, const int j) { return order * (order + 1) / 2 + j; }

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
        rhs[row].combined_factor = combined_order - o;
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

// Weighted Hermite least squares in one fixed frame (paper, section 2.6): the polynomial
//   f(x,y) = a0 + a1 x + a2 y + a3 x^2 + a4 xy + a5 y^2 + a6 x^3 + a7 x^2 y + a8 x y^2 + a9 y^3 ...
// that minimises  sum w_i [ (1-t) (f(x_i,y_i) - z_i)^2 + t (f_x - p_i)^2 + t (f_y - q_i)^2 ]
// plus a ridge, solved by its normal equations. Coordinates are expected to be divided by a local
// length; otherwise t and the ridge have no meaning.
//
// What the polynomial cannot describe spoils its second derivatives: mostly the terms of the next even
// order n, which look like them on a ring of data. A position and a slope see such a term with different
// factors, so that it can be eliminated. By Euler's identity x f_x + y f_y = o f for a term f of order o,
// the combined equation
//   n (f - z) - x (f_x - p) - y (f_y - q) = 0
// is free of terms of order n. Added with a large weight it makes second derivatives about twice as
// accurate; noise, of which it takes n times the position's, too.
//
// The data only enter by moments, which costs a third of adding up the products of equations.
template <int Degree>
class Local_polynomial
{
public:
  static constexpr int size = number_of_monomials(Degree);

private:
  static constexpr Moment_table<Degree> table = Moment_table<Degree>();
  static constexpr int size_of_slopes = number_of_monomials(Degree - 1);

  // An even number of values fills the vector registers. One that is added has any value and is not read.
  template <int Size>
  using Values = Eigen::Array<double, (Size + 1) / 2 * 2, 1>;
  typedef Values<number_of_monomials(2 * Degree)> Monomials;
  typedef Values<number_of_monomials(2 * Degree - 2)> Slope_monomials;

  Monomials m_moments = Monomials::Zero();
  Slope_monomials m_slope_moments = Slope_monomials::Zero();
  Monomials m_combined_moments = Monomials::Zero();
  Values<size> m_z = Values<size>::Zero(), m_combined_z = Values<size>::Zero();
  Values<size_of_slopes> m_p = Values<size_of_slopes>::Zero(), m_q = Values<size_of_slopes>::Zero();
  Values<size> m_ridge = Values<size>::Zero();
  Values<size> m_coefficients = Values<size>::Zero();

public:
  // f(x,y) = z
  void add_position(const double x, const double y, const double z, const double weight)
  {
    add_positions(monomials(x, y), z, weight);
  }

  // f_x(x,y) = p and f_y(x,y) = q
  void add_slopes(const double x, const double y, const double p, const double q, const double weight)
  {
    add_slopes(monomials(x, y), p, q, weight);
  }

  // both, and the combined equation
  void add_position_and_slopes(const double x, const double y, const double z, const double weight,
                               const double p, const double q, const double slope_weight,
                               const double combined_weight)
  {
    const Monomials m = monomials(x, y);
    add_positions(m, z, weight);
    add_slopes(m, p, q, slope_weight);
    if(combined_weight > 0.)
      add_combined(m, table.combined_order * z - x * p - y * q, combined_weight);
  }

  // Adds `ridge` times the square of one coefficient.
  void add_ridge_on_coefficient(const int i, const double ridge) { m_ridge[i] += ridge; }

  // Adds `ridge` times the squared norm of the terms of the given order. The monomials are
  // counted with the inverse of their binomial coefficient, which makes the norm, and so the
  // fit, independent of the directions of x and y.
  void add_ridge(const int order, const double ridge)
  {
    double binomial = 1.;
    for(int j = 0; j <= order; ++j)
    {
      add_ridge_on_coefficient(monomial(order, j), ridge / binomial);
      binomial *= double(order - j) / double(j + 1);
    }
  }

  // Solves for the coefficients from `First` on, the ones before stay zero (1: through the
  // origin). Returns the smallest pivot of the matrix scaled to a unit diagonal, which is in [0, 1];
  // zero or less means that the system was singular and the coefficients are not usable. The matrix
  // is not really scaled: its pivots U^T D U are those of the scaled one times its diagonal.
  // All loops have bounds that the compiler knows, so that it unrolls them and leaves out what is multiplied by 0.
  template <int First = 0>
  double solve()
  {
    Matrix a;
    Values<size>& x = m_coefficients;
    for_each<First, size>([&](const auto row)
    {
      constexpr int i = decltype(row)::value;
      a[i].template tail<Values<size>::SizeAtCompileTime - i / 2 * 2>().setZero();
      for_each<i, size>([&](const auto column) { a[i][column] = matrix_entry<i, decltype(column)::value>(); });
      a[i][i] += m_ridge[i];
      x[i] = m_z[i] + table.rhs[i].factor_x * m_p[table.rhs[i].slope_x]
                    + table.rhs[i].factor_y * m_q[table.rhs[i].slope_y]
                    + table.rhs[i].combined_factor * m_combined_z[i];
    });

    std::array<double, size> diagonal, inverse;
    for(int i = First; i < size; ++i)
      diagonal[i] = a[i][i];
    double smallest_pivot = 1.;
    for_each<First, size>([&](const auto eliminated)
    {
      constexpr int k = decltype(eliminated)::value;
      const double pivot = a[k][k];
      if(!(pivot > std::numeric_limits<double>::epsilon() * diagonal[k]))
        smallest_pivot = 0.;
      if(pivot < smallest_pivot * diagonal[k])
        smallest_pivot = pivot / diagonal[k];
      inverse[k] = 1. / pivot;
      for_each<k + 1, size>([&](const auto row)
      {
        // from an even column on, so that pairs are aligned; what is left of the diagonal is not read
        constexpr int i = decltype(row)::value, length = Values<size>::SizeAtCompileTime - i / 2 * 2;
        const double factor = a[k][i] * inverse[k];
        a[i].template tail<length>() -= factor * a[k].template tail<length>();
        x[i] -= factor * x[k];
      });
    });
    if(!(smallest_pivot > 0.))
      return 0.;
    for(int k = size - 1; k >= First; --k)
    {
      for(int i = k + 1; i < size; ++i)
        x[k] -= a[k][i] * x[i];
      x[k] *= inverse[k];
    }
    return smallest_pivot;
  }

  // The same for positions alone, the rows x, y, z, weight, by orthogonal transformations: several times
  // slower, but a pivot that is zero comes out as the square of a rounding error, where the normal
  // equations can make 1e-6 of it.
  double solve_by_orthogonalization(const Eigen::Matrix<double, Eigen::Dynamic, 4>& positions, const int first)
  {
    const Eigen::Index n = positions.rows();
    const int number_of_unknowns = size - first;
    Eigen::MatrixXd matrix(n, number_of_unknowns + 1);          // the right hand side in the last column
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Monomials m = monomials(positions(i, 0), positions(i, 1));
      const double root = std::sqrt(positions(i, 3));
      for(int j = 0; j < number_of_unknowns; ++j)
        matrix(i, j) = root * m[first + j];
      matrix(i, number_of_unknowns) = root * positions(i, 2);
    }
    const Eigen::VectorXd scale = matrix.leftCols(number_of_unknowns).colwise().norm();
    if(n < number_of_unknowns || !(scale.minCoeff() > 0.))
      return 0.;
    matrix.leftCols(number_of_unknowns).array().rowwise() /= scale.transpose().array();
    triangularize(matrix);
    const double least = matrix.diagonal().head(number_of_unknowns).cwiseAbs().minCoeff();
    if(!(least > 0.))
      return 0.;
    m_coefficients.setZero();
    for(int k = number_of_unknowns - 1; k >= 0; --k)
    {
      double rest = matrix(k, number_of_unknowns);
      for(int j = k + 1; j < number_of_unknowns; ++j)
        rest -= matrix(k, j) * m_coefficients[first + j];
      m_coefficients[first + k] = rest / matrix(k, k);
    }
    for(int j = 0; j < number_of_unknowns; ++j)
      m_coefficients[first + j] /= scale[j];
    return least * least;
  }

  double operator[](const int i) const { return m_coefficients[i]; }

  // f(x,y)
  double operator()(const double x, const double y) const
  {
    const Monomials m = monomials(x, y);
    double sum = 0.;
    for(int i = 0; i < size; ++i)
      sum += m_coefficients[i] * m[i];
    return sum;
  }

  // Of the terms of the given order, independent of the directions of x and y, see `add_ridge()`.
  double squared_norm(const int order) const
  {
    double sum = 0., binomial = 1.;
    for(int j = 0; j <= order; ++j)
    {
      const double c = m_coefficients[monomial(order, j)];
      sum += c * c / binomial;
      binomial *= double(order - j) / double(j + 1);
    }
    return sum;
  }

private:
  typedef std::array<Values<size>, size> Matrix;      // the upper triangle

  // calls `visit` with the integers from First to Last - 1 as types
  template <int First, int Last, typename Visit>
  static void for_each(const Visit& visit)
  {
    if constexpr(First < Last)
    {
      visit(std::integral_constant<int, First>());
      for_each<First + 1, Last>(visit);
    }
  }

  template <int Row, int Column>
  double matrix_entry() const
  {
    constexpr auto e = table.matrix[Row][Column];
    double sum = m_moments[e.position] + e.combined_factor * m_combined_moments[e.position];
    if constexpr(e.factor_x != 0.)
      sum += e.factor_x * m_slope_moments[e.slope_x];
    if constexpr(e.factor_y != 0.)
      sum += e.factor_y * m_slope_moments[e.slope_y];
    return sum;
  }

  // Householder's reflections on all columns but the last. Eigen's class for them works in blocks, which take longer to
  // compile than all the rest of the fit.
  static void triangularize(Eigen::MatrixXd& matrix)
  {
    const Eigen::Index n = matrix.rows(), last = matrix.cols() - 1;
    Eigen::VectorXd workspace(matrix.cols());
    for(Eigen::Index k = 0; k < last; ++k)
    {
      const Eigen::Index rest = n - k - 1;
      double factor, diagonal;
      matrix.col(k).tail(rest + 1).makeHouseholderInPlace(factor, diagonal);
      matrix(k, k) = diagonal;
      matrix.bottomRightCorner(rest + 1, last - k)
        .applyHouseholderOnTheLeft(matrix.col(k).tail(rest), factor, workspace.data());
    }
  }

  static Monomials monomials(const double x, const double y)
  {
    Monomials m;
    m[0] = 1.;
    m[Monomials::SizeAtCompileTime - 1] = 0.;
    add_monomials<1>(x, y, m);
    return m;
  }

  // each order from the one below, in steps that are known to the compiler
  template <int Order>
  static void add_monomials(const double x, const double y, Monomials& m)
  {
    if constexpr(Order <= 2 * Degree)
    {
      constexpr int lower = monomial(Order - 1, 0), first = monomial(Order, 0);
      m.template segment<Order>(first) = x * m.template segment<Order>(lower);
      m[first + Order] = y * m[first - 1];
      add_monomials<Order + 1>(x, y, m);
    }
  }

  template <typename Sums>
  static void add(const double weight, const Monomials& m, Sums& sums)
  {
    sums += weight * m.template head<Sums::SizeAtCompileTime>();
  }

  void add_positions(const Monomials& m, const double z, const double weight)
  {
    add(weight, m, m_moments);
    add(weight * z, m, m_z);
  }

  void add_slopes(const Monomials& m, const double p, const double q, const double weight)
  {
    add(weight, m, m_slope_moments);
    add(weight * p, m, m_p);
    add(weight * q, m, m_q);
  }

  void add_combined(const Monomials& m, const double rhs, const double weight)
  {
    add(weight, m, m_combined_moments);
    add(weight * rhs, m, m_combined_z);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H
