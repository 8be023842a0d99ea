// SPDX-License-Identifier: Apache-2.0 OR MIT
// expression_points.h: the claim points-1 about chain files; docs/certificates/points.md, section 7.
#pragma once
#include "answers.h"

// The conditions after those of the answers. The result: how many points are not covered.
uint64_t check_points_of_expression(const Statement& statement, const std::string& file,
                                    const Body& body, const std::vector<Answer>& answers);
