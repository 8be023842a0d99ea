// SPDX-License-Identifier: Apache-2.0 OR MIT
// ball_claims.h: the claims about balls, for the table.
#pragma once
#include "../common/checker.h"

// Decides ball-1 and ball-invalid-1.
std::string check_ball(const Statement& statement, std::string model, const Body& body);
