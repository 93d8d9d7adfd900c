// The command line program: reads a triangle mesh, remeshes it on its Hermite diffuse surface
// model, writes the result and, on request, a report and a file of fields.

#include "mesh_file.h"
#include "report_output.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>
#include <CGAL/Hermite_diffuse_size_map.h>
#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh_triangle_soup.h>
#include <CGAL/Surface_mesh.h>

#include <boost/optional.hpp>
#include <boost/program_options.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel         K;
typedef CGAL::Surface_mesh<K::Point_3>                              Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor                vertex_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor                  face_descriptor;
typedef std::pair<std::size_t, std::array<double, 3> >              Location;
typedef CGAL::Hermite_diffuse_remeshing::Remeshing_report<Mesh>     Report;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace po = boost::program_options;

// ---- options ------------------------------------------------------------------------------------

struct Options
{
  std::string input, output, report, fields;
  // the laws of the size: 0.01 of the first if none is given
  boost::optional<double> approximation_error, elements_per_circle, angle_per_element, sagitta_over_length;
  double sagitta = std::numeric_limits<double>::infinity();
  double maximum_deviation = std::numeric_limits<double>::infinity();
  double maximum_displacement = std::numeric_limits<double>::infinity();
  double minimum_edge_length = 0.;
  double maximum_edge_length = 0.;
  double gradation = 1.3;
  double sharp_angle = 40.;
  double corner_angle = 60.;
  int iterations = 10;
  std::size_t maximum_number_of_faces = 0;
  double maximum_running_time = std::numeric_limits<double>::infinity();
  bool is_noisy = false;
  bool is_prediction = false;
  bool is_quiet = false;
  bool is_help_wanted = false;
};

// `value` is written by the parser; its present value is the default
template <typename T>
po::typed_value<T>* number(T& value, const char* unit)
{
  return po::value<T>(&value)->value_name(unit);
}

template <typename T>
po::typed_value<boost::optional<T> >* number(boost::optional<T>& value, const char* unit)
{
  return po::value<boost::optional<T> >(&value)->value_name(unit);
}

po::options_description visible_options(Options& o)
{
  po::options_description options("Options (lengths in the unit of the input)", 96, 48);
  options.add_options()
    ("approximation-error", number(o.approximation_error, "E"),
     "error relative to the local radius of curvature (0.01); of this and the next four the smallest size"
     " counts")
    ("elements-per-circle", number(o.elements_per_circle, "N"), "edges on a full circle")
    ("angle-per-element", number(o.angle_per_element, "DEG"), "angle that an edge spans on its circle")
    ("sagitta-over-length", number(o.sagitta_over_length, "S"), "distance of an edge to its arc over its length")
    ("sagitta", number(o.sagitta, "L"), "distance of an edge to its arc")
    ("maximum-deviation", number(o.maximum_deviation, "D"),
     "largest distance to the model of the input (no bound)")
    ("maximum-displacement", number(o.maximum_displacement, "D"),
     "largest distance of the model to the facets of the input (no bound)")
    ("minimum-edge-length", number(o.minimum_edge_length, "L"),
     "lower bound of the sizes (0.0001 of the diameter)")
    ("maximum-edge-length", number(o.maximum_edge_length, "L"),
     "upper bound of the sizes (0.1 of the diameter)")
    ("gradation", number(o.gradation, "G"),
     "largest ratio of the sizes of adjacent faces (1.3)")
    ("sharp-angle", number(o.sharp_angle, "DEG"),
     "edges with a larger angle between normals are features (40)")
    ("corner-angle", number(o.corner_angle, "DEG"),
     "feature curves that turn more have a corner (60)")
    ("noisy", po::bool_switch(&o.is_noisy), "sizes and normals follow the surface, not its noise: scans, isosurfaces")
    ("maximum-number-of-faces", number(o.maximum_number_of_faces, "N"),
     "scale the sizes to meet this (1000000, or ten times the input)")
    ("maximum-running-time", number(o.maximum_running_time, "SECONDS"), "stop after this time (no limit)")
    ("predict", po::bool_switch(&o.is_prediction),
     "print the number of faces to expect, and write nothing")
    ("iterations", number(o.iterations, "N"), "largest number of passes (10)")
    ("report", po::value<std::string>(&o.report)->value_name("FILE.json"), "write a report")
    ("fields", po::value<std::string>(&o.fields)->value_name("FILE.vtp"),
     "write the result with curvatures, size, quality and deviation")
    ("quiet", po::bool_switch(&o.is_quiet), "print nothing but errors")
    ("help", po::bool_switch(&o.is_help_wanted), "print this text");
  return options;
}

