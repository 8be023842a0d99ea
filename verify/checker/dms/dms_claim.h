// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_claim.h: the claim of docs/certificates/dms-solid.md, for the table.
#pragma once
#include "../common/checker.h"

std::string check_dms(const Statement& statement, std::string model, const Body& body);
