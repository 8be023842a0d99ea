// SPDX-License-Identifier: LGPL-3.0-or-later
// The search for overlaps: Newton's iteration in binary64 finds candidates, exact tests decide.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/base/box3d.h"
#include "solids/base/box_hierarchy.h"
#include "solids/vmodel/v_overlap.h"
#include "splines/convert.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Vec3 = std::array<double, 3>;
using Mat3 = std::array<Vec3, 3>;

constexpr double kNextToBorder = 0x1p-36;  // of a domain, for points next to its faces
constexpr int kMostIterations = 24;
constexpr double kConverged = 1e-12;  // of a piece's domain

// ---- maps in binary64

struct RoundedSpan {  // the map on a box of knot spans
  std::uint32_t cell = 0;
  std::array<std::size_t, 3> span{};
  BezierVolume<double> map;
  Box3d hull;  // of its control points
};

struct ValueAndSlopes {
  Vec3 at{};
  Mat3 slopes{};  // slopes[c][a]: coordinate c along axis a
};

struct AxisBasis {
  std::array<double, 16> value{}, slope{};
};
AxisBasis axis_basis(int degree, double t) {
  AxisBasis out;
  std::array<double, 16>& v = out.value;
  v[0] = 1;
  for (int d = 1; d <= degree; ++d) {
    if (d == degree) {
      for (int i = 0; i <= degree; ++i) {
        const double left = i > 0 ? v[static_cast<std::size_t>(i) - 1] : 0;
        const double right = i < degree ? v[static_cast<std::size_t>(i)] : 0;
        out.slope[static_cast<std::size_t>(i)] = degree * (left - right);
      }
    }
    for (int i = d; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      v[k] = (i < d ? (1 - t) * v[k] : 0) + (i > 0 ? t * v[k - 1] : 0);
    }
  }
  return out;
}

ValueAndSlopes value_and_slopes(const BezierVolume<double>& map, const Vec3& t) {
  std::array<AxisBasis, 3> basis;
  for (std::size_t a = 0; a < 3; ++a) basis[a] = axis_basis(map.degree(a), t[a]);
  const Grid<3> grid = map.grid();
  std::array<std::array<double, 4>, 4> sums{};  // by component; value, then slopes along the axes
  for (std::size_t i = 0, n = 0; i < grid.size[0]; ++i)
    for (std::size_t j = 0; j < grid.size[1]; ++j) {
      const double b = basis[0].value[i] * basis[1].value[j];
      const double b_u = basis[0].slope[i] * basis[1].value[j];
      const double b_v = basis[0].value[i] * basis[1].slope[j];
      for (std::size_t k = 0; k < grid.size[2]; ++k, ++n) {
        const double w = basis[2].value[k];
        for (int c = 0; c < map.num_components(); ++c) {
          auto& sum = sums[static_cast<std::size_t>(c)];
          const double x = map.component(c)[n];
          sum[0] += b * w * x;
          sum[1] += b_u * w * x;
          sum[2] += b_v * w * x;
          sum[3] += b * basis[2].slope[k] * x;
        }
      }
    }
  ValueAndSlopes out;
  for (std::size_t c = 0; c < 3; ++c) {
    const double weight = map.is_rational() ? sums[3][0] : 1;
    out.at[c] = sums[c][0] / weight;
    for (std::size_t a = 0; a < 3; ++a)
      out.slopes[c][a] =
          (sums[c][a + 1] - (map.is_rational() ? out.at[c] * sums[3][a + 1] : 0)) / weight;
  }
  return out;
}

Mat3 inverse(const Mat3& m, double& det) {
  Mat3 out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      out[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  det = m[0][0] * out[0][0] + m[0][1] * out[1][0] + m[0][2] * out[2][0];
  for (Vec3& row : out)
    for (double& x : row) x /= det;
  return out;
}
bool is_finite(const Mat3& m) {
  for (const Vec3& row : m)
    for (const double x : row)
      if (!std::isfinite(x)) return false;
  return true;
}

// The parameters in [0, 1]^3 with the image q to which Newton's iteration converges.
std::optional<Vec3> solve(const BezierVolume<double>& map, const Vec3& q, Vec3 t) {
  for (int i = 0; i < kMostIterations; ++i) {
    const ValueAndSlopes here = value_and_slopes(map, t);
    double det = 0;
    const Mat3 back = inverse(here.slopes, det);
    if (!is_finite(back)) return std::nullopt;
    double step = 0, cut = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      double d = 0;
      for (std::size_t c = 0; c < 3; ++c) d += back[a][c] * (q[c] - here.at[c]);
      const double next = std::clamp(t[a] + d, 0.0, 1.0);
      cut = std::max(cut, std::abs(t[a] + d - next));
      step = std::max(step, std::abs(next - t[a]));
      t[a] = next;
    }
    if (!(step < std::numeric_limits<double>::infinity())) return std::nullopt;
    if (step < kConverged) return cut < kConverged ? std::optional(t) : std::nullopt;
  }
  return std::nullopt;
}

