/*!
\ingroup PkgHermiteDiffuseRemeshingConcepts
\cgalConcept

The concept `HermiteDiffuseRemeshingVisitor` is what
`CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()` calls while it runs: to show progress, to
keep data of the user in step with the mesh, and to stop early.

The functions are called in the thread of the caller, between the changes of the mesh: in each of
them the mesh is valid. The functions must not change the connectivity of the mesh or its points.
An exception thrown by a function of the visitor ends the remeshing and reaches the caller, who has a valid
mesh. The repairs of degenerate and folded faces are told in the same way, as collapses and flips of the stage
`"repair"`.

`vertex_descriptor`, `halfedge_descriptor`, `edge_descriptor` and `face_descriptor` stand for the types of
`boost::graph_traits` for the mesh that is remeshed. A model need not name them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<TriangleMesh>}
\cgalHasModelsEnd
*/
class HermiteDiffuseRemeshingVisitor
{
public:
  /// \name Stages
  /// @{

  /// is called when a stage begins; `name` is the one under which the report gives its seconds: "model", "size map",
  /// "repair" where there is something to repair, "adaptation", "optimisation", "deviation" and "report".
  void stage_begins(const char* name);

  /// is called during a stage with the part of it that is done, from 0 to 1 and never falling; a stage may end before
  /// it has reached 1.
  void progress(double fraction);

  /// is called when the stage ends.
  void stage_ends(const char* name);

  /// is asked all the time, in every stage: for a mesh of 100000 faces every few milliseconds, and at least every 50
  /// milliseconds of processor time, so it must be quick itself. The stage "report", which takes about a hundredth of
  /// the time and is waited for after a stop in another stage, too, only asks before it looks for the reason why a face
  /// has a low quality. Once it returns `true` it is not asked again, the mesh is left as it is, valid, and the report
  /// says `CGAL::Hermite_diffuse_remeshing::STOPPED_BY_VISITOR`.
  bool is_stop_requested();

  /// @}

  /// \name Operations
  /// @{

  /// is called before the edge `e` is split.
  void before_edge_split(edge_descriptor e);

  /// is called after an edge was split; `v` is the new vertex.
  void after_edge_split(vertex_descriptor v);

  /// is called after `after_edge_split()` for each face at the edge, and after edges were retriangulated for
  /// each face of the region but `f`: `part` is new, and has taken a part of the place of `f`, whose data it
  /// should get.
  void after_face_split(face_descriptor f, face_descriptor part);

  /// is called before `h` is collapsed: its source will be removed and its target stays.
  void before_edge_collapse(halfedge_descriptor h);

  /// is called after an edge was collapsed; `v` is the vertex that stayed.
  void after_edge_collapse(vertex_descriptor v);

  /// is called before the edge `e` is flipped. An operation that takes several flips, such as the removal of a vertex,
  /// names all edges that go before it begins, and all that have come in their places after it, in another order.
  void before_edge_flip(edge_descriptor e);

  /// is called after the edge `e` was flipped, or has come in the place of one that was.
  void after_edge_flip(edge_descriptor e);

  /// is called before the vertex `v`, inside the surface, is removed with its edges, and the polygon around
  /// it is filled with other edges.
  void before_vertex_removal(vertex_descriptor v);

  /// is called after a vertex was removed.
  void after_vertex_removal();

  /// is called before the vertex `v` is given another point.
  void before_vertex_relocation(vertex_descriptor v);

  /// is called after the vertex `v` was given another point.
  void after_vertex_relocation(vertex_descriptor v);

  /// @}
};
