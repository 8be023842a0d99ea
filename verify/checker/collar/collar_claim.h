// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar_claim.h: the claim of docs/certificates/collar.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_collar(const Statement& statement, std::string model, const Body& body);
