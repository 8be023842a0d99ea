// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/classification.h: one run of classify: points in, answers out, and the certificate of both.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "cli/point_source.h"
#include "cli/progress.h"
#include "io/mesh/read_mesh.h"
#include "report/classify_report.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/patch_classifier.h"
#include "verify/certify/file_patches.h"
#include "verify/format/mesh_certificate.h"

namespace veritope::cli {

struct ClassifySettings {
  bool is_winding = false;
  bool makes_certificate = false;
  Decimals decimals = Decimals::kNearest;
  unsigned jobs = 1;
};

/// Receives the lines of answers, in order.
using WriteAnswers = std::function<Status(std::string_view lines)>;

struct ClassifiedPoints {
  certificate::Bytes
      certificate;  ///< empty without makes_certificate, or for the reason in `refusal`
  std::optional<Error> refusal;  ///< all points are answered, and there is no certificate: see
                                 ///< PointsCertifier and PatchPointsCertifier
};

/// Answers all points of the source with respect to the mesh of the file. Fills the numbers of the report.
/// @param shells  those of a valid mesh; null: --winding, words are not given
/// @error  as PointSource, WriteAnswers and MeshClassifier::make
Result<ClassifiedPoints> classify_points(const MeshFile& file, const MeshShells* shells,
                                         PointSource& source, const ClassifySettings& settings,
                                         const WriteAnswers& write, Progress& progress,
                                         const std::string& shown_name,
                                         report::ClassifyReport& report);
/// With respect to patches. REQUIRES patches.complex->is_closed_oriented_surface().
/// @param subject  what the certificate speaks of, if one is made
/// @error  as PointSource and WriteAnswers
Result<ClassifiedPoints> classify_points(const FilePatches& patches,
                                         const certificate::Subject& subject, PointSource& source,
                                         const ClassifySettings& settings,
                                         const WriteAnswers& write, Progress& progress,
                                         const std::string& shown_name,
                                         report::ClassifyReport& report);

}  // namespace veritope::cli
