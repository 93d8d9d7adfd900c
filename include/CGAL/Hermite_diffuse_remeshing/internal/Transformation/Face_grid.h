// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GRID_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GRID_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Bounding_box
{
  Vector low, high;

  explicit Bounding_box(const std::array<Vector, 3>& p)
    : low(p[0].cwiseMin(p[1]).cwiseMin(p[2])), high(p[0].cwiseMax(p[1]).cwiseMax(p[2]))
  {}

  void add(const Bounding_box& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }

  bool meets(const Bounding_box& other) const
  {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

// Finds the faces near a box while the mesh changes: a grid for every order of magnitude of the faces. A
// face lies in the one cell that holds its middle, of a grid with cells at least as large as the face, so
// that a query looks half a cell farther than its box.
template <typename Face>
class Face_grid
{
public:
  struct Cell_key
  {
    int level;
    std::array<std::int64_t, 3> place;

    bool operator==(const Cell_key& other) const { return level == other.level && place == other.place; }
  };

private:
  struct Hash
  {
    std::size_t operator()(const Cell_key& key) const
    {
      std::size_t seed = static_cast<std::size_t>(key.level);
      for(const std::int64_t i : key.place)
        boost::hash_combine(seed, i);
      return seed;
    }
  };

  std::unordered_map<Cell_key, std::vector<Face>, Hash> m_cells;
  std::map<int, std::size_t> m_number_of_faces;   // of the levels in use

  // Cells of neighbouring levels differ by this factor: sizes that vary little lie on one or two levels,
  // and a query looks at few cells.
  static constexpr int log2_of_factor = 2;

public:
  static Cell_key key(const Bounding_box& box)
  {
    const double extent = (box.high - box.low).maxCoeff();
    int exponent = 0;
    std::frexp(extent, &exponent);                 // extent < 2^exponent
    const int level = exponent >= 0 ? (exponent + log2_of_factor - 1) / log2_of_factor
                                    : -(-exponent / log2_of_factor);
    const double cell = cell_size(level);
    Cell_key result;
    result.level = level;
    for(int i = 0; i < 3; ++i)
      result.place[i] = place((box.low[i] + box.high[i]) / 2., cell);
    return result;
  }

  void insert(const Face f, const Cell_key& key)
  {
    m_cells[key].push_back(f);
    ++m_number_of_faces[key.level];
  }

  void erase(const Face f, const Cell_key& key)
  {
    const auto cell = m_cells.find(key);
    std::vector<Face>& faces = cell->second;
    *std::find(faces.begin(), faces.end(), f) = faces.back();
    faces.pop_back();
    if(faces.empty())
      m_cells.erase(cell);
    const auto level = m_number_of_faces.find(key.level);
    if(--level->second == 0)
      m_number_of_faces.erase(level);
  }

  // calls `visit(face)` for all faces that may meet the box until it returns false
  template <typename Visit>
  bool visit_near(const Bounding_box& box, const Visit& visit) const
  {
    for(const auto& level : m_number_of_faces)
    {
      const double cell = cell_size(level.first);
      std::array<std::int64_t, 3> first, last;
      double number = 1.;
      for(int i = 0; i < 3; ++i)
      {
        first[i] = place(box.low[i] - cell / 2., cell);
        last[i] = place(box.high[i] + cell / 2., cell);
        number *= double(last[i] - first[i] + 1);
      }
      // a large box among small faces: fewer cells exist than places
      if(number > double(m_cells.size()))
      {
        for(const auto& entry : m_cells)
          if(entry.first.level == level.first && !visit_all(entry.second, visit))
            return false;
        continue;
      }
      Cell_key key;
      key.level = level.first;
      for(key.place[0] = first[0]; key.place[0] <= last[0]; ++key.place[0])
        for(key.place[1] = first[1]; key.place[1] <= last[1]; ++key.place[1])
          for(key.place[2] = first[2]; key.place[2] <= last[2]; ++key.place[2])
          {
            const auto found = m_cells.find(key);
            if(found != m_cells.end() && !visit_all(found->second, visit))
              return false;
          }
    }
    return true;
  }

private:
  static double cell_size(const int level) { return std::ldexp(1., log2_of_factor * level); }

  static std::int64_t place(const double x, const double cell)
  {
    return static_cast<std::int64_t>(std::floor(x / cell));
  }

  template <typename Visit>
  static bool visit_all(const std::vector<Face>& faces, const Visit& visit)
  {
    for(const Face f : faces)
      if(!visit(f))
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GRID_H
