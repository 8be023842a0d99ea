// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_points_certifier.h"

#include <algorithm>

#include "io/mesh/reading_rule.h"
#include "robust/base/check.h"
#include "verify/certify/point_codes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kBytesOfPatch = 3;  // of the model and the body: B1 of the page

}  // namespace

class PatchPointsCertifier::Body {
 public:
  Body(const FilePatches& patches, const PatchClassifier& classifier)
      : patches_(patches),
        classifier_(classifier),
        directions_(*patches.complex),
        codes_(to_certificate(patches.entities)) {}

  void add(std::span<const Vec3d> points, std::span<const std::pair<std::size_t, ExactPoint>> exact,
           std::span<const PointAnswer> answers) {
    auto next = exact.begin();
    for (std::size_t i = 0; i < points.size(); ++i) {
      while (next != exact.end() && next->first < i) ++next;
      const bool is_exact = next != exact.end() && next->first == i;
      if (!answers[i].is_decided)
        ++num_undecided_;
      else if (!answers[i].is_on())
        codes_.add_direction(directions_.from(points[i]));
      else if (is_exact)
        add_on(next->second);
      else
        add_on(points[i]);
    }
    num_points_ += points.size();
  }

  Result<certificate::Bytes> finish(certificate::Subject subject,
                                    certificate::AnswersSubject answers) {
    subject.reading_rule = kReadingRule;  // every certificate of the claim has the key
    certificate::PointsBody body;
    body.num_faces = static_cast<std::uint32_t>(patches_.complex->patches().size());
    body.num_vertex_ids = static_cast<std::uint32_t>(patches_.entities.size());
    body.num_points = num_points_;
    body.codes = codes_.take();
    if (num_irrational_ != 0)
      return Error{Code::kOverLimit,
                   {},
                   "for " + std::to_string(num_irrational_) +
                       " points on the surface the parameters are not known as polynomials of one "
                       "root of a polynomial"};
    if (!std::ranges::all_of(patches_.entities, breaks_fit_certificate))
      return Error{Code::kOverLimit, {}, "the knots are longer than certificates may have them"};
    if (kBytesOfPatch * body.num_faces > subject.bytes + body.codes.size())
      return Error{
          Code::kOverLimit, {}, "there are more patches than checkers accept for so few bytes"};
    answers.points = num_points_;
    answers.on = num_on_;
    answers.undecided = num_undecided_;
    return certificate::encode(subject, answers, body);
  }

 private:
  template <typename Point>
  void add_on(const Point& p) {
    std::optional<OnPatch> where;
    classifier_.classify(p, &where, PatchClassifier::Search::kLong);
    VT_CHECK(where.has_value(), "a point on a patch has parameters");
    ++num_on_;
    if (const auto place = place_on_patch(*patches_.complex, *where))
      std::visit([&](const auto& p) { codes_.add(p); }, place->code);
    else
      ++num_irrational_;
  }

  const FilePatches& patches_;
  const PatchClassifier& classifier_;
  const PatchDirections directions_;
  certificate::PatchCodes codes_;
  std::uint64_t num_points_ = 0, num_on_ = 0, num_undecided_ = 0, num_irrational_ = 0;
};

PatchPointsCertifier::PatchPointsCertifier(const FilePatches& patches,
                                           const PatchClassifier& classifier)
    : body_(std::make_unique<Body>(patches, classifier)) {}
PatchPointsCertifier::PatchPointsCertifier(PatchPointsCertifier&&) noexcept = default;
PatchPointsCertifier::~PatchPointsCertifier() = default;

void PatchPointsCertifier::add(std::span<const Vec3d> points,
                               std::span<const std::pair<std::size_t, ExactPoint>> exact,
                               std::span<const PointAnswer> answers) {
  body_->add(points, exact, answers);
}

Result<certificate::Bytes> PatchPointsCertifier::finish(const certificate::Subject& subject,
                                                        certificate::AnswersSubject answers) {
  return body_->finish(subject, std::move(answers));
}

}  // namespace veritope
