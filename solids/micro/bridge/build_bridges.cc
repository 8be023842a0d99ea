// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/build_bridges.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/functions.h"
#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/bridge/bridge_clearance_internal.h"
#include "solids/micro/bridge/bridge_matrix.h"
#include "solids/micro/bridge/bridge_measures_internal.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/bridge_proposals_internal.h"
#include "solids/micro/bridge/bridge_slices.h"
#include "solids/micro/surface/patch_surface.h"
#include "solids/micro/surface/triangle_surface.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using internal::BridgeProposals;
using internal::kBridgeTries;
using internal::OpenCap;
using internal::VolumeSpace;

// A bridge that only other bridges may be against.
struct FoundBridge {
  MicroBridge bridge;
  BridgeSlices slices;
  double reach = 0;  // no point of the end is farther from the surface
};
// What became of a cap.
struct CapSearch {
  OpenCap cap;
  std::optional<BridgeProposals> proposals;
  int next_try = 0;
  BridgeDrop worst = BridgeDrop::kBox;  // the latest test at which a try failed
  std::optional<FoundBridge> found;     // waits for the test against other bridges
  bool is_built = false;
  std::uint64_t unfolded = 0, proved_unfolded = 0;
};

class BridgeBuilder {
 public:
  BridgeBuilder(const SolidSurface& surface, const internal::SkinProjection& projection,
                const VModel& cage, const std::vector<AnalysedTile>& tiles,
                const BridgeOptions& options, Microstructure& micro)
      : surface_(surface),
        projection_(projection),
        cage_(cage),
        tiles_(tiles),
        options_(options),
        micro_(micro),
        cells_(micro),
        disjoint_(micro) {}

