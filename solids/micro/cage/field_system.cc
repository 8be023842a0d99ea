// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/micro/cage/field_system_internal.h"

namespace veritope::internal {
namespace {

using Block = std::array<Point3d, 3>;  // rows of a symmetric matrix
using Moves = std::vector<Point3d>;

Point3d times(const Block& m, const Point3d& x) {
  return {dot(m[0], x), dot(m[1], x), dot(m[2], x)};
}

// The inverse of a symmetric positive matrix.
Block inverse(const Block& m) {
  const Block rows = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const double det = dot(m[0], rows[0]);
  Block out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[i][k] = rows[k][i] / det;
  return out;
}

double inner(const Moves& a, const Moves& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

// Calls visit(number, uv, k) for each control point of the row: uv is the product of the weights along u and v.
template <typename Visit>
void for_each_control(const Grid<3>& grid, const std::array<AxisWeights, 3>& weights, Visit visit) {
  const auto& [u, v, w] = weights;
  for (std::size_t i = 0; i < u.count; ++i)
    for (std::size_t j = 0; j < v.count; ++j) {
      const double uv = u.of[0][i] * v.of[0][j];
      const std::size_t first = grid.at({u.first + i, v.first + j, w.first});
      for (std::size_t k = 0; k < w.count; ++k) visit(first + k, uv, k);
    }
}

// The moves of the point, and of its derivative along w.
std::array<Point3d, 2> moves_at(const Grid<3>& grid, const std::array<AxisWeights, 3>& weights,
                                const Moves& x) {
  const auto& [u, v, w] = weights;
  std::array<Point3d, 2> out{};
  for (std::size_t i = 0; i < u.count; ++i)
    for (std::size_t j = 0; j < v.count; ++j) {
      const Point3d* const line = &x[grid.at({u.first + i, v.first + j, w.first})];
      std::array<Point3d, 2> sum{};
      for (std::size_t k = 0; k < w.count; ++k)
        for (std::size_t d = 0; d < 2; ++d) add_times(sum[d], w.of[d][k], line[k]);
      for (std::size_t d = 0; d < 2; ++d) add_times(out[d], u.of[0][i] * v.of[0][j], sum[d]);
    }
  return out;
}

// The normal equations of the rows, the smoothness and the damping.
class NormalEquations {
 public:
  NormalEquations(const FieldNet& net, std::span<const FieldRow> rows,
                  std::span<const WideRow> wide, const Smoothness& smoothness,
                  const FieldSolve& options)
      : net_(net), rows_(rows), wide_(wide), smoothness_(smoothness), options_(options) {
    double weight = 0;
    for (const FieldRow& row : rows) weight += row.weight;
    scale_ = weight > 0 ? 1 / weight : 0;
    make_blocks();
  }

  // The downhill direction at x = 0.
  Moves right() const {
    Moves out(net_.points.size(), Point3d{});
    smoothness_.apply(net_.points, -options_.smooth, out);
    for (const FieldRow& row : rows_) add_transposed(row, row.goal, out);
    for (const WideRow& row : wide_) add_wide(row, row.goal, out);
    return out;
  }

  Moves apply(const Moves& x) const {
    Moves out(x.size());
    for (std::size_t n = 0; n < x.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k) out[n][k] = options_.damping[n] * x[n][k];
    smoothness_.apply(x, options_.smooth, out);
    for (const FieldRow& row : rows_) {
      const auto [move, along] = moves_at(net_.grid, row.weights, x);
      const Point3d slid = times(row.slide, move);
      const Point3d turn = {along[0] - slid[0], along[1] - slid[1], along[2] - slid[2]};
      add_transposed(row, {dot(row.across[0], turn), dot(row.across[1], turn)}, out);
    }
    for (const WideRow& row : wide_) add_wide(row, inner(row.factors, x), out);
    return out;
  }

  Moves precondition(const Moves& x) const {
    Moves out(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) out[n] = times(blocks_[n], x[n]);
    return out;
  }

 private:
  static void add_wide(const WideRow& row, double value, Moves& out) {
    for (std::size_t n = 0; n < out.size(); ++n) add_times(out[n], value, row.factors[n]);
  }
  void add_transposed(const FieldRow& row, const std::array<double, 2>& turn, Moves& out) const {
    Point3d along{}, move{};
    for (std::size_t r = 0; r < 2; ++r)
      add_times(along, scale_ * row.weight * turn[r], row.across[r]);
    for (std::size_t r = 0; r < 3; ++r) add_times(move, -along[r], row.slide[r]);
    const AxisWeights& w = row.weights[2];
    for_each_control(net_.grid, row.weights, [&](std::size_t n, double uv, std::size_t k) {
      add_times(out[n], uv * w.of[0][k], move);
      add_times(out[n], uv * w.of[1][k], along);
    });
  }

  void make_blocks() {
    blocks_.resize(net_.points.size());
    for (std::size_t n = 0; n < blocks_.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k)
        blocks_[n][k][k] =
            options_.damping[n] + options_.smooth * smoothness_.diagonal()[n] + 0x1p-60;
    for (const FieldRow& row : rows_) {
      std::array<Point3d, 2> slid;  // the rows of across times slide
      for (std::size_t r = 0; r < 2; ++r) {
        slid[r] = {};
        for (std::size_t k = 0; k < 3; ++k) add_times(slid[r], row.across[r][k], row.slide[k]);
      }
      const AxisWeights& w = row.weights[2];
      for_each_control(net_.grid, row.weights, [&](std::size_t n, double uv, std::size_t k) {
        for (std::size_t r = 0; r < 2; ++r) {
          Point3d line{};
          add_times(line, uv * w.of[1][k], row.across[r]);
          add_times(line, -uv * w.of[0][k], slid[r]);
          for (std::size_t a = 0; a < 3; ++a)
            add_times(blocks_[n][a], scale_ * row.weight * line[a], line);
        }
      });
    }
    for (Block& block : blocks_) block = inverse(block);
  }

  const FieldNet& net_;
  std::span<const FieldRow> rows_;
  std::span<const WideRow> wide_;
  const Smoothness& smoothness_;
  const FieldSolve& options_;
  double scale_ = 0;
  std::vector<Block> blocks_;
};

template <typename System>
Moves conjugate_gradients(const System& system, int steps, double tolerance) {
  Moves residual = system.right();
  Moves x(residual.size(), Point3d{}), z = system.precondition(residual), p = z;
  double rz = inner(residual, z);
  const double goal = tolerance * tolerance * rz;
  for (int step = 0; step < steps && rz > goal && rz > 0; ++step) {
    const Moves q = system.apply(p);
    const double alpha = rz / inner(p, q);
    if (!std::isfinite(alpha)) break;
    for (std::size_t n = 0; n < x.size(); ++n) {
      add_times(x[n], alpha, p[n]);
      add_times(residual[n], -alpha, q[n]);
    }
    z = system.precondition(residual);
    const double next = inner(residual, z);
    for (std::size_t n = 0; n < x.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k) p[n][k] = z[n][k] + next / rz * p[n][k];
    rz = next;
  }
  return x;
}

// The normal equations of a function on the net.
class ScalarEquations {
 public:
  ScalarEquations(const FieldNet& net, std::span<const Parameters3> at,
                  std::span<const double> values, const Smoothness& smoothness, double smooth)
      : net_(net), smoothness_(smoothness), smooth_(smooth), right_(net.points.size(), Point3d{}) {
    scale_ = 1 / static_cast<double>(at.size());
    diagonal_.assign(net.points.size(), 0x1p-40);
    for (std::size_t n = 0; n < diagonal_.size(); ++n)
      diagonal_[n] += smooth * smoothness.diagonal()[n];
    for (std::size_t i = 0; i < at.size(); ++i) {
      weights_.push_back(net.weights(at[i]));
      const AxisWeights& w = weights_.back()[2];
      for_each_control(net.grid, weights_.back(), [&](std::size_t n, double uv, std::size_t k) {
        const double f = uv * w.of[0][k];
        right_[n][0] += scale_ * f * values[i];
        diagonal_[n] += scale_ * f * f;
      });
    }
  }
  Moves right() const { return right_; }
  Moves apply(const Moves& x) const {
    Moves out(x.size(), Point3d{});
    for (std::size_t n = 0; n < x.size(); ++n) out[n][0] = 0x1p-40 * x[n][0];
    smoothness_.apply(x, smooth_, out);
    for (const auto& weights : weights_) {
      const double value = moves_at(net_.grid, weights, x)[0][0];
      for_each_control(net_.grid, weights, [&](std::size_t n, double uv, std::size_t k) {
        out[n][0] += scale_ * value * uv * weights[2].of[0][k];
      });
    }
    return out;
  }
  Moves precondition(const Moves& x) const {
    Moves out(x.size(), Point3d{});
    for (std::size_t n = 0; n < x.size(); ++n) out[n][0] = x[n][0] / diagonal_[n];
    return out;
  }

 private:
  const FieldNet& net_;
  const Smoothness& smoothness_;
  double smooth_, scale_ = 0;
  Moves right_;
  std::vector<double> diagonal_;
  std::vector<std::array<AxisWeights, 3>> weights_;
};

}  // namespace

Smoothness::Smoothness(const FieldNet& net, const Point3d& lengths) : grid_(net.grid) {
  const double mean = (lengths[0] + lengths[1] + lengths[2]) / 3;
  std::array<double, 3> unit;  // of a parameter, in parts of the mean length
  double volume = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const FieldAxis& axis = net.axes[k];
    degrees_[k] = static_cast<std::size_t>(axis.degree());
    const auto spans = static_cast<double>(axis.spans());
    unit[k] = lengths[k] / spans / mean;
    volume *= spans;
    const std::size_t n = axis.num_control(), p = degrees_[k], row = 2 * p + 1;
    for (Band& band : bands_[k]) band.assign(n * row, 0.0);
    const std::size_t places = p + 2;
    for (std::size_t s = 0; s < axis.spans(); ++s)
      for (std::size_t t = 0; t < places; ++t) {
        const double part = (static_cast<double>(t) + 0.5) / static_cast<double>(places);
        const AxisWeights w = axis.weights(static_cast<double>(s) + part);
        for (std::size_t d = 0; d < 3; ++d)
          for (std::size_t i = 0; i < w.count; ++i)
            for (std::size_t j = 0; j < w.count; ++j)
              bands_[k][d][(w.first + i) * row + (j + p - i)] +=
                  w.of[d][i] * w.of[d][j] / static_cast<double>(places);
      }
    if (p > 1) continue;
    constexpr std::array<double, 3> kJump = {1, -2, 1};
    // With one span before and after it, the jump is all that there is of a second derivative. Its band is wider than
    // that of degree 1 by one.
    Band wide(n * 5, 0.0);
    for (std::size_t s = 0; s + 2 < n; ++s)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) wide[(s + i) * 5 + (j + 2 - i)] += kJump[i] * kJump[j];
    bands_[k][2] = std::move(wide);
  }
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a; b < 3; ++b) {
      Term term{{0, 0, 0}, (a == b ? 1 : 2) / volume};
      ++term.orders[a];
      ++term.orders[b];
      term.factor /= unit[a] * unit[a] * unit[b] * unit[b];
      // Positions are in units of the normalised model, and the mean length is not 1.
      term.factor /= mean * mean;
      terms_.push_back(term);
    }
  diagonal_.assign(grid_.count(), 0.0);
  for (std::size_t n = 0; n < diagonal_.size(); ++n) {
    const auto at = grid_.index_of(n);
    for (const Term& term : terms_) {
      double product = term.factor;
      for (std::size_t k = 0; k < 3; ++k) {
        const Band& band = bands_[k][term.orders[k]];
        const std::size_t row = band.size() / grid_.size[k];
        product *= band[at[k] * row + row / 2];
      }
      diagonal_[n] += product;
    }
  }
}

