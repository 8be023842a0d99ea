// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/decided_model.h: the surface of a model that is decided VALID, as patches: facets of meshes are flat triangles.
#pragma once
#include <optional>
#include <string>

#include "cli/certification.h"
#include "solids/patches/patch_complex.h"

namespace veritope::cli {

struct DecidedModel {
  std::optional<PatchComplex> complex;
  std::string sha256;
  bool is_mesh = false;
};

/// Whether the model has triangles or splines. @error kUnknownFormat, with the path, for a model of another kind
Status require_surface(const ModelFile& model, const std::string& path);

/// Reads the model and decides it as certify does. Unless it is VALID, complains with the line of its verdict, begun
/// with `refusal`, and returns the exit status of certify.
ExitCode take_decided_model(const std::string& path, CertifySettings settings,
                            const std::string& refusal, Progress& progress, DecidedModel& out);

}  // namespace veritope::cli
