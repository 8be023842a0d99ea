// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/micro_emit.h: the option --emit of veritope micro: the boundary of a microstructure as splines.
#pragma once
#include <string>
#include <vector>

#include "cli/streamed_output.h"
#include "solids/micro/bridge/curve_bridges.h"
#include "solids/micro/compose/composed_surface.h"

namespace veritope::cli {

/// Why a file of this name cannot be emitted; empty if it can: .vjson, .itd or .vtu.
std::string fault_of_emit_name(const std::string& path);

/// Writes the patches to the output, and then the bridges as curves, in the format of its name: in a group "bridges",
/// if there are some. In .vtu the patch of a bridge is -1; the other numbers are those of the tile that it continues.
/// The bytes are the same for every number of jobs.
/// @error kCannotWrite; kNotFinite (.vtu): a coordinate beyond binary64
/// REQUIRES a surface and bridges of micro.
Status emit_surface(const ComposedSurface& surface, const Microstructure& micro,
                    const std::vector<CurveBridge>& bridges, unsigned jobs, StreamedOutput& output);

}  // namespace veritope::cli
