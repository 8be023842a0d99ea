// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_line.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "interval/functions.h"
#include "interval/numeric.h"
#include "interval/upward.h"
#include "solids/dms/dms_table.h"
#include "splines/dms_spline.h"
#include "splines/simplex_line.h"

namespace veritope {
namespace {

DmsPoint at(const DmsLine& line, const Rational& t) {
  DmsPoint out = line.from;
  for (std::size_t c = 0; c < 3; ++c) out[c] += t * (line.to[c] - line.from[c]);
  return out;
}

DmsPoint direction_of(const DmsLine& line) {
  DmsPoint out = line.to;
  for (std::size_t c = 0; c < 3; ++c) out[c] -= line.from[c];
  return out;
}

Interval span_of(const Interval& a, const Interval& b) {
  return Interval::from_bounds(std::min(a.lo(), b.lo()), std::max(a.hi(), b.hi()));
}

// Whether a box may meet a segment: never false if it does.
class SegmentFilter {
 public:
  explicit SegmentFilter(const DmsLine& line) {
    const DmsPoint direction = direction_of(line);
    for (std::size_t c = 0; c < 3; ++c) {
      from_[c] = enclose(line.from[c]);
      along_[c] = enclose(direction[c]);
      both_[c] = span_of(from_[c], enclose(line.to[c]));
    }
  }
  bool operator()(const Box3d& box) const {
    const ScopedUpward upward;
    double low = 0, high = 1;
    for (std::size_t c = 0; c < 3; ++c) {
      if (box.hi[c] < both_[c].lo() || both_[c].hi() < box.lo[c]) return false;
      const Sign3 sign = along_[c].sign();
      if (sign != Sign3::kPositive && sign != Sign3::kNegative) continue;
      const Interval t = (Interval::from_bounds(box.lo[c], box.hi[c]) - from_[c]) / along_[c];
      if (t.is_empty()) continue;
      low = std::max(low, t.lo());
      high = std::min(high, t.hi());
    }
    return low <= high;
  }

 private:
  std::array<Interval, 3> from_, along_, both_;
};

// The part of the segment in the closed tetrahedron of the frame, except where the segment lies in a plane of a face:
// then `side(m)` says on which side of the face m to count it.
template <typename Side>
std::optional<std::array<Rational, 2>> clip(const LineCoordinates<Rational>& c, Rational begin,
                                            Rational end, Side side) {
  for (std::size_t m = 0; m < 4; ++m) {
    const Sign slope = c.along[m].sign();
    if (slope == Sign::kZero) {
      const Sign s = c.at[m].sign();
      if ((s == Sign::kZero ? side(m) : s) == Sign::kNegative) return std::nullopt;
      continue;
    }
    Rational t = -c.at[m] / c.along[m];
    if (slope == Sign::kPositive && begin < t)
      begin = std::move(t);
    else if (slope == Sign::kNegative && t < end)
      end = std::move(t);
  }
  if (end < begin) return std::nullopt;
  return std::array<Rational, 2>{std::move(begin), std::move(end)};
}

// The answers about one stretch of a segment.
class StretchAnswers {
 public:
  StretchAnswers(internal::DmsTable& table, const DmsStretch& stretch)
      : table_(table), stretch_(stretch) {}

  const SimplexFrame<Rational>* frame(const KnotSet& set) { return table_.frame(set); }
  std::optional<std::array<Rational, 2>> inside(const SimplexFrame<Rational>& frame,
                                                const LineCoordinates<Rational>& c) const {
    return clip(c, stretch_.begin, stretch_.end, [&](std::size_t m) { return side(frame, m); });
  }

 private:
  // The sign of the coordinate m along the path, where it is zero on the whole segment. The path leaves every plane.
  Sign side(const SimplexFrame<Rational>& frame, std::size_t m) const {
    const auto& l = frame.lambda[m];
    if (const auto& g = stretch_.path.target()) {
      const auto& to = g->at();
      const Sign s = Rational(l[0] + l[1] * to[0] + l[2] * to[1] + l[3] * to[2]).sign();
      if (s != Sign::kZero) return s;
    }
    for (std::size_t axis = 1; axis < 4; ++axis)
      if (const Sign s = l[axis].sign(); s != Sign::kZero) return s;
    return Sign::kZero;
  }

