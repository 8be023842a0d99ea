// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_draw_clouds.cc: clouds drawn at random and made smaller until they are admissible
// (solids/dms/dms_make.h).
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "predicates/exact_point.h"
#include "robust/base/random.h"
#include "solids/dms/dms_admissible.h"
#include "solids/dms/dms_make.h"

namespace veritope {
namespace {

constexpr int kMaxDraws = 64;     // for a knot that must lie on no inner side of a face
constexpr int kMaxHalvings = 40;  // of a cloud, before it collapses
constexpr std::int64_t kSteps = std::int64_t{1} << 20;  // drawn numbers are multiples of 1 / kSteps

Rational largest_difference(const DmsPoint& a, const DmsPoint& b) {
  Rational most;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, abs(a[c] - b[c]));
  return most;
}

class CloudDraw {
 public:
  CloudDraw(DmsModel& model, const DmsCloudDraw& draw)
      : model_(model),
        draw_(draw),
        admissibility_(model),
        complex_(admissibility_.complex()),
        faces_at_(model.clouds.size()),
        halvings_(model.clouds.size()) {
    for (const TetrahedronFace f : complex_.boundary())
      for (const std::uint32_t v : complex_.vertices(f)) faces_at_[v].push_back(f);
  }

  void run() {
    if (model_.degree == 1) return;  // t_1 has no effect
    for (std::uint32_t v = 0; v < model_.clouds.size(); ++v) draw_cloud(v);
    for (std::set<std::uint32_t> bad = inadmissible(); !bad.empty(); bad = inadmissible())
      for (const std::uint32_t v : bad) halve(v);
  }

 private:
  void draw_cloud(std::uint32_t v) {
    const auto at = complex_.tetrahedra_at(v);
    if (at.empty() || draw_.radius.sign() == Sign::kZero) return;
    std::optional<Rational> shortest;
    for (const std::uint32_t t : at)
      for (const std::uint32_t w : model_.tetrahedra[t]) {
        if (w == v) continue;
        Rational edge = largest_difference(model_.clouds[v][0], model_.clouds[w][0]);
        if (!shortest || edge < *shortest) shortest = std::move(edge);
      }
    Random random(draw_.seed ^ (std::uint64_t{v} * 0x9e3779b97f4a7c15u));
    for (int i = 1; i < model_.degree; ++i)
      model_.clouds[v].push_back(draw_knot(v, draw_.radius * *shortest, random));
  }
  DmsPoint draw_knot(std::uint32_t v, const Rational& reach, Random& random) const {
    for (int i = 0; i < kMaxDraws; ++i) {
      DmsPoint knot = model_.clouds[v][0];
      for (Rational& c : knot)
        c += reach * Rational(random.between(-kSteps, kSteps)) / Rational(kSteps);
      const ExactPoint3 exact(knot);
      const bool is_outward =
          std::all_of(faces_at_[v].begin(), faces_at_[v].end(), [&](TetrahedronFace f) {
            return admissibility_.side_of_face(f, exact) != Sign::kNegative;
          });
      if (is_outward) return knot;
    }
    return model_.clouds[v][0];
  }
  bool is_collapsed(std::uint32_t v) const { return model_.clouds[v].size() == 1; }

  void halve(std::uint32_t v) {
    DmsCloud& cloud = model_.clouds[v];
    if (++halvings_[v] > kMaxHalvings) cloud.resize(1);
    for (std::size_t i = 1; i < cloud.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) cloud[i][c] = (cloud[i][c] + cloud[0][c]) / Rational(2);
  }

  // Vertices whose clouds are not proved to be admissible and are not collapsed.
  std::set<std::uint32_t> inadmissible() const {
    std::set<std::uint32_t> bad;
    const auto add = [&](const auto& vertices) {
      for (const std::uint32_t v : vertices)
        if (!is_collapsed(v)) bad.insert(v);
    };
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t)
      if (!admissibility_.has_core(t)) add(model_.tetrahedra[t]);
    for (const TetrahedronFace f : complex_.boundary())
      if (!admissibility_.misses_inside(f)) add(complex_.vertices(f));
    return bad;
  }

  DmsModel& model_;
  const DmsCloudDraw& draw_;
  DmsAdmissibility admissibility_;
  const TetrahedralComplex& complex_;
  std::vector<std::vector<TetrahedronFace>> faces_at_;  // of the boundary
  std::vector<int> halvings_;
};

}  // namespace

void internal::draw_clouds(DmsModel& model, const DmsCloudDraw& draw) {
  CloudDraw(model, draw).run();
}

}  // namespace veritope