std::string help_text()
{
  Options defaults;
  std::ostringstream text;
  text << "Usage: remesh_file INPUT OUTPUT [options]\n"
       << "       remesh_file INPUT --predict [options]\n\n"
       << "Remeshes a triangle mesh with sizes that follow its curvature. The extensions of the\n"
       << "files choose their formats: .off, .obj, .ply, .stl or .vtp. Triangles that form no oriented\n"
       << "2-manifold are remeshed as a soup, with the edges where several meet.\n\n"
       << visible_options(defaults);
  return text.str();
}

Options parse(int argc, char* argv[])
{
  Options o;
  po::options_description all("all");
  all.add(visible_options(o)).add_options()
    ("input", po::value<std::string>(&o.input))
    ("output", po::value<std::string>(&o.output));
  po::positional_options_description positions;
  positions.add("input", 1).add("output", 1);

  // no short options, so that a negative number is a value
  const int style = po::command_line_style::allow_long
                  | po::command_line_style::long_allow_adjacent
                  | po::command_line_style::long_allow_next;
  po::variables_map values;
  po::command_line_parser parser(argc, argv);
  po::store(parser.options(all).positional(positions).style(style).run(), values);
  po::notify(values);
  return o;
}

void check(const Options& o)
{
  if(o.is_prediction)
  {
    if(o.input.empty())
      throw std::runtime_error("an input file is needed; --help explains it");
    if(!o.output.empty() || !o.report.empty() || !o.fields.empty())
      throw std::runtime_error("--predict writes nothing: no output can be named");
    return;
  }
  if(o.input.empty() || o.output.empty())
    throw std::runtime_error("an input and an output file are needed; --help explains them");
  if(o.iterations < 1)
    throw std::runtime_error("the option --iterations must be at least 1");

  check_mesh_extension(o.output);
  if(!o.fields.empty() && lower_case_extension(o.fields) != ".vtp")
    throw std::runtime_error("the name " + in_quotes(o.fields) + " must end in .vtp");

  std::vector<std::filesystem::path> outputs;
  for(const std::string& name : { o.output, o.report, o.fields })
    if(!name.empty())
      outputs.push_back(checked_output_path(name));
  std::sort(outputs.begin(), outputs.end());
  const auto twin = std::adjacent_find(outputs.begin(), outputs.end());
  if(twin != outputs.end())
    throw std::runtime_error("two outputs have the name " + in_quotes(*twin));
}

// ---- remeshing ----------------------------------------------------------------------------------

// what the user gets: elements in the order of the mesh, and values on them
struct Result
{
  Report report;
  Polygon_soup<K::Point_3> soup;
  std::vector<vtp::Data_array> vertex_data;
  std::vector<vtp::Data_array> face_data;
};

// inradius over longest edge, 1 for an equilateral triangle
double quality(const K::Point_3& p, const K::Point_3& q, const K::Point_3& r)
{
  const double a = std::sqrt(CGAL::squared_distance(q, r));
  const double b = std::sqrt(CGAL::squared_distance(r, p));
  const double c = std::sqrt(CGAL::squared_distance(p, q));
  const double longest = (std::max)({ a, b, c });
  const double double_area = std::sqrt(CGAL::cross_product(q - p, r - p).squared_length());
  return (longest > 0.) ? 2. * std::sqrt(3.) * double_area / ((a + b + c) * longest) : 0.;
}

