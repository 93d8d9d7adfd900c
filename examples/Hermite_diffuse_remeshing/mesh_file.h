// Mesh files by extension, and files that appear only when they are complete.

#ifndef HERMITE_DIFFUSE_REMESHING_EXAMPLES_MESH_FILE_H
#define HERMITE_DIFFUSE_REMESHING_EXAMPLES_MESH_FILE_H

#include "vtp_io.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

template <typename Point>
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
};

inline std::string in_quotes(const std::filesystem::path& path)
{
  return "'" + path.string() + "'";
}

inline std::string lower_case_extension(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

inline void check_mesh_extension(const std::filesystem::path& path)
{
  const std::string extension = lower_case_extension(path);
  for(const char* const known : { ".off", ".obj", ".ply", ".stl", ".vtp" })
    if(extension == known)
      return;
  throw std::runtime_error("the name " + in_quotes(path)
                           + " must end in .off, .obj, .ply, .stl or .vtp");
}

// While it lives nothing reaches std::cerr: CGAL's readers print remarks of their own, and an
// error of the program is to be one sentence.
class Silent_cerr
{
  struct Sink : public std::streambuf
  {
    int_type overflow(const int_type c) override { return traits_type::not_eof(c); }
  };
  Sink sink;
  std::streambuf* const previous;

public:
  Silent_cerr() : previous(std::cerr.rdbuf(&sink)) {}
  ~Silent_cerr() { std::cerr.rdbuf(previous); }
  Silent_cerr(const Silent_cerr&) = delete;
  Silent_cerr& operator=(const Silent_cerr&) = delete;
};

template <typename Point>
Polygon_soup<Point> read_polygon_soup(const std::filesystem::path& path)
{
  check_mesh_extension(path);
  std::ifstream is(path, std::ios::binary);
  if(!is || !std::filesystem::is_regular_file(path))
    throw std::runtime_error("cannot open the input file " + in_quotes(path));

  Polygon_soup<Point> soup;
  if(lower_case_extension(path) == ".vtp")
  {
    try { vtp::read(is, soup.points, soup.polygons); }
    catch(const std::runtime_error& e)
    { throw std::runtime_error("cannot read " + in_quotes(path) + ": " + e.what()); }
  }
  else
  {
    Silent_cerr silence;
    if(!CGAL::IO::read_polygon_soup(path.string(), soup.points, soup.polygons))
      throw std::runtime_error("cannot read a mesh from " + in_quotes(path));
  }
  return soup;
}

// A file as a mesh with the points and polygons in the same order, without unused points; or, if the polygons do not
// form an oriented 2-manifold, as a soup in which points and triangles occur once, and no triangle is without
// three different corners.
template <typename Mesh>
struct Mesh_or_soup
{
  Mesh mesh;
  Polygon_soup<typename Mesh::Point> soup;
  bool is_mesh;
};

template <typename Mesh>
Mesh_or_soup<Mesh> read_mesh_or_soup(const std::filesystem::path& path)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  Mesh_or_soup<Mesh> result;
  auto& soup = result.soup;
  soup = read_polygon_soup<typename Mesh::Point>(path);
  for(const auto& polygon : soup.polygons)
    for(const std::size_t i : polygon)
      if(i >= soup.points.size())
        throw std::runtime_error("a polygon in " + in_quotes(path) + " names a missing point");
  PMP::remove_isolated_points_in_polygon_soup(soup.points, soup.polygons);
  result.is_mesh = PMP::is_polygon_soup_a_polygon_mesh(soup.polygons);
  if(result.is_mesh)
  {
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, result.mesh);
    soup = Polygon_soup<typename Mesh::Point>();
  }
  else
    PMP::repair_polygon_soup(soup.points, soup.polygons);
  return result;
}

template <typename Point>
void write_polygon_soup(std::ostream& os, const std::string& extension,
                        const Polygon_soup<Point>& soup)
{
  const auto np = CGAL::parameters::stream_precision(17);
  if(extension == ".off")
    CGAL::IO::write_OFF(os, soup.points, soup.polygons, np);
  else if(extension == ".obj")
    CGAL::IO::write_OBJ(os, soup.points, soup.polygons, np);
  else if(extension == ".ply")
    CGAL::IO::write_PLY(os, soup.points, soup.polygons, np);
  else if(extension == ".stl")
    CGAL::IO::write_STL(os, soup.points, soup.polygons, np);
  else
    vtp::write(os, soup.points, soup.polygons);
}

inline std::runtime_error write_error(const std::filesystem::path& path)
{
  return std::runtime_error("cannot write the file " + in_quotes(path));
}

// Where `path` really is: through a link, in a folder that exists, and not a device.
inline std::filesystem::path checked_output_path(const std::filesystem::path& path)
{
  std::error_code ec;
  const std::filesystem::path real =
    std::filesystem::weakly_canonical(std::filesystem::absolute(path, ec), ec);
  if(ec || !real.has_filename() || !std::filesystem::is_directory(real.parent_path(), ec)
     || (std::filesystem::exists(real, ec) && !std::filesystem::is_regular_file(real, ec)))
    throw write_error(path);
  return real;
}

// A file that is written beside its final place and moved there by `commit()`.
class Output_file
{
  std::filesystem::path path;
  std::filesystem::path partial;
  std::ofstream os;

public:
  explicit Output_file(const std::filesystem::path& wanted)
    : path(checked_output_path(wanted)), partial(path)
  {
    partial += ".partial";
    os.open(partial, std::ios::binary | std::ios::trunc);
    if(!os)
      throw write_error(path);
    os.precision(17);
  }

  ~Output_file()
  {
    os.close();
    std::error_code ec;
    if(!partial.empty())
      std::filesystem::remove(partial, ec);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  std::ostream& stream() { return os; }

  // to be called once, after the last output; until `commit()` the final place is untouched
  void finish()
  {
    os.close();
    if(!os)
      throw write_error(path);
  }

  void commit()
  {
    std::error_code ec;
    std::filesystem::rename(partial, path, ec);
    if(ec)
      throw write_error(path);
    partial.clear();
  }
};

#endif // HERMITE_DIFFUSE_REMESHING_EXAMPLES_MESH_FILE_H
