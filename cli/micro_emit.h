// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/micro_emit.h: the option --emit of veritope micro: the boundary of a microstructure as splines.
#pragma once
#include <string>

#include "cli/streamed_output.h"
#include "solids/micro/compose/composed_surface.h"

namespace veritope::cli {

/// Why a file of this name cannot be emitted; empty if it can: .vjson, .itd or .vtu.
std::string fault_of_emit_name(const std::string& path);

/// Writes the patches to the output, in the format of its name. The bytes are the same for every number of jobs.
/// @error kCannotWrite; kNotFinite (.vtu): a coordinate beyond binary64
Status emit_surface(const ComposedSurface& surface, unsigned jobs, StreamedOutput& output);

}  // namespace veritope::cli
