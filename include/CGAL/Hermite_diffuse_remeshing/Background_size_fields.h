// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_BACKGROUND_SIZE_FIELDS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_BACKGROUND_SIZE_FIELDS_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_locator.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Scattered_size_field` interpolates sizes that are given at scattered points, such as the
 * nodes of another mesh or the places where a size was measured.
 *
 * The size at a place is a mean of the sizes of the nearest points with the weights
 * \f$ (1 - (d_i/d)^2)^2 / d_i^2 \f$, \f$ d_i \f$ being their distances and \f$ d \f$ the largest of them
 * (R. Franke and G. Nielson, <em>Smooth interpolation of large sets of scattered data</em>, 1980, with a
 * smoother end of the weight). Where there are no more than nine points all count everywhere, with the weights
 * \f$ 1 / d_i^2 \f$ (D. Shepard, <em>A two-dimensional interpolation function for irregularly-spaced data</em>, 1968).
 * The size is continuous, is the given one at the points and stays between the smallest and the largest of them.
 *
 * Copies share the points. A query takes time logarithmic in the number of points.
 *
 * \cgalModels{HermiteDiffuseSizeField}
 *
 * \tparam GeomTraits a model of `HermiteDiffuseRemeshingTraits`
 */
template <typename GeomTraits>
class Scattered_size_field
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef std::pair<Kernel::Point_3, double> Sized_point;
  typedef CGAL::Search_traits_adapter<Sized_point, CGAL::First_of_pair_property_map<Sized_point>,
                                      CGAL::Search_traits_3<Kernel> > Search_traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Search_traits> Search;

  GeomTraits m_traits;
  std::shared_ptr<typename Search::Tree> m_tree;

public:
  /*!
   * copies points and their sizes.
   *
   * @tparam SizedPointRange a model of `ConstRange`, the value type of which is a pair of `GeomTraits::Point_3` and a
   *         type convertible to `double`
   *
   * @param sized_points the points and their sizes, lengths larger than 0
   * @param traits an instance of the geometric traits class
   *
   * \throw std::invalid_argument if there is no point, a coordinate that is not finite, or a size that is
   *        not larger than 0 or not finite
   */
  template <typename SizedPointRange>
  explicit Scattered_size_field(const SizedPointRange& sized_points, const GeomTraits& traits = GeomTraits())
    : m_traits(traits), m_tree(std::make_shared<typename Search::Tree>())
  {
    for(const auto& entry : sized_points)
    {
      const Kernel::Point_3 p = to_point(entry.first);
      const double size = CGAL::to_double(entry.second);
      if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        throw std::invalid_argument("a point of the size field has a coordinate that is not finite");
      if(!(size > 0.) || !std::isfinite(size))
        internal::refuse("a size of the size field", size, "it must be finite and larger than zero");
      m_tree->insert(Sized_point(p, size));
    }
    if(m_tree->empty())
      throw std::invalid_argument("the size field has no point");
    // so that queries do not change the tree
    m_tree->build();
  }

  /// returns the interpolated size.
  double operator()(const typename GeomTraits::Point_3& p) const
  {
    // enough to surround a place on a surface
    constexpr unsigned int number_of_neighbors = 9;
    const Kernel::Point_3 query = to_point(p);
    const Search search(*m_tree, query, number_of_neighbors);
    std::vector<std::pair<double, double> > neighbors;
    double radius2 = 0.;
    for(const auto& found : search)
    {
      neighbors.push_back(std::make_pair(found.second, found.first.second));
      radius2 = (std::max)(radius2, found.second);
    }
    // Where no other one can take its place the farthest point counts, too.
    const bool are_all_near = m_tree->size() <= number_of_neighbors;
    double sum = 0., sum_of_weights = 0.;
    for(const std::pair<double, double>& neighbor : neighbors)
    {
      if(neighbor.first == 0.)
        return neighbor.second;
      const double share = are_all_near ? 1. : 1. - neighbor.first / radius2;
      // where all are equally far all count the same
      constexpr double floor = 1e-9;
      const double weight = (share * share + floor) * radius2 / neighbor.first;
      sum += weight * neighbor.second;
      sum_of_weights += weight;
    }
    return sum / sum_of_weights;
  }

private:
  Kernel::Point_3 to_point(const typename GeomTraits::Point_3& p) const
  {
    const internal::Vector q = internal::Point_reader<GeomTraits>(m_traits)(p);
    return Kernel::Point_3(q[0], q[1], q[2]);
  }
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Background_size_field` reads the size on another triangle mesh, the background: it is
 * interpolated linearly in the background's point that is closest. The background may be coarser or finer
 * than the mesh that is remeshed, and need not cover it.
 *
 * The geometry and the sizes are copied; copies of the field share them. A query takes time logarithmic
 * in the number of faces of the background.
 *
 * \cgalModels{HermiteDiffuseSizeField}
 *
 * \tparam GeomTraits a model of `HermiteDiffuseRemeshingTraits`
 */
template <typename GeomTraits>
class Background_size_field
{
  struct Data
  {
    internal::Indexed_triangles triangles;
    std::vector<double> sizes;                   // per vertex
    std::unique_ptr<internal::Triangle_tree> tree;
  };

  GeomTraits m_traits;
  std::shared_ptr<const Data> m_data;

public:
  /*!
   * copies a mesh and the sizes of its vertices.
   *
   * @tparam TriangleMesh a model of `FaceListGraph` with an internal property map of points
   * @tparam VertexSizeMap a model of `ReadablePropertyMap` with key type `vertex_descriptor` and a value type
   *         convertible to `double`
   *
   * @param background the mesh
   * @param sizes the sizes of its vertices, lengths larger than 0. Where one is infinite, and in the faces around,
   *        there is no wish.
   * @param traits an instance of the geometric traits class
   *
   * \throw std::invalid_argument if the background has no face, a face that is not a triangle, a coordinate
   *        that is not finite, or a size that is not larger than 0
   */
  template <typename TriangleMesh, typename VertexSizeMap>
  Background_size_field(const TriangleMesh& background, const VertexSizeMap& sizes,
                        const GeomTraits& traits = GeomTraits())
    : m_traits(traits)
  {
    const auto data = std::make_shared<Data>();
    std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> faces;
    data->triangles = internal::read_triangles(background, get_const_property_map(CGAL::vertex_point, background),
                                               traits, faces);
    for(const auto v : vertices(background))
    {
      const double size = CGAL::to_double(get(sizes, v));
      if(!(size > 0.))
        internal::refuse("the size of vertex " + std::to_string(data->sizes.size()), size,
                         "it must be larger than zero");
      data->sizes.push_back(size);
    }
    data->tree.reset(new internal::Triangle_tree(data->triangles));
    m_data = data;
  }

  /// returns the size at the closest point of the background.
  double operator()(const typename GeomTraits::Point_3& p) const
  {
    const internal::Vector query = internal::Point_reader<GeomTraits>(m_traits)(p);
    const internal::Indexed_triangles& triangles = m_data->triangles;
    const std::pair<int, internal::Vector> closest = m_data->tree->closest(query);
    const int f = closest.first;
    const internal::Barycentric l = internal::closest_barycentric(triangles.point(f, 0), triangles.point(f, 1),
                                                                  triangles.point(f, 2), closest.second);
    double size = 0.;
    for(int k = 0; k < 3; ++k)
      // an infinite size at another vertex must not spoil the result
      if(l[k] > 0.)
        size += l[k] * m_data->sizes[triangles.triangles[f][k]];
    return size;
  }
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_BACKGROUND_SIZE_FIELDS_H
