// SPDX-License-Identifier: LGPL-3.0-or-later
// report/micro_run_report.h: what veritope micro says of a microstructure that it made, or did not make.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/micro_topology.h"

namespace veritope::report {

struct MicroRunReport {
  struct File {
    std::string path, sha256;
    std::uint64_t bytes = 0;
  };
  /// Why nothing was written.
  struct Defect {
    std::string code;  ///< "cage", or the condition of docs/certificates/microstructure.md
    std::optional<std::uint64_t> tile;                 ///< the number of a kind of tile
    std::optional<std::array<std::uint64_t, 4>> cell;  ///< volume, i, j, k
    std::optional<std::string> wall;                   ///< "u0"
    std::string message;
  };
  struct Mesh {
    File file;
    std::uint64_t facets = 0, vertices = 0;
    double distance =
        0;  ///< proved: no point of it or of the microstructure is farther from the other
  };
  struct Composed {
    File file;
    std::uint64_t patches = 0;
    std::uint64_t curves = 0;  ///< among the patches
    std::uint64_t bridges = 0;
    std::vector<std::uint32_t>
        bridges_left_out;  ///< numbers of those that cross a knot of the cage
  };
  /// What the cells held whose tiles became the cage: micro --nest.
  struct Outer {
    std::uint64_t cells = 0, kept = 0, crossing = 0, touching = 0, outside = 0, undecided = 0;
    std::uint64_t volumes = 0;  ///< of the cage that was written
  };
  /// Both bounds are rounded outward.
  struct Bounds {
    double lo = 0, hi = 0;
  };
  struct Seconds {
    double cage = 0, filter = 0, bridge = 0, topology = 0, measure = 0, mesh = 0, compose = 0;
  };

  File cage;
  std::optional<File> model, output;
  std::uint64_t cells = 0;
  std::uint64_t kept = 0, crossing = 0, touching = 0, outside = 0, undecided = 0, floating = 0;
  std::optional<Outer> outer;
  std::uint64_t kinds = 0;
  std::optional<MicroCounts> counts;    ///< of what was written
  std::optional<BridgeReport> bridges;  ///< nothing if none were to be built
  std::optional<Bounds> volume;         ///< of tiles and bridges, in cubic units of the model
  std::optional<Bounds> density;        ///< that volume over the volume of all cells
  /// The least and the greatest determinant of the cage's map from [0, 1]^3 over the cells with tiles, up to its sign.
  std::optional<Bounds> scale;
  /// The least distance of a tile from the surface of the model, in its units.
  std::optional<Bounds> clearance;
  std::optional<Mesh> mesh;
  std::optional<Composed> composed;
  bool is_open =
      false;  ///< a run with tiles of curves and sheets, of which only composed splines are written
  bool wants_surface = false;  ///< a mesh or the composed surface was asked for
  std::vector<Defect> defects;
  Seconds seconds;
};

/// The schema: docs/report.schema.json, micro_run. One line.
std::string micro_run_json(const MicroRunReport& report);
/// Lines for people, if something was written.
std::string micro_run_text(const MicroRunReport& report);

}  // namespace veritope::report
