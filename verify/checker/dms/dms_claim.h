// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_claim.h: the claims of docs/certificates/dms-solid.md, dms-solid-2.md and dms-invalid.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_dms(const Statement& statement, std::string model, const Body& body);
std::string check_dms_2(const Statement& statement, std::string model, const Body& body);
void check_dms_finding(const Statement& statement);  // S1
std::string check_dms_invalid(const Statement& statement, std::string model, const Body& body);
