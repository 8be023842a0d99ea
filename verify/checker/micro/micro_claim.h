// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_claim.h: the claim of docs/certificates/microstructure.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_micro(const Statement& statement, std::string model, const Body& body);
