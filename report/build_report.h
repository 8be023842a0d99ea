// SPDX-License-Identifier: LGPL-3.0-or-later
// report/build_report.h: what veritope build says of a tree of volumes.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/rational.h"

namespace veritope::report {

struct BuildReport {
  /// What a node did that the tree does not say in full.
  struct Note {
    std::string pointer, op;
    std::optional<Rational> degrees, error;                       ///< of a turn or a rotation
    std::optional<Rational> distance_from_rotation, determinant;  ///< of a matrix
  };

  std::string path, sha256;                ///< of the tree
  std::string output_path, output_sha256;  ///< of the volumes
  std::uint64_t output_bytes = 0;
  std::uint64_t cells = 0, control_points = 0, nodes = 0, files = 0;
  std::vector<Note> notes;
  double seconds = 0;
};

/// The schema: docs/report.schema.json, build. One line.
std::string build_json(const BuildReport& report);

/// Lines for people.
std::string build_text(const BuildReport& report);

}  // namespace veritope::report
