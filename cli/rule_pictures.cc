// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/rule_pictures.h"

#include <array>

namespace veritope::cli {
namespace {

constexpr std::array<std::string_view, kNumMeshRules> kPictures = {
    // M1
    R"(
      c
    /   \          m lies on the line through a and b:
  a---m---b        the face (a, b, m) has no area
    \   /
      d)",
    // M2
    R"(
      c
     / \
    /1,2\          face 1 = (a, b, c), face 2 = (b, c, a)
   a-----b)",
    // M3
    R"(
  +---+---+
  | / | / |        a face is missing: the edges around the
  +---+---+        hole have one face each
  | / | \   hole
  +---+---+)",
    // M4
    R"(
    1     2
     \   /
      \ /          seen along the edge: three faces meet
       e
       |
       3)",
    // M5
    R"(
  +----<----+
  | 1     / ^      both faces run along the diagonal in the
  v     /   |      same direction; one of them shows its
  |   /   2 |      back
  +---->----+)",
    // M6
    R"(
  \  1  /
   \   /
    \ /            two fans of faces have the vertex v in
     v             common and nothing else
    / \
   /   \
  /  2  \)",
    // M7
    R"(
        |\
        | \ 2
   +----|--\----+
   | 1  x---x   |  face 2 goes through face 1
   +----|--/----+
        | /
        |/)",
    // M8
    R"(
  +-------------+
  |             |      the normals point into the shell, as if
  |             | <--  all space but its inside were solid
  |             |
  +-------------+)",
    // M9
    R"(
  +-------------+ -->
  |   +-----+   |
  |   |     | -->      the inner shell (depth 1) bounds a cavity
  |   +-----+   |      and must face inward; here both face
  +-------------+      outward)",
};

}  // namespace

std::string_view rule_picture(MeshRule rule) { return kPictures[rule_index(rule)].substr(1); }

}  // namespace veritope::cli
