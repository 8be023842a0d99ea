// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/expression_points_certifier.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "io/mesh/reading_rule.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/expression/decision_diagram.h"
#include "verify/certify/point_codes.h"

namespace veritope {
namespace {

constexpr std::size_t kChunkOfExpressions = 64;
// The limits of docs/certificates/points.md, section 7.
constexpr std::size_t kMostTabulated = 12;
constexpr std::size_t kBytesOfFlatPatch = 3;
constexpr std::uint64_t kMostWedgeUnits = std::uint64_t{1} << 22;
constexpr std::uint64_t kFreeWedgeUnits = std::uint64_t{1} << 23, kWedgeUnitsOfPoint = 4096;

bool holds(const ExactBox<3>& box, const ExactPoint& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!box[k].contains(p[k])) return false;
  return true;
}

// What is known of a solid at a point.
struct Knowledge {
  Value3 value = Value3::kMixed;
  bool is_on = false;  // on its boundary; otherwise, if the value is mixed, nothing is known
  RayDirection ray;    // if the value is 0 or 1
  std::uint32_t facet = 0;
  std::optional<CertifiedPlace> place;
  OperandPlace operand_place;
};

struct CertifiedPoint {
  certificate::Bytes codes;
  std::uint64_t units = 0, wedge_units = 0;
  bool is_covered = true;
};

// One variable of the expression.
class CertifiedSolid {
 public:
  CertifiedSolid(ExpressionSolid solid, unsigned jobs)
      : solid_(std::move(solid)), parts_(solid_.operand->parts()) {
    if (parts_.mesh != nullptr) mesh_directions_.emplace(*parts_.mesh, jobs);
    if (parts_.patches != nullptr) patch_directions_.emplace(*parts_.patches);
    for (std::size_t k = 0; k < 3; ++k) {
      within_.lo[k] = round_up(solid_.box[k].lo);
      within_.hi[k] = round_down(solid_.box[k].hi);
    }
  }

  const ExpressionSolid& solid() const { return solid_; }
  const OperandParts& parts() const { return parts_; }
  bool is_box() const { return parts_.mesh == nullptr && parts_.patches == nullptr; }

  // Roundings are monotone: binary64 numbers compare with a bound as with its rounding to their side.
  bool box_has(const Vec3d& p) const { return is_inside({to_point(p), to_point(p)}, within_); }
  bool box_has(const ExactPoint& p) const { return holds(solid_.box, p); }

  // @param rounded  the point, or near it
  template <typename Point>
  Knowledge at(const Point& p, const Vec3d& rounded) const {
    Knowledge out;
    if (is_box()) {
      out.operand_place = solid_.operand->place(p);
      out.value = out.operand_place.value;
      out.is_on = out.value == Value3::kMixed;
      return out;
    }
    std::optional<OnPatch> where;
    const PointAnswer answer =
        parts_.mesh != nullptr
            ? parts_.mesh_classifier->classify(p)
            : parts_.patch_classifier->classify(p, &where, PatchClassifier::Search::kLong);
    if (answer.is_decided && !answer.is_on()) {
      out.value = to_value(answer.winding != 0);
      if (mesh_directions_) out.ray = mesh_directions_->from(rounded);
      if (patch_directions_) out.ray.code = patch_directions_->from(rounded);
    } else if (answer.is_decided && parts_.mesh != nullptr) {
      out.is_on = true;
      out.facet = answer.facet;
    } else if (where) {
      out.place = place_on_patch(*parts_.patches, *where);
      out.operand_place = {Value3::kMixed, false, std::move(where)};
      out.is_on = out.place.has_value();
    }
    return out;
  }

  // The number of wedges into which checkers cut the walls at a point on them, or more; nothing if these are not all
  // flat, or not known as exact numbers.
  std::optional<std::uint64_t> num_wedges(const Knowledge& known, const ExactPoint& p) const {
    if (known.place && !known.place->is_located) return std::nullopt;
    const std::optional<TangentCone> cone = solid_.operand->tangent_cone(p, known.operand_place);
    if (!cone || !cone->is_flat) return std::nullopt;
    const std::uint64_t corners = parts_.mesh != nullptr ? 3 : 4;  // of a patch, at most
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < cone->sectors.size(); ++i) {
      const ConeSheet& sheet = cone->sheets[i];
      // At a collapsed side checkers take one wedge, if the patch leaves it within less than a half turn.
      if (sheet.pole && !is_uncut(sheet)) return std::nullopt;
      out += sheet.pole ? 1 : corners - cone->sectors[i].inward.size();
    }
    return out;
  }

 private:
  static bool is_uncut(const ConeSheet& sheet) {
    return sheet.pole_part[0].sign() == 0 && sheet.pole_part[1] == Rational(1);
  }

  const ExpressionSolid solid_;
  const OperandParts parts_;
  std::optional<MeshDirections> mesh_directions_;
  std::optional<PatchDirections> patch_directions_;
  Box3d within_;
};

