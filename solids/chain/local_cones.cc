// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "robust/integer.h"
#include "solids/chain/local_cones_internal.h"

namespace veritope::internal {
namespace {

using Ray = std::array<Integer, 3>;

Ray cross_of(const Ray& a, const Ray& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Integer dot_of(const Ray& a, const Ray& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Ray sum_of_rays(const Ray& a, const Ray& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Ray opposite(Ray a) {
  for (Integer& x : a) x.negate();
  return a;
}

// Without a common factor. REQUIRES a ray that is not 0.
Ray primitive(Ray a) {
  const Integer g = gcd(gcd(a[0], a[1]), a[2]);
  for (Integer& x : a) x = divide_exactly(x, g);
  return a;
}

Ray ray_of(const ExactPoint& p) {
  Integer scale(1);
  for (const Rational& x : p) scale = lcm(scale, x.denominator());
  Ray out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = p[k].numerator() * divide_exactly(scale, p[k].denominator());
  return primitive(std::move(out));
}

bool is_null(const Ray& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

// The first coordinate that is not 0 is positive.
bool is_canonical(const Ray& a) {
  for (const Integer& x : a)
    if (!x.is_zero()) return x.sign() > 0;
  return true;
}

class Arrangement {
 public:
  explicit Arrangement(const std::vector<LocalCone>& cones) {
    for (const LocalCone& cone : cones) {
      std::vector<std::pair<std::size_t, bool>> sides;
      for (const ExactPoint& n : cone.inner) {
        const Ray ray = ray_of(n);
        const bool is_forward = is_canonical(ray);
        sides.emplace_back(number_of(is_forward ? ray : opposite(ray)), is_forward);
      }
      cones_.emplace_back(cone.coefficient, std::move(sides));
    }
    num_own_ = planes_.size();
    // With these three there is a vertex, and no plane without a line.
    number_of({1, 0, 0});
    number_of({0, 1, 0});
    number_of({0, 0, 1});
  }

  std::size_t num_planes() const { return num_own_; }

  int regular() {
    add(std::vector<Sign>(planes_.size(), Sign::kZero), false);
    for (std::size_t i = 0; i < planes_.size(); ++i) visit_plane(i);
    if (!has_value_) return 0;
    return greatest_ > 0 ? greatest_ : least_;
  }

 private:
  std::size_t number_of(const Ray& plane) {
    const auto [known, is_new] = numbers_.emplace(plane, planes_.size());
    if (is_new) planes_.push_back(plane);
    return known->second;
  }

  // The value on a face, given by the signs of its points on all planes.
  void add(const std::vector<Sign>& signs, bool is_open) {
    int sum = 0;
    for (const auto& [coefficient, sides] : cones_) {
      const bool is_in = std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        return side.second ? signs[side.first] >= 0 : signs[side.first] <= 0;
      });
      if (is_in) sum += coefficient;
    }
    greatest_ = std::max(greatest_, sum);
    least_ = std::min(least_, sum);
    has_value_ = has_value_ || (is_open && sum != 0);
  }

  std::vector<Sign> signs_at(const Ray& d) const {
    std::vector<Sign> out;
    for (const Ray& plane : planes_) out.push_back(dot_of(plane, d).sign());
    return out;
  }

  // Its rays in the order of their angles, the sectors between them, and the cells on both sides of these.
  void visit_plane(std::size_t i) {
    std::vector<Ray> rays;
    for (std::size_t j = 0; j < planes_.size(); ++j) {
      const Ray ray = cross_of(planes_[i], planes_[j]);
      if (is_null(ray)) continue;
      rays.push_back(primitive(ray));
      rays.push_back(opposite(rays.back()));
    }
    const Ray& first = rays.front();
    const auto turn = [&](const Ray& a, const Ray& b) {
      return dot_of(planes_[i], cross_of(a, b)).sign();
    };
    // 0: along the first ray or up to half a turn after it; 1: from half a turn on.
    const auto half = [&](const Ray& a) {
      const Sign s = turn(first, a);
      if (s != 0) return s > 0 ? 0 : 1;
      return dot_of(first, a).sign() > 0 ? 0 : 1;
    };
    std::sort(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) {
      const int ha = half(a), hb = half(b);
      return ha != hb ? ha < hb : turn(a, b) > 0;
    });
    rays.erase(std::unique(rays.begin(), rays.end()), rays.end());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      add(signs_at(rays[k]), false);
      std::vector<Sign> signs = signs_at(sum_of_rays(rays[k], rays[(k + 1) % rays.size()]));
      add(signs, false);
      for (const Sign side : {Sign::kPositive, Sign::kNegative}) {
        signs[i] = side;
        add(signs, true);
      }
    }
  }

  std::map<Ray, std::size_t> numbers_;
  std::vector<Ray> planes_;
  std::size_t num_own_ = 0;
  std::vector<std::pair<int, std::vector<std::pair<std::size_t, bool>>>> cones_;
  int greatest_ = 0, least_ = 0;
  bool has_value_ = false;
};

}  // namespace

std::optional<int> regular_value(const std::vector<LocalCone>& cones) {
  Arrangement arrangement(cones);
  if (arrangement.num_planes() > kMostPlanes) return std::nullopt;
  return arrangement.regular();
}

}  // namespace veritope::internal
