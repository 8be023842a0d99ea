// SPDX-License-Identifier: LGPL-3.0-or-later
// report/inspect_report.h: what veritope inspect says of a V-model: its elements and what they meet.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/text_style.h"
#include "solids/vmodel/v_model.h"
#include "topology/hexahedral_v_complex.h"

namespace veritope::report {

struct InspectReport {
  /// A face or an edge of a cell that is one point or curve.
  struct Collapsed {
    std::uint32_t cell = 0;
    std::string part;
    bool is_onto_curve = false;
    std::uint32_t onto = 0;  ///< that V-curve, or V-point
  };

  std::string path;
  VModel model;
  HexahedralVComplex elements;       ///< of the model
  std::vector<VCurveId> bad_curves;  ///< where it is not a manifold with boundary
  std::vector<VPointId> bad_points;
  /// Over the rationals; nothing if they are not known.
  std::optional<std::array<std::uint64_t, 4>> betti;
  std::uint64_t components = 0;
  std::vector<Collapsed> collapsed;  ///< by cell; faces, then edges

  bool is_manifold() const { return bad_curves.empty() && bad_points.empty(); }
};

/// @error kBadArgument, with the cell: see v_complex_of
Result<InspectReport> inspect_v_model(std::string path, VModel model);

/// The schema: docs/report.schema.json, inspect. Each element is on a line of its own.
std::string inspect_json(const InspectReport& report);
std::string inspect_text(const InspectReport& report, const Style& style);

/// What two cells have in common. REQUIRES that they are cells.
std::string pair_json(const InspectReport& report, std::array<std::uint32_t, 2> cells);
std::string pair_text(const InspectReport& report, std::array<std::uint32_t, 2> cells,
                      const Style& style);

}  // namespace veritope::report
