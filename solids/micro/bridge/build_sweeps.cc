// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/build_sweeps.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/bridge/bridge_clearance_internal.h"
#include "solids/micro/bridge/bridge_measures_internal.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/sweep_clearance_internal.h"
#include "solids/micro/bridge/sweep_proposals_internal.h"
#include "solids/micro/surface/patch_surface.h"
#include "solids/micro/surface/triangle_surface.h"
#include "splines/bezier_domain.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

using internal::kSweepTries;
using internal::PairBudget;
using internal::PlacedSweep;
using internal::SpaceCap;
using internal::SweepProposals;

// The page lets a checker visit 2^12 pairs for each sweep.
constexpr std::uint64_t kPairsForTiles = 1 << 10, kPairsForSweeps = 1 << 10;
constexpr int kSamplesAlong = 3;  // of a cap

// A sweep that only other sweeps may be against.
struct FoundSweep {
  MicroSweep sweep;
  SweepWitness witness;
  double reach = 0;  // no point of the end is farther from the surface
};
struct SweepSearch {
  SpaceCap cap;
  std::optional<SweepProposals> proposals;
  int next_try = 0;
  BridgeDrop worst = BridgeDrop::kFolded;  // the latest test at which a try failed
  std::optional<FoundSweep> found;         // waits for the test against other sweeps
  bool is_built = false;
};

class SweepBuilder {
 public:
  SweepBuilder(const SolidSurface& surface, const internal::SkinProjection& projection,
               const VModel& cage, const std::vector<AnalysedTile>& tiles,
               const BridgeOptions& options, Microstructure& micro,
               std::vector<internal::VolumeSpace> spaces)
      : surface_(surface),
        projection_(projection),
        cage_(cage),
        tiles_(tiles),
        options_(options),
        micro_(micro),
        spaces_(std::move(spaces)),
        starts_(micro, tiles),
        in_space_(micro, spaces_, options.jobs) {}

