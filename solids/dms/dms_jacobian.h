// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_jacobian.h: proofs that the derivative of a solid's map has a positive determinant everywhere: trees
// of leaves, as docs/certificates/dms-solid.md has them. Theory: docs/THEORY.md, DMS-1.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_knots.h"

namespace veritope {

/// A leaf is of kind H, where the matrix is monotone with the derivatives of all terms near it, or of kind P, where the
/// map is one polynomial, and the matrix is monotone with the Bernstein coefficients of its derivative.
struct DmsLeaf {
  bool is_polynomial = false;
  DmsMatrix matrix;
};
/// A node is cut at the middle of an edge: 0 to 5 for the corners 01, 02, 03, 12, 13, 23.
struct DmsEdgeCut {
  int edge = 0;
};
/// In preorder; the first child of a cut node has the middle in the place of the edge's second corner.
using DmsLeafTree = std::vector<std::variant<DmsEdgeCut, DmsLeaf>>;

/// A part of a tetrahedron where no leaf was found.
struct DmsOpenLeaf {
  std::uint32_t tetrahedron = 0;
  std::array<DmsPoint, 4> corners;
  /// A point with a determinant below 0, if one was met: then the model is no solid.
  std::optional<DmsPoint> negative_at;
  Rational negative_value;  ///< the determinant there
  /// Whether the map is one polynomial on the part, and its determinant is 0 everywhere.
  bool is_flat = false;
};

struct JacobianSearchOptions {
  int max_levels = 24;            ///< at most 64
  std::size_t max_leaves = 4096;  ///< of one tetrahedron
  /// Parts of a leaf on which the map is one polynomial: how many are looked at for a negative determinant.
  std::size_t max_parts = 512;
  /// Where a leaf is not proved: how many parts of tetrahedra are looked at for a negative determinant, those with the
  /// least determinants at samples first.
  std::size_t max_sampled = 256;
};

/// The trees of all tetrahedra; or a leaf with a negative determinant, or a flat one; or, if neither is found, the
/// first one that is not proved. Where clouds crease the map at a vertex, leaves there cannot be proved if its
/// derivatives vary much; so the search for a negative determinant goes on elsewhere.
/// REQUIRES a model without defects of its domain and its clouds (solids/dms/dms_defects.h).
std::variant<std::vector<DmsLeafTree>, DmsOpenLeaf> prove_jacobian(
    const DmsModel& model, const JacobianSearchOptions& options = {});

}  // namespace veritope
