// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Polynomial_moments.h>

#include <CGAL/number_type_basic.h>

#include <Eigen/Core>
#include <Eigen/Householder>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

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
template <int Degree>
class Local_polynomial
{
public:
  static constexpr int size = number_of_monomials(Degree);
  typedef typename Polynomial_moments<Degree>::Pair Pair;

private:
  Polynomial_moments<Degree> m_moments;
  std::array<double, size> m_ridge = {}, m_relative_ridge = {}, m_coefficients = {};

public:
  // f(x,y) = z
  void add_position(const double x, const double y, const double z, const double weight)
  {
    m_moments.add(x, y, z, weight, 0., 0., 0., 0.);
  }

  // f_x(x,y) = p and f_y(x,y) = q
  void add_slopes(const double x, const double y, const double p, const double q, const double weight)
  {
    m_moments.add(x, y, 0., 0., p, q, weight, 0.);
  }

  // both, and the combined equation
  void add_position_and_slopes(const double x, const double y, const double z, const double weight,
                               const double p, const double q, const double slope_weight,
                               const double combined_weight)
  {
    m_moments.add(x, y, z, weight, p, q, slope_weight, combined_weight);
  }

  // same for two data at once
  void add_two(const Pair& x, const Pair& y, const Pair& z, const Pair& weight,
               const Pair& p, const Pair& q, const Pair& slope_weight, const Pair& combined_weight)
  {
    m_moments.add_two(x, y, z, weight, p, q, slope_weight, combined_weight);
  }

  // Adds `ridge` times the square of one coefficient.
  void add_ridge_on_coefficient(const int i, const double ridge) { m_ridge[i] += ridge; }

  // Adds `ridge` times the total weight of the data times the squared norm of the terms of the given order. The monomials
  // are counted with the inverse of their binomial coefficient, which makes the norm, and so the fit, independent of the
  // directions of x and y.
  void add_ridge(const int order, const double ridge, const double total_weight)
  {
    double binomial = 1.;
    for(int j = 0; j <= order; ++j)
    {
      const int i = monomial(order, j);
      add_ridge_on_coefficient(i, ridge * total_weight / binomial);
      m_relative_ridge[i] += ridge / binomial;
      binomial *= double(order - j) / double(j + 1);
    }
  }

  // Solves for the coefficients from `First` on, the ones before stay zero (1: through the
  // origin). Returns the smallest pivot of the matrix scaled to a unit diagonal, which is in [0, 1];
  // zero or less means that the system was singular and the coefficients are not usable. The matrix
  // is not really scaled: its pivots U^T D U are those of the scaled one times its diagonal. Where data far away make
  // the diagonal large, a pivot counts as large as the ridge that bounds what noise makes of its coefficient.
  // All loops have bounds that the compiler knows, so that it unrolls them and leaves out what is multiplied by 0.
  template <int First = 0>
  double solve() { return solve_and_look<First>([](const Matrix&, const std::array<double, size>&) {}); }

  // Solves for the coefficients from the slopes at the origin on, through which the polynomial passes. Returns the variance
  // of all of them, if the data have the inverse of their weights for variances; infinite where the system is singular.
  // Other than a pivot, one of which hides another, it does not depend on the directions of x and y: where positions lie on
  // few lines pivots differ by seven orders of magnitude.
  double solve_through_origin()
  {
    double variance = 0.;
    const double pivot = solve_and_look<1>([&](const Matrix& a, const std::array<double, size>& inverse)
    {
      std::array<std::array<double, size>, size> factors;
      for(int k = 1; k < size; ++k)
        for(int i = k + 1; i < size; ++i)
          factors[k][i] = entry(a, k, i) * inverse[k];
      variance = total_variance([&](const int k, const int i) { return factors[k][i]; },
                                [&](const int i) { return inverse[i]; }, [](const int) { return 1.; });
    });
    return pivot > 0. ? variance : (std::numeric_limits<double>::infinity)();
  }