  Result<BridgeReport> run() {
    if (Status status = find_caps(); !status) return status.error();
    for (bool goes_on = true; goes_on;) {
      parallel_for(searches_.size(), 8, options_.jobs,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) advance(searches_[i]);
                   });
      goes_on = false;
      for (SweepSearch& search : searches_) goes_on = accept(search) || goes_on;
    }
    conclude();
    return std::move(report_);
  }

 private:
  Status find_caps() {
    const auto met = walls_with_neighbours(micro_, cage_);
    if (!met) return met.error();
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      for (std::uint64_t c = 0; c < micro_.grids[g].tiles.size(); ++c) {
        if (micro_.grids[g].tiles[c] == 0) continue;
        for (int wall = 0; wall < 6; ++wall)
          if (((*met)[g][c] >> wall & 1) == 0) add_wall({g, c, wall});
      }
    if (searches_.size() <= kMaxMicroBridges) return ok_status();
    return Error{Code::kOverLimit,
                 {},
                 "more than " + std::to_string(kMaxMicroBridges) + " caps are to be bridged"};
  }
  void add_wall(const CapPlace& place) {
    const MicroGrid& grid = micro_.grids[place.grid];
    const std::size_t count = tiles_[grid.tiles[place.cell] - 1u]
                                  .caps_of_wall[static_cast<std::size_t>(place.wall)]
                                  .size();
    if (count == 0) return;
    report_.caps += count;
    const auto surface = starts_.cap(place);
    auto cap = surface ? space_cap(place, *surface) : std::nullopt;
    if (cap) {
      searches_.emplace_back().cap = std::move(*cap);
      return;
    }
    for (std::size_t i = 0; i < count; ++i) drop(place, BridgeDrop::kBox);
  }
  // Nothing if the map has no finite values there.
  std::optional<SpaceCap> space_cap(const CapPlace& place,
                                    const BezierSurface<Rational>& surface) const {
    const internal::VolumeSpace& space = spaces_[micro_.grids[place.grid].volume];
    const auto a = static_cast<std::size_t>(place.wall / 2), b = (a + 1) % 3, c = (a + 2) % 3;
    const auto at = [&](int i, int j) {
      return space.place(parameters_of(place, surface, Rational(i, kSamplesAlong - 1),
                                       Rational(j, kSamplesAlong - 1)));
    };
    SpaceCap out;
    out.cap = place;
    for (int i = 0; i < kSamplesAlong; ++i)
      for (int j = 0; j < kSamplesAlong; ++j) {
        const auto sample = at(i, j);
        if (!sample) return std::nullopt;
        out.samples.push_back(sample->image);
        if (2 * i != kSamplesAlong - 1 || i != j) continue;
        out.middle = sample->image;
        out.arm =
            0.5 * nearest_double(starts_.widths(place)[a]) * internal::size_of(sample->partial[a]);
        out.axis = internal::unit_vector(sample->partial[a]);
        if (place.wall % 2 == 0)
          for (double& x : out.axis) x = -x;
        out.normal =
            internal::unit_vector(internal::cross_product(sample->partial[b], sample->partial[c]));
        if (internal::dot_product(out.normal, out.axis) < 0)
          for (double& x : out.normal) x = -x;
      }
    return out;
  }
  // The place of the cap's point (u, v) in the parameters of the volume, approximately.
  Point3d parameters_of(const CapPlace& place, const BezierSurface<Rational>& surface,
                        const Rational& u, const Rational& v) const {
    const MicroGrid& grid = micro_.grids[place.grid];
    const auto cell = grid.shape().index_of(place.cell);
    const auto across = static_cast<std::size_t>(place.wall / 2);
    const std::vector<Rational> p = evaluate<Rational, 2>(surface, {u, v});
    const auto widths = starts_.widths(place);
    Point3d out;
    for (std::size_t a = 0; a < 3; ++a)
      out[a] = nearest_double(a == across ? starts_.position(place)
                                          : grid.breaks[a][cell[a]] +
                                                widths[a] * p[a < across ? a : a - 1]);
    return out;
  }
  void drop(const CapPlace& cap, BridgeDrop why) {
    ++report_.dropped[static_cast<std::size_t>(why)];
    report_.without.emplace_back(cap, why);
  }

  // The next try that only other sweeps may be against.
  void advance(SweepSearch& search) const {
    if (search.is_built || search.next_try >= kSweepTries) return;
    if (!search.proposals) {
      search.proposals.emplace(projection_, options_, search.cap);
      if (search.proposals->is_flat()) {
        search.worst = BridgeDrop::kFlat;
        search.next_try = kSweepTries;
      }
    }
    const auto view = surface_.view();
    while (search.next_try < kSweepTries && !search.found) try_next(*view, search);
  }
  void try_next(SurfaceView& view, SweepSearch& search) const {
    const auto fails = [&](BridgeDrop why) { search.worst = std::max(search.worst, why); };
    std::optional<MicroSweep> sweep = search.proposals->propose(search.next_try++);
    if (!sweep) return fails(BridgeDrop::kSkin);
    const auto witness = find_sweep_witness(starts_, *sweep);
    if (!witness) return fails(BridgeDrop::kFolded);
    const ScopedUpward upward;
    PlacedSweep placed(starts_, *sweep, *witness);
    PairBudget budget{kPairsForTiles, 0};
    if (!in_space_.are_missed_by(placed, budget)) return fails(BridgeDrop::kTile);
    const auto reach = end_distance(view, placed.nodes, options_.skin);
    if (!reach || !misses_surface(view, placed.nodes)) return fails(BridgeDrop::kSkin);
    search.found = FoundSweep{std::move(*sweep), *witness, *reach};
  }

  // Whether the search goes on.
  bool accept(SweepSearch& search) {
    if (search.is_built || !search.found) return false;
    const ScopedUpward upward;
    PairBudget budget{kPairsForSweeps, 0};
    if (disjoint_.add(PlacedSweep(starts_, search.found->sweep, search.found->witness), budget)) {
      search.worst = BridgeDrop::kBridge;
      search.found.reset();
      return search.next_try < kSweepTries;
    }
    search.is_built = true;
    return false;
  }

  void conclude() {
    bool is_first = true;
    for (SweepSearch& search : searches_) {
      if (!search.is_built) {
        drop(search.cap.cap, search.worst);
        continue;
      }
      ++report_.built;
      const ScopedUpward upward;
      internal::widen({least_reach(search.found->sweep), search.found->reach}, is_first,
                      &report_.reach);
      internal::widen(kink_of(search.found->sweep), is_first, &report_.kink);
      is_first = false;
      micro_.sweeps.push_back(std::move(search.found->sweep));
    }
    std::sort(report_.without.begin(), report_.without.end());
    std::sort(micro_.sweeps.begin(), micro_.sweeps.end(),
              [](const MicroSweep& a, const MicroSweep& b) { return a.cap < b.cap; });
  }
  // The corner (0, 0) of the end face is at least that far from the surface.
  double least_reach(const MicroSweep& sweep) const {
    const BezierSurface<Rational> cap = starts_.cap(sweep.cap).value();
    const auto corner = evaluate<Interval, 2>(
        starts_.wall(sweep.cap), {enclose(cap.component(0)[0]), enclose(cap.component(1)[0])});
    Box3 at;
    for (std::size_t c = 0; c < 3; ++c) {
      at[c] = corner.size() > 3 ? corner[c] / corner[3] : corner[c];
      at[c] += enclose(sweep.axis[1][c]);
    }
    return internal::distance_below(projection_, at);
  }
  // The angle between the begin of the curve and the images of the axis, at the points of a box around the cap.
  BridgeRange kink_of(const MicroSweep& sweep) const {
    const BezierSurface<Rational> cap = starts_.cap(sweep.cap).value();
    const auto across = static_cast<std::size_t>(sweep.cap.wall / 2);
    BezierVolume<Interval> map = starts_.slab(sweep.cap, Rational(1));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto x = cap.component(static_cast<int>(k));
      const auto [lo, hi] = std::minmax_element(x.begin(), x.end());
      map = restricted(std::move(map), k < across ? k : k + 1, *lo, *hi);
    }
    const Box3 start(enclose(sweep.axis[0][0]), enclose(sweep.axis[0][1]),
                     enclose(sweep.axis[0][2]));
    const auto outward = outward_directions(map, across, sweep.cap.wall % 2 == 1);
    return outward ? internal::angle_between(start, *outward) : internal::kAnyAngle;
  }
  // Contains a vector with the direction of the derivative along the axis, away from the map's domain, at each point
  // of its begin or end: that from the last but one Bernstein point of the line to the last one; this holds for
  // rational lines with positive weights, too.
  static std::optional<Box3> outward_directions(const BezierVolume<Interval>& map, std::size_t axis,
                                                bool is_end) {
    const Grid<3> grid = map.grid();
    const std::size_t step = grid.stride(axis), n = grid.size[axis];
    const std::size_t last = is_end ? (n - 1) * step : 0, before = is_end ? (n - 2) * step : step;
    bool has_weights = true;
    const auto point = [&](std::size_t i) {
      Box3 p(map.component(0)[i], map.component(1)[i], map.component(2)[i]);
      if (!map.is_rational()) return p;
      const Interval& w = map.component(3)[i];
      has_weights = has_weights && w.sign() == Sign3::kPositive;
      for (std::size_t c = 0; has_weights && c < 3; ++c) p[c] = p[c] / w;
      return p;
    };
    Box3 from = Box3::empty(), to = from, all = from;
    grid.for_each_line(axis, [&](std::size_t line) {
      const Box3 p = point(line + before), q = point(line + last);
      from = hull(from, p);
      to = hull(to, q);
      all = hull(all, q - p);
    });
    if (!has_weights) return std::nullopt;
    return map.is_rational() ? to - from : all;
  }

  const SolidSurface& surface_;
  const internal::SkinProjection& projection_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  const BridgeOptions& options_;
  Microstructure& micro_;
  std::vector<internal::VolumeSpace> spaces_;
  SweepStarts starts_;
  internal::TilesInSpace in_space_;
  internal::DisjointSweeps disjoint_;
  std::vector<SweepSearch> searches_;
  BridgeReport report_;
};

