// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_weld_round_internal.h: one try to weld pairs of near faces: corners, edges, faces,
// then cells.
#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "solids/vmodel/unit_space_internal.h"
#include "solids/vmodel/v_face_internal.h"
#include "solids/vmodel/v_near_faces_internal.h"
#include "solids/vmodel/v_weld_classes_internal.h"

namespace veritope::internal {

/// A cell before and after, both in the function spaces that it has after.
struct WeldedCell {
  std::array<UnitSpace, 3> spaces;
  VVolume before, after;
};

/// REQUIRES that the steps are called in this order, and that nothing failed before the next one.
class WeldRound {
 public:
  /// The pairs in the order in which they are taken; those that cannot be tied fail.
  WeldRound(const VModel& model, const Rational& eps, const std::vector<NearPair>& pairs,
            WeldClasses classes);

  void place_corners();
  void make_edges();
  /// @error kOverLimit
  std::optional<Error> make_faces();
  std::optional<Error> make_cells();

  /// Pairs by their number that stay apart, with the reason.
  const std::map<std::size_t, VApartReason>& failed() const { return failed_; }
  const std::map<std::uint32_t, WeldedCell>& cells() const { return cells_; }
  bool is_tied(std::size_t pair) const { return failed_.count(pair) == 0; }
  /// Whether the pair failed before the first step.
  bool was_untied(std::size_t pair) const { return is_untied_[pair]; }
  bool wins(VFaceNumber f, VFaceNumber g) const { return rank_of_face(f) < rank_of_face(g); }
  /// Makes all tied pairs fail that could have changed the cell; without such a pair, all of them.
  void fail_around(std::uint32_t cell, VApartReason reason);
  void fail(std::size_t pair, VApartReason reason) { failed_.emplace(pair, reason); }

 private:
  using Curve = BSplineCurve<Rational>;
  using Surface = BSplineSurface<Rational>;
  using Point3 = std::array<Rational, 3>;
  /// The least wins.
  struct Rank {
    std::uint64_t degrees, controls;
    bool has_weights;
    VFaceNumber number;
    auto operator<=>(const Rank&) const = default;
  };
  struct Member {
    std::uint32_t edge;
    bool flips;
  };
  /// On [0,1], as its class runs.
  struct FinalEdge {
    Curve curve;
    UnitSpace space;
  };
  struct MovedEdge {
    std::size_t number;  // in final_edges_
    bool flips;
  };
  struct FinalFace {
    Surface
        surface;  // on the unit square, in the parameters of the face; where it has weights they do not count
    std::array<UnitSpace, 2> spaces;
  };

  FaceView view(VFaceNumber f) const { return {model_.cell(f / 6), f % 6}; }
  Point3 corner_point(std::uint32_t corner) const;
  Rank rank_of_face(VFaceNumber f) const;
  Rank rank_of_corner(std::uint32_t corner) const;
  Rank rank_of_edge(std::uint32_t edge) const;
  Rank best_rank(std::uint32_t cell, std::initializer_list<std::size_t> faces) const;
  /// Where the corner goes, if it moves.
  const Point3* moved_corner(std::uint32_t corner);
  bool is_stirred_corner(std::uint32_t corner);
  Point3 place_of(std::uint32_t corner);
  Curve curve_of(const Member& member) const;
  void make_edge(std::uint32_t edge_class, const std::vector<Member>& members);
  std::optional<VApartReason> fault_of_edge(const Curve& curve,
                                            const std::vector<Member>& members) const;
  Curve middle_of(const std::vector<Member>& members, Curve weights) const;
  void set_ends(Curve& curve, const Member& member);
  void fail_at_edge(std::uint32_t edge_class, VApartReason reason);
  bool has_moved_side(VFaceNumber f);
  /// Nothing, or why the faces cannot be made one.
  Result<std::optional<VApartReason>> make_face(VFaceNumber f, VFaceNumber g, unsigned symmetry);
  Result<FinalFace> with_moved_sides(VFaceNumber f);
  void store(VFaceNumber f, FinalFace face);
  Curve moved_curve(const MovedEdge& edge, const UnitSpace& space) const;
  void need(std::uint32_t cell, std::size_t axis, const UnitSpace& space);
  std::optional<Error> make_cell(std::uint32_t c);
  void write_edges(std::uint32_t c, WeldedCell& cell);
  void write_faces(std::uint32_t c, WeldedCell& cell);
  void write_collapsed(std::uint32_t c, WeldedCell& cell);
  std::optional<VApartReason> fault_of(std::uint32_t c, const WeldedCell& cell) const;

  const VModel& model_;
  const Rational& eps_;
  const std::vector<NearPair>& pairs_;
  WeldClasses classes_;
  std::map<std::size_t, VApartReason> failed_;
  std::vector<bool> is_untied_;
  std::vector<bool> is_tied_face_;                      // to another one, near or equal
  std::unordered_map<std::uint32_t, Point3> places_;    // of tied classes of corners
  std::unordered_map<std::uint32_t, bool> is_stirred_;  // whether one of them moves
  std::vector<FinalEdge> final_edges_;
  std::unordered_map<std::uint32_t, MovedEdge> moved_edges_;
  std::unordered_map<VFaceNumber, FinalFace> final_faces_;
  std::map<std::uint32_t, UnitSpace> needs_;  // by 3 cell + axis
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> pairs_at_corner_,
      pairs_at_edge_;  // by class
  std::map<std::uint32_t, WeldedCell> cells_;
  std::uint64_t num_control_points_ = 0;
};

}  // namespace veritope::internal