auto model_parameters(const Options& o)
{
  using namespace CGAL::Hermite_diffuse_remeshing;
  return CGAL::parameters::sharp_dihedral_angle(o.sharp_angle).corner_angle(o.corner_angle)
                          .normal_estimation(o.is_noisy ? SMOOTH_NORMALS : FITTED_NORMALS);
}

// evaluated on the model of the input, where the remeshing has put the vertices
std::vector<vtp::Data_array> curvature_data(const Mesh& reference, const Options& o,
                                            const std::vector<Location>& locations)
{
  const std::vector<face_descriptor> reference_faces(faces(reference).begin(),
                                                     faces(reference).end());
  const CGAL::Hermite_diffuse_surface<Mesh> surface(reference, model_parameters(o));

  std::vector<vtp::Data_array> data = { { "k_min", {} }, { "k_max", {} },
                                        { "mean_curvature", {} }, { "gaussian_curvature", {} } };
  for(const Location& location : locations)
  {
    const std::pair<K::FT, K::FT> k =
      surface.principal_curvatures({ reference_faces[location.first], location.second });
    data[0].second.push_back(k.second);
    data[1].second.push_back(k.first);
    data[2].second.push_back(0.5 * (k.first + k.second));
    data[3].second.push_back(k.first * k.second);
  }
  return data;
}

// all laws but the sagitta are spellings of the relative error
double approximation_error(const Options& o)
{
  namespace HDR = CGAL::Hermite_diffuse_remeshing;
  double ratio = std::numeric_limits<double>::infinity();
  if(o.elements_per_circle)
    ratio = (std::min)(ratio, HDR::length_over_radius_of_elements_per_circle(*o.elements_per_circle));
  if(o.angle_per_element)
    ratio = (std::min)(ratio, HDR::length_over_radius_of_angle(*o.angle_per_element));
  if(o.sagitta_over_length)
    ratio = (std::min)(ratio, HDR::length_over_radius_of_sagitta_over_length(*o.sagitta_over_length));
  if(ratio == std::numeric_limits<double>::infinity())
    return o.approximation_error.value_or(std::isfinite(o.sagitta) ? 0. : 0.01);
  const double error = HDR::error_of_length_over_radius(ratio);
  // 0 turns this law off, negative values are refused later
  return o.approximation_error && *o.approximation_error != 0. ? (std::min)(error, *o.approximation_error) : error;
}

auto size_parameters(const Options& o)
{
  return model_parameters(o)
    .approximation_error(approximation_error(o))
    .sagitta(o.sagitta)
    .maximum_deviation(o.maximum_deviation)
    .maximum_displacement(o.maximum_displacement)
    .minimum_edge_length(o.minimum_edge_length)
    .maximum_edge_length(o.maximum_edge_length)
    .gradation(o.gradation)
    .maximum_number_of_faces(o.maximum_number_of_faces);
}

