// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/micro_options.h: the options of veritope micro, and what is wrong with them as a whole.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/bridge_option.h"
#include "cli/micro_nest.h"
#include "cli/tile_option.h"
#include "interval/formula/real_formula.h"
#include "io/read_model.h"

namespace veritope::cli {

struct MicroOptions {
  std::optional<std::string> cage, model;
  std::vector<TileChoice> tiles;
  std::vector<std::array<std::uint64_t, 3>> counts;  // one, or one for each volume
  std::optional<RealFormula> thickness, place;
  std::vector<std::pair<std::string, RealFormula>> materials;  // names and formulas
  std::optional<std::uint64_t> doubled_from;                   // a layer of w
  std::optional<NestChoice> nest;
  std::optional<std::string> output, list, mesh, emit, json;
  std::optional<double> chord, skin;
  BridgeChoice bridge;
  bool wants_connected = false;
  std::uint64_t max_tiles = 10'000'000;
  ModelReadOptions reading;
};

/// Declares all of them, with the rules that they have to obey together.
void declare_micro_options(OptionSet& set, const std::shared_ptr<MicroOptions>& options);

}  // namespace veritope::cli
