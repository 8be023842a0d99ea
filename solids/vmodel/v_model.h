// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_model.h: volumes glued along equal faces: which faces of the cells are glued, border or collapsed,
// where the cells are cut into pieces, and how many V-surfaces, V-curves and V-points there are.
// The theory: docs/THEORY.md, VMODEL-1. The numbering of faces, edges, corners, symmetries and pieces, and the rules
// for collapsed and glued faces: docs/certificates/vmodel.md, sections 2 to 4 and 7. Nothing is said here about
// determinants (jacobian_sign.h) or about the border (v_faces.h).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "robust/base/sign.h"
#include "splines/bspline.h"
#include "splines/grid.h"

namespace veritope {

using VVolume = BSplineVolume<Rational>;

inline constexpr int kMaxVDegree = 15;
inline constexpr std::uint64_t kMaxVCells = std::uint64_t{1} << 20;
inline constexpr std::uint64_t kMaxVPieces = std::uint64_t{1} << 24;

/// Whether cells whose determinant is negative are taken as they are, or reversed.
enum class VOrientation { kKeep, kAuto };

/// How a face is collapsed: kAlongFirst means that its image does not depend on its first parameter, up to the factor
/// of homogeneous coordinates.
enum class VCollapse : std::uint8_t { kNone, kToPoint, kAlongFirst, kAlongSecond };

/// A face of a cell: number 6 cell + 2 axis + end.
using VFaceNumber = std::uint32_t;
inline constexpr VFaceNumber kNoVFace = std::numeric_limits<VFaceNumber>::max();

/// At most one of the two: collapsed, or glued to another face. Neither: part of the border.
struct VFaceRole {
  VCollapse collapse = VCollapse::kNone;
  std::uint8_t symmetry = 0;  ///< if glued: takes the parameters of this face to those of the mate
  VFaceNumber mate = kNoVFace;

  bool is_glued() const { return mate != kNoVFace; }
  bool is_collapsed() const { return collapse != VCollapse::kNone; }
  bool is_border() const { return !is_glued() && !is_collapsed(); }
};

/// A part of a cell that is collapsed although no face or edge of the cell that holds it is: no certificate holds.
/// Condition V1 fails, or, for a part of a face whose collapsed sides lie in other collapsed faces, V2 or P1.
struct VForbiddenCollapse {
  enum class Kind {
    kPartOfFace,  ///< a face is collapsed on some of its knot spans only
    kPartOfEdge,  ///< an edge is collapsed on some of its knot spans only
    kInside       ///< a line inside of the cell or of a face
  };
  struct Split {
    std::size_t axis;
    Rational at;
  };
  Kind kind = Kind::kInside;
  std::uint32_t cell = 0;
  std::optional<std::size_t> face;             ///< 2 axis + end, where the part lies in a face
  std::array<std::array<Rational, 2>, 3> box;  ///< in the cell's parameters
  std::vector<Split> splits;                   ///< inner knots at which the cell may be split
};

/// The numbers of docs/certificates/vmodel.md, section 7.
struct VCounts {
  std::uint64_t cells = 0, pieces = 0, half_v_surfaces = 0, v_surfaces = 0, v_curves = 0,
                v_points = 0;
  std::uint64_t internal = 0, boundary = 0;  ///< glued pairs, and border faces
  std::uint64_t reversed = 0;
  std::int64_t euler = 0;

  friend bool operator==(const VCounts&, const VCounts&) = default;
};

/// The axes that are the first and the second parameter of a face across `axis`.
constexpr std::array<std::size_t, 2> v_face_axes(std::size_t axis) {
  return {axis == 0 ? std::size_t{1} : std::size_t{0}, axis == 2 ? std::size_t{1} : std::size_t{2}};
}
/// The symmetry s, of 0 to 7, applied to parameters that are 0 or 1.
constexpr std::array<unsigned, 2> v_symmetry_image(unsigned s, std::array<unsigned, 2> at) {
  if ((s & 1) != 0) at = {at[1], at[0]};
  return {at[0] ^ ((s >> 1) & 1), at[1] ^ (s >> 2)};
}
/// Whether an odd number of exchanges and reversals make up the symmetry.
constexpr bool is_v_symmetry_odd(unsigned s) {
  return (((s & 1) + ((s >> 1) & 1) + (s >> 2)) & 1) != 0;
}
/// The symmetry that undoes s.
constexpr unsigned v_symmetry_inverse(unsigned s) {
  return (s & 1) == 0 ? s : 1u + ((s & 4) >> 1) + ((s & 2) << 1);
}

/// Cells and how they hang together. Immutable.
class VModel {
 public:
  std::size_t num_cells() const { return cells_.size(); }
  std::span<const VVolume> cells() const { return cells_; }
  const VVolume& cell(std::size_t c) const { return cells_[c]; }

