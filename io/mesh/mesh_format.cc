// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/mesh_format.h"

namespace veritope {

const char* mesh_format_name(MeshFormat format) {
  switch (format) {
    case MeshFormat::kStl: return "stl";
    case MeshFormat::kObj: return "obj";
    case MeshFormat::kPly: return "ply";
    case MeshFormat::kOff: return "off";
  }
  return "unknown";
}

}  // namespace veritope
