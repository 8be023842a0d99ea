// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_points.h"

#include <algorithm>
#include <utility>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/fit/fit_frame.h"

namespace veritope {
namespace {

constexpr int kMaxSteps = 400;  // of a walk
constexpr double kSlack =
    -1e-9;  // of barycentric coordinates: rounding takes a point off its tetrahedron

using Lambda = std::array<std::array<double, 4>, 4>;

class Walk {
 public:
  explicit Walk(const DmsModel& model)
      : complex_(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())) {
    for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t)
      lambda_.push_back(fit_frame(last_knots(model, t, {})).lambda);
  }

  std::uint32_t find(std::uint32_t from, const std::array<double, 3>& u) const {
    std::uint32_t t = from;
    for (int i = 0; i < kMaxSteps; ++i) {
      const auto [corner, least] = lowest(t, u);
      if (least >= 0) return t;
      const auto next = complex_.partner(4 * t + corner);
      if (!next) break;
      t = face_tetrahedron(*next);
    }
    if (lowest(t, u).second >= kSlack) return t;
    return best(u);
  }

 private:
  std::pair<std::uint32_t, double> lowest(std::uint32_t t, const std::array<double, 3>& u) const {
    std::pair<std::uint32_t, double> out{0, 2};
    for (std::uint32_t m = 0; m < 4; ++m) {
      const auto& l = lambda_[t][m];
      const double at = l[0] + l[1] * u[0] + l[2] * u[1] + l[3] * u[2];
      if (at < out.second) out = {m, at};
    }
    return out;
  }
  std::uint32_t best(const std::array<double, 3>& u) const {
    std::pair<double, std::uint32_t> most{lowest(0, u).second, 0};
    for (std::uint32_t t = 1; t < lambda_.size(); ++t)
      if (const double at = lowest(t, u).second; at > most.first) most = {at, t};
    return most.second;
  }

  TetrahedralComplex complex_;
  std::vector<Lambda> lambda_;
};

}  // namespace

FitPoints find_fit_points(const DmsModel& model, const DmsData& data) {
  const DmsEvaluator evaluator(model);
  FitPoints out;
  out.data = &data;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const DmsPoint& p = data.points[i];
    const auto place = evaluator.locate(p);
    if (!place) {
      out.outside.push_back(i);
      continue;
    }
    out.number.push_back(i);
    out.at.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
    for (std::size_t a = 0; a < data.num_attributes; ++a)
      out.values.push_back(nearest_double(data.value(i, a)));
    out.tetrahedron.push_back(place->tetrahedron);
    out.needs_target.push_back(place->path.target().has_value());
  }
  return out;
}

void move_fit_points(const DmsModel& model, FitPoints& points) {
  const Walk walk(model);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.tetrahedron[i] = walk.find(points.tetrahedron[i], points.at[i]);
}

}  // namespace veritope