  // Same, by orthogonal transformations, for positions alone, the rows x, y, z, weight: several times slower, but a variance
  // that is infinite comes out as the inverse of a squared rounding error, where the normal equations can make 1e6 of it.
  double solve_through_origin_by_orthogonalization(const Eigen::Matrix<double, Eigen::Dynamic, 4>& positions)
  {
    constexpr int first = 1, number_of_unknowns = size - first;
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    const Eigen::Index n = positions.rows();
    Eigen::MatrixXd matrix(n, number_of_unknowns + 1);          // the right hand side in the last column
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const std::array<double, size> m = monomials(positions(i, 0), positions(i, 1));
      const double root = std::sqrt(positions(i, 3));
      for(int j = 0; j < number_of_unknowns; ++j)
        matrix(i, j) = root * m[first + j];
      matrix(i, number_of_unknowns) = root * positions(i, 2);
    }
    const Eigen::VectorXd scale = matrix.leftCols(number_of_unknowns).colwise().norm();
    if(n < number_of_unknowns || !(scale.minCoeff() > 0.))
      return infinity;
    matrix.leftCols(number_of_unknowns).array().rowwise() /= scale.transpose().array();
    triangularize(matrix);
    if(!(matrix.diagonal().head(number_of_unknowns).cwiseAbs().minCoeff() > 0.))
      return infinity;
    m_coefficients.fill(0.);
    for(int k = number_of_unknowns - 1; k >= 0; --k)
    {
      double rest = matrix(k, number_of_unknowns);
      for(int j = k + 1; j < number_of_unknowns; ++j)
        rest -= matrix(k, j) * m_coefficients[first + j];
      m_coefficients[first + k] = rest / matrix(k, k);
    }
    for(int j = 0; j < number_of_unknowns; ++j)
      m_coefficients[first + j] /= scale[j];
    return total_variance([&](const int k, const int i) { return matrix(k - first, i - first) / matrix(k - first, k - first); },
                          [&](const int i) { return 1. / CGAL::square(matrix(i - first, i - first)); },
                          [&](const int i) { return scale[i - first]; });
  }

  double operator[](const int i) const { return m_coefficients[i]; }

  // f(x,y)
  double operator()(const double x, const double y) const
  {
    const std::array<double, size> m = monomials(x, y);
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
  // The upper triangle, in pairs of columns. What is left of the diagonal, or beyond an odd number, is not read.
  static constexpr int number_of_pairs = (size + 1) / 2;
  typedef std::array<std::array<Pair, number_of_pairs>, size> Matrix;

  // `look(matrix, inverse of its diagonal)` after the elimination
  template <int First, typename Look>
  double solve_and_look(const Look& look)
  {
    m_moments.finish();
    Matrix a;
    std::array<double, size>& x = m_coefficients;
    std::array<double, size> diagonal, inverse;
    for_each_constant<First, size>([&](const auto row)
    {
      constexpr int i = decltype(row)::value;
      for_each_constant<i / 2, number_of_pairs>([&](const auto pair)
      {
        constexpr int j = 2 * decltype(pair)::value;
        a[i][j / 2] = Pair(matrix_entry<i, j>(), matrix_entry<i, j + 1>());
      });
      diagonal[i] = entry(a, i, i);
      x[i] = m_moments.template right_hand_side<i>();
    });

    double smallest_pivot = 1.;
    for_each_constant<First, size>([&](const auto eliminated)
    {
      constexpr int k = decltype(eliminated)::value;
      const double pivot = entry(a, k, k);
      if(!(pivot > std::numeric_limits<double>::epsilon() * diagonal[k]))
        smallest_pivot = 0.;
      if(pivot < smallest_pivot * diagonal[k])
        smallest_pivot = (std::min)(smallest_pivot, (std::max)(pivot / diagonal[k], m_relative_ridge[k]));
      inverse[k] = 1. / pivot;
      for_each_constant<k + 1, size>([&](const auto row)
      {
        constexpr int i = decltype(row)::value;
        const double factor = entry(a, k, i) * inverse[k];
        for(int pair = i / 2; pair < number_of_pairs; ++pair)
          a[i][pair] -= factor * a[k][pair];
        x[i] -= factor * x[k];
      });
    });
    if(!(smallest_pivot > 0.))
      return 0.;
    look(a, inverse);
    // column by column: what follows waits for one product only, not for a sum of them
    for_each_constant<First, size>([&](const auto index)
    {
      constexpr int k = size - 1 + First - decltype(index)::value;
      x[k] *= inverse[k];
      for(int i = First; i < k; ++i)
        x[i] -= entry(a, i, k) * x[k];
    });
    return smallest_pivot;
  }

  static double entry(const Matrix& a, const int i, const int j) { return a[i][j / 2][j % 2]; }

  template <int Row, int Column>
  double matrix_entry() const
  {
    if constexpr(Column < Row || Column >= size)
      return 0.;
    else
      return m_moments.template matrix_entry<Row, Column>() + (Row == Column ? m_ridge[Row] : 0.);
  }

  // Of all unknowns but the first, those of one order counted as in `squared_norm()`: the matrix of covariances is
  // U^-1 D^-1 U^-T, with `factor(row, column)` of U, whose diagonal is 1, and `inverse(row)` of D, for unknowns that are
  // `scale(row)` times as large.
  template <typename Factor, typename Inverse, typename Scale>
  static double total_variance(const Factor& factor, const Inverse& inverse, const Scale& scale)
  {
    double result = 0.;
    for(int order = 1; order <= Degree; ++order)
    {
      double binomial = 1.;
      for(int j = 0; j <= order; ++j)
      {
        const int unknown = monomial(order, j);
        std::array<double, size> row = {};
        double variance = 0.;
        for(int i = unknown; i < size; ++i)
        {
          row[i] = i == unknown ? 1. : 0.;
          for(int k = unknown; k < i; ++k)
            row[i] -= factor(k, i) * row[k];
          variance += row[i] * row[i] * inverse(i);
        }
        result += variance / (binomial * CGAL::square(scale(unknown)));
        binomial *= double(order - j) / double(j + 1);
      }
    }
    return result;
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

  static std::array<double, size> monomials(const double x, const double y)
  {
    std::array<double, size> m;
    m[0] = 1.;
    find_monomials(x, y, m);
    return m;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H