Result<BridgeReport> build_on(const SolidSurface& surface,
                              const internal::SkinProjection& projection, const VModel& cage,
                              const std::vector<AnalysedTile>& tiles, const BridgeOptions& options,
                              Microstructure& micro) {
  std::vector<internal::VolumeSpace> spaces;
  for (const VVolume& volume : micro.cage) {
    Result<internal::VolumeSpace> space = internal::VolumeSpace::make(volume);
    if (!space) return space.error();
    spaces.push_back(std::move(*space));
  }
  return SweepBuilder(surface, projection, cage, tiles, options, micro, std::move(spaces)).run();
}

}  // namespace

Result<BridgeReport> build_sweeps(const TriangleMesh& mesh, const VModel& cage,
                                  const std::vector<AnalysedTile>& tiles,
                                  const BridgeOptions& options, Microstructure& micro) {
  return build_on(TriangleSurface(mesh), *internal::skin_projection(mesh), cage, tiles, options,
                  micro);
}
Result<BridgeReport> build_sweeps(const PatchComplex& complex, const VModel& cage,
                                  const std::vector<AnalysedTile>& tiles,
                                  const BridgeOptions& options, Microstructure& micro) {
  return build_on(PatchSurface(complex), *internal::skin_projection(complex), cage, tiles, options,
                  micro);
}

}  // namespace veritope
