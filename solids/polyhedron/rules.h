// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/rules.h: the rules that the triangles of a solid's boundary obey. Catalogue with pictures:
// docs/rules/.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "solids/base/finding.h"

namespace veritope {

/// Stable ids; the number is part of the certificate format.
enum class MeshRule : std::uint8_t {
  kM1 = 1,  ///< degenerate face
  kM2 = 2,  ///< duplicate face
  kM3 = 3,  ///< boundary edge
  kM4 = 4,  ///< edge with more than two faces
  kM5 = 5,  ///< misoriented edge
  kM6 = 6,  ///< vertex whose faces form more than one fan
  kM7 = 7,  ///< two faces that meet outside their common vertex or edge
  kM8 = 8,  ///< inward outer shell
  kM9 = 9,  ///< shell nested with the wrong side
};
inline constexpr std::size_t kNumMeshRules = 9;

/// What a person needs to know about a rule.
struct RuleText {
  std::string_view id;       ///< "M3"
  std::string_view name;     ///< "boundary edge"
  std::string_view meaning;  ///< what is wrong, exactly
  std::string_view causes;   ///< where it usually comes from
  std::string_view remedy;   ///< what usually helps
  std::string_view crosswalk;  ///< what other tools call it
};
const RuleText& rule_text(MeshRule rule);
/// "M3" or "m3".
std::optional<MeshRule> rule_from_id(std::string_view id);
/// The rule that a defect of a mesh breaks. REQUIRES a finding whose code is the id of a rule.
MeshRule rule_of(const Finding& defect);

constexpr std::size_t rule_index(MeshRule rule) { return static_cast<std::size_t>(rule) - 1; }
constexpr MeshRule rule_at(std::size_t index) { return static_cast<MeshRule>(index + 1); }

}  // namespace veritope
