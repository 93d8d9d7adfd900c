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
#include <limits>
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

  static Bounding_box nothing()
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    return Bounding_box(Vector::Constant(infinity), Vector::Constant(-infinity));
  }

  Bounding_box enlarged(const double distance) const
  {
    return Bounding_box((low.array() - distance).matrix(), (high.array() + distance).matrix());
  }

  void add(const Bounding_box& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }

  bool holds(const Bounding_box& other) const
  {
    return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
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
// that holds its middle, of a level whose cells are larger than the face, so that the faces of a cell reach at
// most half a cell beyond it. Every cell with faces has all its ancestors, and is found by going down from the
// largest ones. Surfaces leave most of a large cell empty: cells remember how far the faces below them reach.
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
  struct Boxed_face
  {
    Face face;
    Bounding_box box;
  };

  struct Cell
  {
    Cell_key key;
    Cell* parent = nullptr;
    std::array<Cell*, 8> children{};
    int number_of_children = 0;
    std::vector<Boxed_face> faces;
    Bounding_box content = Bounding_box::nothing();       // holds the faces of the cell and of its descendants
  };

private:
  // above the level whose cells are just as large as a face, where a search near some faces meets some 40 cells with
  // two faces each on the average
  static constexpr int levels_above = 1;

  int m_top_level;
  std::unordered_map<Cell_key, Cell, Hash> m_cells;
  std::vector<Cell*> m_top_cells;       // few: they are as large as the mesh

public:
  // `extent`: of the largest face that will be
  explicit Face_grid(const double extent) : m_top_level(level_of(extent)) {}

  Cell_key key(const Bounding_box& box) const
  {
    Cell_key result;
    result.level = (std::min)(m_top_level, levels_above + level_of((box.high - box.low).maxCoeff()));
    for(int i = 0; i < 3; ++i)
      result.place[i] = place((box.low[i] + box.high[i]) / 2., cell_size(result.level));
    return result;
  }

  // May a face with the box stay in a cell? It may reach half a cell beyond it.
  static bool holds(const Cell& cell, const Bounding_box& box)
  {
    // a face that has become four times smaller is found faster in a smaller cell
    constexpr double least_share = 0.125;
    const double size = cell_size(cell.key.level);
    for(int i = 0; i < 3; ++i)
      if(box.low[i] < (double(cell.key.place[i]) - 0.5) * size || box.high[i] > (double(cell.key.place[i]) + 1.5) * size)
        return false;
    return (box.high - box.low).maxCoeff() >= least_share * size;
  }

  // returns the cell, which stays where it is
  Cell* insert(const Face f, const Bounding_box& box)
  {
    Cell* const cell = make_cell(key(box));
    cell->faces.push_back({f, box});
    add_content(box, cell);
    return cell;
  }

  static const Bounding_box& box(const Face f, const Cell& cell) { return find(f, cell)->box; }

  // the face has moved within its cell
  static void set_box(const Face f, const Bounding_box& box, Cell& cell)
  {
    find(f, cell)->box = box;
    add_content(box, &cell);
  }

  void erase(const Face f, Cell* const cell)
  {
    *find(f, *cell) = cell->faces.back();
    cell->faces.pop_back();
    remove_if_empty(cell);
  }

  // calls `visit(face, box of the face)` for the faces whose boxes meet the box until it returns false
  template <typename Visit>
  bool visit_near(const Bounding_box& box, const Visit& visit) const
  {
    return std::all_of(m_top_cells.begin(), m_top_cells.end(), [&](const Cell* const cell)
                       { return visit_cell(*cell, box, visit); });
  }

private:
  template <typename Cell_of_face>
  static auto find(const Face f, Cell_of_face& cell)
  {
    return std::find_if(cell.faces.begin(), cell.faces.end(), [f](const Boxed_face& boxed) { return boxed.face == f; });
  }

  // what a cell holds its ancestors do, too
  static void add_content(const Bounding_box& box, Cell* cell)
  {
    for(; cell != nullptr && !cell->content.holds(box); cell = cell->parent)
      cell->content.add(box);
  }

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
    const auto inserted = m_cells.try_emplace(key);
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
    else
      m_top_cells.push_back(cell);
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
      else
        m_top_cells.erase(std::find(m_top_cells.begin(), m_top_cells.end(), cell));
      m_cells.erase(Cell_key(cell->key));
      cell = parent;
    }
  }

  template <typename Visit>
  static bool visit_cell(const Cell& cell, const Bounding_box& box, const Visit& visit)
  {
    if(!cell.content.meets(box))
      return true;
    for(const Boxed_face& f : cell.faces)
      if(f.box.meets(box) && !visit(f.face, f.box))
        return false;
    if(cell.number_of_children == 0)
      return true;
    // The children in the lower and in the upper half of each direction, which reach half of their size beyond.
    const double size = cell_size(cell.key.level - 1);
    std::array<std::array<bool, 2>, 3> is_near;
    for(int i = 0; i < 3; ++i)
    {
      const double middle = double(2 * cell.key.place[i] + 1) * size;
      is_near[i][0] = box.low[i] <= middle + 0.5 * size && box.high[i] >= middle - 1.5 * size;
      is_near[i][1] = box.low[i] <= middle + 1.5 * size && box.high[i] >= middle - 0.5 * size;
    }
    for(int k = 0; k < 8; ++k)
      if(cell.children[k] != nullptr && is_near[0][k & 1] && is_near[1][k >> 1 & 1] && is_near[2][k >> 2]
         && !visit_cell(*cell.children[k], box, visit))
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GRID_H
