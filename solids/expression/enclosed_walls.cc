// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/enclosed_walls_internal.h"

#include <algorithm>
#include <vector>

#include "solids/expression/enclosed_place_internal.h"
#include "solids/expression/patch_jet_internal.h"
#include "solids/expression/same_sheet_internal.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kMostSurfaces = 12, kMostNormals = 12;

// Cones in classes of one surface: the bit of each is that of the class, or the other one.
struct Ties {
  std::vector<std::size_t> class_of;
  std::vector<bool> is_opposite;
  std::size_t num_classes = 0;

  explicit Ties(std::span<const TangentCone> cones)
      : class_of(cones.size()), is_opposite(cones.size()) {
    std::vector<std::size_t> first;
    for (std::size_t i = 0; i < cones.size(); ++i) {
      int tie = 0;
      class_of[i] = first.size();
      for (std::size_t c = 0; c < first.size() && tie == 0; ++c) {
        tie = tie_of(cones[first[c]], cones[i]);
        if (tie != 0) class_of[i] = c;
      }
      is_opposite[i] = tie < 0;
      if (tie == 0) first.push_back(i);
    }
    num_classes = first.size();
  }

 private:
  // The search for a common point is not symmetric.
  static int tie_of(const TangentCone& a, const TangentCone& b) {
    if (!a.enclosure || !b.enclosure) return 0;
    const int tie = enclosed_tie(a, b);
    return tie != 0 ? tie : enclosed_tie(b, a);
  }
};

// Over all bits of the classes.
ValuesNear values_of_patterns(const Ties& ties, const NearbyFunction& f) {
  if (ties.num_classes > kMostSurfaces) return ValuesNear::kUnknown;
  const std::uint32_t count = std::uint32_t{1} << ties.num_classes;
  std::vector<bool> values(count);
  NearbyBits bits(ties.class_of.size());
  for (std::uint32_t pattern = 0; pattern < count; ++pattern) {
    for (std::size_t i = 0; i < bits.size(); ++i)
      bits[i] = ((pattern >> ties.class_of[i] & 1) != 0) != ties.is_opposite[i];
    values[pattern] = f(bits);
  }
  if (std::all_of(values.begin(), values.end(), [&](bool v) { return v == values[0]; }))
    return values[0] ? ValuesNear::kOnlyOne : ValuesNear::kOnlyZero;
  std::size_t num_needed = 0;
  for (std::size_t c = 0; c < ties.num_classes; ++c) {
    bool is_needed = false;
    for (std::uint32_t pattern = 0; pattern < count; ++pattern)
      is_needed |= values[pattern] != values[pattern ^ (std::uint32_t{1} << c)];
    num_needed += is_needed ? 1 : 0;
  }
  return num_needed == 1 ? ValuesNear::kBoth : ValuesNear::kUnknown;
}

// ---- directions

class Directions {
 public:
  Directions(std::span<const TangentCone> cones, const NearbyFunction& f)
      : cones_(cones), f_(f), bits_(cones.size()) {
    for (const TangentCone& cone : cones)
      if (cone.enclosure) {
        Vector n;
        for (std::size_t k = 0; k < 3; ++k)
          n[k] = (cone.enclosure->normal[k].lo + cone.enclosure->normal[k].hi) / Rational(2);
        normals_.push_back(shortened_vector(n));
      } else {
        for (const Sector& s : cone.sectors)
          normals_.push_back(shortened_vector(
              {s.normal[0].to_rational(), s.normal[1].to_rational(), s.normal[2].to_rational()}));
      }
    if (normals_.size() > kMostNormals) normals_.resize(kMostNormals);
  }

  // Tries a direction in each wedge of two planes, and in each octant of three.
  bool have_both_values() {
    const std::size_t n = normals_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const Vector across = crossed(normals_[i], normals_[j]);
        if (is_zero(across)) continue;
        try_octants({normals_[i], normals_[j], across});
        for (std::size_t k = j + 1; k < n && !has_both(); ++k)
          if (dotted(across, normals_[k]).sign() != 0)
            try_octants({normals_[i], normals_[j], normals_[k]});
        if (has_both()) return true;
      }
    return has_both();
  }

 private:
  bool has_both() const { return has_[0] && has_[1]; }

  // Few bits: directions are only tried.
  static Vector shortened_vector(const Vector& a) {
    Rational most;
    for (const Rational& x : a) most = std::max(most, x.sign() < 0 ? -x : x);
    if (most.sign() == 0) return a;
    Vector out;
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = rounded_down(a[k] / most * Rational::power_of_two(60));
    return out;
  }

  // With products of given signs with three vectors.
  void try_octants(const std::array<Vector, 3>& n) {
    const std::array<Vector, 3> dual{crossed(n[1], n[2]), crossed(n[2], n[0]), crossed(n[0], n[1])};
    const bool is_left = dotted(n[0], dual[0]).sign() < 0;
    for (int octant = 0; octant < 8; ++octant) {
      Vector d;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          d[k] += ((octant >> i & 1) != 0) == is_left ? dual[i][k] : -dual[i][k];
      try_direction(d);
    }
  }

  void try_direction(const Vector& d) {
    const Direction direction = exact_direction(d);
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      const TangentCone& cone = cones_[i];
      if (!cone.enclosure) {
        for (const Sector& s : cone.sectors)
          if (side(s.normal, direction) == 0) return;
        bits_[i] = is_inside(cone.sectors, direction);
        continue;
      }
      ExactInterval along{0, 0};
      for (std::size_t k = 0; k < 3; ++k)
        along = sum(along, product(cone.enclosure->normal[k], {d[k], d[k]}));
      if (along.lo.sign() <= 0 && along.hi.sign() >= 0) return;
      bits_[i] = along.hi.sign() < 0;
    }
    has_[f_(bits_) ? 1 : 0] = true;
  }

  static Direction exact_direction(const Vector& d) {
    std::array<Dyadic, 3> out;  // integers
    for (std::size_t k = 0; k < 3; ++k) out[k] = Dyadic(d[k].numerator());
    return Direction(std::move(out));
  }

  std::span<const TangentCone> cones_;
  const NearbyFunction& f_;
  NearbyBits bits_;
  std::vector<Vector> normals_;
  bool has_[2] = {};
};

}  // namespace

ValuesNear values_near(std::span<const TangentCone> cones, const NearbyFunction& f) {
  const ValuesNear by_patterns = values_of_patterns(Ties(cones), f);
  if (by_patterns != ValuesNear::kUnknown) return by_patterns;
  return Directions(cones, f).have_both_values() ? ValuesNear::kBoth : ValuesNear::kUnknown;
}

}  // namespace veritope::internal
