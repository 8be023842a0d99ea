// SPDX-License-Identifier: LGPL-3.0-or-later
// render/rule_colour.h: the colours of pictures of defects.
#pragma once
#include "render/colour.h"
#include "solids/polyhedron/rules.h"

namespace veritope {

/// The colour of a rule's defects. Those of all rules differ for colour-blind readers, too.
Colour colour_of(MeshRule rule);

}  // namespace veritope
