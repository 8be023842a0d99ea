// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_defects.h: whether the tetrahedra of a model form a domain, and whether its knots' tetrahedra W_γ are
// positively oriented: the first conditions of docs/formats/dms-files.md, "Domains and clouds without defects".
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "solids/dms/dms_model.h"

namespace veritope {

enum class DmsFault {
  kReversed,    ///< d(p_0, q_0, r_0, s_0) <= 0
  kOverused,    ///< three vertices are faces too often, or in one orientation twice
  kDegenerate,  ///< condition (a): d(W_γ) <= 0 for a γ with 0 < |γ| <= N
};
/// "tet-reversed", "tet-face-overused", "cloud-degenerate"
const char* fault_name(DmsFault fault);

struct DmsDefect {
  DmsFault fault = DmsFault::kReversed;
  std::vector<std::uint32_t> tetrahedra;  ///< one, or all that have the face, ascending
  TetrahedralIndex beta{};                ///< γ of kDegenerate
  std::array<std::uint32_t, 3> face{};    ///< of kOverused: its vertices, ascending
  Sign sign = Sign::kZero;                ///< of d, unless kOverused
};
/// "tetrahedron 3, beta (1,0,0,0): d < 0"
std::string to_string(const DmsDefect& defect);

struct DmsDefects {
  std::uint64_t count = 0;
  std::vector<DmsDefect>
      first;  ///< the first ones: by fault, then by tetrahedron and γ, or by the face's vertices
};

/// All defects of the three kinds are counted, and the first `max_listed` are described. Where clouds are
/// collapsed, the γ of a tetrahedron that have equal knots count once, with the least numbers.
/// REQUIRES a model that validate() accepts. @cost an exact orientation for each tetrahedron and γ
DmsDefects find_dms_defects(const DmsModel& model, std::size_t max_listed = 100);

}  // namespace veritope
