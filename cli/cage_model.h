// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/cage_model.h: the model around which a cage is made.
#pragma once
#include <string>

#include "io/model_file.h"
#include "robust/base/result.h"
#include "solids/micro/cage/cage_content.h"

namespace veritope::cli {

struct CagedModel {
  CageContent content;
  bool is_mesh = false;  ///< the parts are its triangles
  std::string sha256;
};

/// Reads a mesh, surfaces or volumes; trimmed surfaces and curves are refused. Volumes are their boundary faces.
/// @error  as read_model_file, with the file; kEmpty, kBadArgument with the entity, kOverLimit
Result<CagedModel> read_caged_model(const std::string& path, const ModelReadOptions& reading);

/// "triangle 12", or "the part near (1, 2, 3)" of splines.
std::string part_name(const CagedModel& model, std::size_t part);

}  // namespace veritope::cli
