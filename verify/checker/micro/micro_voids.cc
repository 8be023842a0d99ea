// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_voids.cc: I2 and I3 of docs/certificates/micro-inside.md.
#include <cstring>

#include "../points/mesh_points.h"
#include "micro_bridges.h"
#include "micro_inside.h"

namespace {

int64_t key_of(double x) {
  uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  const int64_t r = int64_t(bits & ~(uint64_t(1) << 63));
  return bits >> 63 != 0 ? -r : r;
}
Nat natural_of(const Big& a) {
  Nat r;
  for (uint64_t limb : a.m) r.push_back(uint32_t(limb)), r.push_back(uint32_t(limb >> 32));
  drop_zeros(&r);
  return r;
}

class VoidCheck {
 public:
  VoidCheck(TileParts* parts, SolidAround* solid)
      : file_(parts->file()),
        maps_(parts->maps()),
        solid_(*solid),
        depths_(solid->depths()),
        bridges_(boxes_of(file_)),
        sweeps_(boxes_of_sweeps(parts)) {}

  void check(const VoidEntry& v, uint32_t shell) {
    check_bridges(v);
    const std::vector<Big> q = maps_.point(v.volume, v.x);
    check_sweeps(q);
    if (v.corner == 8)
      check_empty(v);
    else
      check_corner(v);
    check_hole(q, shell);
  }

 private:
  static RatioBox box_of_bridge(const MicroBridge& b) {
    RatioBox r;
    for (size_t i = 0; i < b.net.size(); i += 3)
      for (size_t k = 0; k < 3; ++k) {
        const Ratio x(b.net[i + k], b.scale);
        if (i == 0 || compare(x, r.lo[k]) < 0) r.lo[k] = x;
        if (i == 0 || compare(r.hi[k], x) < 0) r.hi[k] = x;
      }
    return r;
  }
  static std::vector<DoubleBox> boxes_of(const MicroFile& file) {
    std::vector<DoubleBox> r;
    for (const MicroBridge& b : file.bridges) r.push_back(outer(box_of_bridge(b)));
    return r;
  }
  static std::vector<DoubleBox> boxes_of_sweeps(TileParts* parts) {
    std::vector<DoubleBox> r;
    PointHull hull;
    for (const MicroSweep& b : parts->file().sweeps) {
      const SweepPart part(parts, b, r.size(), "I3");
      part.set_points(part.cap(), 0, 1, &hull);
      require(hull.is_known, "I3", "the numbers are too large, of sweep", r.size());
      r.push_back(hull.box);
    }
    return r;
  }
  static void fail(const char* why) { throw Rejected{"I3", why}; }

  void check_bridges(const VoidEntry& v) const {
    RatioBox x;
    for (size_t k = 0; k < 3; ++k) {
      const std::vector<Ratio>& t = file_.cage[v.volume].knots[k];
      require(compare(t[0], v.x[k]) < 0 && compare(v.x[k], t.back()) < 0, "I3",
              "x is not inside of volume", v.volume);
      x.lo[k] = x.hi[k] = v.x[k];
    }
    bridges_.each(outer(x), [&](uint32_t i) {
      const MicroBridge& b = file_.bridges[i];
      require(b.volume != v.volume || !meet(box_of_bridge(b), x), "I3", "x is in the box of bridge",
              i);
      return true;
    });
  }
  // Bounds of q: it may be called to be in a box by whose rounding it is.
  void check_sweeps(const std::vector<Big>& q) const {
    DoubleBox at;
    for (size_t k = 0; k < 3; ++k) {
      const Span x = span_of(q[k], q[3]);
      at.lo[k] = x.lo, at.hi[k] = x.hi;
    }
    sweeps_.each(at, [](uint32_t i) -> bool {
      require(false, "I3", "the image of x may be in the box of sweep", i);
      return false;
    });
  }
  // The cells of a grid that hold x: of an axis one, or two if x is a break.
  static void cells_at(const std::vector<Ratio>& b, const Ratio& x, size_t* first, size_t* last) {
    const auto less = [](const Ratio& a, const Ratio& c) { return compare(a, c) < 0; };
    const size_t not_below = size_t(std::lower_bound(b.begin(), b.end(), x, less) - b.begin());
    const size_t above = size_t(std::upper_bound(b.begin(), b.end(), x, less) - b.begin());
    *first = not_below == 0 ? 0 : not_below - 1;
    *last = std::min(above, b.size() - 1);
  }
  // Calls use(grid, i) for each closed cell that holds x and a tile.
  template <class Use>
  void each_cell(const VoidEntry& v, Use use) const {
    for (size_t n = first_grid_of(file_, v.volume); n < file_.grids.size(); ++n) {
      const MicroGrid& g = file_.grids[n];
      if (g.volume != v.volume) break;
      size_t first[3], last[3], i[3];
      for (size_t k = 0; k < 3; ++k) cells_at(g.breaks[k], v.x[k], &first[k], &last[k]);
      for (i[0] = first[0]; i[0] < last[0]; ++i[0])
        for (i[1] = first[1]; i[1] < last[1]; ++i[1])
          for (i[2] = first[2]; i[2] < last[2]; ++i[2])
            if (g.tile[g.cell(i)] != 0) use(g, static_cast<const size_t*>(i));
    }
  }
  void check_empty(const VoidEntry& v) const {
    each_cell(v, [](const MicroGrid&, const size_t*) { fail("x is in a cell that holds a tile"); });
  }
  void check_corner(const VoidEntry& v) const {
    bool is_found = false;
    each_cell(v, [&](const MicroGrid& g, const size_t* i) {
      Ratio lo[3], hi[3];  // of the box of x and the corner, in the unit cube
      for (size_t k = 0; k < 3; ++k) {
        const Ratio &begin = g.breaks[k][i[k]], &end = g.breaks[k][i[k] + 1];
        const Ratio x = ratio_quotient(v.x[k] - begin, end - begin);
        if (x.n.sign() <= 0 || !(x.n < x.d)) fail("x is not inside of a cell");
        const bool is_end = (v.corner >> k & 1) != 0;
        lo[k] = is_end ? x : Ratio(Big(0));
        hi[k] = is_end ? Ratio(Big(1)) : x;
      }
      is_found = true;
      const MicroTile& tile = file_.tiles[g.tile[g.cell(i)] - size_t(1)];
      int visited = 0;
      for (uint64_t s = 0; s < tile.patches.size(); ++s) {
        const MicroPatch& patch = tile.patches[s];
        const uint32_t number = patch.wall < 0 ? 0 : g.number(i, size_t(patch.wall));
        check_missed(at_number(patch, number), lo, hi, "I3", s, &visited);
      }
    });
    if (!is_found) fail("x is in no cell that holds a tile");
  }
  void check_hole(const std::vector<Big>& q, uint32_t shell) {
    const std::map<uint32_t, int64_t> around = solid_.around(q, shell);
    require(around.count(shell) != 0, "I3", "the image of x is not in the void of shell", shell);
    require(around.size() == depths_[shell] + 1, "I3",
            "the image of x is in another shell, too, for the void of shell", shell);
  }

