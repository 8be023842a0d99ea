// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/filter_model_internal.h: what the filter asks of the solid M, whatever bounds it: where boxes and
// points lie, which parts of its surface are near a piece of a tile, one vertex of each shell. Internal to
// solids/micro/filter.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interval/box.h"
#include "solids/base/box_hierarchy.h"
#include "solids/classify/point_answer.h"
#include "solids/classify/value3.h"
#include "solids/micro/filter/cell_net_internal.h"
#include "solids/micro/filter/tile_filter.h"
#include "solids/micro/filter/tile_pieces_internal.h"

namespace veritope {
namespace internal {

/// What is known of a piece of the tile's surface that is not proved apart from M's surface. Both of the last two may
/// hold of a piece that lies in the plane of a facet.
struct PieceSide {
  bool is_decided = false;
  bool is_hopeless = false;  ///< nor will parts of it be decided
  bool is_apart = false;     ///< from the surface of M
  bool is_near_inside =
      false;  ///< every point of the piece is a limit of points in the interior of M
  bool is_near_outside = false;  ///< every point of the piece is a limit of points off M
};

/// The parts of M's surface near one tile, by numbers. One thread uses it. All functions REQUIRE a live ScopedUpward.
class Obstacles {
 public:
  virtual ~Obstacles() = default;
  /// The numbers of parts that may meet the piece: all others are apart from it.
  virtual std::vector<std::uint32_t> near(const TilePiece& piece) = 0;
  /// Removes the parts that are apart from the piece, and may replace others by smaller ones. REQUIRES numbers from
  /// here, of parts near a piece that contains this one.
  virtual void keep_close(const TilePiece& piece, std::vector<std::uint32_t>* numbers) = 0;
  /// Looks closer at a piece and parts near it. `contact` is set to a point of both if one is found.
  virtual PieceSide examine(const TilePiece& piece, std::span<const std::uint32_t> numbers,
                            std::optional<ExactPoint>* contact) = 0;
};

/// The vertices of each shell, ascending, and a look-up of the first ones.
class ShellVertices {
 public:
  static constexpr std::uint32_t kUnused = 0xffffffffu;
  ShellVertices() = default;
  /// `shell_of` holds the shell of each vertex, or kUnused; `point` encloses a vertex.
  /// REQUIRES that each shell has one.
  template <typename Point>
  ShellVertices(const std::vector<std::uint32_t>& shell_of, std::uint32_t num_shells, Point point) {
    begin_.assign(num_shells + 1, 0);
    for (const std::uint32_t s : shell_of)
      if (s != kUnused) ++begin_[s + 1];
    for (std::uint32_t s = 0; s < num_shells; ++s) begin_[s + 1] += begin_[s];
    vertices_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t v = 0; v < shell_of.size(); ++v)
      if (shell_of[v] != kUnused) vertices_[next[shell_of[v]]++] = v;
    std::vector<Box3d> firsts;
    for (std::uint32_t s = 0; s < num_shells; ++s)
      firsts.push_back(outer_box(point(vertices_[begin_[s]])));
    tree_ = BoxHierarchy(firsts);
  }

  std::span<const std::uint32_t> of(std::uint32_t shell) const {
    return {vertices_.data() + begin_[shell], begin_[shell + 1] - begin_[shell]};
  }
  /// Calls visit(shell) for every shell whose first vertex may lie in the box.
  template <typename Visit>
  void visit(const Box3d& box, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }

 private:
  std::vector<std::uint32_t> begin_{0}, vertices_;
  BoxHierarchy tree_;
};

}  // namespace internal

/// Immutable: threads share it.
class TileFilter::Model {
 public:
  virtual ~Model() = default;

  /// The finding for one cell whose map is `net`, enclosed. REQUIRES a live ScopedUpward.
  CellFinding find(const internal::CellNet& net, const CellMap& cell, const TileShape& tile,
                   const TileFilterLimits& limits) const;

  /// One if all points of the box are in the interior of M, zero if they are off M. REQUIRES no empty box.
  Value3 value(const Box3d& box) const {
    return is_finite(box) ? finite_value(box) : Value3::kMixed;
  }
  virtual PointAnswer classify(const ExactPoint& point) const = 0;

  virtual std::unique_ptr<internal::Obstacles> obstacles(const CellMap& cell, const TileShape& tile,
                                                         const TileFilterLimits& limits) const = 0;

  const internal::ShellVertices& shells() const { return shells_; }
  /// Contains the vertex.
  virtual Box3 vertex(std::uint32_t number) const = 0;

 protected:
  Model() = default;
  Model(const Model&) = delete;
  virtual Value3 finite_value(const Box3d& box) const = 0;
  void set_shells(internal::ShellVertices shells) { shells_ = std::move(shells); }

 private:
  internal::ShellVertices shells_;
};

}  // namespace veritope
