// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_face_pairs.h: proofs that the map is one to one on the boundary of its domain, by blocks of tetrahedra
// and by pairs of faces: the conditions U1 to U7 of docs/certificates/dms-solid-2.md. Theory: docs/THEORY.md, DMS-5.
// Design: docs/design/0109-boundaries-by-pairs-of-faces.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "robust/base/work_share.h"
#include "solids/dms/dms_jacobian.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// The convex hull of some tetrahedra, whose inside misses the boundary of the domain.
struct DmsBlock {
  std::vector<std::uint32_t> tetrahedra;
  /// Monotone with the derivatives of all V_γ that reach into the block: the map is one to one on it.
  DmsMatrix matrix;
};

/// Two faces of the boundary, by their places in boundary() of the complex.
struct DmsFacePair {
  enum class Kind { kApart, kChain, kAtEdge };

  std::uint32_t first = 0, second = 0;  ///< first < second
  Kind kind = Kind::kApart;
  /// kAtEdge: two; else one.
  std::vector<DmsPoint> directions = {};
  /// kChain: vertices from one of the first face to one of the second face, each joined to the next one by an edge; and
  /// for each of these edges a tetrahedron that has it.
  std::vector<std::uint32_t> chain = {}, tetrahedra = {};
  /// kAtEdge: where on the edge the apexes of both faces are projected to. The edge leads from 0 to 1 as it does in the
  /// first face.
  std::array<Rational, 2> feet = {};
};

/// Pairs are in ascending order. Not listed are two faces whose tetrahedra are in one block, and two without a
/// common vertex whose images have boxes that are apart.
struct DmsFacePairs {
  std::vector<DmsBlock> blocks;
  std::vector<DmsFacePair> pairs;
};

/// Places of two faces, perhaps of one twice, for which nothing was found, or whose shells may meet.
struct DmsOpenPair {
  std::size_t first = 0, second = 0;
};

struct DmsFacePairOptions {
  unsigned jobs = 1;          ///< threads; what is found does not depend on them
  WorkShare* work = nullptr;  ///< what is done of a step, if it is not null
};

/// REQUIRES the complex of the model, a model without defects (solids/dms/dms_defects.h), and trees of prove_jacobian.
/// @cost  for each pair of faces that are near each other, the V_γ that reach into their tetrahedra
std::variant<DmsFacePairs, DmsOpenPair> prove_face_pairs(const DmsModel& model,
                                                         const TetrahedralComplex& complex,
                                                         const std::vector<DmsLeafTree>& trees,
                                                         const DmsFacePairOptions& options = {});

}  // namespace veritope
