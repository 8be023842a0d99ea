// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solids/dms/dms_knots.h"
#include "solids/dms/fit/fit_frame.h"

namespace veritope {
namespace {

constexpr double kNear = 0x1p-30;  // a barycentric coordinate of a point near a face
constexpr double kStep = 0x1p-20, kSmaller = 0x1p-8;
constexpr double kMostSlope = 0x1p20;  // of barycentric coordinates, where the size is 1

bool has_open_cloud(const DmsModel& model, const TetrahedronCorners& t) {
  return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
    const DmsCloud& cloud = model.clouds[v];
    return std::any_of(cloud.begin(), cloud.end(),
                       [&](const DmsPoint& p) { return p != cloud[0]; });
  });
}

Box3d knot_box(const DmsModel& model, const TetrahedronCorners& t) {
  std::vector<DmsPoint> knots;
  for (const std::uint32_t v : t)
    knots.insert(knots.end(), model.clouds[v].begin(), model.clouds[v].end());
  return box_around(knots);
}

// The mean of the corners, and how far a corner is from it.
std::pair<std::array<double, 3>, double> centre_of(const DmsModel& model,
                                                   const TetrahedronCorners& t) {
  std::array<double, 3> middle{};
  for (const std::uint32_t v : t)
    for (std::size_t c = 0; c < 3; ++c) middle[c] += nearest_double(model.clouds[v][0][c]) / 4;
  double size = 0;
  for (std::size_t c = 0; c < 3; ++c)
    size = std::max(size, std::abs(nearest_double(model.clouds[t[0]][0][c]) - middle[c]));
  return {middle, size};
}

// The slope, an axis a row, of the affine map from W_γ to control points, as sums over the four.
using GammaSlope = std::array<std::pair<std::uint32_t, std::array<double, 3>>, 4>;

GammaSlope gamma_slope(const DmsModel& model, const FitControl& control, std::uint32_t t,
                       const TetrahedralIndex& gamma) {
  const FitFrame frame = fit_frame(last_knots(model, t, gamma));
  GammaSlope out;
  for (std::size_t m = 0; m < 4; ++m) {
    out[m].first = control.of(t, raised(gamma, m));
    for (std::size_t c = 0; c < 3; ++c) out[m].second[c] = frame.lambda[m][c + 1];
  }
  return out;
}

// At most 1, so that slopes in flat tetrahedra do not outweigh all others. They are of the order 1 / size.
double weight_of(const GammaSlope& slope, double size) {
  double most = 0;
  for (const auto& [number, along] : slope)
    for (const double x : along) most = std::max(most, std::abs(x));
  const double limit = kMostSlope / size;
  return most > limit ? limit / most : 1;
}

void add_difference(const GammaSlope& a, const GammaSlope& b, double weight, SparseRows& out) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<std::pair<int, double>> entries;
    for (std::size_t m = 0; m < 4; ++m) {
      entries.emplace_back(static_cast<int>(a[m].first), weight * a[m].second[c]);
      entries.emplace_back(static_cast<int>(b[m].first), -weight * b[m].second[c]);
    }
    out.add(entries);
  }
}

double size_of(const DmsModel& model, std::uint32_t t) {
  std::vector<DmsPoint> corners;
  for (const std::uint32_t v : model.tetrahedra[t]) corners.push_back(model.clouds[v][0]);
  const Box3d box = box_around(corners);
  return std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
}

}  // namespace

FitControl fit_control(const DmsModel& model) {
  FitControl out;
  out.count = model.num_control();
  out.per_tetrahedron = num_tetrahedral_indices(model.degree);
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t)
    for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
      out.number.push_back(static_cast<std::uint32_t>(control_of(model, t, beta)));
    });
  return out;
}

FitBasis::FitBasis(const DmsModel& model, const FitControl& control, const FitPoints& points,
                   bool with_knots)
    : model_(model), control_(control), points_(points), programs_(model, with_knots) {
  std::vector<Box3d> boxes;
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t) {
    is_flat_.push_back(has_flat_knots(model, t));
    if (is_flat_[t] && !exact_) exact_.emplace(model);
    is_open_.push_back(has_open_cloud(model, model.tetrahedra[t]));
    if (!is_open_[t]) continue;
    open_numbers_.push_back(t);
    boxes.push_back(knot_box(model, model.tetrahedra[t]));
  }
  open_ = BoxHierarchy(boxes);
  if (boxes.empty()) return;
  for (const TetrahedronCorners& t : model.tetrahedra) centres_.push_back(centre_of(model, t));
}

