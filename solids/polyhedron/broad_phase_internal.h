// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/broad_phase_internal.h: what the tests of the broad phase may call.
#pragma once

namespace veritope::internal {

/// Sets for this process whether the walk uses no instruction that some x86-64 processor lacks. The pairs found are the
/// same.
void use_baseline_boxes(bool only_baseline);

}  // namespace veritope::internal