void Smoothness::along(std::size_t axis, std::size_t order, const Moves& x, Moves& out) const {
  const Band& band = bands_[axis][order];
  const std::size_t n = grid_.size[axis], row = band.size() / n, half = row / 2;
  const std::size_t stride = grid_.stride(axis);
  out.assign(x.size(), Point3d{});
  grid_.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t begin = i < half ? half - i : 0, end = std::min(row, n + half - i);
      for (std::size_t j = begin; j < end; ++j)
        add_times(out[first + i * stride], band[i * row + j], x[first + (i + j - half) * stride]);
    }
  });
}

void Smoothness::apply(const Moves& x, double factor, Moves& out) const {
  if (factor == 0) return;
  Moves a, b;
  for (const Term& term : terms_) {
    along(2, term.orders[2], x, a);
    along(1, term.orders[1], a, b);
    along(0, term.orders[0], b, a);
    for (std::size_t n = 0; n < x.size(); ++n) add_times(out[n], factor * term.factor, a[n]);
  }
}

double Smoothness::energy(const Moves& x) const {
  Moves out(x.size(), Point3d{});
  apply(x, 1, out);
  return inner(x, out);
}

FieldRow field_row(const FieldNet& net, const Parameters3& at, const Point3d& direction) {
  FieldRow out;
  out.weights = net.weights(at);
  const FieldJet j = net.jet(out.weights);
  // slide = [T_uw T_vw T_ww] J^-1, row by row.
  const double det = j.det();
  const std::array<Point3d, 3> dual = {cross(j.along[1], j.along[2]), cross(j.along[2], j.along[0]),
                                       cross(j.along[0], j.along[1])};
  for (std::size_t r = 0; r < 3; ++r) {
    out.slide[r] = {};
    for (std::size_t k = 0; k < 3; ++k) add_times(out.slide[r], j.along_w[k][r] / det, dual[k]);
  }
  const Point3d& w = j.along[2];
  const double length = std::sqrt(dot(w, w));
  const Point3d t = {w[0] / length, w[1] / length, w[2] / length};
  // Two directions across t.
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(t[k]) < std::abs(t[least])) least = k;
  Point3d axis{};
  axis[least] = 1;
  Point3d f = cross(t, axis);
  const double size = std::sqrt(dot(f, f));
  for (double& x : f) x /= size;
  const Point3d g = cross(t, f);
  // The great circle from t to the direction, or to its opposite if that is nearer.
  const double sign = dot(t, direction) < 0 ? -1 : 1;
  const double x = sign * dot(f, direction), y = sign * dot(g, direction);
  const double part = std::sqrt(2 / (1 + std::min(1.0, std::abs(dot(t, direction)))));
  out.goal = {part * x, part * y};
  for (std::size_t k = 0; k < 3; ++k) {
    out.across[0][k] = f[k] / length;
    out.across[1][k] = g[k] / length;
  }
  return out;
}

