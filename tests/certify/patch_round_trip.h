// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/patch_round_trip.h: patches -> .vjson -> reader -> decision -> certificate -> both checkers as programs.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/patch_model.h"
#include "io/read_splines.h"
#include "io/write_splines.h"
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

/// Both checkers accept the certificate.
inline void expect_accepted(const CertifiedPatches& c, const std::string& what) {
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::temp_directory_path() / ("veritope_patches_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "model.vjson", std::ios::binary) << c.file;
  std::ofstream(folder / "model.cert", std::ios::binary)
      << std::string(c.bytes.begin(), c.bytes.end());
  for (const std::string& program : {std::string("'" VERITOPE_BIN_DIR "/veritope-check'"),
                                     std::string("'" VERITOPE_PYTHON "' -B '" VERITOPE_SOURCE_DIR
                                                 "/verify/checker/veritope_check.py'")}) {
    const std::string command = program + " '" + (folder / "model.vjson").string() + "' '" +
                                (folder / "model.cert").string() + "' 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string out;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) out.append(part, n);
    const int status = ::pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << what << ", " << program << ": " << out.substr(0, 400);
  }
  fs::remove_all(folder);
}

}  // namespace veritope
