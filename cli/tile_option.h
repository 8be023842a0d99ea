// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/tile_option.h: tiles as options of veritope micro: "jack,node=1/5,cap=1/8,degree=3".
#pragma once
#include <string>

#include "solids/micro/jack.h"

namespace veritope::cli {

/// Returns nothing, or what is wrong with the text, in words that follow the name of the option.
std::string take_jack(const std::string& text, JackShape& shape);

}  // namespace veritope::cli
