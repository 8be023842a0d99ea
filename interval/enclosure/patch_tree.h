// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/patch_tree.h: a surface as a tree of ever smaller rectangles of parameters, each with a box around
// its points.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "interval/enclosure/enclosed_surface.h"

namespace veritope {

/// Nodes above single pieces hold groups of spans; below them a piece is cut into four at binary64 numbers next to the
/// middle. Children cover their parent. Nodes are made on demand and kept. All functions REQUIRE a live ScopedUpward.
class PatchTree {
 public:
  using Id = std::uint32_t;
  struct Node {
    double u0, u1, v0, v1;         // working parameters
    std::uint32_t i0, i1, j0, j1;  // spans [i0, i1) x [j0, j1)
    Box3 hull;
    Id first_child = 0;
    std::uint32_t num_children = 0;
    bool has_net = false, has_derivatives = false;
    std::size_t net = 0;
    Box3 du, dv;  // meaningful where has_derivatives

    bool is_single() const { return i1 - i0 == 1 && j1 - j0 == 1; }
  };

  /// Keeps a reference to the surface.
  explicit PatchTree(const EnclosedSurface& surface);

  static constexpr Id kRoot = 0;
  const Node& node(Id id) const { return nodes_[id]; }
  const EnclosedSurface& surface() const { return surface_; }
  /// The first child; the num_children() ids from there on are the children. Splits the node if it has none yet.
  Id children(Id id);
  std::uint32_t num_children(Id id) const { return nodes_[id].num_children; }
  /// The node, with derivatives over its rectangle by working parameters. REQUIRES is_single().
  const Node& with_derivatives(Id id);
  /// Coefficients of the node's part, as EnclosedSurface::piece. REQUIRES is_single().
  const Interval* net(Id id) const { return nets_.data() + nodes_[id].net; }
  /// Whether the rectangle can be cut: binary64 numbers lie between its ends.
  bool can_split(Id id) const;

 private:
  void build_groups(Id id);
  void split_piece(Id id);
  void append_part(const Node& parent, bool second_u, bool second_v, double um, double vm,
                   const Interval* net);

  const EnclosedSurface& surface_;
  std::vector<Node> nodes_;
  std::vector<Interval> nets_;
};

}  // namespace veritope
