// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_claims.h: the claims of docs/certificates/star-box.md, patch-invalid.md, patch-invalid-2.md and
// volume-folded.md, for the table.
#pragma once
#include "../common/checker.h"

void check_finding(const Statement& statement);    // for patch-invalid-1
void check_finding_2(const Statement& statement);  // for patch-invalid-2
std::string check_star_box(const Statement& statement, std::string model, const Body& body);
std::string check_patch_invalid(const Statement& statement, std::string model, const Body& body);
std::string check_patch_invalid_2(const Statement& statement, std::string model, const Body& body);
std::string check_volume_folded(const Statement& statement, std::string model, const Body& body);
