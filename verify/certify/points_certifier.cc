// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/points_certifier.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "robust/base/parallel.h"
#include "verify/certify/point_codes.h"
#include "verify/format/byte_stream.h"

namespace veritope {
namespace {

constexpr std::size_t kChunkOfPoints = 1024;

}  // namespace

class PointsCertifier::Body {
 public:
  Body(const MeshFile& file, unsigned jobs)
      : mesh_(file.mesh), jobs_(jobs), directions_(file.mesh, jobs) {}

  void add(std::span<const Vec3d> points, std::span<const PointAnswer> answers) {
    std::vector<RayDirection> directions(points.size());
    parallel_for(points.size(), kChunkOfPoints, jobs_,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     if (!answers[i].is_on()) directions[i] = directions_.from(points[i]);
                 });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (answers[i].is_on()) {
        ++num_on_, ++work_;
        codes_.varint(answers[i].facet);
      } else {
        work_ += directions[i].units;
        codes_.u8(directions[i].code);
      }
    }
    num_points_ += points.size();
  }

  Result<certificate::Bytes> finish(const certificate::Subject& subject,
                                    certificate::AnswersSubject answers) {
    if (work_ > 10 * mesh_.faces.size() + 1000 * num_points_)
      return Error{Code::kOverLimit, {}, "the points need more work than checkers may spend"};
    certificate::PointsBody body;
    body.num_faces = static_cast<std::uint32_t>(mesh_.faces.size());
    body.num_vertex_ids = static_cast<std::uint32_t>(mesh_.positions.size());
    body.num_points = num_points_;
    body.codes = codes_.take();
    answers.points = num_points_;
    answers.on = num_on_;
    return certificate::encode(subject, answers, body);
  }

 private:
  const TriangleMesh& mesh_;
  const unsigned jobs_;
  const MeshDirections directions_;
  certificate::internal::ByteWriter codes_;
  std::uint64_t num_points_ = 0, num_on_ = 0, work_ = 0;
};

PointsCertifier::PointsCertifier(const MeshFile& file, unsigned jobs)
    : body_(std::make_unique<Body>(file, jobs)) {}
PointsCertifier::PointsCertifier(PointsCertifier&&) noexcept = default;
PointsCertifier::~PointsCertifier() = default;

void PointsCertifier::add(std::span<const Vec3d> points, std::span<const PointAnswer> answers) {
  body_->add(points, answers);
}

Result<certificate::Bytes> PointsCertifier::finish(const certificate::Subject& subject,
                                                   certificate::AnswersSubject answers) {
  return body_->finish(subject, std::move(answers));
}

}  // namespace veritope
