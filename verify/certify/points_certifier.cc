// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/points_certifier.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "robust/base/parallel.h"
#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/broad_phase.h"
#include "verify/format/byte_stream.h"

namespace veritope {
namespace {

constexpr std::size_t kFewBoxes = 16;  // a direction with no more boxes is taken at once
constexpr std::size_t kChunkOfPoints = 1024;

BoxGroups groups_of(const TriangleMesh& mesh, unsigned jobs) {
  std::vector<std::uint32_t> all(mesh.faces.size());
  std::iota(all.begin(), all.end(), 0u);
  const UnitScale scale(bounding_box_of_faces(mesh, jobs));
  const VertexStars no_stars{std::vector<std::uint8_t>(mesh.positions.size(), kNoStar), {}};
  return BoxGroups(mesh, morton_order(mesh, all, scale, jobs), no_stars, scale, jobs);
}

struct Direction {
  std::uint8_t code = 0;
  std::uint64_t units = 0;  // of work, as section 5 of docs/certificates/points.md counts them
};

// Whether a checker has to look at the facet.
bool is_unit(const TriangleMesh& mesh, std::uint32_t facet, const Vec3d& q, std::uint8_t code) {
  Box3d box = empty_box();
  for (const std::uint32_t v : mesh.faces[facet]) add(to_point(mesh.positions[v]), &box);
  const Point3d at = to_point(q);
  if (is_inside({at, at}, box)) return true;
  const std::size_t u = code / 2u;
  for (const std::size_t k : {(u + 1) % 3, (u + 2) % 3})
    if (at[k] < box.lo[k] || at[k] >= box.hi[k]) return false;
  return code % 2 == 0 ? box.hi[u] >= at[u] : box.lo[u] <= at[u];
}

}  // namespace

class PointsCertifier::Body {
 public:
  Body(const MeshFile& file, unsigned jobs)
      : mesh_(file.mesh), jobs_(jobs), boxes_(groups_of(file.mesh, jobs)) {}

  void add(std::span<const Vec3d> points, std::span<const PointAnswer> answers) {
    std::vector<Direction> directions(points.size());
    parallel_for(points.size(), kChunkOfPoints, jobs_,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     if (!answers[i].is_on()) directions[i] = direction_from(points[i]);
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
  // The first of six with few boxes on its way; the meaning of few grows until there is one.
  Direction direction_from(const Vec3d& p) const {
    std::vector<std::uint32_t> met;
    for (std::size_t few = kFewBoxes;; few *= 8)
      for (std::uint8_t code = 0; code < 6; ++code) {
        met.clear();
        if (!boxes_.stabbed(p, code / 2, code % 2 == 0, few, met)) continue;
        const auto units = std::count_if(
            met.begin(), met.end(), [&](std::uint32_t f) { return is_unit(mesh_, f, p, code); });
        return {code, static_cast<std::uint64_t>(units)};
      }
  }

  const TriangleMesh& mesh_;
  const unsigned jobs_;
  const BoxGroups boxes_;
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
