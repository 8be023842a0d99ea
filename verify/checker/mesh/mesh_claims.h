// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_claims.h: the claims of docs/certificates/mesh.md and mesh-reversed.md, for the table.
#pragma once
#include "../common/checker.h"

void check_volume(const Statement& statement);  // for mesh-valid-1 and mesh-reversed-1
void check_rules(const Statement& statement);   // for mesh-invalid-1
// Both claims about solids.
std::string check_mesh_valid(const Statement& statement, std::string model, const Body& body);
std::string check_mesh_invalid(const Statement& statement, std::string model, const Body& body);
