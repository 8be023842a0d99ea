// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/short_vertices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "predicates/projection.h"
#include "robust/base/check.h"
#include "solids/dms/dms_knots.h"

namespace veritope {
namespace {

using Kind = VertexFlat::Kind;
using ExactPlace = std::array<Rational, 3>;

// Numbers that are short enough, and the digits that are tried.
constexpr std::uint64_t kShortBits = 64;
constexpr std::array<int, 5> kDigits{10, 20, 40, 80, 160};

// The multiple of 2^-digits that is nearest to x.
Rational rounded(const Rational& x, int digits) {
  const Rational scaled = x * Rational::power_of_two(digits + 1) + Rational(1);
  return Rational(floor_divide(scaled.numerator(), Integer(2) * scaled.denominator())) *
         Rational::power_of_two(-digits);
}

ExactPlace exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

// A point as an origin plus short multiples of directions.
class Frame {
 public:
  // `size`: approximately the length by which a free vertex may move
  Frame(const VertexFlat& flat, const ExactPoint3& p, double size) {
    const auto& q = flat.points;
    if (flat.kind == Kind::kFree) {
      unit_ = std::isfinite(size) && size > 0 ? std::ilogb(size) : 0;
      factors_ = {p.at()[0], p.at()[1], p.at()[2]};
      for (Rational& f : factors_) f *= Rational::power_of_two(-unit_);
      return;
    }
    origin_ = exact(q[0]);
    directions_.push_back(difference(exact(q[1]), origin_));
    if (flat.kind == Kind::kPlane) directions_.push_back(difference(exact(q[2]), origin_));
    solve(q, difference(p.at(), origin_));
  }

  // With so many binary digits of the factors.
  ExactPlace place(int digits) const {
    if (directions_.empty()) {
      ExactPlace out;
      for (std::size_t k = 0; k < 3; ++k)
        out[k] = rounded(factors_[k], digits) * Rational::power_of_two(unit_);
      return out;
    }
    ExactPlace out = origin_;
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      const Rational f = rounded(factors_[d], digits);
      for (std::size_t k = 0; k < 3; ++k) out[k] += f * directions_[d][k];
    }
    return out;
  }

 private:
  void solve(const std::array<Vec3d, 3>& q, const ExactPlace& r) {
    const ExactPlace& u = directions_[0];
    if (directions_.size() == 1) {
      std::size_t axis = 0;
      for (std::size_t k = 1; k < 3; ++k)
        if (abs(u[k]) > abs(u[axis])) axis = k;
      factors_ = {r[axis] / u[axis]};
      return;
    }
    const ExactPlace& v = directions_[1];
    const auto axis = static_cast<std::size_t>(projection_of(q[0], q[1], q[2]).axis);
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Rational d = u[i] * v[j] - u[j] * v[i];
    factors_ = {(r[i] * v[j] - r[j] * v[i]) / d, (u[i] * r[j] - u[j] * r[i]) / d};
  }

  ExactPlace origin_;
  std::vector<ExactPlace> directions_;
  std::vector<Rational> factors_;
  int unit_ = 0;
};

class Shortening {
 public:
  Shortening(std::span<const TetrahedronCorners> tetrahedra, std::vector<ExactPoint3>& points)
      : tetrahedra_(tetrahedra), points_(points), first_(points.size() + 1, 0) {
    for (const TetrahedronCorners& t : tetrahedra)
      for (const std::uint32_t v : t) ++first_[v + 1];
    for (std::size_t v = 0; v < points.size(); ++v) first_[v + 1] += first_[v];
    at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
      for (const std::uint32_t v : tetrahedra[t]) at_[next[v]++] = t;
  }

  void shorten(std::uint32_t v, const VertexFlat& flat) {
    const std::uint64_t bits = num_bits(points_[v]);
    if (flat.kind == Kind::kFixed || bits <= kShortBits) return;
    const Frame frame(flat, points_[v], size_at(v));
    ExactPoint3 old = points_[v];
    for (const int digits : kDigits) {
      ExactPoint3 moved(frame.place(digits));
      if (num_bits(moved) >= bits) break;
      points_[v] = std::move(moved);
      if (are_positive(v)) return;
    }
    points_[v] = std::move(old);
  }

 private:
  std::span<const std::uint32_t> tetrahedra_at(std::uint32_t v) const {
    return {at_.data() + first_[v], first_[v + 1] - first_[v]};
  }
  bool are_positive(std::uint32_t v) const {
    const auto all = tetrahedra_at(v);
    return std::all_of(all.begin(), all.end(), [&](std::uint32_t t) {
      const TetrahedronCorners& c = tetrahedra_[t];
      return orient3d(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]) ==
             Sign::kPositive;
    });
  }
  // The shortest edge at a vertex, lengths along axes, rounded.
  double size_at(std::uint32_t v) const {
    double size = HUGE_VAL;
    for (const std::uint32_t t : tetrahedra_at(v))
      for (const std::uint32_t w : tetrahedra_[t]) {
        if (w == v) continue;
        const Vec3d &a = points_[v].rounded(), &b = points_[w].rounded();
        size = std::min(size,
                        std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}));
      }
    return size;
  }

  std::span<const TetrahedronCorners> tetrahedra_;
  std::vector<ExactPoint3>& points_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> at_;  // for each vertex its tetrahedra
};

}  // namespace

std::uint64_t num_bits(const ExactPoint3& p) {
  std::uint64_t bits = 0;
  for (const Rational& x : p.at())
    bits = std::max({bits, x.numerator().bit_length(), x.denominator().bit_length()});
  return bits;
}

void shorten_vertices(std::span<const VertexFlat> flats,
                      std::span<const TetrahedronCorners> tetrahedra,
                      std::vector<ExactPoint3>& points) {
  VT_CHECK(flats.size() == points.size(), "each vertex has a flat");
  Shortening all(tetrahedra, points);
  for (std::uint32_t v = 0; v < points.size(); ++v) all.shorten(v, flats[v]);
}

}  // namespace veritope