  internal::DmsTable& table_;
  const DmsStretch& stretch_;
};

using Moments = SimplexLineMoments<Rational, StretchAnswers>;
using WeightMap = std::map<std::size_t, Rational>;

// The weights of one tetrahedron's terms, in the form of degree n - 1 or n.
void add_weights(const DmsModel& model, std::uint32_t t, const DmsKnots& knots, Moments& moments,
                 WeightMap& weights) {
  const bool is_shared = !model.control.is_separate;
  for_each_tetrahedral_index(model.condition_degree(), [&](const TetrahedralIndex& gamma) {
    const std::vector<Rational>& of_set = moments.moments(knots.up_to(gamma));
    if (of_set.empty()) return;
    const auto w = knots.tetrahedron(gamma);
    const SimplexFrame<Rational>* const frame = moments.frame(KnotSet{w[0], w[1], w[2], w[3]});
    VT_CHECK(frame != nullptr, "the four last knots of a basis function are independent");
    if (!is_shared) {
      weights[control_of(model, t, gamma)] += frame->volume * of_set[0];
      return;
    }
    const LineCoordinates<Rational>& c = moments.coordinates(*frame);
    for (std::size_t m = 0; m < 4; ++m)
      weights[control_of(model, t, raised(gamma, m))] +=
          frame->volume * (c.at[m] * of_set[0] + c.along[m] * of_set[1]);
  });
}

}  // namespace

std::vector<DmsStretch> DmsLineIntegrator::stretches(const DmsLine& line) const {
  std::vector<DmsStretch> out;
  if (line.from == line.to) {
    if (auto place = evaluator_.locate(line.from))
      out.push_back({Rational(0), Rational(1), std::move(place->path)});
    return out;
  }
  const DmsPoint direction = direction_of(line);
  std::vector<Rational> cuts;
  evaluator_.by_corners_.visit(SegmentFilter(line), [&](std::uint32_t t) {
    internal::DmsTable& table = evaluator_.table(t);
    const auto w = table.knots().tetrahedron({0, 0, 0, 0});
    const SimplexFrame<Rational>* const frame = table.frame(KnotSet{w[0], w[1], w[2], w[3]});
    if (frame == nullptr) return;
    const LineCoordinates<Rational> c{frame->barycentric(line.from),
                                      frame->barycentric_direction(direction)};
    auto part = clip(c, Rational(0), Rational(1), [](std::size_t) { return Sign::kPositive; });
    if (part) std::move(part->begin(), part->end(), std::back_inserter(cuts));
  });
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::int64_t last = -1;  // the tetrahedron of the last stretch; -1 outside of the domain
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    auto place = evaluator_.locate(at(line, (cuts[i] + cuts[i + 1]) / Rational(2)));
    if (!place) {
      last = -1;
      continue;
    }
    const bool is_inward = place->path.target().has_value();
    const bool goes_on = last >= 0 && out.back().path.target().has_value() == is_inward &&
                         (!is_inward || last == place->tetrahedron);
    last = place->tetrahedron;
    if (goes_on)
      out.back().end = cuts[i + 1];
    else
      out.push_back({cuts[i], cuts[i + 1], std::move(place->path)});
  }
  return out;
}

std::vector<DmsWeight> DmsLineIntegrator::weights(const DmsLine& line) {
  evaluator_.drop_tables_if_many();
  const std::vector<DmsStretch> parts = stretches(line);
  if (parts.empty()) return {};
  std::vector<std::uint32_t> tetrahedra;
  evaluator_.by_knots_.visit(SegmentFilter(line),
                             [&](std::uint32_t t) { tetrahedra.push_back(t); });
  std::sort(tetrahedra.begin(), tetrahedra.end());
  const DmsPoint direction = direction_of(line);
  WeightMap sums;
  for (const std::uint32_t t : tetrahedra) {
    internal::DmsTable& table = evaluator_.table(t);
    const std::size_t before = table.num_frames();
    for (const DmsStretch& part : parts) {
      StretchAnswers answers(table, part);
      Moments moments(answers, line.from, direction, evaluator_.model_.degree);
      add_weights(evaluator_.model_, t, table.knots(), moments, sums);
    }
    evaluator_.num_frames_ += table.num_frames() - before;
  }
  std::vector<DmsWeight> out;
  for (auto& [control, weight] : sums)
    if (weight.sign() != Sign::kZero) out.push_back({control, std::move(weight)});
  return out;
}

Rational DmsLineIntegrator::mean(const DmsLine& line, std::size_t component) {
  Rational sum;
  for (const DmsWeight& w : weights(line))
    sum += w.weight * evaluator_.model_.value(w.control)[component];
  return sum;
}

namespace {

// Encloses the square root, also where binary64 does not have x. REQUIRES x >= 0.
Interval root_of(const Rational& x) {
  if (x.sign() == Sign::kZero) return Interval(0.0);
  const auto bits = [](const Integer& n) { return static_cast<std::int64_t>(n.bit_length()); };
  const std::int64_t half = (bits(x.numerator()) - bits(x.denominator())) / 2;
  const Interval near_one = enclose(x * Rational::power_of_two(-2 * half));
  Interval root;
  {
    const ScopedUpward upward;
    root = sqrt(near_one);
  }
  const auto moved = [&](double end) {
    return enclose(Rational::from_double(end) * Rational::power_of_two(half));
  };
  return Interval::from_bounds(inf(moved(inf(root))), sup(moved(sup(root))));
}

}  // namespace

DmsAbsorption absorption(const DmsLine& line, const Rational& mean) {
  const DmsPoint d = direction_of(line);
  const Rational squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  Interval integral = root_of(mean * mean * squared);
  if (mean.sign() == Sign::kNegative) integral = -integral;
  return {integral, exp(-integral)};
}

}  // namespace veritope