Result remesh(Mesh& mesh, const Options& o)
{
  auto location_map = mesh.add_property_map<vertex_descriptor, Location>("v:location").first;
  auto size_map = mesh.add_property_map<vertex_descriptor, double>("v:size").first;
  auto deviation_map = mesh.add_property_map<face_descriptor, double>("f:deviation").first;
  const std::unique_ptr<const Mesh> reference(o.fields.empty() ? nullptr : new Mesh(mesh));

  Result result;
  {
    Progress_line<Mesh> progress(std::cerr, !o.is_quiet && is_terminal());
    result.report = PMP::hermite_diffuse_remesh(mesh,
      size_parameters(o)
        .number_of_iterations(o.iterations)
        .maximum_running_time(o.maximum_running_time)
        .vertex_location_map(location_map)
        .vertex_size_map(size_map)
        .face_deviation_map(deviation_map)
        .visitor(std::ref(progress)));
  }

  std::vector<std::size_t> rank(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  std::vector<Location> locations;
  std::vector<double> sizes, deviations, qualities;
  for(const vertex_descriptor v : vertices(mesh))
  {
    rank[v] = result.soup.points.size();
    result.soup.points.push_back(mesh.point(v));
    locations.push_back(location_map[v]);
    sizes.push_back(size_map[v]);
  }
  for(const face_descriptor f : faces(mesh))
  {
    std::vector<std::size_t> polygon;
    for(const vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      polygon.push_back(rank[v]);
    const auto& points = result.soup.points;
    qualities.push_back(quality(points[polygon[0]], points[polygon[1]], points[polygon[2]]));
    deviations.push_back(deviation_map[f]);
    result.soup.polygons.push_back(polygon);
  }

  if(reference != nullptr)
  {
    result.vertex_data = curvature_data(*reference, o, locations);
    result.vertex_data.emplace_back("size", sizes);
    result.face_data = { { "quality", qualities }, { "deviation", deviations } };
  }
  return result;
}

// writes values in the order of their indices
struct Growing_map
{
  typedef std::size_t key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::writable_property_map_tag category;

  std::vector<double>* values;

  friend void put(const Growing_map& map, const std::size_t i, const double value)
  {
    if(i >= map.values->size())
      map.values->resize(i + 1);
    (*map.values)[i] = value;
  }
};

// A soup has no mesh that curvatures could be evaluated on: sizes, deviations and qualities are its fields.
Result remesh(Polygon_soup<K::Point_3> soup, const Options& o)
{
  std::vector<double> sizes, deviations, qualities;
  Result result;
  {
    Progress_line<Mesh> progress(std::cerr, !o.is_quiet && is_terminal());
    result.report = PMP::hermite_diffuse_remesh_triangle_soup(soup.points, soup.polygons,
      size_parameters(o)
        .number_of_iterations(o.iterations)
        .vertex_size_map(Growing_map{&sizes})
        .face_deviation_map(Growing_map{&deviations})
        .visitor(std::ref(progress)));
  }
  for(const std::vector<std::size_t>& t : soup.polygons)
    qualities.push_back(quality(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
  result.soup = std::move(soup);
  if(!o.fields.empty())
  {
    result.vertex_data.emplace_back("size", sizes);
    result.face_data = { { "quality", qualities }, { "deviation", deviations } };
  }
  return result;
}

// ---- main ---------------------------------------------------------------------------------------

// all the files or none
void write_files(const Result& result, const Options& o)
{
  std::vector<std::unique_ptr<Output_file> > files;
  const auto open = [&files](const std::string& name) -> std::ostream&
  {
    files.push_back(std::make_unique<Output_file>(name));
    return files.back()->stream();
  };
  write_polygon_soup(open(o.output), lower_case_extension(o.output), result.soup);
  if(!o.report.empty())
    write_json(open(o.report), result.report);
  if(!o.fields.empty())
    vtp::write(open(o.fields), result.soup.points, result.soup.polygons, result.vertex_data,
               result.face_data);

  for(const auto& file : files)
    file->finish();
  for(const auto& file : files)
    file->commit();
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(argc, argv);
    if(options.is_help_wanted)
    {
      std::cout << help_text();
      return 0;
    }
    check(options);
    Mesh_or_soup<Mesh> input = read_mesh_or_soup<Mesh>(options.input);
    Mesh& mesh = input.mesh;
    if(options.is_prediction)
    {
      if(!input.is_mesh)
        throw std::runtime_error("the polygons in " + in_quotes(options.input)
                                 + " do not form an oriented 2-manifold: --predict needs one");
      const CGAL::Hermite_diffuse_size_map<Mesh> sizes(mesh, size_parameters(options));
      std::cout << std::llround(sizes.predicted_number_of_faces()) << std::endl;
      return 0;
    }
    if(!input.is_mesh && !options.is_quiet)
      std::cerr << "remesh_file: the polygons in " << in_quotes(options.input)
                << " do not form an oriented 2-manifold: they are remeshed as a soup" << std::endl;
    const Result result = input.is_mesh ? remesh(mesh, options) : remesh(std::move(input.soup), options);
    write_files(result, options);
    if(!options.is_quiet)
      print_table(std::cout, result.report);
    return 0;
  }
  catch(const std::exception& e)
  {
    std::cerr << "remesh_file: " << e.what() << std::endl;
    return 2;
  }
}