  Result<BridgeReport> run() {
    if (Status status = find_caps(); !status) return status.error();
    for (bool goes_on = true; goes_on;) {
      parallel_for(searches_.size(), 16, options_.jobs,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) advance(searches_[i]);
                   });
      goes_on = false;
      for (CapSearch& search : searches_) goes_on = accept(search) || goes_on;
    }
    conclude();
    return std::move(report_);
  }

 private:
  Status find_caps() {
    for (const VVolume& volume : micro_.cage) {
      Result<VolumeSpace> space = VolumeSpace::make(volume);
      if (!space) return space.error();
      spaces_.push_back(std::move(*space));
    }
    const auto met = walls_with_neighbours(micro_, cage_);
    if (!met) return met.error();
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      for (std::uint64_t c = 0; c < micro_.grids[g].tiles.size(); ++c) {
        if (micro_.grids[g].tiles[c] == 0) continue;
        for (int wall = 0; wall < 6; ++wall)
          if (((*met)[g][c] >> wall & 1) == 0) add_wall({g, c, wall});
      }
    if (searches_.size() > kMaxMicroBridges)
      return Error{Code::kOverLimit,
                   {},
                   "more than " + std::to_string(kMaxMicroBridges) + " caps are to be bridged"};
    return ok_status();
  }
  void add_wall(const CapPlace& place) {
    const MicroGrid& grid = micro_.grids[place.grid];
    const auto& caps =
        tiles_[grid.tiles[place.cell] - 1u].caps_of_wall[static_cast<std::size_t>(place.wall)];
    if (caps.empty()) return;
    report_.caps += caps.size();
    const auto front = front_of(micro_, cage_, place);
    auto surface = front ? cap_on_front(micro_, cage_, tiles_, place, *front) : std::nullopt;
    if (!surface) {
      for (std::size_t i = 0; i < caps.size(); ++i) drop(place, BridgeDrop::kBox);
      return;
    }
    CapSearch& search = searches_.emplace_back();
    OpenCap& cap = search.cap;
    cap.cap = place;
    cap.front = *front;
    const std::vector<Rational> middle =
        evaluate<Rational, 2>(*surface, {Rational(1) / Rational(2), Rational(1) / Rational(2)});
    for (std::size_t a = 0; a < 3; ++a) cap.middle[a] = nearest_double(middle[a]);
    cap.surface = turned_beyond(std::move(*surface), *front);
    // The cell's size beyond the front is not known; in a glued volume the own one, in parts of the domain, is taken.
    const auto axis = static_cast<std::size_t>(place.wall / 2);
    const std::size_t index = grid.shape().index_of(place.cell)[axis];
    const auto length = [&](std::uint32_t volume, std::size_t a) {
      const KnotAxis<Rational>& k = micro_.cage[volume].axis(a);
      return nearest_double(k.domain_end() - k.domain_begin());
    };
    cap.cell_size = nearest_double(grid.breaks[axis][index + 1] - grid.breaks[axis][index]) *
                    length(front->volume, front->axis) / length(grid.volume, axis);
    if (const auto at = spaces_[front->volume].place(cap.middle)) {
      const Point3d& d = at->partial[front->axis];
      cap.arm = 0.5 * cap.cell_size * std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
  }
  void drop(const CapPlace& cap, BridgeDrop why) {
    ++report_.dropped[static_cast<std::size_t>(why)];
    report_.without.emplace_back(cap, why);
  }

  // The next try that only other bridges may be against.
  void advance(CapSearch& search) const {
    if (search.is_built || search.next_try >= kBridgeTries) return;
    if (!search.proposals) {
      search.proposals.emplace(projection_, spaces_[search.cap.front.volume], options_, search.cap);
      if (search.proposals->is_flat()) {
        search.worst = BridgeDrop::kFlat;
        search.next_try = kBridgeTries;
      }
    }
    const auto view = surface_.view();
    while (search.next_try < kBridgeTries && !search.found) try_next(*view, search);
  }
  void try_next(SurfaceView& view, CapSearch& search) const {
    const auto fails = [&](BridgeDrop why) { search.worst = std::max(search.worst, why); };
    std::optional<MicroBridge> bridge = search.proposals->propose(search.next_try++);
    const BridgeFront& front = search.cap.front;
    if (!bridge || !is_in_open_box(*bridge, micro_.cage[front.volume], front))
      return fails(BridgeDrop::kBox);
    const bool is_unfolded = has_positive_determinants(*bridge);
    search.unfolded += is_unfolded;
    if (!is_unfolded || !find_bridge_matrix(*bridge)) return fails(BridgeDrop::kFolded);
    search.proved_unfolded += is_unfolded;
    BridgeSlices slices(*bridge);
    if (!cut_off_tiles(cells_, bridge->cap, front, slices)) return fails(BridgeDrop::kTile);
    const VolumeSpace& space = spaces_[front.volume];
    const auto reach = end_distance(view, space, *bridge, options_.skin);
    if (!reach || !misses_surface(view, space, *bridge)) return fails(BridgeDrop::kSkin);
    search.found = FoundBridge{std::move(*bridge), std::move(slices), *reach};
  }

  // Whether the search goes on.
  bool accept(CapSearch& search) {
    if (search.is_built || !search.found) return false;
    if (disjoint_.add(std::move(search.found->slices))) {
      search.worst = BridgeDrop::kBridge;
      search.found.reset();
      return search.next_try < kBridgeTries;
    }
    search.is_built = true;
    return false;
  }

  void conclude() {
    bool is_first = true;
    for (CapSearch& search : searches_) {
      report_.unfolded += search.unfolded;
      report_.proved_unfolded += search.proved_unfolded;
      if (!search.is_built) {
        drop(search.cap.cap, search.worst);
        continue;
      }
      ++report_.built;
      const double hi = search.found->reach, lo = least_reach(search);
      internal::widen({lo, hi}, is_first, &report_.reach);
      internal::widen(kink_of(search.cap), is_first, &report_.kink);
      is_first = false;
      micro_.bridges.push_back(std::move(search.found->bridge));
    }
    std::sort(report_.without.begin(), report_.without.end());
    std::sort(micro_.bridges.begin(), micro_.bridges.end(),
              [](const MicroBridge& a, const MicroBridge& b) { return a.cap < b.cap; });
  }
  // A point of the end face is at least that far from the surface.
  double least_reach(const CapSearch& search) const {
    const MicroBridge& b = search.found->bridge;
    std::vector<internal::HullPoints> hulls;
    const ScopedUpward upward;
    Box3 corner;
    for (std::size_t c = 0; c < 3; ++c) corner[c] = enclose(b.points[b.at(0, 0, 2)][c]);
    const Box3d at{{corner[0].lo(), corner[1].lo(), corner[2].lo()},
                   {corner[0].hi(), corner[1].hi(), corner[2].hi()}};
    if (!spaces_[b.volume].hulls(at, &hulls) || hulls.empty()) return 0;
    Box3 image = Box3::empty();
    for (const auto& points : hulls) image = hull(image, internal::hull_of(points));
    return internal::distance_below(projection_, image);
  }

  // Nothing where the map has one derivative at the wall. Else the angle between the derivatives on both sides.
  BridgeRange kink_of(const OpenCap& cap) const {
    const MicroGrid& grid = micro_.grids[cap.cap.grid];
    BridgeFront own;
    own.volume = grid.volume;
    own.axis = static_cast<std::size_t>(cap.cap.wall / 2);
    own.is_upward = cap.cap.wall % 2 == 1;
    const std::size_t index = grid.shape().index_of(cap.cap.cell)[own.axis];
    own.at = grid.breaks[own.axis][index + static_cast<std::size_t>(cap.cap.wall % 2)];
    const KnotAxis<Rational>& knots = micro_.cage[own.volume].axis(own.axis);
    if (!cap.front.is_in_face && multiplicity(knots, own.at) < knots.degree) return {};
    const auto surface = cap_on_front(micro_, cage_, tiles_, cap.cap, own);
    if (!surface) return internal::kAnyAngle;
    const ScopedUpward upward;
    internal::HullPoints back, on;
    if (!spaces_[own.volume].directions(box_of_surface(*surface), own.axis, !own.is_upward,
                                        &back) ||
        !spaces_[cap.front.volume].directions(box_of_surface(cap.surface), cap.front.axis,
                                              cap.front.is_upward, &on))
      return internal::kAnyAngle;
    return internal::angle_between(Interval(-1.0) * internal::hull_of(back), internal::hull_of(on));
  }
  // REQUIRES a live ScopedUpward.
  static Box3d box_of_surface(const BezierSurface<Rational>& surface) {
    Box3d out = empty_box();
    for (std::size_t c = 0; c < 3; ++c)
      for (const Rational& x : surface.component(static_cast<int>(c))) {
        const Interval value = enclose(x);
        out.lo[c] = std::min(out.lo[c], value.lo());
        out.hi[c] = std::max(out.hi[c], value.hi());
      }
    return out;
  }

  const SolidSurface& surface_;
  const internal::SkinProjection& projection_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  const BridgeOptions& options_;
  Microstructure& micro_;
  TileCells cells_;
  DisjointBridges disjoint_;
  std::vector<VolumeSpace> spaces_;
  std::vector<CapSearch> searches_;
  BridgeReport report_;
};