// ---- exact candidates

// The rational k / 2^bits next to t.
Rational dyadic(double t, int bits) {
  return Rational::from_double(std::ldexp(std::nearbyint(std::ldexp(t, bits)), -bits));
}

// Boxes around the solution, from large to small: a large one tolerates rounding, a small one is nearer to linear.
std::optional<VPreimage> preimage_near(const RoundedSpan& on, const Vec3& t, int bits) {
  VPreimage out;
  out.box.cell = on.cell;
  out.box.span = on.span;
  const double half = std::ldexp(1.0, -bits);
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational lo = dyadic(std::max(0.0, t[a] - half), 48);
    const Rational hi = dyadic(std::min(1.0, t[a] + half), 48);
    if (!(lo < hi)) return std::nullopt;
    out.box.at[a] = {lo, hi};
  }
  double det = 0;
  const Mat3 back = inverse(value_and_slopes(on.map, t).slopes, det);
  if (!is_finite(back)) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    double greatest = 0;
    for (const double x : back[i]) greatest = std::max(greatest, std::abs(x));
    if (!(greatest > 0)) return std::nullopt;
    const int shift = 30 - std::ilogb(greatest);
    for (std::size_t c = 0; c < 3; ++c)
      out.rows[i][c] = static_cast<std::int64_t>(std::nearbyint(std::ldexp(back[i][c], shift)));
  }
  return out;
}

class OverlapSearch {
 public:
  OverlapSearch(const VModel& model, const VOverlapOptions& options)
      : model_(model), options_(options) {
    for (std::uint32_t c = 0; c < model.num_cells(); ++c) add_spans(c);
    std::vector<Box3d> hulls;
    for (const RoundedSpan& s : spans_) hulls.push_back(s.hull);
    hulls_ = BoxHierarchy(hulls);
  }

  std::optional<VOverlap> run() {
    if (spans_.empty()) return std::nullopt;
    for (const auto& hint : options_.hints)
      if (auto found = try_at(place_at(model_, hint.cell, hint.at), true)) return found;
    for (const Samples samples : {Samples::kMiddles, Samples::kFaces, Samples::kNearEdges})
      if (auto found = try_samples(samples)) return found;
    return options_.within_spans ? try_within_spans() : std::nullopt;
  }

 private:
  enum class Samples { kMiddles, kFaces, kNearEdges };

