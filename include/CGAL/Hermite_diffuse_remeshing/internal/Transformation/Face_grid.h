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
  Vector low = Vector::Zero(), high = Vector::Zero();

  Bounding_box() {}
  Bounding_box(const Vector& lowest, const Vector& highest) : low(lowest), high(highest) {}
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

  // zero inside
  double distance(const Vector& p) const
  {
    return (low - p).cwiseMax(p - high).cwiseMax(0.).norm();
  }
};

// Finds the faces near a box while the mesh changes: an octree with loose cells. A face lies in the one cell
// that holds its middle, of the level whose cells are just as large as the face or larger, so that the faces of
// a cell reach at most half a cell beyond it. Every cell with faces has all its ancestors. Cells know their
// children and parents, and are looked up by their place only where a search begins.
template <typename Face>
class Face_grid
{
public:
  struct Cell_key
  {
    int level = 0;                        // cells have the size 2^level
    std::array<std::int64_t, 3> place = {{0, 0, 0}};

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

public:
  struct Cell
  {
    Cell_key key;
    Cell* parent = nullptr;
    std::array<Cell*, 8> children{};
    int number_of_children = 0;
    std::vector<Face> faces;
  };

private:
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

  // May a face with the box stay in a cell? It may reach half a cell beyond it.
  static bool holds(const Cell& cell, const Bounding_box& box)
  {
    // a face that has become much smaller is found faster in a smaller cell
    constexpr double least_share = 0.25;
    const double size = cell_size(cell.key.level);
    for(int i = 0; i < 3; ++i)
      if(box.low[i] < (double(cell.key.place[i]) - 0.5) * size || box.high[i] > (double(cell.key.place[i]) + 1.5) * size)
        return false;
    return (box.high - box.low).maxCoeff() >= least_share * size;
  }

  // returns the cell, which stays where it is
  Cell* insert(const Face f, const Cell_key& key)
  {
    ++m_number_of_faces[key.level];
    Cell* const cell = make_cell(key);
    cell->faces.push_back(f);
    return cell;
  }

  void erase(const Face f, Cell* const cell)
  {
    *std::find(cell->faces.begin(), cell->faces.end(), f) = cell->faces.back();
    cell->faces.pop_back();
    const auto level = m_number_of_faces.find(cell->key.level);
    if(--level->second == 0)
      m_number_of_faces.erase(level);
    remove_if_empty(cell);
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
          {
            const auto found = m_cells.find(key);
            if(found != m_cells.end() && !visit_cell(found->second, box, level == own_level, visit))
              return false;
          }
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
    Cell_key result;
    result.level = key.level + 1;
    for(int i = 0; i < 3; ++i)
      result.place[i] = half(key.place[i]);
    return result;
  }

  static int place_in_parent(const Cell_key& key)
  {
    int result = 0;
    for(int i = 0; i < 3; ++i)
      result |= static_cast<int>(key.place[i] & 1) << i;
    return result;
  }

  // with its ancestors
  Cell* make_cell(const Cell_key& key)
  {
    const auto inserted = m_cells.emplace(key, Cell());
    Cell* const cell = &inserted.first->second;
    if(!inserted.second)
      return cell;
    cell->key = key;
    if(key.level < m_top_level)
    {
      cell->parent = make_cell(parent(key));
      cell->parent->children[place_in_parent(key)] = cell;
      ++cell->parent->number_of_children;
    }
    return cell;
  }

  void remove_if_empty(Cell* cell)
  {
    while(cell != nullptr && cell->faces.empty() && cell->number_of_children == 0)
    {
      Cell* const parent = cell->parent;
      if(parent != nullptr)
      {
        parent->children[place_in_parent(cell->key)] = nullptr;
        --parent->number_of_children;
      }
      m_cells.erase(Cell_key(cell->key));
      cell = parent;
    }
  }

  template <typename Visit>
  bool visit_cell(const Cell& cell, const Bounding_box& box, const bool is_deep, const Visit& visit) const
  {
    for(const Face f : cell.faces)
      if(!visit(f))
        return false;
    if(!is_deep || cell.number_of_children == 0)
      return true;
    const double size = cell_size(cell.key.level - 1);
    for(const Cell* const child : cell.children)
    {
      if(child == nullptr)
        continue;
      bool is_near = true;
      for(int i = 0; i < 3; ++i)
        is_near = is_near && box.low[i] <= (double(child->key.place[i]) + 1.5) * size
                          && box.high[i] >= (double(child->key.place[i]) - 0.5) * size;
      if(is_near && !visit_cell(*child, box, true, visit))
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GRID_H