double skin_of_box(const Box3d& box) {
  return std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]) / 100;
}

}  // namespace

const char* bridge_drop_name(BridgeDrop drop) {
  constexpr std::array<const char*, kNumBridgeDrops> kNames = {"flat", "box",  "folded",
                                                               "tile", "skin", "bridge"};
  return kNames[static_cast<std::size_t>(drop)];
}

double default_skin(const TriangleMesh& mesh) {
  Box3d box = empty_box();
  for (const Vec3d& p : mesh.positions) add({p.x, p.y, p.z}, &box);
  return skin_of_box(box);
}
double default_skin(const PatchComplex& complex) {
  return skin_of_box(PatchSurface(complex).box());
}

Result<BridgeReport> build_bridges(const TriangleMesh& mesh, const VModel& cage,
                                   const std::vector<AnalysedTile>& tiles,
                                   const BridgeOptions& options, Microstructure& micro) {
  return BridgeBuilder(TriangleSurface(mesh), *internal::skin_projection(mesh), cage, tiles,
                       options, micro)
      .run();
}
Result<BridgeReport> build_bridges(const PatchComplex& complex, const VModel& cage,
                                   const std::vector<AnalysedTile>& tiles,
                                   const BridgeOptions& options, Microstructure& micro) {
  return BridgeBuilder(PatchSurface(complex), *internal::skin_projection(complex), cage, tiles,
                       options, micro)
      .run();
}

}  // namespace veritope
