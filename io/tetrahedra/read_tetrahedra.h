// SPDX-License-Identifier: LGPL-3.0-or-later
// io/tetrahedra/read_tetrahedra.h: meshes of tetrahedra as other programs write them: TetGen's .node and .ele, MEDIT's
// .mesh, Gmsh's .msh of versions 2.2 and 4.1, all as text. Numbers are exact.
// The formats, and what is ignored: docs/cli/dms-domain.md.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "robust/rational.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

enum class TetrahedraFormat { kTetgen, kMedit, kGmsh };
/// "tetgen", "medit", "gmsh"
const char* tetrahedra_format_name(TetrahedraFormat format);

/// Tetrahedra as they were read. Nothing is promised about them but that their corners are four different points.
struct TetrahedraFile {
  std::vector<std::array<Rational, 3>> points;
  std::vector<TetrahedronCorners> tetrahedra;  ///< numbers of points from 0
  /// What was ignored, with counts, in a fixed order: {"triangles", 12}, ...
  std::vector<std::pair<std::string, std::uint64_t>> ignored;
};

/// By the first word: MEDIT or Gmsh. TetGen's files consist of numbers only, and so are known by their names.
std::optional<TetrahedraFormat> tetrahedra_format_of(const Source& source);

/// @error of all: kSyntax, kTruncated, kNotFinite, kIndexOutOfRange, kOverLimit, kForeignFormat (binary variants, cells
///        of a higher order), with the line
/// @cost  linear; no count is believed before its items are read
Result<TetrahedraFile> read_medit(const Source& source, const ReadLimits& limits);
Result<TetrahedraFile> read_gmsh(const Source& source, const ReadLimits& limits);
Result<TetrahedraFile> read_tetgen(const Source& nodes, const Source& elements,
                                   const ReadLimits& limits);

}  // namespace veritope