  /// The sign of the cell's determinant as it is given, at the middle of the first piece between knots where that is
  /// not 0; 0 if it vanishes at all middles. It is a choice, not a proof that the determinant has one sign.
  Sign hand(std::size_t c) const { return hands_[c]; }
  bool is_reversed(std::size_t c) const { return is_reversed_[c]; }
  /// The cells whose hand is negative, ascending: those that are reversed, if the model was made with kAuto.
  const std::vector<std::uint32_t>& left_handed() const { return left_handed_; }

  std::size_t num_faces() const { return faces_.size(); }
  const VFaceRole& face(VFaceNumber f) const { return faces_[f]; }
  const VFaceRole& face(std::size_t c, std::size_t k) const { return faces_[6 * c + k]; }
  /// The code of a certificate: docs/certificates/vmodel.md, section 4.
  std::uint64_t face_code(VFaceNumber f) const {
    const VFaceRole& role = faces_[f];
    if (!role.is_glued()) return role.is_collapsed() ? 1 : 0;
    return role.mate < f ? 2 : 3 + 8 * std::uint64_t{role.mate - f - 1} + role.symmetry;
  }
  /// Edge 4 axis + e + 2 f of a cell.
  bool is_edge_collapsed(std::size_t c, std::size_t edge) const {
    return (collapsed_edges_[c] >> edge & 1u) != 0;
  }

  /// Ascending, inside of the axis's domain, none of them a knot.
  const std::vector<Rational>& added_breaks(std::size_t c, std::size_t axis) const;
  /// The different knots of the domain and the added breaks, ascending.
  std::vector<Rational> breaks(std::size_t c, std::size_t axis) const;
  Grid<3> piece_grid(std::size_t c) const { return piece_grids_[c]; }
  /// The number of the cell's first piece; first_piece(num_cells()) is the number of all pieces.
  std::uint64_t first_piece(std::size_t c) const { return first_piece_[c]; }
  std::uint64_t num_pieces() const { return first_piece_.back(); }

  const VCounts& counts() const { return counts_; }

  /// Pairs of equal faces that only symmetries of the wrong parity take to one another; they are not glued.
  const std::vector<std::array<VFaceNumber, 2>>& copies() const { return copies_; }
  /// Three or more equal faces; none of them is glued.
  const std::vector<std::vector<VFaceNumber>>& crowds() const { return crowds_; }
  /// A certificate needs that there is nothing.
  const std::vector<VForbiddenCollapse>& forbidden() const { return forbidden_; }

 private:
  friend class VModelMaker;
  std::vector<VVolume> cells_;
  std::vector<Sign> hands_;
  std::vector<bool> is_reversed_;
  std::vector<std::uint32_t> left_handed_;
  std::vector<VFaceRole> faces_;
  std::vector<std::uint16_t> collapsed_edges_;
  std::vector<std::array<std::uint32_t, 3>> added_of_;  // into added_; list 0 is empty
  std::vector<std::vector<Rational>> added_;
  std::vector<Grid<3>> piece_grids_;
  std::vector<std::uint64_t> first_piece_;
  VCounts counts_;
  std::vector<std::array<VFaceNumber, 2>> copies_;
  std::vector<std::vector<VFaceNumber>> crowds_;
  std::vector<VForbiddenCollapse> forbidden_;
};

/// Finds out how the cells hang together. Faces are glued that are equal under a symmetry of the square, as maps up to
/// degrees, knots, affine changes of the domain and one positive factor of homogeneous coordinates, if the symmetry
/// reverses their orientation, and if there is no third equal face. A rational face equals a polynomial one only if its
/// weights are constant; a polynomial factor, or another parametrisation, makes another face.
/// @error kBadArgument, with the entity: a cell that is not a map to space (see geometry_of), an axis that is not
///        clamped, an inner knot that occurs more often than the degree, a weight that is not positive; kOverLimit: a
///        degree over kMaxVDegree, more than kMaxVCells cells or kMaxVPieces pieces. kEmpty without a cell.
/// @cost  near-linear in the control points, if few faces have the same corners and the same middle without being
///        equal
Result<VModel> make_v_model(std::vector<VVolume> cells, VOrientation orientation);

/// The first three coordinates (with the weight, if there is one): attributes are stripped.
/// @error kBadArgument if there are fewer than three
Result<VVolume> geometry_of(const VVolume& volume);

}  // namespace veritope
