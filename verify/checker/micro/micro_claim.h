// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_claim.h: the claims of docs/certificates/microstructure.md and micro-inside.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_micro(const Statement& statement, std::string model, const Body& body);

void check_inside_values(const Statement& statement);  // S1, of the keys of micro-inside-1
std::string check_micro_inside(const Statement& statement, std::string model, const Body& body);
