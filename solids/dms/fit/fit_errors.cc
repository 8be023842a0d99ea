// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_errors.h"

#include <algorithm>

#include "interval/numeric.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_program.h"
#include "solids/dms/fit/fit_frame.h"
#include "solids/dms/fit/fit_rows.h"

namespace veritope {
namespace {

class ErrorSums {
 public:
  ErrorSums(const DmsModel& model, const DmsData& data)
      : model_(model),
        data_(data),
        evaluator_(model),
        programs_(model, false),
        control_(fit_control(model)),
        squares_(1 + data.num_attributes),
        most_(data.num_attributes) {
    for (const DmsCloud& cloud : model.clouds)
      is_open_.push_back(std::any_of(cloud.begin(), cloud.end(),
                                     [&](const DmsPoint& p) { return p != cloud[0]; }));
    for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t)
      is_flat_.push_back(has_flat_knots(model, t));
    for (const Rational& value : model.control.values) values_.push_back(enclose(value));
  }

  void add(std::size_t point) {
    const auto place = evaluator_.locate(data_.points[point]);
    if (!place) return;
    const std::vector<std::uint32_t> near = evaluator_.near(place->path.start());
    const bool is_near_flat =
        std::any_of(near.begin(), near.end(), [&](std::uint32_t t) { return is_flat_[t]; });
    // Enclosures of coordinates in flat tetrahedra say nothing.
    const DmsValue exact = is_near_flat ? evaluator_.evaluate(*place) : DmsValue();
    const ScopedUpward upward;
    ++count_;
    std::vector<Interval> value(model_.num_components());
    std::array<Interval, 3> u;
    for (std::size_t c = 0; c < 3; ++c) u[c] = enclose(data_.points[point][c]);
    if (is_near_flat)
      std::transform(exact.value.begin(), exact.value.end(), value.begin(),
                     [](const Rational& x) { return enclose(x); });
    else
      for (const std::uint32_t t : near) add_terms(t, *place, u, value);
    Interval square;
    for (std::size_t c = 0; c < 3; ++c) square += sqr(value[c] - u[c]);
    squares_[0] += square;
    for (std::size_t a = 0; a < data_.num_attributes; ++a) {
      const Interval error = value[3 + a] - enclose(data_.value(point, a));
      squares_[1 + a] += sqr(error);
      most_[a] = std::max(most_[a], mag(error));
    }
  }

  DmsFitErrors result() const {
    const ScopedUpward upward;
    const auto mean = [&](const Interval& sum) {
      return count_ == 0 ? 0.0 : (sum / Interval(static_cast<double>(count_))).hi();
    };
    DmsFitErrors out{mean(squares_[0]), {}, most_};
    for (std::size_t a = 0; a < data_.num_attributes; ++a)
      out.attribute_mse.push_back(mean(squares_[1 + a]));
    return out;
  }

 private:
  // REQUIRES a live ScopedUpward.
  void add_terms(std::uint32_t t, const DmsPlace& place, const std::array<Interval, 3>& u,
                 std::vector<Interval>& value) {
    const TetrahedronCorners& corners = model_.tetrahedra[t];
    const bool is_open =
        std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return is_open_[v]; });
    if (!is_open && t != place.tetrahedron) return;
    const DmsProgram<Interval>& program = programs_.of(t);
    run_program(
        program, u, [&](std::uint32_t f) { return !is_open || contains(program, f, place); }, run_);
    for (const auto& b : program.basis) {
      if (b.node == DmsProgram<Interval>::kNone) continue;
      const Interval n = program.frames[b.frame].volume * run_.value[b.node];
      if (n == Interval()) continue;
      for (std::size_t m = 0; m < 4; ++m) {
        const Interval factor = n * run_.barycentric[b.frame][m];
        const std::size_t control = control_.of(t, raised(b.gamma, m)) * value.size();
        for (std::size_t c = 0; c < value.size(); ++c) value[c] += factor * values_[control + c];
      }
    }
  }
  bool contains(const DmsProgram<Interval>& program, std::uint32_t f, const DmsPlace& place) const {
    bool is_sure = true;
    for (const Interval& at : run_.barycentric[f]) {
      if (at.sign() == Sign3::kNegative) return false;
      is_sure = is_sure && at.sign() == Sign3::kPositive;
    }
    return is_sure || is_entered(program.corners[f], place.path);
  }

  const DmsModel& model_;
  const DmsData& data_;
  DmsEvaluator evaluator_;
  DmsPrograms<Interval> programs_;
  FitControl control_;
  std::vector<bool> is_flat_;     // of each tetrahedron, nearly
  std::vector<bool> is_open_;     // of each vertex, whether its cloud is not collapsed
  std::vector<Interval> values_;  // of the control points
  std::size_t count_ = 0;
  std::vector<Interval> squares_;  // of the geometry, then of the attributes
  std::vector<double> most_;
  DmsRun<Interval> run_;
};

}  // namespace

DmsFitErrors measure_fit_errors(const DmsModel& model, const DmsData& data) {
  ErrorSums sums(model, data);
  for (std::size_t i = 0; i < data.points.size(); ++i) sums.add(i);
  return sums.result();
}

}  // namespace veritope
