// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/box_trace.h: what V is inside a box: nothing, a disk, or a surface of known Euler
// characteristic; proved, or undecided. Proofs: docs/THEORY.md, BOX-1 (monotone boxes), BOX-2. Source: condition C2 of
// [SSP01] 2. Design: docs/design/0019-paper-conditions.md.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/interval_boxes/boundary_model.h"

namespace veritope {

/// V∩b for a box b that V meets generically.
struct BoxTrace {
  enum class Kind { kMissed, kSurface, kUndecided };
  Kind kind = Kind::kUndecided;
  /// kSurface: V∩b is a compact surface, its boundary V∩(boundary of b), with this Euler characteristic.
  int euler = 0;
  bool is_connected = false;  ///< kSurface: proved to be; false: not known
  Box3d place{};  ///< kUndecided: a box in which nothing was decided, in the forest's coordinates
  std::size_t cells = 0;  ///< cells that were examined

  bool is_missed() const { return kind == Kind::kMissed; }
  /// A properly embedded disk: it cuts b into two balls, one on each side of V (Alexander). This is C2.
  bool is_disk() const { return kind == Kind::kSurface && is_connected && euler == 1; }
  /// C2 is refuted: a disk has the Euler characteristic 1.
  bool is_no_disk() const { return is_missed() || (kind == Kind::kSurface && euler != 1); }
};

struct TraceOptions {
  /// Boxes that are examined for one trace, for each of three choices of cuts.
  std::size_t max_cells = 40000;
  int max_splits = 36;
  std::size_t max_pieces = 256;               ///< of V in a box that is decided as one
  std::size_t memory = std::size_t{1} << 28;  ///< bytes of the nets of pieces, between two traces
};

/// Claim   the answer about V∩b, or kUndecided.
/// A box is decided as one if V misses it; if it is a star box about centres on the mean normal (STAR-1); or by the
/// monotone-box lemma, BOX-1: on a set A of axes all normals of pieces at b have one strict sign, V misses the face,
/// edge or corner L of b that is lowest in A, and the opposite one, H, and a line from L to H crosses the tested pieces
/// once. (Then V∩b is a disk seen from L: for fixed other coordinates the inside is a down-set of A.) Otherwise b is
/// cut into two boxes b', b'' that overlap in a slab, and chi(V∩b) = chi(V∩b') + chi(V∩b'') - chi(V∩b'∩b''). V∩b is a
/// surface with its boundary in that of b, since every point of b has a neighbourhood in b inside of one of the boxes
/// decided as one; it is connected if those that meet V hang together through points of V. In a planar model the third
/// axis is never cut.
BoxTrace trace(BoundaryModel& model, const Box3d& forest_box, const TraceOptions& options = {});

/// Whether V misses the closed box. It is decided by hulls, within a budget; false means that it is not proved.
bool is_missed(PieceForest& forest, const Box3d& box, std::size_t max_visits = 2000);
/// Whether a part of V lies in the closed box: a piece whose closed hull does (of a planar model: in the plane). False
/// means that none was found.
bool is_met(BoundaryModel& model, const Box3d& box, std::size_t max_visits = 500);

}  // namespace veritope
