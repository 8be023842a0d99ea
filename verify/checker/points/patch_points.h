// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_points.h: the claim points-1 about spline models; docs/certificates/points.md, section 6.
#pragma once
#include "answers.h"

bool is_about_patches(const Statement& statement);
// The conditions from B1 on, after those of the answers.
void check_points_of_patches(const Statement& statement, const std::string& file, const Body& body,
                             const std::vector<Answer>& answers);
