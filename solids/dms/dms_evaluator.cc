// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_evaluator.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_table.h"
#include "splines/dms_spline.h"

namespace veritope {
namespace {

// Frames are kept up to this number: some 700 bytes each, and more where coordinates are long.
constexpr std::size_t kMaxKeptFrames = std::size_t{1} << 17;

// Bounds beyond the largest number become it, so that boxes that have a point in common still do.
double clamped(double v) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return std::clamp(v, -kMost, kMost);
}
Box3d box_of(const ExactPoint3& p) {
  Box3d box{};
  for (std::size_t c = 0; c < 3; ++c) {
    box.lo[c] = clamped(round_down(p.at()[c]));
    box.hi[c] = clamped(round_up(p.at()[c]));
  }
  return box;
}

// Whether the closed tetrahedron contains the point. Nothing for a degenerate one.
bool holds(const std::array<const ExactPoint3*, 4>& t, const ExactPoint3& u) {
  const Sign s = orient3d(*t[0], *t[1], *t[2], *t[3]);
  if (s == Sign::kZero) return false;
  for (std::size_t m = 0; m < 4; ++m) {
    std::array<const ExactPoint3*, 4> moved = t;
    moved[m] = &u;
    if (orient3d(*moved[0], *moved[1], *moved[2], *moved[3]) == -s) return false;
  }
  return true;
}

ExactPoint3 mean(const std::array<const ExactPoint3*, 4>& t) {
  std::array<Rational, 3> sum;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const ExactPoint3* p : t) sum[c] += p->at()[c];
    sum[c] /= Rational(4);
  }
  return ExactPoint3(std::move(sum));
}

}  // namespace

namespace internal {

const SimplexFrame<Rational>* DmsTable::frame_of(const std::array<KnotNumber, 4>& four) {
  const std::uint32_t key = static_cast<std::uint32_t>(four[0]) << 24 |
                            static_cast<std::uint32_t>(four[1]) << 16 |
                            static_cast<std::uint32_t>(four[2]) << 8 | four[3];
  const auto [place, is_new] = frames_.try_emplace(key);
  if (is_new) {
    std::array<std::array<Rational, 3>, 4> at;
    for (std::size_t m = 0; m < 4; ++m) at[m] = points_[four[m]]->at();
    const Sign s =
        orient3d(*points_[four[0]], *points_[four[1]], *points_[four[2]], *points_[four[3]]);
    if (s != Sign::kZero) place->second = simplex_frame<Rational>(four, at, s);
  }
  return place->second ? &*place->second : nullptr;
}

const SimplexFrame<Rational>* DmsTable::frame(const KnotSet& set) {
  const auto found = chosen_.find(set);
  if (found != chosen_.end()) return found->second;
  return chosen_
      .emplace(set, choose_frame(set, [this](const auto& four) { return frame_of(four); }))
      .first->second;
}

DmsKnots dms_knots(const DmsModel& model, std::uint32_t tetrahedron) {
  DmsKnots knots;
  for (std::size_t m = 0; m < 4; ++m) {
    const DmsCloud& cloud = model.clouds[model.tetrahedra[tetrahedron][m]];
    for (std::size_t i = 0; i <= kMaxDmsDegree; ++i) {
      // A knot that is an earlier one of its cloud has its number.
      std::size_t first = i < cloud.size() ? i : 0;
      for (std::size_t k = 0; k < first; ++k)
        if (cloud[k] == cloud[first]) first = k;
      knots.number[m][i] = static_cast<KnotNumber>(m * kKnotsOfCorner + first);
    }
  }
  return knots;
}

DmsTable make_dms_table(const DmsModel& model, std::uint32_t tetrahedron,
                        const std::vector<ExactPoint3>& all,
                        const std::vector<std::size_t>& first_knot) {
  const DmsKnots knots = dms_knots(model, tetrahedron);
  std::array<const ExactPoint3*, 4 * kKnotsOfCorner> points{};
  for (std::size_t m = 0; m < 4; ++m)
    for (const KnotNumber number : knots.number[m])
      points[number] = &all[first_knot[model.tetrahedra[tetrahedron][m]] + number % kKnotsOfCorner];
  return DmsTable(knots, points);
}

}  // namespace internal

DmsEvaluator::DmsEvaluator(const DmsModel& model) : model_(model) {
  for (const DmsCloud& cloud : model.clouds) {
    first_knot_.push_back(knots_.size());
    for (const DmsPoint& knot : cloud) knots_.emplace_back(knot);
  }
  std::vector<Box3d> cloud_boxes;
  for (std::size_t v = 0; v < model.clouds.size(); ++v) {
    Box3d box = empty_box();
    for (std::size_t i = 0; i < model.clouds[v].size(); ++i)
      box = hull(box, box_of(knots_[first_knot_[v] + i]));
    cloud_boxes.push_back(box);
  }
  for (const TetrahedronCorners& t : model.tetrahedra) {
    Box3d corners = empty_box(), all = empty_box();
    for (const std::uint32_t v : t) {
      corners = hull(corners, box_of(knots_[first_knot_[v]]));
      all = hull(all, cloud_boxes[v]);
    }
    corner_boxes_.push_back(corners);
    knot_boxes_.push_back(all);
  }
  by_corners_ = BoxHierarchy(corner_boxes_);
  by_knots_ = BoxHierarchy(knot_boxes_);
}

