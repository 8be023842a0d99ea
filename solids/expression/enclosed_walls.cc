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

// The enclosed cones, in classes of one surface: the bit of each is that of its class, or the other one. Those of edges
// are alone.
class Ties {
 public:
  explicit Ties(std::span<const TangentCone> cones) {
    for (std::size_t i = 0; i < cones.size(); ++i) {
      if (!cones[i].is_enclosed()) continue;
      std::size_t c = 0;
      int tie = 0;
      for (; c < first_.size(); ++c)
        if ((tie = tie_of(cones[first_[c]], cones[i])) != 0) break;
      if (tie == 0) first_.push_back(i);
      members_.push_back({i, c, tie < 0});
    }
  }

  std::size_t size() const { return first_.size(); }
  /// A mask for the class of a cone.
  std::uint32_t class_of(std::size_t cone) const {
    const auto at = std::find_if(members_.begin(), members_.end(),
                                 [&](const Member& m) { return m.cone == cone; });
    return std::uint32_t{1} << at->number;
  }
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
    if (a.edge || b.edge) return 0;
    const int tie = enclosed_tie(a, b);
    return tie != 0 ? tie : enclosed_tie(b, a);
  }

  std::vector<std::size_t> first_;  // of each class
  std::vector<Member> members_;
};

struct Pattern {
  NearbyBits bits;  // of the cones with sectors; others are 0
  struct Fixed {
    std::size_t cone;
    bool bit;
  };
  std::vector<Fixed> fixed;  // bits of edges
};

// An edge whose bit one side of a plane tells.
struct PlaneOfEdge {
  std::size_t cone;
  bool is_behind;  // the side on which the bit is known: it is 1 behind the plane, 0 in front of it
};

// The patterns that may occur near the apex: if the cones with sectors are flat, those that they have, beside the
// planes of edges; otherwise all.
std::vector<Pattern> patterns_near(std::span<const TangentCone> cones) {
  std::vector<TangentCone> exact;
  std::vector<std::size_t> number;
  bool are_flat = true;
  for (std::size_t i = 0; i < cones.size(); ++i)
    if (!cones[i].is_enclosed()) {
      exact.push_back(cones[i]);
      number.push_back(i);
      are_flat = are_flat && cones[i].is_flat;
    }
  std::vector<PlaneOfEdge> planes;  // their cones are the last ones
  for (std::size_t i = 0; i < cones.size(); ++i) {
    if (!cones[i].edge || !cones[i].edge->plane || cones[i].edge->convexity == 0) continue;
    exact.push_back(flat_tangent_cone({*cones[i].edge->plane}));
    planes.push_back({i, cones[i].edge->convexity < 0});
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
  std::vector<Pattern> out;
  for (const NearbyBits& bits : found) {
    out.push_back({NearbyBits(cones.size()), {}});
    for (std::size_t k = 0; k < number.size(); ++k) out.back().bits[number[k]] = bits[k];
    for (std::size_t k = 0; k < planes.size(); ++k)
      if (bits[number.size() + k] == planes[k].is_behind)
        out.back().fixed.push_back({planes[k].cone, planes[k].is_behind});
  }
  return out;
}

// Over all patterns that may occur.
ValuesNear values_of_patterns(const Ties& ties, std::vector<Pattern> patterns,
                              const NearbyFunction& f) {
  if (ties.size() > kMostSurfaces || patterns.empty()) return ValuesNear::kUnknown;
  const std::uint32_t count = std::uint32_t{1} << ties.size();
  std::vector<std::vector<bool>> values(patterns.size(), std::vector<bool>(count));
  bool has[2] = {}, is_any_fixed = false;
  for (std::size_t k = 0; k < patterns.size(); ++k) {
    std::uint32_t fixed = 0, wanted = 0;
    for (const auto& [cone, bit] : patterns[k].fixed) {
      fixed |= ties.class_of(cone);
      wanted |= bit ? ties.class_of(cone) : 0;
    }
    is_any_fixed = is_any_fixed || fixed != 0;
    for (std::uint32_t classes = 0; classes < count; ++classes) {
      if ((classes & fixed) != wanted) continue;
      ties.set(classes, patterns[k].bits);
      const bool value = f(patterns[k].bits);
      values[k][classes] = value;
      has[value ? 1 : 0] = true;
    }
  }
  if (!has[0] || !has[1]) return has[1] ? ValuesNear::kOnlyOne : ValuesNear::kOnlyZero;
  // Both bits of one surface occur.
  if (is_any_fixed ||
      std::any_of(values.begin(), values.end(), [&](const auto& v) { return v != values[0]; }))
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
        add_middle(cone.enclosure->normal);
      } else if (cone.edge) {
        for (const EnclosedVector& n : cone.edge->normals) add_middle(n);
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

  void add_middle(const EnclosedVector& normal) {
    Vector n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = (normal[k].lo + normal[k].hi) / Rational(2);
    normals_.push_back(shortened_vector(n));
  }

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
      if (!cone.is_enclosed()) {
        for (const Sector& s : cone.sectors)
          if (side(s.normal, direction) == 0) return;
        bits_[i] = is_inside(cone.sectors, direction);
        continue;
      }
      const Sign side =
          cone.edge ? side_of_edge(*cone.edge, d) : side_of(cone.enclosure->normal, d);
      if (side == 0) return;
      bits_[i] = side < 0;
    }
    has_[f_(bits_) ? 1 : 0] = true;
  }

  static Sign side_of(const EnclosedVector& normal, const Vector& d) {
    EnclosedVector exact;
    for (std::size_t k = 0; k < 3; ++k) exact[k] = {d[k], d[k]};
    return sign_of(dotted(normal, exact));
  }
  // Negative inside. In front of one patch and behind the other one a direction is outside if the solid has less than a
  // half turn at the edge, inside if it has more.
  static Sign side_of_edge(const TangentCone::EnclosedEdge& edge, const Vector& d) {
    const Sign a = side_of(edge.normals[0], d), b = side_of(edge.normals[1], d);
    if (a == 0 || b == 0) return Sign::kZero;
    return a == b ? a : edge.convexity;
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
  const ValuesNear by_patterns = values_of_patterns(Ties(cones), patterns_near(cones), f);
  if (by_patterns != ValuesNear::kUnknown) return by_patterns;
  return Directions(cones, f).have_both_values() ? ValuesNear::kBoth : ValuesNear::kUnknown;
}

}  // namespace veritope::internal
