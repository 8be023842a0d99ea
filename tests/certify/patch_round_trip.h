// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/patch_round_trip.h: patches -> .vjson -> reader -> decision -> certificate.
#pragma once
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "verify/certify/patch_certifier.h"
#include "verify/format/sha256.h"

namespace veritope {

struct CertifiedPatches {
  std::string file;
  PatchDecision decision;
  certificate::Bytes bytes;  ///< empty if undecided
};

inline CertifiedPatches certified_patches(const std::vector<Patch>& patches,
                                          PatchDecisionOptions options = {}) {
  CertifiedPatches out;
  out.file = spline_json_bytes(model_of(patches));
  const SplineFile file =
      read_spline_bytes({reinterpret_cast<const unsigned char*>(out.file.data()), out.file.size()},
                        "model.vjson", {})
          .value();
  PatchSource source = patch_source(file.model).value();
  const PatchComplex complex = make_patch_complex(std::move(source.patches)).value();
  std::vector<StarBoxEntity> entities;
  for (std::size_t e = 0; e < source.entities.size(); ++e)
    entities.push_back({std::holds_alternative<ExactSurface>(file.model.entities[e].shape), false,
                        static_cast<std::uint32_t>(source.entities[e].first_patch),
                        source.entities[e].breaks});
  options.outer = outer_sides(entities, complex.patches().size());
  std::optional<PieceForest> forest;
  out.decision = decide_patches(complex, options, &forest);
  if (out.decision.open) return out;
  certificate::Subject subject;
  subject.sha256 = file.sha256;
  subject.bytes = out.file.size();
  subject.format = "vjson";
  subject.tool = "tests";
  out.bytes = make_patch_certificate(complex, forest, out.decision, entities, subject);
  return out;
}

}  // namespace veritope
