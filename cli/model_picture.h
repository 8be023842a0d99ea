// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/model_picture.h: the picture of a model that certify --picture writes.
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "io/model_file.h"
#include "report/file_report.h"
#include "robust/base/result.h"

namespace veritope::cli {

enum class PictureKind { kPng, kPly, kVtu, kGltf };

/// The most defects of each rule that a picture shows, and the most open sides.
inline constexpr std::size_t kMostDrawn = 20'000;

/// ".png", ".ply", ".vtu" or ".gltf", in any case. Nothing for other endings.
std::optional<PictureKind> picture_kind(const std::string& path);

/// Whether models of this kind have pictures.
bool has_pictures(ModelKind kind);

/// The model with what the report says is wrong with it.
/// REQUIRES a report with a verdict.
/// @error  kEmpty, kNotFinite, kOverLimit, kBadArgument: the model cannot be drawn
Result<std::string> picture_of(const ModelFile& model, const report::FileReport& report,
                               PictureKind kind, unsigned jobs);

/// Drops all but the first `most` defects of each rule of a mesh, and all but the first `most` open sides.
void keep_first(std::size_t most, report::FileReport& report);

}  // namespace veritope::cli
