// SPDX-License-Identifier: Apache-2.0 OR MIT
// claims.h: the claims that this checker decides.
#pragma once
#include "common/checker.h"

const std::vector<Claim>& all_claims();
// What --claims prints, a line for each claim: name, magic, formats, keys with the kinds of their values.
std::string claims_as_text();
