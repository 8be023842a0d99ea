// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/chunk_internal.h: how many items one call of a parallel loop takes.
#pragma once
#include <cstddef>

namespace veritope::internal {

// Small enough that threads end together, large enough that handing chunks out costs nothing.
inline constexpr std::size_t kChunk = 1 << 12;

}  // namespace veritope::internal
