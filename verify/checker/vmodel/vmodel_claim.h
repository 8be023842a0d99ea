// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_claim.h: the claim of docs/certificates/vmodel.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_vmodel(const Statement& statement, std::string model, const Body& body);
