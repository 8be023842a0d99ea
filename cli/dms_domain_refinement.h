// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/dms_domain_refinement.h: limits of the tetrahedra that veritope dms domain makes.
#pragma once
#include <cstdint>
#include <optional>

#include "cli/option_set.h"
#include "report/dms_domain_report.h"
#include "solids/dms/domain/refine_domain.h"

namespace veritope::cli {

/// Declares --max-volume, --max-radius-edge and --max-points.
void declare_refinement(OptionSet& set, RefineLimits& limits,
                        std::optional<std::uint64_t>& max_points);
bool has_limit(const RefineLimits& limits);

report::DmsDomainRefinement describe_refinement(const RefineLimits& limits,
                                                const RefinedDomain& refined);

}  // namespace veritope::cli
