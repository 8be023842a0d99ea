// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_shells.cc: spline models as solids for I0, I2 and I3 of docs/certificates/micro-inside.md, section 8.
#include "../patches/star_box.h"
#include "micro_inside.h"

namespace {

Ratio ratio_of(double x) {  // a finite one
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
  return scaled(Ratio(Big(int64_t(std::ldexp(m, 53)))), exponent - 53);
}
// A point with the coordinates x, each rounded to a multiple of 2^k, in units of 2^unit.
RationalPoint rounded(const Ratio* x, int k, int64_t unit) {
  Ratio r[3];
  for (size_t i = 0; i < 3; ++i) {
    const Big n = k < 0 ? shifted(x[i].n, -k) : x[i].n, d = k > 0 ? shifted(x[i].d, k) : x[i].d;
    r[i] = scaled(Ratio(divide(n, d, nullptr)), k - unit);
  }
  return RationalPoint(r);
}
// A point of the hull, in units of 2^unit, that no symmetry of the model singles out. It is a mean of four computed
// points with positive weights, exactly, but for less than a sixteenth of their error e in each coordinate: what parts
// the computed points from a node, parts it, too, since the bounds of d.q add 4 d e, where 3 d e would do.
RationalPoint point_of(const PointHull& hull, int64_t unit) {
  const int weights[4] = {13, 15, 17, 19};  // of 64
  const size_t count = hull.p.size() / 3;
  Ratio x[3];
  for (size_t i = 0; i < 4; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const Ratio p = ratio_of(hull.p[3 * (i * (count - 1) / 3) + k]);
      x[k] = x[k] - lowest(Ratio(p.n * Big(-weights[i]), p.d * Big(64)));
    }
  const bool is_small = !(hull.error > 1e-290);
  return rounded(x, is_small ? -1100 : std::ilogb(hull.error) - 4, unit);
}

class PatchesAround : public SolidAround {
 public:
  explicit PatchesAround(const SolidPatches& solid)
      : solid_(solid), boxes_(solid.grids), units_(solid.bytes, 0) {}

  void check_shells(const std::vector<PatchOfCell>& shells, OffSurface* off) override {
    units_ = PointUnits(solid_.bytes, shells.size());
    std::set<OffSurface::BlockKey> known;  // whose points' winding numbers are 1
    for (const PatchOfCell& first : shells) {
      PointHull hull;
      OffSurface::BlockKey key;
      if (!off->point_of_block(first, &key, &hull))
        off->point_near(first, &hull);
      else if (!known.insert(key).second)
        continue;
      int64_t sum = 0;
      for (const auto& of : windings(point_of(hull, solid_.unit), false, "I2")) sum += of.second;
      require(sum == 1, "I2", "the winding number is not 1 around the point of the shell of cell",
              first.cell);
    }
  }
  void begin_voids(uint64_t entries) override {
    units_ = PointUnits(solid_.bytes, entries + (solid_.shells > 1 ? solid_.shells : 0));
  }
  const std::vector<uint64_t>& depths() override {
    if (depths_.empty()) depths_.assign(solid_.shells, 0);
    if (solid_.shells == 1) return depths_;
    std::vector<bool> is_seen(solid_.shells);
    for (uint32_t patch = 0; patch < solid_.grids.size(); ++patch) {
      const uint32_t shell = solid_.shell[patch];
      if (is_seen[shell]) continue;
      is_seen[shell] = true;
      const std::vector<Big>& net = solid_.grids[patch].net;
      Ratio x[3];
      for (size_t k = 0; k < 3; ++k) x[k] = lowest(Ratio(net[k], net[3]));
      depths_[shell] = uint64_t(windings(RationalPoint(x), true, "I3", shell).size());
    }
    return depths_;
  }
  std::map<uint32_t, int64_t> around(const std::vector<Big>& q, uint32_t) override {
    Ratio x[3];
    for (size_t k = 0; k < 3; ++k) x[k] = scaled(lowest(Ratio(q[k], q[3])), -solid_.unit);
    return windings(RationalPoint(x), true, "I3");
  }

 private:
  // Those of shells that are not 0, but for one shell; or, unless by_shell, their sum as that of shell 0. The point has
  // to be on none of the patches.
  std::map<uint32_t, int64_t> windings(const RationalPoint& q, bool by_shell, const char* id,
                                       uint32_t without = kNoPair) {
    for (int direction = 0; direction < 6; ++direction) {
      std::map<uint32_t, std::vector<uint32_t>> patches;
      for (uint32_t patch : boxes_.on_ray(q, direction))
        if (!by_shell || solid_.shell[patch] != without)
          patches[by_shell ? solid_.shell[patch] : 0].push_back(patch);
      std::map<uint32_t, int64_t> found;
      bool is_known = true;
      for (const auto& of : patches) {
        int64_t sum = 0;
        is_known = is_known && sum_of(of.second, q, direction, id, &sum);
        if (sum != 0) found[of.first] = sum;
      }
      if (is_known) return found;
    }
    throw Rejected{id, "a point may be on the model, or is in a bad place for each direction"};
  }
  // False, too, if the direction takes more work than one point may.
  bool sum_of(const std::vector<uint32_t>& patches, const RationalPoint& q, int direction,
              const char* id, int64_t* sum) {
    units_.begin_point();
    try {
      return sum_around(solid_.grids, patches, q, direction, &units_, sum);
    } catch (const Rejected& r) {
      if (units_.are_spent()) throw Rejected{id, r.why};
      return false;
    }
  }

  const SolidPatches& solid_;
  const PatchBoxes boxes_;
  PointUnits units_;
  std::vector<uint64_t> depths_;
};

}  // namespace

SolidPatches check_solid_patches(const std::vector<Entity>& entities, uint64_t model_bytes,
                                 const Body& part) {
  StarBody star = read_star_body("VTS2", entities, part, [](StarBytes*) {});
  SolidPatches r;
  r.bytes = model_bytes + part.left();
  {
    const StarCheck check(&star, r.bytes, false);
    require(check.walks.bodies > 0, "W3", "the model has no body");
    r.shells = check.x.components;
  }
  require(star.num_reversed == 0, "I0", "flags of patches:", star.num_reversed);
  r.unit = star.unit;
  for (const Patch& p : star.patches) {
    r.grids.push_back(Grid(p));
    r.is_rational.push_back(p.is_rational);
    r.shell.push_back(p.component);
  }
  return r;
}
std::unique_ptr<SolidAround> around_patches(const SolidPatches& solid) {
  return std::unique_ptr<SolidAround>(new PatchesAround(solid));
}
