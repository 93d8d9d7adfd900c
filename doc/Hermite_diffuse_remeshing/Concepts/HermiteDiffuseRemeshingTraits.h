/*!
\ingroup PkgHermiteDiffuseRemeshingConcepts
\cgalConcept

The concept `HermiteDiffuseRemeshingTraits` gathers the geometry that the Hermite diffuse surface
and the remeshing take from a kernel. The model itself is computed with `double`; the coordinates of
points are read and new points are constructed through the functors.

\cgalRefines{DefaultConstructible,CopyConstructible,Assignable}

\cgalHasModelsBegin
\cgalHasModelsBare{Any \cgal kernel whose `FT` is a floating point number type\, for example
`CGAL::Exact_predicates_inexact_constructions_kernel` and `CGAL::Simple_cartesian<double>`}
\cgalHasModelsEnd
*/
class HermiteDiffuseRemeshingTraits
{
public:
  /// \name Types
  /// @{

  /// the number type: a floating point number type such as `double`
  typedef unspecified_type FT;

  /// the point type, a model of `CopyConstructible` and `Assignable`
  typedef unspecified_type Point_3;

  /// the vector type, a model of `DefaultConstructible`, `CopyConstructible` and `Assignable`
  typedef unspecified_type Vector_3;

  /// provides `FT operator()(Point_3 p)` and `FT operator()(Vector_3 v)`, the first coordinate
  typedef unspecified_type Compute_x_3;

  /// provides `FT operator()(Point_3 p)` and `FT operator()(Vector_3 v)`, the second coordinate
  typedef unspecified_type Compute_y_3;

  /// provides `FT operator()(Point_3 p)` and `FT operator()(Vector_3 v)`, the third coordinate
  typedef unspecified_type Compute_z_3;

  /// provides `Point_3 operator()(FT x, FT y, FT z)`
  typedef unspecified_type Construct_point_3;

  /// provides `Vector_3 operator()(FT x, FT y, FT z)`
  typedef unspecified_type Construct_vector_3;

  /// @}

  /// \name Operations
  /// @{

  /// returns the functor
  Compute_x_3 compute_x_3_object() const;

  /// returns the functor
  Compute_y_3 compute_y_3_object() const;

  /// returns the functor
  Compute_z_3 compute_z_3_object() const;

  /// returns the functor
  Construct_point_3 construct_point_3_object() const;

  /// returns the functor
  Construct_vector_3 construct_vector_3_object() const;

  /// @}
};
