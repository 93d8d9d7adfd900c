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

// Finds the faces near a box while the mesh changes: an octree with loose cells. A face lies in the one cell
// that holds its middle, of the level whose cells are just as large as the face or larger, so that the faces of
// a cell reach at most half a cell beyond it. Every cell with faces has all its ancestors.
template <typename Face>
class Face_grid
{
public:
  struct Cell_key
  {
    int level;                            // cells have the size 2^level
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

  struct Cell
  {
    std::vector<Face> faces;
    int number_of_children = 0;
  };

  int m_top_level;
  std::unordered_map<Cell_key, Cell, Hash> m_cells;
  std::map<int, std::size_t> m_number_of_faces;   // of the levels that have some

public:
  // `extent`: of the largest face that will be
  explicit Face_grid(const double extent) : m_top_level(level_of(extent)) {}

  Cell_key key(const Bounding_box& box) const
  {
    Cell_key result;
    result.level = (std::min)(m_top_level, level_of((box.high - box.low).maxCoeff()));
    for(int i = 0; i < 3; ++i)
      result.place[i] = place((box.low[i] + box.high[i]) / 2., cell_size(result.level));
    return result;
  }

  void insert(const Face f, const Cell_key& key)
  {
    ++m_number_of_faces[key.level];
    make_cell(key).faces.push_back(f);
  }

  void erase(const Face f, const Cell_key& key)
  {
    std::vector<Face>& faces = m_cells.find(key)->second.faces;
    *std::find(faces.begin(), faces.end(), f) = faces.back();
    faces.pop_back();
    const auto level = m_number_of_faces.find(key.level);
    if(--level->second == 0)
      m_number_of_faces.erase(level);
    remove_if_empty(key);
  }

  // calls `visit(face)` for all faces that may meet the box until it returns false
  template <typename Visit>
  bool visit_near(const Bounding_box& box, const Visit& visit) const
  {
    // cells as large as the box or larger are few and looked up one by one, smaller ones from their parents
    const int own_level = key(box).level;
    for(int level = own_level; level <= m_top_level; ++level)
    {
      if(level > own_level && m_number_of_faces.count(level) == 0)
        continue;
      const double size = cell_size(level);
      std::array<std::int64_t, 3> first, last;
      for(int i = 0; i < 3; ++i)
      {
        first[i] = place(box.low[i] - size / 2., size);
        last[i] = place(box.high[i] + size / 2., size);
      }
      Cell_key key;
      key.level = level;
      for(key.place[0] = first[0]; key.place[0] <= last[0]; ++key.place[0])
        for(key.place[1] = first[1]; key.place[1] <= last[1]; ++key.place[1])
          for(key.place[2] = first[2]; key.place[2] <= last[2]; ++key.place[2])
            if(!visit_cell(key, box, level == own_level, visit))
              return false;
    }
    return true;
  }

private:
  static int level_of(const double extent)
  {
    int exponent = 0;
    std::frexp(extent, &exponent);        // extent < 2^exponent
    return exponent;
  }

  static double cell_size(const int level) { return std::ldexp(1., level); }

  static std::int64_t place(const double x, const double size)
  {
    return static_cast<std::int64_t>(std::floor(x / size));
  }

  static Cell_key parent(const Cell_key& key)
  {
    const auto half = [](const std::int64_t i) { return i >= 0 ? i / 2 : -((1 - i) / 2); };
    return {key.level + 1, {{half(key.place[0]), half(key.place[1]), half(key.place[2])}}};
  }

  // with its ancestors
  Cell& make_cell(const Cell_key& key)
  {
    const auto found = m_cells.find(key);
    if(found != m_cells.end())
      return found->second;
    if(key.level < m_top_level)
      ++make_cell(parent(key)).number_of_children;
    return m_cells[key];
  }

  void remove_if_empty(Cell_key key)
  {
    for(;; key = parent(key))
    {
      const auto cell = m_cells.find(key);
      if(!cell->second.faces.empty() || cell->second.number_of_children > 0)
        return;
      m_cells.erase(cell);
      if(key.level == m_top_level)
        return;
      --m_cells.find(parent(key))->second.number_of_children;
    }
  }

  template <typename Visit>
  bool visit_cell(const Cell_key& key, const Bounding_box& box, const bool is_deep, const Visit& visit) const
  {
    const auto found = m_cells.find(key);
    if(found == m_cells.end())
      return true;
    for(const Face f : found->second.faces)
      if(!visit(f))
        return false;
    if(!is_deep || found->second.number_of_children == 0)
      return true;
    const double size = cell_size(key.level - 1);
    for(int child = 0; child < 8; ++child)
    {
      Cell_key child_key;
      child_key.level = key.level - 1;
      bool is_near = true;
      for(int i = 0; i < 3; ++i)
      {
        child_key.place[i] = 2 * key.place[i] + (child >> i & 1);
        is_near = is_near && box.low[i] <= (double(child_key.place[i]) + 1.5) * size
                          && box.high[i] >= (double(child_key.place[i]) - 0.5) * size;
      }
      if(is_near && !visit_cell(child_key, box, true, visit))
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GRID_H
