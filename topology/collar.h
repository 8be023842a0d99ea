// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/collar.h: is a union of octree cells a product, surface x [0, 1]? Topology only: it says nothing about where
// a surface lies.
// Theory: docs/THEORY.md, COLLAR-1.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "topology/collapse.h"
#include "topology/common_subdivision.h"
#include "topology/complex_boundary.h"

namespace veritope {

enum class CollarOutcome {
  kCollar,  ///< K1, K2, K3 hold: every body is a product, between the two components of its boundary
  kNotManifold,  ///< K1 fails: |K| is not a 3-manifold
  kNotProduct,   ///< |K| is a 3-manifold, but some body does not have two boundary components of one genus
  kUndecided,    ///< every order that was tried got stuck: it may be a product or not
};

/// The bytes that a complex, its boundary and find_collar take at their peak for each face of the complex. Derived in
/// docs/design/0036-bounds-on-everything.md.
inline constexpr std::size_t kCollarBytesPerFace = 208;

struct CollarOptions {
  /// Boundary faces, in at most one component of each body: their components are d+. For the other bodies d+ is chosen.
  std::span<const std::uint32_t> d_plus = {};
  unsigned max_attempts = 8;  ///< orders that are tried for each body; at least 1
  std::uint64_t seed = 1;     ///< of the later orders
};

/// One body of |K|; boundary components by their numbers in `boundary`.
struct CollarBody {
  std::uint32_t d_plus = CommonSubdivision::kNone,
                d_minus = CommonSubdivision::kNone;  ///< kNone unless the body has two of one genus
  unsigned attempts = 0;                             ///< orders that were tried
  bool is_product = false;                           ///< proved by collapses
};

struct Collar {
  CollarOutcome outcome = CollarOutcome::kUndecided;
  std::string message;  ///< empty for a collar, else the reason with the place
  ComplexBoundary boundary;
  std::vector<CollarBody> bodies;  ///< parallel to boundary.bodies; empty if K1 fails
  CollapseSequence collapses;      ///< of the bodies that are products: certificate content
  /// The numbers of vertices, edges, faces and cells outside d+ that the last order left in the undecided bodies.
  std::array<std::uint64_t, 4> remaining{};

  /// All faces of the d+ of products, ascending: with `collapses` the input of replay_collapse.
  std::vector<std::uint32_t> d_plus_faces() const;
};

/// Decides K1, K2 and K3. Either side of a product may be d+; unless the caller chooses, the side that has the smaller
/// number of faces is tried first.
/// The result depends on the cells and the options alone.
/// @error kBadArgument if max_attempts is 0, a face of options.d_plus is not on the boundary, or two of them lie on
///        different sides of one body.
/// @cost  O(size of the complex) for each order tried
Result<Collar> find_collar(const CommonSubdivision& complex, const CollarOptions& options = {});

}  // namespace veritope
