// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/dms_domain_mesh.h: a domain of tetrahedra whose boundary is a mesh, which certify calls VALID.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "cli/option_groups.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "solids/dms/domain/mesh_domain.h"

namespace veritope::cli {

struct MeshDomainChoice {
  std::string path;  ///< "-": standard input
  ModelReadOptions reading;
  std::optional<std::uint64_t> max_vertices;
  bool no_check = false;  ///< does without the checker
};

/// Reads a mesh, decides it as certify does, and makes the domain. Else complains, and returns the exit status: that of
/// certify for a mesh that is not VALID, kExitUndecided if a limit ends the search for a domain.
ExitCode take_mesh_domain(const MeshDomainChoice& choice, Progress& progress, MeshDomain& out);

}  // namespace veritope::cli
