/*!
\ingroup PkgHermiteDiffuseRemeshingConcepts
\cgalConcept

The concept `HermiteDiffuseSizeField` is what a user asks for as the length of the edges at a place on
the mesh. It is the type of the named parameter `size_field` of
`CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`.

There are two forms of the call operator, and a model has one of them. A field that depends on the point alone, such as
a lambda expression, has the first. A field that is attached to the mesh, such as a property map, has the
second.

`Point_3` and `FT` stand for these types of the geometry traits, `face_descriptor` for the faces of the mesh, or
`std::size_t` where a soup is remeshed. A model need not name them.

A field is read before the mesh is changed, and not afterwards. It is not asked about faces that a repair takes away;
beside these, where a repair changes the corners of a face, the coordinates are those between its new corners. It must
be a function in the mathematical sense: the same place has the same size, however often and in whichever order it is
asked. It is copied; a copy must give the same sizes. Its call operator is `const`.

A size is a length, larger than 0, in the unit of the mesh. Infinity means that there is no wish at
the place. Anything else is refused with `std::invalid_argument`, before the mesh is changed.

The field need be neither continuous nor of limited slope: the gradation takes care of that.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Constant_size_field}
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Vertex_size_field<TriangleMesh,VertexSizeMap>}
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Face_size_field<TriangleMesh,FaceSizeMap>}
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Minimum_size_field<SizeFields>}
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Scattered_size_field<GeomTraits>}
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Background_size_field<GeomTraits>}
\cgalHasModelsEnd
*/
class HermiteDiffuseSizeField
{
public:
  /// returns the size at a point of the surface.
  double operator()(const Point_3& p) const;

  /// returns the size at the point `p` of the surface above the face `f` of the mesh, at the barycentric
  /// coordinates of `source(halfedge(f))`, `target(halfedge(f))` and the third vertex.
  double operator()(const Point_3& p, face_descriptor f, const std::array<FT, 3>& coordinates) const;
};
