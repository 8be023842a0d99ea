// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/bridge_option.h: the options of veritope micro that say whether and how bridges are built.
#pragma once
#include <optional>
#include <string>

#include "cli/option_set.h"

namespace veritope::cli {

struct BridgeChoice {
  bool is_given = false, has_alpha = false;
  bool is_wanted = true, are_in_space = false;
  double alpha = 0.5;

  /// Whether an option asks for bridges. Without one they are built where they can be.
  bool is_asked_for(bool has_skin) const {
    return (is_given && is_wanted) || has_alpha || has_skin;
  }
  /// Nothing, or what is wrong, as a sentence.
  std::string fault(bool has_model, bool has_skin) const;
};

/// --bridge, --alpha and --skin.
void declare_bridge(OptionSet& set, BridgeChoice& choice, std::optional<double>& skin);

}  // namespace veritope::cli