  const MicroFile& file_;
  VolumeMaps& maps_;
  SolidAround& solid_;
  const std::vector<uint64_t>& depths_;
  const BoxTree bridges_, sweeps_;
};

// The point that is asked about is not that of the page, but both lie in a convex set that I1's planes part from each
// triangle.
class MeshAround : public SolidAround {
 public:
  MeshAround(const Model& model, const SolidMesh& solid)
      : model_(model), solid_(solid), mesh_(model), work_(0, "I3") {}

  void check_shells(const std::vector<PatchOfCell>& shells, OffSurface* off) override {
    Work work(limit(shells.size()), "I2");
    for (const PatchOfCell& first : shells) {
      PointHull hull;
      off->point_near(first, &hull);
      Coordinate c[3];
      for (size_t k = 0; k < 3; ++k) c[k] = coordinate_of(key_of(hull.p[k]));
      const MeshPoints::Winding w = mesh_.winding(Point(c, mesh_.lattice()), 0, false, &work);
      require(!w.is_on && w.sum == 1, "I2",
              "the winding number is not 1 around the point of the shell of cell", first.cell);
    }
  }
  void begin_voids(uint64_t entries) override { work_ = Work(limit(entries), "I3"); }
  const std::vector<uint64_t>& depths() override { return solid_.depth; }
  std::map<uint32_t, int64_t> around(const std::vector<Big>& q, uint32_t shell) override {
    Coordinate c[3];
    for (size_t k = 0; k < 3; ++k) {
      Integer n;
      n.neg = q[k].neg, n.m = natural_of(q[k]);
      c[k] = coordinate_of(n, natural_of(q[3]));
    }
    bool is_on = false;
    const std::map<uint32_t, int64_t> r =
        mesh_.windings(Point(c, mesh_.lattice()), 0, solid_.shell, &work_, &is_on);
    require(!is_on, "I3", "the image of x lies on the model, for the void of shell", shell);
    return r;
  }

 private:
  uint64_t limit(uint64_t points) const { return 100 * uint64_t(model_.faces()) + 1000 * points; }

  const Model& model_;
  const SolidMesh& solid_;
  const MeshPoints mesh_;
  Work work_;
};

}  // namespace

std::unique_ptr<SolidAround> around_mesh(const Model& model, const SolidMesh& solid) {
  return std::unique_ptr<SolidAround>(new MeshAround(model, solid));
}

void check_voids(const std::vector<VoidEntry>& voids, TileParts* parts, SolidAround* solid) {
  solid->begin_voids(voids.size());
  const std::vector<uint64_t>& depths = solid->depths();
  std::vector<uint32_t> shells;  // of odd depth
  for (uint32_t s = 0; s < depths.size(); ++s)
    if (depths[s] % 2 == 1) shells.push_back(s);
  require(voids.size() == shells.size(), "I3", "the voids of the model are", shells.size());
  if (voids.empty()) return;
  VoidCheck check(parts, solid);
  for (size_t i = 0; i < voids.size(); ++i) check.check(voids[i], shells[i]);
}
