// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/expression_classification.h: one run of classify with respect to an expression: points in, answers out.
#pragma once
#include <span>
#include <string>

#include "cli/classification.h"
#include "solids/expression/expression_classifier.h"
#include "verify/certify/expression_points_certifier.h"

namespace veritope::cli {

/// What the run needs for a certificate of its answers.
struct ExpressionCertificate {
  ExpressionPointsCertifier certifier;
  certificate::AnswersSubject answers;  ///< its hash and its size are set by the run
};

/// Answers all points of the source. Fills the numbers of the report.
/// @param names  of the solids, in the order of the variables, for the reasons of undecided points
/// @param certificate  null: there will be none
/// @error as PointSource and WriteAnswers
Status classify_points(const ExpressionClassifier& classifier, std::span<const std::string> names,
                       PointSource& source, unsigned jobs, const WriteAnswers& write,
                       report::ClassifyReport& report, ExpressionCertificate* certificate);

}  // namespace veritope::cli
