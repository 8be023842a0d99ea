// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_defects.h: whether a model obeys "Domains and clouds without defects" of docs/formats/dms-files.md,
// decided exactly; if not, where, and what shows it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solids/dms/dms_core.h"
#include "solids/dms/dms_model.h"

namespace veritope {

enum class DmsFault {
  kReversed,       ///< d(p_0, q_0, r_0, s_0) <= 0
  kOverused,       ///< three vertices are faces too often, or in one orientation twice
  kCrowdedEdge,    ///< M4: an edge of three faces of the boundary or more
  kPinched,        ///< M6: the faces of the boundary at a vertex form several fans
  kImproper,       ///< M7: two faces of the boundary have an improper common point
  kOverlap,        ///< M9: two tetrahedra have a common inner point
  kDegenerate,     ///< condition (a): d(W_γ) <= 0 for a γ with 0 < |γ| <= N
  kNoCore,         ///< condition (b)
  kInside,         ///< condition (c)
  kDomainsDiffer,  ///< the boundaries of the domain and of the attribute domain are two sets
};
/// "tet-reversed", "tet-face-overused", "M4", ..., "cloud-degenerate", "cloud-no-core", "cloud-inside",
/// "domains-differ"
const char* fault_name(DmsFault fault);

/// Only what the fault has is set.
struct DmsDefect {
  DmsFault fault = DmsFault::kReversed;
  /// Whether numbers are of the attribute domain.
  bool is_of_attributes = false;
  /// One, or two that overlap, or all that have the face or the edge, ascending; of kInside those of the face and of
  /// the one into which the hull reaches, in this order; of kDomainsDiffer that of the face that has the point.
  std::vector<std::uint32_t> tetrahedra;
  /// γ of kDegenerate and the first one of kNoCore; of kInside the last knots of the corners of the face's tetrahedron.
  TetrahedralIndex beta{};
  std::vector<std::uint32_t>
      vertices;  ///< three of kOverused, two of kCrowdedEdge, one of kPinched; ascending
  /// kOverused: all; kCrowdedEdge: all; kImproper: two; kInside: one.
  std::vector<TetrahedronFace> faces;
  Sign sign = Sign::kZero;             ///< of d: kReversed, kDegenerate
  std::vector<DmsCoreWeight> weights;  ///< of kNoCore
  /// kInside: of the knots of the hull; kImproper: of the vertices of the first face, then of the second.
  std::vector<Rational> shares;
  /// The common point of kImproper, kOverlap and kInside; for kDomainsDiffer a point of one boundary alone.
  std::optional<DmsPoint> point;

  bool has_beta() const { return fault >= DmsFault::kDegenerate && fault <= DmsFault::kInside; }
};
/// "tetrahedron 3, beta (1,0,0,0): d < 0"; one of the attribute domain begins with "attribute domain: ".
std::string to_string(const DmsDefect& defect);

struct DmsDefects {
  std::uint64_t count = 0;
  std::vector<DmsDefect> first;  ///< the first ones, in the order of faults, then of places
};

/// All defects are counted (of kImproper at most 1,000), and the first `max_listed` are described. Where tetrahedra are
/// reversed or faces overused, there is no boundary, and M4 to M9 and (c) are not looked at; (b) is not where (a) is
/// broken. Those of the attribute domain come after those of the model; boundaries are compared if there are no others.
/// Where clouds are collapsed, the γ of a tetrahedron that have equal knots count once, with the least numbers.
/// REQUIRES a model that validate() accepts.
/// @cost near-linear: a few signs for each tetrahedron and γ, and for each two that are near each other
DmsDefects find_dms_defects(const DmsModel& model, std::size_t max_listed = 100);
/// As find_dms_defects, for the geometry alone: an attribute domain is not looked at.
DmsDefects find_geometry_defects(const DmsModel& model, std::size_t max_listed = 100);
/// The rest of find_dms_defects: those of the attribute domain, and where the boundaries differ.
/// REQUIRES a model whose geometry has no defects.
DmsDefects find_attribute_defects(const DmsModel& model, std::size_t max_listed = 100);

}  // namespace veritope
