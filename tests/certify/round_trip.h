// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/round_trip.h: model -> file -> reader -> decision -> certificate, as the command line does it.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "io/mesh/reading_rule.h"
#include "io/mesh/write_mesh.h"
#include "io/read_model.h"
#include "tests/support/report_text.h"
#include "tests/support/shapes.h"
#include "verify/certify/mesh_certifier.h"
#include "verify/format/sha256.h"

namespace veritope {

struct CertifiedMesh {
  std::string file;   ///< the model's bytes
  TriangleMesh mesh;  ///< as read back
  ListedReport report;
  certificate::Bytes bytes;  ///< the certificate
  std::string certificate() const { return {bytes.begin(), bytes.end()}; }
  certificate::Certificate decoded() const {
    std::string why;
    return certificate::decode(bytes, why).value();
  }
};

inline CertifiedMesh certified_file(std::string file, const std::string& name, bool as_indexed,
                                unsigned jobs, std::size_t max_defects = 20) {
  CertifiedMesh out;
  out.file = std::move(file);
  ModelReadOptions read;
  read.as_indexed = as_indexed;
  const auto bytes =
      std::span(reinterpret_cast<const unsigned char*>(out.file.data()), out.file.size());
  auto model = read_mesh_bytes(bytes, name, read);
  out.mesh = std::move(model.value().mesh);
  ValidityOptions options;
  options.jobs = jobs;
  options.max_defects = max_defects;
  options.keep_meetings = jobs > 1;  // as certify does; the bytes are the same without
  out.report = decide_and_list(out.mesh, options);
  certificate::Subject subject;
  subject.sha256 = model.value().sha256;
  subject.bytes = out.file.size();
  subject.format = name.substr(name.find('.') + 1);
  subject.as_indexed = as_indexed;
  subject.reading_rule = std::string(kReadingRule);
  subject.tool = "tests";
  out.bytes = make_mesh_certificate(out.mesh, out.report, out.report.defects, subject, jobs);
  return out;
}

/// Through a binary PLY file with doubles: every coordinate survives.
inline CertifiedMesh certified(const TriangleMesh& mesh, bool as_indexed = false, unsigned jobs = 1,
                           std::size_t max_defects = 20) {
  auto file = mesh_to_bytes(mesh, *write_options_from_name("ply-binary-little-endian"));
  return certified_file(std::move(file.value()), "model.ply", as_indexed, jobs, max_defects);
}

}  // namespace veritope