double squared_chord(const Point3d& a, const Point3d& b) {
  const Point3d c = cross(a, b);
  const double length = std::sqrt(dot(a, a) * dot(b, b));
  return 2 * dot(c, c) / (length * (length + std::abs(dot(a, b))));
}

ParameterMoments::ParameterMoments(const FieldNet& net, std::vector<Parameters3> at)
    : first_(std::move(at)) {
  const std::size_t n = first_.size();
  const double part = 1 / static_cast<double>(n);
  std::array<std::vector<double>, 3> centred;
  for (std::size_t k = 0; k < 3; ++k) {
    double mean = 0, square = 0;
    for (const Parameters3& p : first_) mean += part * p[k];
    for (const Parameters3& p : first_) square += part * (p[k] - mean) * (p[k] - mean);
    const double size = std::max(std::sqrt(square), 0x1p-10);
    for (const Parameters3& p : first_) centred[k].push_back((p[k] - mean) / size);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double unit = part / static_cast<double>(net.axes[axis].spans());
    moments_.push_back({axis, std::vector<double>(n, unit)});
    for (std::size_t k = 0; k < (axis == 2 ? 3u : 2u); ++k) {
      moments_.push_back({axis, centred[k]});
      for (double& x : moments_.back().factors) x *= unit;
    }
  }
}

