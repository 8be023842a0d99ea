// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/cage_options.h: the options of veritope cage, and which of them belong to which kind of cage.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/option_set.h"
#include "io/model_file.h"
#include "solids/micro/cage/box_cage.h"
#include "solids/micro/cage/radial_cage.h"
#include "solids/micro/cage/split_cage.h"

namespace veritope::cli {

enum class CageKind { kBox, kRadial, kHull, kSplit, kFit };
/// "box", "radial", "hull", "split", "fit".
const char* cage_kind_name(CageKind kind);

/// A parameter of an axis: "u=1/2".
struct AxisParameter {
  std::size_t axis = 0;
  Rational at;
};
/// A face of a cell: "w1".
struct FaceName {
  std::size_t axis = 0;
  bool is_at_end = false;
};

struct CageOptions {
  CageOptions();

  std::optional<CageKind> kind;
  ModelReadOptions reading;
  std::optional<std::string> output, json;
  std::optional<std::string> around;
  std::optional<Rational> margin;
  // A box, and a hull.
  std::optional<CellPoint> min, max;
  std::optional<std::array<std::uint64_t, 3>> degrees, spans;
  // A radial cage.
  std::optional<CellPoint> point, axis, start;
  std::optional<Rational> inner, outer, sector;
  std::optional<std::array<Rational, 2>> height;
  // A field to follow.
  std::optional<std::string> field;
  // A split.
  std::optional<std::string> of;
  std::optional<std::uint32_t> entity;
  std::optional<AxisParameter> at;
  std::optional<FaceName> open;
  std::optional<Rational> from;
  std::optional<CellPoint> low, high;

  Rational margin_part() const;
  /// With these spans where no others are given.
  CageGrid grid(std::uint64_t default_spans, int default_degree = 1) const;
  RadialShape shape() const;
  /// REQUIRES --at.
  CageSplit split() const;
};

/// Declares them all, and the rules. REQUIRES that the options live until the line is parsed.
void declare_cage_options(OptionSet& set, CageOptions& options);

}  // namespace veritope::cli
