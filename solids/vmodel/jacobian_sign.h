// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/jacobian_sign.h: proves that the determinant of every cell is positive except on faces, edges and
// corners of pieces where it vanishes, or shows where it is not. docs/certificates/vmodel.md, section 5.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/sign.h"
#include "solids/vmodel/v_model.h"

namespace veritope {

struct JacobianOptions {
  unsigned jobs = 1;             ///< threads; 0: as many as the machine has
  std::size_t max_nodes = 4096;  ///< of the tree of a piece
};

/// What a piece needs in a certificate: its zeros, and its tree. Pieces without zeros whose tree is one leaf are left
/// out.
struct PieceProof {
  std::uint64_t piece = 0;         ///< its number
  std::uint32_t zeros = 0;         ///< bit 9 s0 + 3 s1 + s2 for each zero
  std::vector<std::uint8_t> tree;  ///< in preorder: 0 a leaf, 1, 2, 3 halved along axis 0, 1, 2
};

/// A point of a cell's domain and the exact sign of its determinant there, as it is given, without its reversal.
/// Derivatives are taken in the piece. Where the sign is not 0, the point lies inside of the piece.
struct JacobianPlace {
  std::array<std::size_t, 3> piece{};  ///< between breaks, along each axis
  std::array<Rational, 3> at;          ///< in the cell's parameters
  Sign sign = Sign::kZero;
};

/// Why a cell is not proved.
struct JacobianFinding {
  enum class Kind {
    kFolded,      ///< two places of opposite signs
    kFlat,        ///< the determinant vanishes on the whole box, which is a piece
    kLeftHanded,  ///< it is negative where the model expects a positive one, and nothing shows a fold
    kZero,        ///< it vanishes at a place, which no zero holds
    kZeroFace,  ///< it vanishes on a face of a piece that is neither border nor collapsed: the box
    kUndecided  ///< the tree got too large in this box
  };
  Kind kind = Kind::kUndecided;
  std::uint32_t cell = 0;
  std::array<std::array<Rational, 2>, 3>
      box;  ///< in the cell's parameters; a point for kFolded, kLeftHanded, kZero
  std::vector<JacobianPlace>
      places;  ///< kFolded: one positive, one negative; kLeftHanded, kZero: one
};

struct VDeterminants {
  std::vector<PieceProof> proofs;         ///< ascending; complete only without findings
  std::vector<JacobianFinding> findings;  ///< at most one a cell, ascending
  std::uint64_t num_zeros = 0;            ///< of all pieces
  std::uint64_t num_exact = 0;            ///< pieces that needed integers

  bool is_proved() const { return findings.empty(); }
};

/// The result does not depend on the number of threads.
VDeterminants decide_determinants(const VModel& model, const JacobianOptions& options = {});

/// The exact sign of the determinant of a cell at a point of its domain, with derivatives from the right, or from the
/// left at the end of the domain. REQUIRES a cell in space and a point of its domain.
Sign jacobian_sign(const VVolume& cell, const std::array<Rational, 3>& at);

}  // namespace veritope