void add_code(const Knowledge& known, bool is_mesh, certificate::ExpressionCodes& codes) {
  if (is_constant(known.value))
    codes.add_off(known.value == Value3::kOne, known.ray.code);
  else if (!known.is_on)
    codes.add_open();
  else if (is_mesh)
    codes.add_on(known.facet);
  else
    std::visit([&](const auto& place) { codes.add_on(place); }, known.place->code);
}

}  // namespace

class ExpressionPointsCertifier::Body {
 public:
  Body(const Formula& formula, std::vector<ExpressionSolid> solids, std::uint64_t num_leaves,
       unsigned jobs)
      : formula_(formula), num_leaves_(num_leaves), jobs_(jobs) {
    for (ExpressionSolid& solid : solids)
      solids_.push_back(std::make_unique<const CertifiedSolid>(std::move(solid), jobs));
  }

  void add(std::span<const Vec3d> points, std::span<const std::pair<std::size_t, ExactPoint>> exact,
           std::span<const PointWord> words) {
    std::vector<const ExactPoint*> exact_at(points.size(), nullptr);
    for (const auto& [i, point] : exact) exact_at[i] = &point;
    std::vector<CertifiedPoint> done(points.size());
    parallel_for(points.size(), kChunkOfExpressions, jobs_,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     if (words[i] != PointWord::kUndecided)
                       done[i] = exact_at[i] != nullptr ? prove(*exact_at[i], points[i], words[i])
                                                        : prove(points[i], points[i], words[i]);
                 });
    for (std::size_t i = 0; i < points.size(); ++i) {
      ++num_points_;
      num_on_ += words[i] == PointWord::kOn ? 1u : 0u;
      num_undecided_ += words[i] == PointWord::kUndecided ? 1u : 0u;
      take(std::move(done[i]));
    }
  }

  std::uint64_t num_uncovered() const { return num_uncovered_; }

  Result<certificate::Bytes> finish(certificate::Subject subject,
                                    certificate::AnswersSubject answers) {
    subject.reading_rule = kReadingRule;
    certificate::ExpressionHeader header(num_uncovered_);
    certificate::PointsBody body;
    for (const auto& solid : solids_) {
      if (solid->is_box()) continue;
      ++body.num_faces;
      if (const Status status = add_to(header, *solid); !status) return status.error();
    }
    body.num_vertex_ids = static_cast<std::uint32_t>(num_leaves_);
    body.num_points = num_points_;
    body.codes = header.take();
    body.codes.insert(body.codes.end(), codes_.begin(), codes_.end());
    codes_.clear();
    if (units_ > 10 * num_facets() + 1000 * (num_points_ + body.codes.size()))
      return Error{Code::kOverLimit, {}, "the points need more work than checkers may spend"};
    answers.points = num_points_;
    answers.on = num_on_;
    answers.undecided = num_undecided_;
    return certificate::encode(subject, answers, body);
  }

 private:
  // What the checkers ask for, in their order, and what they conclude.
  template <typename Point>
  CertifiedPoint prove(const Point& p, const Vec3d& rounded, PointWord word) const {
    std::vector<std::pair<std::uint32_t, Knowledge>> asked;
    const auto value_of = [&](std::uint32_t v) {
      const auto found = std::ranges::find(asked, v, &std::pair<std::uint32_t, Knowledge>::first);
      if (found != asked.end()) return found->second.value;
      Knowledge known;
      known.value = Value3::kZero;
      if (!solids_[v]->box_has(p)) return known.value;
      known = solids_[v]->at(p, rounded);
      asked.emplace_back(v, std::move(known));
      return asked.back().second.value;
    };
    const Value3 value = formula_.value(value_of);
    CertifiedPoint out;
    if (is_constant(value))
      VT_CHECK((value == Value3::kOne) == (word == PointWord::kIn) && word != PointWord::kOn,
               "the word of a point is that of its solids");
    else
      conclude(formula_.folded(value_of), asked, exact_of(p), out);
    certificate::ExpressionCodes codes;
    if (!out.is_covered) codes.add_uncovered();
    for (const auto& [v, known] : asked) {
      if (!out.is_covered || solids_[v]->is_box()) continue;
      out.units += known.ray.units;
      add_code(known, solids_[v]->parts().mesh != nullptr, codes);
    }
    out.codes = codes.take();
    return out;
  }
  static ExactPoint exact_of(const ExactPoint& p) { return p; }
  static ExactPoint exact_of(const Vec3d& p) {
    return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
  }

  // Whether checkers can decide by the solids that are mixed: none of them matters, or one, or all that do are flat.
  void conclude(const Formula& rest, const std::vector<std::pair<std::uint32_t, Knowledge>>& asked,
                const ExactPoint& p, CertifiedPoint& out) const {
    const auto num_mixed = std::ranges::count_if(
        asked, [](const auto& a) { return a.second.value == Value3::kMixed; });
    const bool is_tabulated = static_cast<std::size_t>(num_mixed) <= kMostTabulated;
    const auto matters =
        [&, support = is_tabulated ? support_of(rest) : std::vector<std::uint32_t>()](
            std::uint32_t v) { return !is_tabulated || std::ranges::binary_search(support, v); };
    std::vector<const std::pair<std::uint32_t, Knowledge>*> relevant;
    for (const auto& a : asked)
      if (a.second.value == Value3::kMixed && matters(a.first)) relevant.push_back(&a);
    if (!std::ranges::all_of(relevant, [](const auto* a) { return a->second.is_on; })) {
      out.is_covered = false;
      return;
    }
    if (relevant.size() < 2) return;
    std::uint64_t wedges = 0;
    for (const auto* a : relevant) {
      const auto more = solids_[a->first]->num_wedges(a->second, p);
      out.is_covered = out.is_covered && more.has_value();
      wedges += more.value_or(0);
    }
    constexpr std::uint64_t kMany = 1000;
    const std::uint64_t evaluations = is_tabulated ? 1 : 1 + num_leaves_ / 64;
    out.wedge_units = wedges < kMany
                          ? (wedges * wedges + wedges * wedges * wedges / 32) * evaluations
                          : kMostWedgeUnits + 1;
  }
  static std::vector<std::uint32_t> support_of(const Formula& formula) {
    const auto diagram = DecisionDiagram::make(formula, std::size_t{1} << (kMostTabulated + 1));
    VT_CHECK(diagram.has_value(), "few variables have a small diagram");
    return diagram->support();
  }

  void take(CertifiedPoint point) {
    wedge_units_ += point.wedge_units;
    if (point.is_covered && point.wedge_units > 0 &&
        (point.wedge_units > kMostWedgeUnits ||
         wedge_units_ > kFreeWedgeUnits + kWedgeUnitsOfPoint * num_points_)) {
      wedge_units_ -= point.wedge_units;
      certificate::ExpressionCodes codes;
      codes.add_uncovered();
      point = {codes.take(), 0, 0, false};
    }
    units_ += point.units;
    num_uncovered_ += point.is_covered ? 0u : 1u;
    codes_.insert(codes_.end(), point.codes.begin(), point.codes.end());
  }

  Status add_to(certificate::ExpressionHeader& header, const CertifiedSolid& solid) const {
    if (const TriangleMesh* const mesh = solid.parts().mesh) {
      header.add_mesh(static_cast<std::uint32_t>(mesh->faces.size()),
                      static_cast<std::uint32_t>(mesh->positions.size()));
      return ok_status();
    }
    const auto num_patches = static_cast<std::uint32_t>(solid.parts().patches->patches().size());
    if (!std::ranges::all_of(solid.solid().entities, breaks_fit_certificate))
      return Error{Code::kOverLimit, {}, "the knots are longer than certificates may have them"};
    if (kBytesOfFlatPatch * num_patches > solid.solid().bytes + codes_.size())
      return Error{
          Code::kOverLimit, {}, "there are more patches than checkers accept for so few bytes"};
    header.add_patches(solid.solid().is_by_faces, num_patches,
                       to_certificate(solid.solid().entities));
    return ok_status();
  }
  std::uint64_t num_facets() const {
    std::uint64_t out = 0;
    for (const auto& solid : solids_)
      if (solid->parts().mesh != nullptr) out += solid->parts().mesh->faces.size();
    return out;
  }

  const Formula formula_;
  const std::uint64_t num_leaves_;
  const unsigned jobs_;
  std::vector<std::unique_ptr<const CertifiedSolid>> solids_;
  certificate::Bytes codes_;
  std::uint64_t num_points_ = 0, num_on_ = 0, num_undecided_ = 0, num_uncovered_ = 0;
  std::uint64_t units_ = 0, wedge_units_ = 0;
};

ExpressionPointsCertifier::ExpressionPointsCertifier(const Formula& formula,
                                                     std::vector<ExpressionSolid> solids,
                                                     std::uint64_t num_leaves, unsigned jobs)
    : body_(std::make_unique<Body>(formula, std::move(solids), num_leaves, jobs)) {}
ExpressionPointsCertifier::ExpressionPointsCertifier(ExpressionPointsCertifier&&) noexcept =
    default;
ExpressionPointsCertifier::~ExpressionPointsCertifier() = default;

void ExpressionPointsCertifier::add(std::span<const Vec3d> points,
                                    std::span<const std::pair<std::size_t, ExactPoint>> exact,
                                    std::span<const PointWord> words) {
  body_->add(points, exact, words);
}

std::uint64_t ExpressionPointsCertifier::num_uncovered() const { return body_->num_uncovered(); }

Result<certificate::Bytes> ExpressionPointsCertifier::finish(certificate::Subject subject,
                                                             certificate::AnswersSubject answers) {
  return body_->finish(std::move(subject), std::move(answers));
}

}  // namespace veritope
