// SPDX-License-Identifier: LGPL-3.0-or-later
// report/dms_domain_report.h: what veritope dms domain says of the domain that it wrote.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace veritope::report {

/// A vertex of the boundary; the names of its classes.
struct DmsDomainVertex {
  std::uint32_t vertex = 0;
  std::string used, paper;
  double solid_angle = 0;  ///< in radians
};

/// A tetrahedron of the hull that the domain does not have, in numbers of points of the file, and why.
struct DmsDomainRemoval {
  std::array<std::uint32_t, 4> points{};
  std::string reason;
};

/// Refinement, if a limit was given.
struct DmsDomainRefinement {
  std::optional<std::string> max_volume, max_radius_edge;  ///< "p/q"
  std::uint64_t max_points = 0, inserted = 0, taken_away = 0;
  std::string end;
  std::uint64_t over_volume = 0, over_radius_edge = 0;
  double largest_volume = 0, largest_radius_edge = 0;
  std::vector<std::uint32_t> protected_tetrahedra;
  struct SmallAngle {
    std::vector<std::uint32_t> vertices;
    bool is_dihedral = false;
    double degrees = 0;
  };
  std::vector<SmallAngle> small_angles;
};

struct DmsDomainReport {
  std::string input;
  std::string path, sha256;  ///< of the model
  std::uint64_t bytes = 0;
  std::uint64_t points = 0, duplicates = 0;
  std::uint64_t vertices = 0, tetrahedra = 0, steiner = 0;
  bool is_delaunay = false;
  double min_dihedral = 0;  ///< in degrees, rounded
  std::vector<DmsDomainVertex> classes;
  std::vector<std::vector<std::uint32_t>>
      feature_lines;  ///< vertices in order; closed if first = last
  std::vector<DmsDomainRemoval> removed;
  std::vector<std::array<std::uint32_t, 4>>
      filled;  ///< in the domain by a later step, numbers of points
  std::optional<DmsDomainRefinement> refinement;
  double seconds = 0;
};

/// The schema: docs/report.schema.json, dms_domain.
std::string dms_domain_json(const DmsDomainReport& report);

/// Sentences for people: whether the limits hold, and why not. REQUIRES a refinement.
std::string dms_refinement_text(const DmsDomainReport& report);

}  // namespace veritope::report