  void add_spans(std::uint32_t cell) {
    const auto rounded = nearest_double(model_.cell(cell));
    if (!rounded) return;
    BezierPieces<double, 3> pieces = bezier_pieces(rounded.value());
    const Grid<3> grid = pieces.grid();
    for (std::size_t a = 0; a < 3; ++a)  // knots that are one in binary64
      if (grid.size[a] + 1 != internal::breaks_of(model_.cell(cell).axis(a)).size()) return;
    first_span_.resize(cell + 1, kNoSpan);
    first_span_[cell] = spans_.size();
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const Box3d around = hull_of(pieces.pieces[i]);
      spans_.push_back({cell, grid.index_of(i), std::move(pieces.pieces[i]), around});
    }
  }
  static Box3d hull_of(const BezierVolume<double>& map) {
    Box3d out = empty_box();
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < map.grid().count(); ++i) {
        const double w = map.is_rational() ? map.component(3)[i] : 1;
        const double x = map.component(static_cast<int>(c))[i] / w;
        out.lo[c] = std::min(out.lo[c], x);
        out.hi[c] = std::max(out.hi[c], x);
      }
    }
    return out;
  }
  const RoundedSpan* span_of(const VPlace& place) const {
    if (place.cell >= first_span_.size() || first_span_[place.cell] == kNoSpan) return nullptr;
    Grid<3> grid;
    for (std::size_t a = 0; a < 3; ++a)
      grid.size[a] = internal::breaks_of(model_.cell(place.cell).axis(a)).size() - 1;
    return &spans_[first_span_[place.cell] + grid.at(place.span)];
  }

  // Another point with the image of this one. `thoroughly`: with more beginnings, and in its own span.
  std::optional<VOverlap> try_at(const VPlace& inside, bool thoroughly) {
    const RoundedSpan* const own = span_of(inside);
    if (own == nullptr) return std::nullopt;
    const Vec3 t = {nearest_double(inside.at[0]), nearest_double(inside.at[1]),
                    nearest_double(inside.at[2])};
    const Vec3 q = value_and_slopes(own->map, t).at;
    std::optional<VOverlap> found;
    const Box3d point{q, q};
    const auto keep = [&](const Box3d& b) {
      return !found && solves_ < options_.max_solves && is_inside(point, b);
    };
    hulls_.visit(keep, [&](std::uint32_t number) {
      const RoundedSpan& s = spans_[number];
      if (&s != own || thoroughly) found = solve_on(inside, t, q, s, &s == own, thoroughly);
    });
    return found;
  }

  std::optional<VOverlap> solve_on(const VPlace& inside, const Vec3& own_t, const Vec3& q,
                                   const RoundedSpan& s, bool is_own, bool thoroughly) {
    static constexpr std::array<double, 3> kBegins = {0.5, 0.125, 0.875};
    const std::size_t begins = thoroughly ? 27 : 1;
    for (std::size_t i = 0; i < begins && solves_ < options_.max_solves; ++i) {
      ++solves_;
      const auto t = solve(s.map, q, {kBegins[i % 3], kBegins[i / 3 % 3], kBegins[i / 9]});
      if (!t) continue;
      double distance = 0;
      for (std::size_t a = 0; a < 3; ++a)
        distance = std::max(distance, std::abs((*t)[a] - own_t[a]));
      if (is_own && distance < 1e-6) continue;
      if (auto out = proved(inside, s, *t)) return out;
    }
    return std::nullopt;
  }
  std::optional<VOverlap> proved(const VPlace& inside, const RoundedSpan& s, const Vec3& t) const {
    VOverlap out;
    out.inside = inside;
    for (const int bits : {20, 30, 12, 38, 44}) {
      out.somewhere = preimage_near(s, t, bits);
      if (out.somewhere && is_overlap(model_, out)) return out;
    }
    out.somewhere.reset();
    out.point = VPlace{s.cell, s.span, {dyadic(t[0], 20), dyadic(t[1], 20), dyadic(t[2], 20)}};
    if (is_overlap(model_, out)) return out;
    return std::nullopt;
  }

  std::optional<VOverlap> try_samples(Samples samples) {
    for (const RoundedSpan& s : spans_)
      for (const Vec3& t : sample_points(s, samples)) {
        if (solves_ >= options_.max_solves) return std::nullopt;
        VPlace place{s.cell, s.span, {}};
        for (std::size_t a = 0; a < 3; ++a) place.at[a] = dyadic(t[a], 40);
        if (auto found = try_at(place, false)) return found;
      }
    return std::nullopt;
  }
  // Next to border faces: their middles, or their corners and the middles of their sides.
  std::vector<Vec3> sample_points(const RoundedSpan& s, Samples samples) const {
    if (samples == Samples::kMiddles) return {{0.5, 0.5, 0.5}};
    std::vector<Vec3> out;
    for (std::size_t f = 0; f < 6; ++f) {
      const auto axis = f / 2;
      const std::size_t last = internal::breaks_of(model_.cell(s.cell).axis(axis)).size() - 2;
      if (!model_.face(s.cell, f).is_border() || s.span[axis] != (f % 2 == 0 ? 0 : last)) continue;
      const auto [p, q] = v_face_axes(axis);
      static constexpr std::array<double, 3> kAlong = {kNextToBorder, 0.5, 1 - kNextToBorder};
      for (std::size_t i = 0; i < 9; ++i) {
        if ((i == 4) != (samples == Samples::kFaces)) continue;
        Vec3 t{};
        t[axis] = f % 2 == 0 ? kNextToBorder : 1 - kNextToBorder;
        t[p] = kAlong[i % 3], t[q] = kAlong[i / 3];
        out.push_back(t);
      }
    }
    return out;
  }

  // A span that runs through itself.
  std::optional<VOverlap> try_within_spans() {
    for (const RoundedSpan& s : spans_) {
      Grid<3> samples;
      for (std::size_t a = 0; a < 3; ++a)
        samples.size[a] = static_cast<std::size_t>(2 * s.map.degree(a) + 2);
      for (std::size_t i = 0; i < samples.count(); ++i) {
        if (solves_ >= options_.max_solves) return std::nullopt;
        const auto index = samples.index_of(i);
        VPlace place{s.cell, s.span, {}};
        for (std::size_t a = 0; a < 3; ++a)
          place.at[a] = dyadic(
              (static_cast<double>(index[a]) + 0.5) / static_cast<double>(samples.size[a]), 10);
        if (auto found = try_at(place, true)) return found;
      }
    }
    return std::nullopt;
  }

  static constexpr std::size_t kNoSpan = std::numeric_limits<std::size_t>::max();
  const VModel& model_;
  const VOverlapOptions& options_;
  std::vector<RoundedSpan> spans_;
  std::vector<std::size_t> first_span_;  // of each cell
  BoxHierarchy hulls_;
  std::size_t solves_ = 0;
};

}  // namespace

std::optional<VOverlap> find_overlap(const VModel& model, const VOverlapOptions& options) {
  return OverlapSearch(model, options).run();
}

}  // namespace veritope
