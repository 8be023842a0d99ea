// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_claim.h: the claims of docs/certificates/vmodel.md and vmodel-invalid.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_vmodel(const Statement& statement, std::string model, const Body& body);
void check_vmodel_finding(const Statement& statement);
std::string check_vmodel_invalid(const Statement& statement, std::string model, const Body& body);
