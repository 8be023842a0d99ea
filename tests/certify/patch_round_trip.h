// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/patch_round_trip.h: patches -> .vjson -> reader -> decision and certificate, through the functions that certify() is made of.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/patch_certifier.h"

namespace veritope {

struct CertifiedPatches {
  std::string file;
  PatchDecision decision;
  certificate::Bytes bytes;  ///< empty if undecided
};

inline SplineFile spline_file_of(const std::string& bytes) {
  ModelFile file =
      read_model_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                       "model.vjson", {})
          .value();
  return std::get<SplineFile>(std::move(file));
}

inline CertifiedPatches certified_patches(const std::vector<Patch>& patches,
                                          PatchDecisionOptions options = {}) {
  CertifiedPatches out;
  out.file = spline_json_bytes(model_of(patches));
  const SplineFile file = spline_file_of(out.file);
  FilePatches model = file_patches(file.model, PatchOrientation::kKeep).value();
  FileDecisionOptions how;
  how.search = std::move(options);
  FileDecision decided = decide_file_patches(model, how);
  if (!decided.decision.open)
    out.bytes = make_patch_certificate(model, decided, subject_of(file, "tests"));
  out.decision = std::move(decided.decision);
  return out;
}

}  // namespace veritope
