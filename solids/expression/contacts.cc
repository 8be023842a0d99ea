// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/contacts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "robust/base/check.h"
#include "solids/expression/arc_walk_internal.h"
#include "solids/expression/same_sheet_internal.h"

namespace veritope {
namespace {

using internal::SheetOf;

// A half-plane of a boundary beside a direction t.
struct HalfSheet {
  SheetOf of;
  Direction inward;      // in the plane, across t
  bool is_solid_behind;  // the solid is on the side to which a counter-clockwise turn around t goes
  const SheetRim* rim = nullptr;  // the border along t; null: the sheet continues beyond t
};

// One boundary beside a direction of its cone.
struct BoundaryAlong {
  std::size_t cone = 0;
  std::vector<HalfSheet> halves;  // two, unless several edges leave in one direction
  bool is_simple() const { return halves.size() == 2; }
  bool is_sheet = false;           // one surface, which continues across t
  const SheetRim* edge = nullptr;  // of two halves
};

bool is_same_direction(const Direction& a, const Direction& b) {
  return is_parallel(a, b) && dot(a, b).sign() > 0;
}

// The remembered results of comparisons at one point.
class SheetPairs {
 public:
  bool is_same_surface(const SheetOf& a, const SheetOf& b) {
    const std::pair key(&a.sheet(), &b.sheet());
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    return known_[key] = key.first == key.second || internal::is_same_surface(a, b);
  }

 private:
  std::map<std::pair<const ConeSheet*, const ConeSheet*>, bool> known_;
};

// The half-plane of a sector with the rim t, its first ray or its last one.
HalfSheet half_at_rim(const SheetOf& of, const Direction& t, bool is_first) {
  const Direction across = cross(of.sector().normal, t);
  const SheetRim& rim = of.sheet().rims[is_first ? 0 : 1];
  return {of, is_first ? across : -across, !is_first, rim.is_cut ? nullptr : &rim};
}

BoundaryAlong boundary_along(const TangentCone& cone, std::size_t number, const Direction& t,
                             SheetPairs& pairs) {
  BoundaryAlong out;
  out.cone = number;
  for (std::size_t i = 0; i < cone.sectors.size(); ++i) {
    const Sector& s = cone.sectors[i];
    if (side(s.normal, t) != 0 || !s.contains(t)) continue;
    const SheetOf of{&cone, i};
    if (s.holds(t)) {
      const Direction across = cross(s.normal, t);
      out.halves = {{of, across, false}, {of, -across, true}};
      out.is_sheet = true;
      return out;
    }
    out.halves.push_back(half_at_rim(of, t, is_same_direction(s.rays.front(), t)));
  }
  if (!out.is_simple()) return out;
  const HalfSheet &a = out.halves[0], &b = out.halves[1];
  out.edge = a.rim;
  out.is_sheet = a.rim == nullptr || pairs.is_same_surface(a.of, b.of);
  return out;
}

// All boundaries that leave the apex in the direction t.
class Meeting {
 public:
  Meeting(std::span<const TangentCone> cones, const Direction& t, SheetPairs& pairs)
      : t_(t), pairs_(pairs), bits_(cones.size()) {
    for (std::size_t i = 0; i < cones.size(); ++i) {
      BoundaryAlong b = boundary_along(cones[i], i, t, pairs);
      if (b.halves.empty())
        bits_[i] = is_inside(cones[i].sectors, t);
      else
        members_.push_back(std::move(b));
    }
  }

  std::size_t size() const { return members_.size(); }

  // Whether f has the value for all patterns of bits that may occur.
  bool is_settled(const NearbyFunction& f, bool value) {
    if (size() < 2) return true;
    if (size() > kMostMembers) return false;
    find_cells();
    find_groups();
    // If all fit, the cells have all patterns.
    const Mask all = ~Mask{0} >> (kMostMembers - size());
    if (std::find(groups_.begin(), groups_.end(), all) != groups_.end())
      return std::all_of(cells_.begin(), cells_.end(),
                         [&](Mask cell) { return value_of(cell, f) == value; });
    if (size() > kMostInContact) return false;
    for (Mask pattern = 0; pattern <= all; ++pattern)
      if (!is_excluded(pattern) && value_of(pattern, f) != value) return false;
    return true;
  }

  Contact contact() const {
    Contact out;
    for (const BoundaryAlong& b : members_) {
      out.cones.push_back(b.cone);
      out.sheets.push_back(b.halves[0].of.sheet().number);
    }
    return out;
  }

 private:
  using Mask = std::uint64_t;
  static constexpr std::size_t kMostMembers = 64;

  bool value_of(Mask pattern, const NearbyFunction& f) {
    for (std::size_t m = 0; m < size(); ++m) bits_[members_[m].cone] = (pattern >> m & 1) != 0;
    return f(bits_);
  }

  // ---- the bits between neighbouring half-planes around t

