// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/rule_pictures.h: the rules as small pictures made of characters, for veritope explain; docs/rules/ has them, too.
#pragma once
#include <string_view>

#include "solids/polyhedron/rules.h"

namespace veritope::cli {

/// Lines of at most 74 printable ASCII characters, at most eight of them, without a line feed at the end.
std::string_view rule_picture(MeshRule rule);

}  // namespace veritope::cli
