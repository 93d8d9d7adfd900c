// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H

#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Weighted Hermite least squares in one fixed frame (paper, section 2.6): the polynomial
//   f(x,y) = a0 + a1 x + a2 y + a3 x^2 + a4 xy + a5 y^2 + a6 x^3 + a7 x^2 y + a8 x y^2 + a9 y^3 ...
// that minimises  sum w_i [ (1-t) (f(x_i,y_i) - z_i)^2 + t (f_x - p_i)^2 + t (f_y - q_i)^2 ]
// plus a ridge, solved by its normal equations scaled to a unit diagonal. Coordinates are
// expected to be divided by a local length; otherwise t and the ridge have no meaning.
template <int Degree>
class Local_polynomial
{
public:
  static constexpr int size = (Degree + 1) * (Degree + 2) / 2;

private:
  std::array<std::array<double, size>, size> m_matrix;      // lower triangle
  std::array<double, size> m_rhs;
  std::array<double, size> m_coefficients;

public:
  Local_polynomial() { clear(); }

  void clear()
  {
    for(std::array<double, size>& row : m_matrix)
      row.fill(0.);
    m_rhs.fill(0.);
    m_coefficients.fill(0.);
  }

  // row . a = rhs, any linear equation of the coefficients a
  void add_equation(const std::array<double, size>& row, const double rhs, const double weight)
  {
    for(int i = 0; i < size; ++i)
    {
      const double w = weight * row[i];
      for(int j = 0; j <= i; ++j)
        m_matrix[i][j] += w * row[j];
      m_rhs[i] += w * rhs;
    }
  }

  // f(x,y) = z
  void add_position(const double x, const double y, const double z, const double weight)
  {
    add_equation(monomials(x, y), z, weight);
  }

  // f_x(x,y) = p and f_y(x,y) = q
  void add_slopes(const double x, const double y, const double p, const double q, const double weight)
  {
    const std::array<double, size> m = monomials(x, y);
    std::array<double, size> row;
    differentiate<0>(m, row);
    add_equation(row, p, weight);
    differentiate<1>(m, row);
    add_equation(row, q, weight);
  }

  // Adds `ridge` times the squared norm of the terms of the given order. The monomials are
  // counted with the inverse of their binomial coefficient, which makes the norm, and so the
  // fit, independent of the directions of x and y.
  void add_ridge(const int order, const double ridge)
  {
    const int first = order * (order + 1) / 2;
    double binomial = 1.;
    for(int j = 0; j <= order; ++j)
    {
      m_matrix[first + j][first + j] += ridge / binomial;
      binomial *= double(order - j) / double(j + 1);
    }
  }

  // Solves for the coefficients from `first` on, the ones before stay zero (1: through the
  // origin). Returns the smallest pivot of the scaled matrix, which is in [0, 1]; zero or less
  // means that the system was singular and the coefficients are not usable.
  double solve(const int first = 0)
  {
    std::array<double, size> scale;
    for(int i = first; i < size; ++i)
    {
      if(!(m_matrix[i][i] > 0.))
        return 0.;
      scale[i] = 1. / std::sqrt(m_matrix[i][i]);
    }

    // L D L^T in place
    double smallest_pivot = 1.;
    std::array<double, size> inverse_pivot, column;
    for(int i = first; i < size; ++i)
    {
      std::array<double, size>& row = m_matrix[i];
      for(int j = first; j <= i; ++j)
        row[j] *= scale[i] * scale[j];
      for(int j = first; j < i; ++j)
      {
        double sum = row[j];
        for(int k = first; k < j; ++k)
          sum -= column[k] * m_matrix[j][k];
        column[j] = sum;
        row[j] = sum * inverse_pivot[j];
      }
      double pivot = row[i];
      for(int k = first; k < i; ++k)
        pivot -= column[k] * row[k];
      if(!(pivot > std::numeric_limits<double>::epsilon()))
        return 0.;
      smallest_pivot = pivot < smallest_pivot ? pivot : smallest_pivot;
      inverse_pivot[i] = 1. / pivot;
    }

    std::array<double, size>& a = m_coefficients;
    for(int i = first; i < size; ++i)
    {
      a[i] = m_rhs[i] * scale[i];
      for(int k = first; k < i; ++k)
        a[i] -= m_matrix[i][k] * a[k];
    }
    for(int i = size - 1; i >= first; --i)
    {
      a[i] *= inverse_pivot[i];
      for(int k = i + 1; k < size; ++k)
        a[i] -= m_matrix[k][i] * a[k];
    }
    for(int i = first; i < size; ++i)
      a[i] *= scale[i];
    return smallest_pivot;
  }

  double operator[](const int i) const { return m_coefficients[i]; }

private:
  static std::array<double, size> monomials(const double x, const double y)
  {
    std::array<double, size> m;
    m[0] = 1.;
    for(int order = 1, i = 1; order <= Degree; ++order)
    {
      const int lower = i - order;
      for(int j = 0; j < order; ++j, ++i)
        m[i] = m[lower + j] * x;
      m[i] = m[i - order - 1] * y;
      ++i;
    }
    return m;
  }

  // derivative with respect to x (Axis 0) or y (Axis 1) of all monomials at once:
  // monomial j of an order is x^(order-j) y^j
  template <int Axis>
  static void differentiate(const std::array<double, size>& m, std::array<double, size>& row)
  {
    row[0] = 0.;
    for(int order = 1, i = 1; order <= Degree; ++order)
    {
      const int lower = i - order;
      for(int j = 0; j <= order; ++j, ++i)
        if(Axis == 0)
          row[i] = j < order ? (order - j) * m[lower + j] : 0.;
        else
          row[i] = j > 0 ? j * m[lower + j - 1] : 0.;
    }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_POLYNOMIAL_H
