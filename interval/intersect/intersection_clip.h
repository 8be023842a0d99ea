// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_clip.h: the parts of a tube's arc that lie in both domains.
#pragma once
#include <vector>

#include "interval/intersect/intersection_branches.h"

namespace veritope {

/// Appends the parts to `arcs`; where the arc touches the border, or meets a corner in an undecided way, appends a box
/// to `unresolved`. REQUIRES a live ScopedUpward.
void clip_to_domains(const EnclosedSurface& s1, const EnclosedSurface& s2,
                     const IntersectionTube& tube, std::vector<DomainArc>* arcs,
                     std::vector<Box4>* unresolved);

/// The domain of parameter i of (u, v, s, t).
Interval parameter_domain(const EnclosedSurface& s1, const EnclosedSurface& s2, std::size_t i);

}  // namespace veritope
