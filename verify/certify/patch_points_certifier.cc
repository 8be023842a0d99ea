// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_points_certifier.h"

#include <algorithm>
#include <limits>

#include "io/mesh/reading_rule.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr std::uint64_t kBytesOfPatch = 3;  // of the model and the body: B1 of the page

// Approximately.
Box3d box_of(const PatchComplex& complex) {
  Box3d out = empty_box();
  for (const Patch& patch : complex.patches())
    for (std::size_t i = 0; i < patch.num_control(); ++i) {
      Point3d at{};
      for (int k = 0; k < 3; ++k) {
        Rational x = patch.component(k)[i];
        if (patch.is_rational()) x /= patch.component(3)[i];
        at[static_cast<std::size_t>(k)] = nearest_double(x);
      }
      add(at, &out);
    }
  return out;
}

}  // namespace

class PatchPointsCertifier::Body {
 public:
  Body(const FilePatches& patches, const PatchClassifier& classifier)
      : patches_(patches),
        classifier_(classifier),
        box_(box_of(*patches.complex)),
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
        codes_.add_direction(direction_from(points[i]));
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
                       " points on the surface no common generator of both irrational parameters "
                       "was found"};
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
  // That in which the model ends soonest: few patches lie there.
  std::uint8_t direction_from(const Vec3d& p) const {
    const Point3d at = to_point(p);
    std::uint8_t out = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint8_t code = 0; code < 6; ++code) {
      const std::size_t k = code / 2u;
      const double length = code % 2 == 0 ? box_.hi[k] - at[k] : at[k] - box_.lo[k];
      if (length < least) least = length, out = code;
    }
    return out;
  }

  template <typename Point>
  void add_on(const Point& p) {
    std::optional<OnPatch> where;
    classifier_.classify(p, &where);
    VT_CHECK(where.has_value(), "a point on a patch has parameters");
    ++num_on_;
    // The certificate has barycentric coordinates of triangles.
    const bool is_triangle = patches_.complex->patch(where->patch).is_triangle();
    if (where->parameters.is_rational()) {
      const Rational &u = where->parameters[0].lo, &v = where->parameters[1].lo;
      codes_.add(certificate::PointOnPatch{where->patch,
                                           {to_fraction(is_triangle ? u * (Rational(1) - v) : u),
                                            to_fraction(is_triangle ? u * v : v)}});
      return;
    }
    std::optional<PrimitivePair> pair = primitive_pair(where->parameters);
    if (!pair) {
      ++num_irrational_;
      return;
    }
    if (is_triangle) {
      auto& [u, v] = pair->numbers;
      std::vector<Rational> rest = v;  // 1 - v
      for (Rational& x : rest) x.negate();
      rest.front() += Rational(1);
      std::vector<Rational> second = product_modulo(u, v, pair->modulus);
      u = product_modulo(u, rest, pair->modulus);
      v = std::move(second);
    }
    codes_.add(certificate::AlgebraicPointOnPatch{
        where->patch,
        fractions(pair->modulus),
        {to_fraction(pair->lo), to_fraction(pair->hi)},
        {fractions(pair->numbers[0]), fractions(pair->numbers[1])}});
  }

  static std::vector<certificate::Fraction> fractions(const std::vector<Rational>& polynomial) {
    std::vector<certificate::Fraction> out;
    for (const Rational& x : polynomial) out.push_back(to_fraction(x));
    return out;
  }

  const FilePatches& patches_;
  const PatchClassifier& classifier_;
  const Box3d box_;
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
