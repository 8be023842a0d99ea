// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/chain_classification.h: the f of points by a chain of a model, for study: classify --by normal and literal.
#pragma once
#include <string>

#include "cli/classification.h"
#include "solids/patches/patch_complex.h"

namespace veritope::cli {

enum class ChainKind { kNormal, kLiteral };

/// For each point one line: its coordinates, "-", f or "wall", and "-" or, by the literal chain, f* where there is one.
/// Fills the numbers of the report. REQUIRES a closed oriented surface. @error as PointSource and WriteAnswers
Status classify_by_chain(const PatchComplex& complex, ChainKind kind, const ExactPoint& origin,
                         PointSource& source, unsigned jobs, const WriteAnswers& write,
                         report::ClassifyReport& report);

}  // namespace veritope::cli
