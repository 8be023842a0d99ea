// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/box_option.h: a box on the command line.
#pragma once
#include <optional>
#include <string>

#include "interval/exact_box.h"

namespace veritope::cli {

/// Takes X0,Y0,Z0,X1,Y1,Z1: decimals, which mean the nearest binary64 numbers, as coordinates do, fractions, or
/// hexadecimal numbers. Returns nothing, or what is wrong with the text.
std::string take_box(const std::string& text, std::optional<ExactBox<3>>& box);

}  // namespace veritope::cli
