// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/certify.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/certification.h"
#include "cli/defect_picture.h"
#include "io/formats.h"
#include "io/mesh/reading_rule.h"
#include "verify/certify/mesh_certifier.h"
#include "verify/format/mesh_certificate.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

class MeshCertification : public Certification {
 public:
  using Certification::Certification;

 private:
  bool read() override {
    phase("reading");
    Result<MeshFile> file = read_mesh();
    report_.seconds.read = watch_.lap();
    if (!file) return refuse(fault_of(file.error()));
    report_.reading = file->report;
    report_.as_indexed = settings_.reading.as_indexed && file->report.format != MeshFormat::kStl;
    report_.sha256 = file->sha256;
    mesh_ = std::move(file->mesh);
    polygon_of_face_ = std::move(file->polygon_of_face);
    return true;
  }

  Result<MeshFile> read_mesh() {
    const std::string& path = report_.path;
    if (!needs_copy()) return read_mesh_file(path, settings_.reading);
    Result<ByteBuffer> bytes = read_once();
    if (!bytes) return bytes.error();
    spooled_ = std::move(*bytes);
    const ByteBuffer& b = spooled_;
    return read_mesh_bytes({b.data(), b.size()}, path, settings_.reading);
  }

  bool decide() override {
    phase("deciding");
    ValidityOptions options;
    options.jobs = settings_.jobs;
    options.max_defects = std::max<std::size_t>(settings_.max_defects, 1);  // for the witnesses
    report_.decision = decide_validity(mesh_, options);
    report_.seconds.decide = watch_.lap();
    return true;
  }

  bool certify() override {
    phase("certifying");
    ValidityReport& decision = *report_.decision;
    certificate::Subject subject;
    subject.sha256 = report_.sha256;
    subject.bytes = report_.reading->bytes;
    subject.format = mesh_format_name(report_.reading->format);
    subject.as_indexed = report_.as_indexed;
    subject.reading_rule = kReadingRule;
    subject.tool = tool_name();
    bytes_ = make_mesh_certificate(mesh_, decision, subject, settings_.jobs);
    report_.certificate = CertificateReport{{}, to_hex(sha256(bytes_)), bytes_.size(), false};
    list_defects(decision);
    report_.seconds.certify = watch_.lap();
    if (settings_.with_picture) report_.picture = defect_picture(mesh_, report_.defects);
    mesh_ = {};  // memory for the checker
    decision.stars = {};
    return true;
  }

  void list_defects(ValidityReport& decision) {
    for (Defect& d : share_out(std::move(decision.defects), settings_.max_defects)) {
      ListedDefect listed;
      for (const std::uint32_t f : d.faces) {
        if (!polygon_of_face_.empty()) listed.polygons.push_back(polygon_of_face_[f]);
      }
      listed.defect = std::move(d);
      report_.defects.push_back(std::move(listed));
    }
    decision.defects.clear();
    polygon_of_face_ = {};
  }

  bool is_valid() const override { return report_.decision->is_valid; }
  std::string claim() const override {
    return std::string(is_valid() ? certificate::kValidClaim : certificate::kInvalidClaim);
  }
  void forget() override {
    report_.decision.reset();
    report_.defects.clear();
  }
  std::string own_options() const override {
    std::string options;
    if (settings_.reading.as_indexed) options += "--as-indexed ";
    if (settings_.reading.format)
      options += std::string("--format ") + model_format(*settings_.reading.format).name + " ";
    return options;
  }

  TriangleMesh mesh_;
  std::vector<std::uint32_t> polygon_of_face_;
};

}  // namespace

FileReport certify_file(const std::string& path, const CertifySettings& settings,
                        const KeepCertificate& keep, Progress& progress) {
  return MeshCertification(path, settings, keep, progress).run();
}

std::string tool_name() { return "veritope " VERITOPE_VERSION; }

}  // namespace veritope::cli