double ParameterMoments::change(const Moment& moment, const std::vector<Parameters3>& at) const {
  double sum = 0;
  for (std::size_t i = 0; i < at.size(); ++i)
    sum += moment.factors[i] * (at[i][moment.axis] - first_[i][moment.axis]);
  return sum;
}

double ParameterMoments::energy(const std::vector<Parameters3>& at) const {
  double sum = 0;
  for (const Moment& moment : moments_) {
    const double x = change(moment, at);
    sum += x * x;
  }
  return sum;
}

std::vector<WideRow> ParameterMoments::rows(const FieldNet& net,
                                            const std::vector<Parameters3>& at) const {
  std::vector<WideRow> out;
  for (const Moment& moment : moments_)
    out.push_back({Moves(net.points.size(), Point3d{}), -change(moment, at)});
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto weights = net.weights(at[i]);
    const FieldJet j = net.jet(weights);
    const double det = j.det();
    for (std::size_t m = 0; m < moments_.size(); ++m) {
      const std::size_t k = moments_[m].axis;
      const Point3d dual = cross(j.along[(k + 1) % 3], j.along[(k + 2) % 3]);
      const double factor = -moments_[m].factors[i] / det;
      for_each_control(net.grid, weights, [&](std::size_t n, double uv, std::size_t c) {
        add_times(out[m].factors[n], factor * uv * weights[2].of[0][c], dual);
      });
    }
  }
  return out;
}

Moves solve_field(const FieldNet& net, std::span<const FieldRow> rows,
                  std::span<const WideRow> wide, const Smoothness& smoothness,
                  const FieldSolve& options) {
  return conjugate_gradients(NormalEquations(net, rows, wide, smoothness, options), options.steps,
                             options.tolerance);
}

Moves solve_scalar(const FieldNet& net, std::span<const Parameters3> at,
                   std::span<const double> values, const Smoothness& smoothness, double smooth) {
  return conjugate_gradients(ScalarEquations(net, at, values, smoothness, smooth), 2000, 1e-9);
}

}  // namespace veritope::internal
