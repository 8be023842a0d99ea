// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/enclosed_walls_internal.h"

#include <algorithm>
#include <set>
#include <vector>

#include "solids/expression/enclosed_place_internal.h"
#include "solids/expression/patch_jet_internal.h"
#include "solids/expression/same_sheet_internal.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kMostSurfaces = 12, kMostNormals = 12;

// The cones with an enclosure, in classes of one surface: the bit of each is that of its class, or the other one.
class Ties {
 public:
  explicit Ties(std::span<const TangentCone> cones) {
    for (std::size_t i = 0; i < cones.size(); ++i) {
      if (!cones[i].enclosure) continue;
      std::size_t c = 0;
      int tie = 0;
      for (; c < first_.size(); ++c)
        if ((tie = tie_of(cones[first_[c]], cones[i])) != 0) break;
      if (tie == 0) first_.push_back(i);
      members_.push_back({i, c, tie < 0});
    }
  }

  std::size_t size() const { return first_.size(); }
  /// Sets the bits of all members.
  void set(std::uint32_t pattern, NearbyBits& bits) const {
    for (const Member& m : members_)
      bits[m.cone] = ((pattern >> m.number & 1) != 0) != m.is_opposite;
  }

 private:
  struct Member {
    std::size_t cone, number;
    bool is_opposite;
  };
  // The search for a common point is not symmetric.
  static int tie_of(const TangentCone& a, const TangentCone& b) {
    const int tie = enclosed_tie(a, b);
    return tie != 0 ? tie : enclosed_tie(b, a);
  }

  std::vector<std::size_t> first_;  // of each class
  std::vector<Member> members_;
};

// The patterns of bits that the cones with sectors may have near the apex: if they are flat, those that they have;
// otherwise all. Others are 0.
std::vector<NearbyBits> patterns_of_sectors(std::span<const TangentCone> cones) {
  std::vector<TangentCone> exact;
  std::vector<std::size_t> number;
  bool are_flat = true;
  for (std::size_t i = 0; i < cones.size(); ++i)
    if (!cones[i].enclosure) {
      exact.push_back(cones[i]);
      number.push_back(i);
      are_flat = are_flat && cones[i].is_flat;
    }
  std::set<NearbyBits> found;
  if (exact.empty() || are_flat) {
    if (exact.empty()) found.insert(NearbyBits());
    // A function of one value: all cells are visited.
    common_value(exact, [&](const NearbyBits& bits) { return found.insert(bits), false; });
  } else if (exact.size() <= kMostSurfaces) {
    for (std::uint32_t pattern = 0; pattern < std::uint32_t{1} << exact.size(); ++pattern) {
      NearbyBits bits(exact.size());
      for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = (pattern >> k & 1) != 0;
      found.insert(std::move(bits));
    }
  }
  std::vector<NearbyBits> out;
  for (const NearbyBits& bits : found) {
    out.emplace_back(cones.size());
    for (std::size_t k = 0; k < bits.size(); ++k) out.back()[number[k]] = bits[k];
  }
  return out;
}

// Over all patterns that may occur.
ValuesNear values_of_patterns(const Ties& ties, std::vector<NearbyBits> patterns,
                              const NearbyFunction& f) {
  if (ties.size() > kMostSurfaces || patterns.empty()) return ValuesNear::kUnknown;
  const std::uint32_t count = std::uint32_t{1} << ties.size();
  std::vector<std::vector<bool>> values(patterns.size(), std::vector<bool>(count));
  bool has[2] = {};
  for (std::size_t k = 0; k < patterns.size(); ++k)
    for (std::uint32_t classes = 0; classes < count; ++classes) {
      ties.set(classes, patterns[k]);
      const bool value = f(patterns[k]);
      values[k][classes] = value;
      has[value ? 1 : 0] = true;
    }
  if (!has[0] || !has[1]) return has[1] ? ValuesNear::kOnlyOne : ValuesNear::kOnlyZero;
  // Both bits of one surface occur.
  if (std::any_of(values.begin(), values.end(), [&](const auto& v) { return v != values[0]; }))
    return ValuesNear::kUnknown;
  std::size_t num_needed = 0;
  for (std::size_t c = 0; c < ties.size(); ++c) {
    bool is_needed = false;
    for (std::uint32_t classes = 0; classes < count; ++classes)
      is_needed |= values[0][classes] != values[0][classes ^ (std::uint32_t{1} << c)];
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
  const ValuesNear by_patterns = values_of_patterns(Ties(cones), patterns_of_sectors(cones), f);
  if (by_patterns != ValuesNear::kUnknown) return by_patterns;
  return Directions(cones, f).have_both_values() ? ValuesNear::kBoth : ValuesNear::kUnknown;
}

}  // namespace veritope::internal
