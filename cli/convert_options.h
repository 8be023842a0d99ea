// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/convert_options.h: the options of veritope convert, for meshes and for splines.
#pragma once
#include <optional>
#include <string>

#include "cli/option_groups.h"
#include "robust/rational.h"

namespace veritope::cli {

struct ConvertOptions {
  InputOptions input;
  std::string output;
  std::optional<std::string> to;
  bool single_precision = false, lossy = false;
  bool faces = false;               ///< write the boundary of volumes
  bool pn = false;                  ///< write PN-triangles of a mesh
  bool rejoin = false;              ///< cut splines at T-junctions
  std::optional<Rational> weld;     ///< make faces of volumes equal that are within this distance
  std::optional<std::string> json;  ///< what was welded
  std::optional<double> chord;      ///< for splines written as obj or gltf
};

/// Why the name of the new file chooses none of the formats in which `what`, "a mesh" or "splines", can be written.
inline std::string no_target_text(const std::string& output, const std::string& what,
                                  const std::string& names) {
  return "the name " + output + " does not end in " + names + ", the formats for " + what +
         "; --to chooses one of them whatever the name";
}

}  // namespace veritope::cli