// A point on the way into the domain that rule H takes, which lies on no plane where the point itself lies on some.
std::array<double, 3> FitBasis::point_beside(std::size_t i) const {
  std::array<double, 3> at = points_.at[i];
  const auto& [middle, size] = centres_[points_.tetrahedron[i]];
  double step = kStep;
  if (points_.needs_target[i]) {
    for (std::size_t c = 0; c < 3; ++c) at[c] += step * (middle[c] - points_.at[i][c]);
    step *= kSmaller;
  }
  for (double& c : at) c += size * step, step *= kSmaller;
  return at;
}

// The tetrahedra that may have terms at point i, ascending.
std::vector<std::uint32_t> FitBasis::near(std::size_t i) const {
  const auto& u = points_.at[i];
  std::vector<std::uint32_t> near;
  if (!is_open_[points_.tetrahedron[i]]) near.push_back(points_.tetrahedron[i]);
  const Box3d at{{u[0], u[1], u[2]}, {u[0], u[1], u[2]}};
  open_.visit([&](const Box3d& box) { return meets(box, at); },
              [&](std::uint32_t k) { near.push_back(open_numbers_[k]); });
  std::sort(near.begin(), near.end());
  return near;
}

// visit(tetrahedron, program) after a run at point i, for all of them. REQUIRES that none of them is flat.
template <typename Visit>
void FitBasis::visit_terms(std::size_t i, std::span<const std::uint32_t> near, Visit visit) {
  const auto& u = points_.at[i];
  std::optional<std::array<double, 3>> beside;
  for (const std::uint32_t t : near) {
    const DmsProgram<double>& program = programs_.of(t);
    const auto least = [](const std::array<double, 4>& l) {
      return std::min({l[0], l[1], l[2], l[3]});
    };
    const auto contains = [&](std::uint32_t f) {
      if (!is_open_[t]) return true;
      const double height = least(run_.barycentric[f]);
      if (std::abs(height) > kNear) return height > 0;
      if (!beside) beside = point_beside(i);
      return least(program.frames[f].barycentric(*beside)) > 0;
    };
    run_program(program, u, contains, run_);
    visit(t, program);
  }
}

SparseRows FitBasis::rows() {
  SparseRows out;
  std::vector<std::pair<int, double>> entries;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    entries.clear();
    const std::vector<std::uint32_t> near = this->near(i);
    if (has_flat(near)) {
      add_exact_row(i, entries);
      out.add(entries);
      continue;
    }
    visit_terms(i, near, [&](std::uint32_t t, const DmsProgram<double>& program) {
      for (const auto& b : program.basis) {
        if (b.node == DmsProgram<double>::kNone || run_.value[b.node] == 0) continue;
        const double n = program.frames[b.frame].volume * run_.value[b.node];
        for (std::size_t m = 0; m < 4; ++m)
          entries.emplace_back(static_cast<int>(control_.of(t, raised(b.gamma, m))),
                               n * run_.barycentric[b.frame][m]);
      }
    });
    out.add(entries);
  }
  return out;
}

bool FitBasis::has_flat(std::span<const std::uint32_t> near) const {
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t t) { return is_flat_[t]; });
}

// The row of a point with flat tetrahedra near it, rounded at the end.
void FitBasis::add_exact_row(std::size_t i, std::vector<std::pair<int, double>>& entries) {
  const DmsPoint& u = points_.data->points[points_.number[i]];
  const auto place = exact_->locate(u);
  if (!place) return;
  exact_->for_each_basis(
      *place, model_.degree - 1,
      [&](std::uint32_t t, const TetrahedralIndex& gamma, const Rational& n) {
        const auto frame =
            simplex_frame<Rational>({0, 1, 2, 3}, last_knots(model_, t, gamma), Sign::kPositive);
        const auto lambda = frame.barycentric(u);
        for (std::size_t m = 0; m < 4; ++m)
          entries.emplace_back(static_cast<int>(control_.of(t, raised(gamma, m))),
                               nearest_double(n * lambda[m]));
      });
}