  void find_cells() {
    struct Ray {
      const Direction* inward;
      std::size_t member;
      bool is_solid_behind;
    };
    std::vector<Ray> rays;
    for (std::size_t m = 0; m < size(); ++m)
      for (const HalfSheet& h : members_[m].halves)
        rays.push_back({&h.inward, m, h.is_solid_behind});
    const Direction& zero = *rays.front().inward;
    // Whether the turn from the first one is less than a half turn.
    const auto is_ahead = [&](const Direction& d) {
      const Sign s = turn(t_, zero, d);
      return s > 0 || (s == 0 && dot(zero, d).sign() > 0);
    };
    std::sort(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) {
      const bool ahead = is_ahead(*a.inward);
      if (ahead != is_ahead(*b.inward)) return ahead;
      return turn(t_, *a.inward, *b.inward) > 0;
    });
    Mask bits = 0;
    const auto pass = [&](const Ray& r) {
      bits = r.is_solid_behind ? bits | Mask{1} << r.member : bits & ~(Mask{1} << r.member);
    };
    for (const Ray& r : rays) pass(r);  // then the bits are those before the first one
    for (std::size_t i = 0; i < rays.size(); ++i) {
      pass(rays[i]);
      const Direction& next = *rays[(i + 1) % rays.size()].inward;
      if (!is_same_direction(*rays[i].inward, next)) cells_.push_back(bits);
    }
  }

  // ---- groups of boundaries whose joint patterns are those of the cells

  void find_groups() {
    for (std::size_t m = 0; m < size(); ++m) {
      const BoundaryAlong& b = members_[m];
      if (!b.is_simple()) continue;
      if (b.edge != nullptr) add_groups(*b.edge, m);
      if (!b.is_sheet) continue;
      if (b.halves[0].of.sheet().is_flat) {
        add_groups(SheetRim{}, m);
        continue;
      }
      std::vector<std::size_t> same;
      for (std::size_t k = 0; k < size(); ++k)
        if (members_[k].is_sheet && is_same(b.halves[0], members_[k].halves[0])) same.push_back(k);
      add_group(same);
    }
  }

  bool is_same(const HalfSheet& a, const HalfSheet& b) {
    return pairs_.is_same_surface(a.of, b.of);
  }

  // Groups of boundaries that have a curve in common, which is that of `owner`.
  void add_groups(const SheetRim& curve, std::size_t owner) {
    std::vector<std::size_t> holders;
    for (std::size_t k = 0; k < size(); ++k)
      if (k == owner || has_curve(members_[k], curve, members_[owner])) holders.push_back(k);
    for (const std::size_t first : holders) {
      std::vector<std::size_t> group{first};
      for (const std::size_t k : holders)
        if (k != first && std::all_of(group.begin(), group.end(), [&](std::size_t other) {
              return do_fit(members_[k], members_[other]);
            }))
          group.push_back(k);
      add_group(group);
    }
  }

  bool has_curve(const BoundaryAlong& b, const SheetRim& curve, const BoundaryAlong& owner) {
    if (!b.is_simple()) return false;
    if (b.edge != nullptr && internal::is_same_curve(*b.edge, curve)) return true;
    if (!b.is_sheet) return false;
    if (b.halves[0].of.sheet().is_flat)
      return internal::is_in_plane(curve, b.halves[0].of.sector());
    return owner.edge != nullptr &&
           std::any_of(owner.halves.begin(), owner.halves.end(),
                       [&](const HalfSheet& h) { return is_same(h, b.halves[0]); });
  }

  // Whether halves in one half-plane are one.
  bool do_fit(const BoundaryAlong& a, const BoundaryAlong& b) {
    for (const HalfSheet& x : a.halves)
      for (const HalfSheet& y : b.halves)
        if (is_same_direction(x.inward, y.inward) && !is_same(x, y)) return false;
    return true;
  }

  void add_group(const std::vector<std::size_t>& members) {
    if (members.size() < 2) return;
    Mask group = 0;
    for (const std::size_t m : members) group |= Mask{1} << m;
    groups_.push_back(group);
  }

  // A group has this pattern in no cell.
  bool is_excluded(Mask pattern) const {
    return std::any_of(groups_.begin(), groups_.end(), [&](Mask group) {
      return std::none_of(cells_.begin(), cells_.end(),
                          [&](Mask cell) { return (cell & group) == (pattern & group); });
    });
  }

  const Direction& t_;
  SheetPairs& pairs_;
  NearbyBits bits_;
  std::vector<BoundaryAlong> members_;
  std::vector<Mask> cells_, groups_;
};

}  // namespace

std::optional<Contact> find_contact(std::span<const TangentCone> cones, const NearbyFunction& f,
                                    bool value) {
  SheetPairs pairs;
  std::optional<Contact> out;
  const auto look = [&](std::size_t, const Sector&, const Direction& t) {
    Meeting meeting(cones, t, pairs);
    if (meeting.is_settled(f, value)) return true;
    out = meeting.contact();
    return false;
  };
  internal::walk_arcs(cones, look, look);
  return out;
}

}  // namespace veritope
