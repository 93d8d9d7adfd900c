// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_REMESHING_REPORT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_REMESHING_REPORT_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * tells why the adaptation ended.
 */
enum Stop_reason
{
  CONVERGED,           ///< a whole pass found nothing left to change
  ITERATION_BOUND,     ///< `number_of_iterations` passes were made
  FACE_BUDGET,         ///< the number of faces reached its cap, or more were needed for `maximum_deviation`: whether this
                       ///< was met all the same, `Remeshing_report::is_maximum_deviation_met` tells
  TIME_BUDGET,         ///< `maximum_running_time` was over
  DEVIATION_NOT_MET,   ///< some faces still deviate more than `maximum_deviation`, each for one of the reasons of
                       ///< `Deviation_obstacle`
  STOPPED_BY_VISITOR   ///< the visitor asked for it
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * returns the name of a stop reason in lower case with underscores, as the command line program
 * writes it.
 */
inline const char* name(const Stop_reason reason)
{
  switch(reason)
  {
    case CONVERGED:          return "converged";
    case ITERATION_BOUND:    return "iteration_bound";
    case FACE_BUDGET:        return "face_budget";
    case TIME_BUDGET:        return "time_budget";
    case DEVIATION_NOT_MET:  return "deviation_not_met";
    case STOPPED_BY_VISITOR: return "stopped_by_visitor";
  }
  return "unknown";
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * tells why a face deviates more than `maximum_deviation`.
 */
enum Deviation_obstacle
{
  DEVIATION_AT_PROTECTED_EDGE, ///< the edge where it does may not be changed, or the sizes there start from its length
  DEVIATION_AT_SMALLEST_SIZE,  ///< the size there is `minimum_edge_length` already
  DEVIATION_AT_FOLD,           ///< smaller faces were tried, and did not help or could not be made: the model is folded
                               ///< or torn there, as over flat or intersecting faces of the input
  DEVIATION_AFTER_STOP         ///< the face budget, the time, or the number of rounds of refinement was used up before
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * returns the name of an obstacle in lower case with underscores, as the command line program writes it.
 */
inline const char* name(const Deviation_obstacle obstacle)
{
  switch(obstacle)
  {
    case DEVIATION_AT_PROTECTED_EDGE: return "protected_edge";
    case DEVIATION_AT_SMALLEST_SIZE:  return "smallest_size";
    case DEVIATION_AT_FOLD:           return "fold";
    case DEVIATION_AFTER_STOP:        return "stop";
  }
  return "unknown";
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * tells why a face has a low quality.
 */
enum Quality_obstacle
{
  QUALITY_AT_FEATURE_ANGLE,    ///< two feature curves meet at one of its corners, at an angle that forces it
  QUALITY_AT_PROTECTED_EDGE,   ///< one of its edges may not be changed
  QUALITY_AT_CLOSE_CORNERS,    ///< two corners of the features are closer to each other than the size there
  QUALITY_BETWEEN_FEATURES,    ///< its vertices lie on feature curves that are closer to each other than the size there
  QUALITY_AT_FOLD,             ///< the model is folded or torn there, as over flat or intersecting faces of the input
  QUALITY_AT_INTERSECTION,     ///< what would improve it would make faces intersect
  QUALITY_AT_OTHER_FACES,      ///< what would improve it would make a face beside it as bad or worse
  QUALITY_AFTER_STOP           ///< the remeshing was stopped, or its number of tries used up, before
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * returns the name of an obstacle in lower case with underscores, as the command line program writes it.
 */
inline const char* name(const Quality_obstacle obstacle)
{
  switch(obstacle)
  {
    case QUALITY_AT_FEATURE_ANGLE:  return "feature_angle";
    case QUALITY_AT_PROTECTED_EDGE: return "protected_edge";
    case QUALITY_AT_CLOSE_CORNERS:  return "close_corners";
    case QUALITY_BETWEEN_FEATURES:  return "between_features";
    case QUALITY_AT_FOLD:           return "fold";
    case QUALITY_AT_INTERSECTION:   return "intersection";
    case QUALITY_AT_OTHER_FACES:    return "other_faces";
    case QUALITY_AFTER_STOP:        return "stop";
  }
  return "unknown";
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * is a face of the result with a quality below `low_quality`, and the reason.
 */
template <typename FaceDescriptor>
struct Low_quality_face
{
  /// faces with a lower quality are reported
  static constexpr double low_quality = 0.3;

  FaceDescriptor face;                            ///< of the result
  double quality = 0.;                            ///< in [0, `low_quality`]
  std::array<double, 3> point = {{0., 0., 0.}};   ///< the centroid
  Quality_obstacle obstacle = QUALITY_AFTER_STOP; ///< the reason
  /// degrees between the feature curves; 0 for other reasons than `QUALITY_AT_FEATURE_ANGLE`
  double angle = 0.;
  /// no triangle can be better in a corner with this angle; 1 for other reasons
  double best_quality = 1.;
  /// distance between the corners, or the feature curves, that are too close; 0 for other reasons
  double distance = 0.;
  double size = 0.;                               ///< the edge length that was asked for there
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * says what a remeshing did and which promises it kept. Lengths are in the unit of the input.
 * The quality of a triangle is \f$ 2\sqrt{3}\,\rho / L \f$ with \f$ \rho \f$ the radius of the
 * inscribed circle and \f$ L \f$ the longest edge: 1 for an equilateral triangle, 0 for a flat one.
 *
 * \tparam TriangleMesh the type of the mesh that was remeshed
 */
template <typename TriangleMesh>
struct Remeshing_report
{
  /// a face of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  /// \name Size of the mesh
  /// @{
  std::size_t number_of_input_faces = 0;   ///< of the whole mesh before remeshing
  std::size_t number_of_faces = 0;         ///< of the whole mesh after remeshing
  std::size_t number_of_vertices = 0;      ///< of the whole mesh after remeshing
  /// @}

  /// \name State of the input
  /// @{

  /// faces whose height is within the rounding of the coordinates
  std::size_t number_of_degenerate_input_faces = 0;
  /// faces that are turned by more than 120 degrees against all faces beside them
  std::size_t number_of_folded_input_faces = 0;
  /// those of both that could not be repaired before the surface was fitted; all, after a stop that came before
  std::size_t number_of_unrepaired_faces = 0;
  double largest_unfolding = 0.;           ///< how far the repair of folded faces has moved the surface at most
  std::size_t number_of_isolated_vertices = 0;   ///< vertices without faces; they stay
  /// vertices at the place of another; they are not merged
  std::size_t number_of_coincident_vertices = 0;
  /// @}

  /// \name Quality of the remeshed faces
  /// without any the smallest one is 1 and the mean 0
  /// @{
  double smallest_input_quality = 0.;      ///< of the input, where it is remeshed
  double mean_input_quality = 0.;          ///< of the input, where it is remeshed
  double smallest_quality = 0.;            ///< of the result
  double mean_quality = 0.;                ///< of the result
  /// the faces with a quality below `Low_quality_face::low_quality`, the worst first; none if the remeshing was stopped
  /// before the mesh was changed
  std::vector<Low_quality_face<face_descriptor> > low_quality_faces;
  /// @}

  /// \name Distance to the model
  /// measured at vertices, edge middles and face centroids of the result, where these tell that it is larger in
  /// between, between feature edges and their curves, and back to the result: from the vertices of the input, from the
  /// middles of its feature edges, on their curves, and, if there is a bound, from points of the model over its faces,
  /// as many as it takes to know the model, where it is smooth between them, to a twentieth of the bound; and where
  /// edges of the result cross the sides of faces of the input, along which the model may have ridges, and between.
  /// Distances are raised by 5 %, or by 15 % with a `maximum_displacement`, which allows for what is between the points. The mean is
  /// that of the faces of the result, of what is measured at their vertices, middles and centroids, not raised.
  /// @{

  /// `false` if the remeshing was stopped before it was measured; then what is measured means nothing, and
  /// `is_maximum_deviation_met` is `false` if there is a bound
  bool is_deviation_measured = false;
  double largest_deviation = 0.;           ///< a length
  double mean_deviation = 0.;              ///< a length
  /// the point of the result or of the model at which `largest_deviation` was measured
  std::array<double, 3> point_of_largest_deviation = {{0., 0., 0.}};
  /// the largest distance between the model and the facets of the input, at the middles of their sides and at their
  /// centroids, and at more points of those where it is large. The distance between the result and these facets, which
  /// are chords of the model too, is at most the sum of this and of `largest_deviation`, with two exceptions: where faces
  /// of the result span many facets and there is no bound, as between the vertices of the input nothing is measured then;
  /// and where the model rounds off a rim that is no feature, from which it is farther than from the facets beside it.
  double distance_of_model_from_input = 0.;
  /// the bound that was asked for, infinite if there was none
  double maximum_deviation = std::numeric_limits<double>::infinity();
  /// `true` if there is no bound, or if the deviation was measured and `largest_deviation` is at most
  /// `maximum_deviation`
  bool is_maximum_deviation_met = true;
  /// rounds of smaller sizes that `maximum_deviation` made necessary
  std::size_t number_of_deviation_rounds = 0;
  /// the faces of the result that deviate more than `maximum_deviation`
  std::vector<face_descriptor> faces_above_maximum_deviation;
  /// why they do, in the same order
  std::vector<Deviation_obstacle> deviation_obstacles;
  /// @}

  /// \name Sizes
  /// @{

  /// part of the edges with a length between half and twice the size asked for, in [0, 1]; the sizes are those that
  /// `maximum_deviation` has lowered. 1 without edges
  double size_conformity = 0.;
  /// number of faces of the whole mesh that was expected from the sizes before anything was changed:
  /// the integral of \f$ 4/(\sqrt{3}\,L^2) \f$ over the remeshed part, and the faces of the rest
  double predicted_number_of_faces = 0.;
  /// factor of the sizes that `maximum_number_of_faces` made necessary; 1 if it did not. Where features make more faces than
  /// predicted it is larger than that of the prediction.
  double size_scale = 1.;
  /// @}

  /// \name Classification
  /// @{

  /// of the input, those of the user included, and the vertices at which closed curves are cut: more than
  /// `hermite_diffuse_classify_features()` finds
  std::size_t number_of_corners = 0;
  std::size_t number_of_feature_edges = 0;  ///< of the input: boundary edges, sharp edges, user's edges
  std::size_t number_of_curves = 0;         ///< chains of feature edges between corners; closed ones count twice
  /// @}

  /// \name What was done
  /// @{
  std::size_t number_of_splits = 0;         ///< of edges
  std::size_t number_of_collapses = 0;      ///< of edges
  std::size_t number_of_flips = 0;          ///< of edges
  /// of vertices that were removed with their edges, the polygon being filled with others
  std::size_t number_of_vertex_removals = 0;
  std::size_t number_of_relocations = 0;    ///< of vertices that were given another point
  std::size_t number_of_iterations = 0;     ///< passes over the final sizes, those for budget and deviation included
  Stop_reason stop_reason = CONVERGED;      ///< why it ended
  /// name and seconds of every stage, in the order of the run
  std::vector<std::pair<std::string, double> > stages;
  double seconds = 0.;                      ///< of all stages; reading and checking the input comes before
  /// @}
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_REMESHING_REPORT_H