DmsEvaluator::~DmsEvaluator() = default;

std::vector<std::uint32_t> DmsEvaluator::near(const ExactPoint3& point) const {
  return near(box_of(point));
}

std::vector<std::uint32_t> DmsEvaluator::near(const Box3d& at) const {
  std::vector<std::uint32_t> found;
  by_knots_.visit([&](const Box3d& box) { return meets(box, at); },
                  [&](std::uint32_t t) { found.push_back(t); });
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<DmsPlace> DmsEvaluator::locate(const DmsPoint& point) const {
  const ExactPoint3 u(point);
  const Box3d at = box_of(u);
  std::vector<std::uint32_t> candidates;
  by_corners_.visit([&](const Box3d& box) { return meets(box, at); },
                    [&](std::uint32_t t) { candidates.push_back(t); });
  std::sort(candidates.begin(), candidates.end());
  const auto corners = [&](std::uint32_t t) {
    std::array<const ExactPoint3*, 4> out{};
    for (std::size_t m = 0; m < 4; ++m) out[m] = &knots_[first_knot_[model_.tetrahedra[t][m]]];
    return out;
  };
  EntryPath axes = EntryPath::along_axes(u);
  for (const std::uint32_t t : candidates)
    if (is_entered(corners(t), axes)) return DmsPlace{t, std::move(axes)};
  for (const std::uint32_t t : candidates)
    if (holds(corners(t), u)) return DmsPlace{t, EntryPath::inward(u, mean(corners(t)))};
  return std::nullopt;
}

internal::DmsTable& DmsEvaluator::table(std::uint32_t tetrahedron) {
  const auto found = tables_.find(tetrahedron);
  if (found != tables_.end()) return *found->second;
  auto made = std::make_unique<internal::DmsTable>(make_table(tetrahedron));
  return *tables_.emplace(tetrahedron, std::move(made)).first->second;
}

internal::DmsTable DmsEvaluator::make_table(std::uint32_t tetrahedron) const {
  return internal::make_dms_table(model_, tetrahedron, knots_, first_knot_);
}

void DmsEvaluator::drop_tables_if_many() {
  if (num_frames_ > kMaxKeptFrames) tables_.clear(), num_frames_ = 0;
}

// The components from the first one on, as many as `sums` has.
void DmsEvaluator::add_terms(const DmsPlace& place, std::size_t first_component,
                             DmsSums<Rational>& sums) {
  drop_tables_if_many();
  const ExactPoint3& u = place.path.start();
  for (const std::uint32_t t : near(u)) {
    internal::DmsTable& frames = table(t);
    const std::size_t before = frames.num_frames();
    internal::DmsAnswers answers(frames, place.path);
    SimplexSplines<Rational, internal::DmsAnswers> splines(answers, u.at());
    const auto control = [&](const TetrahedralIndex& beta) {
      return model_.value(control_of(model_, t, beta)).subspan(first_component);
    };
    if (model_.control.is_separate) {
      add_dms_terms_of_degree_n(splines, frames.knots(), model_.degree, control, sums);
    } else {
      add_dms_terms(splines, frames.knots(), model_.degree, control, sums);
    }
    num_frames_ += frames.num_frames() - before;
  }
}

DmsValue DmsEvaluator::evaluate(const DmsPlace& place) {
  DmsSums<Rational> sums(model_.num_components());
  add_terms(place, 0, sums);
  return {std::move(sums.value), std::move(sums.gradient)};
}

Rational DmsEvaluator::component(const DmsPlace& place, std::size_t number) {
  DmsSums<Rational> sums(1);
  sums.gradient.clear();
  add_terms(place, number, sums);
  return std::move(sums.value[0]);
}

std::vector<DmsEvaluator::Basis> DmsEvaluator::basis(std::uint32_t tetrahedron,
                                                     const EntryPath& path, int sum) {
  VT_CHECK(sum >= 0 && sum <= model_.degree, "basis functions of degrees up to the model's");
  internal::DmsTable& frames = table(tetrahedron);
  internal::DmsAnswers answers(frames, path);
  SimplexSplines<Rational, internal::DmsAnswers> splines(answers, path.start().at());
  std::vector<Basis> out;
  for_each_dms_basis(
      splines, frames.knots(), sum,
      [&](const TetrahedralIndex& gamma, const SimplexFrame<Rational>&, const Rational& value) {
        out.push_back({gamma, value});
      });
  return out;
}

}  // namespace veritope