std::vector<KnotSlope> FitBasis::slopes(std::size_t i, std::span<const double> values,
                                        std::size_t num_attributes) {
  const double degree = model_.degree;
  std::vector<KnotSlope> out;
  const std::vector<std::uint32_t> near = this->near(i);
  if (has_flat(near)) return out;
  const auto slope_of = [&](std::uint32_t vertex, int index) -> KnotSlope& {
    for (KnotSlope& s : out)
      if (s.vertex == vertex && s.index == index) return s;
    return out.emplace_back(
        KnotSlope{vertex, index, std::vector<std::array<double, 3>>(num_attributes)});
  };
  std::vector<double> affine(num_attributes);
  std::vector<std::array<double, 3>> linear(num_attributes);
  visit_terms(i, near, [&](std::uint32_t t, const DmsProgram<double>& program) {
    for (const auto& b : program.basis) {
      const SimplexFrame<double>& frame = program.frames[b.frame];
      const auto& lambda = run_.barycentric[b.frame];
      const bool is_flat = b.node == DmsProgram<double>::kNone;
      const double n = is_flat ? 0 : frame.volume * run_.value[b.node];
      for (std::size_t a = 0; a < num_attributes; ++a) {
        affine[a] = 0, linear[a] = {};
        for (std::size_t m = 0; m < 4; ++m) {
          const double c = values[control_.of(t, raised(b.gamma, m)) * num_attributes + a];
          affine[a] += lambda[m] * c;
          for (std::size_t k = 0; k < 3; ++k) linear[a][k] += frame.lambda[m][k + 1] * c;
        }
      }
      for (const auto& doubled : b.doubled) {
        const auto rise = program_gradient(program, run_, doubled.node, model_.degree);
        const bool is_last = doubled.index == b.gamma[doubled.corner];
        if (rise == std::array<double, 3>{} && (n == 0 || !is_last)) continue;
        KnotSlope& slope = slope_of(model_.tetrahedra[t][doubled.corner], doubled.index);
        for (std::size_t a = 0; a < num_attributes; ++a)
          for (std::size_t k = 0; k < 3; ++k) {
            slope.along[a][k] -= frame.volume * affine[a] * rise[k] / degree;
            if (is_last)
              slope.along[a][k] += n * (frame.lambda[doubled.corner][k + 1] * affine[a] -
                                        lambda[doubled.corner] * linear[a][k]);
          }
      }
    }
  });
  return out;
}

SparseRows smoothness_rows(const DmsModel& model, const FitControl& control) {
  SparseRows out;
  const TetrahedralComplex complex(model.tetrahedra,
                                   static_cast<std::uint32_t>(model.clouds.size()));
  const int n = model.degree;
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t) {
    const double size = size_of(model, t), weight = std::sqrt(size);
    const auto add = [&](const GammaSlope& a, const GammaSlope& b) {
      add_difference(a, b, weight * std::min(weight_of(a, size), weight_of(b, size)), out);
    };
    for_each_tetrahedral_index(n - 1, [&](const TetrahedralIndex& gamma) {
      const GammaSlope slope = gamma_slope(model, control, t, gamma);
      // One step from corner m to the next one.
      for (std::size_t m = 0; m < 3; ++m) {
        if (gamma[m] == 0) continue;
        TetrahedralIndex other = raised(gamma, m + 1);
        --other[m];
        add(slope, gamma_slope(model, control, t, other));
      }
      for (std::uint32_t m = 0; m < 4; ++m) {
        if (gamma[m] > 0) continue;
        const auto across = complex.partner(4 * t + m);
        if (!across || *across < 4 * t + m) continue;
        const std::uint32_t beyond = face_tetrahedron(*across);
        TetrahedralIndex same{};
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t j = 0; j < 4; ++j)
            if (model.tetrahedra[t][i] == model.tetrahedra[beyond][j]) same[j] = gamma[i];
        add(slope, gamma_slope(model, control, beyond, same));
      }
    });
  }
  return out;
}

}  // namespace veritope
