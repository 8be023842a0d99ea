// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/rule_colour.h"

#include <array>

namespace veritope {

Colour colour_of(MeshRule rule) {
  // The palette of Okabe and Ito, and a dark brown.
  constexpr std::array<Colour, kNumMeshRules> kColours = {{{0, 0, 0},
                                                           {0, 114, 178},
                                                           {230, 159, 0},
                                                           {86, 180, 233},
                                                           {0, 158, 115},
                                                           {204, 121, 167},
                                                           {213, 94, 0},
                                                           {240, 228, 66},
                                                           {90, 60, 20}}};
  return kColours[rule_index(rule)];
}

}  // namespace veritope
