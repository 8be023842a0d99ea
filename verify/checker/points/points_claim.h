// SPDX-License-Identifier: Apache-2.0 OR MIT
// points_claim.h: the claim points-1 of docs/certificates/points.md, for the table.
#pragma once
#include "../common/checker.h"

void check_decimals(const Statement& statement);  // S1, of the key `decimals`
// The model is a mesh, a spline model or a chain file.
std::string check_points(const Statement& statement, std::string model, const Body& body);
