// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/micro_solid.h: the solid M of veritope micro, whatever its file holds.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/model_file.h"
#include "robust/base/result.h"
#include "solids/base/verdict.h"
#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/build_sweeps.h"
#include "solids/micro/filter/tile_filter.h"
#include "solids/micro/inside/clearance.h"
#include "solids/vmodel/v_model.h"
#include "verify/certify/file_patches.h"

namespace veritope::cli {

/// A mesh, or surfaces and triangles as one complex, or the boundary faces of volumes. Stays where it is in memory:
/// filters refer to it.
class MicroSolid {
 public:
  /// Reads the file and decides whether it bounds a solid.
  /// @error  as read_model_file and certify, with the file
  static Result<std::unique_ptr<const MicroSolid>> read(const std::string& path,
                                                        const ModelReadOptions& reading);

  const std::string& sha256() const { return sha256_of(file_); }
  std::uint64_t bytes() const { return num_bytes(file_); }
  /// Null unless the file is a mesh.
  const TriangleMesh* mesh() const {
    const auto* const file = std::get_if<MeshFile>(&file_);
    return file == nullptr ? nullptr : &file->mesh;
  }
  /// Nothing if the solid is VALID; else why not.
  const std::optional<std::string>& fault() const { return fault_; }
  /// Whether the fault is that something was not decided, and not a defect of the solid.
  bool is_undecided() const { return is_open_; }

  /// Null unless the file holds splines. REQUIRES !fault().
  const PatchComplex* complex() const { return patches_.complex.get(); }

  /// REQUIRES !fault().
  Result<TileFilter> filter() const;
  /// How near to the surface bridges end unless an option says so. REQUIRES !fault().
  double default_skin() const;

  /// How far the tiles are from the surface. REQUIRES !fault(), and as veritope::clearance_of.
  /// @error as veritope::clearance_of
  Result<std::optional<Clearance>> clearance_of(const Microstructure& micro, unsigned jobs) const;
  /// See build_bridges and build_sweeps. REQUIRES !fault().
  Result<BridgeReport> bridge(const VModel& cage, const std::vector<AnalysedTile>& tiles,
                              const BridgeOptions& options, bool in_space,
                              Microstructure& micro) const;

  struct Escape {
    std::string message;              ///< "triangle 5 does not lie inside of the cage: ..."
    bool is_certain = false;          ///< else it is not proved inside
    std::optional<VFaceNumber> face;  ///< of the cage's border, near it
  };
  /// Nothing only if the cage is proved to contain the solid's surface. REQUIRES !fault(), a valid cage.
  /// @error as find_escape
  Result<std::optional<Escape>> escape_from(const VModel& cage) const;

 private:
  explicit MicroSolid(ModelFile file) : file_(std::move(file)) {}
  Status decide(unsigned jobs);

  ModelFile file_;
  FilePatches patches_;  // of a file of splines
  std::optional<std::string> fault_;
  bool is_open_ = false;
};

}  // namespace veritope::cli
