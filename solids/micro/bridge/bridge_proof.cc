// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/bridge_proof.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "solids/micro/bridge/bridge_slices.h"
#include "solids/micro/bridge_front.h"
#include "solids/micro/matched_caps.h"
#include "solids/micro/wall_pairs.h"

namespace veritope {
namespace {

class BridgeProver {
 public:
  BridgeProver(const Microstructure& micro, const VModel& cage,
               const std::vector<AnalysedTile>& tiles)
      : micro_(micro), cage_(cage), tiles_(tiles), cells_(micro), disjoint_(micro) {}

  std::variant<std::vector<BridgeWitness>, BridgeDefect> run() {
    std::uint64_t cost = 0;
    for (std::size_t b = 0; b < micro_.bridges.size(); ++b) {
      cost += bridge_cost(micro_.bridges[b]);
      if (cost > kMaxBridgeCost)
        return BridgeDefect{"B2", b, "the bridges have too many or too long numbers"};
    }
    std::vector<CapPlace> places;
    for (const MicroBridge& b : micro_.bridges) places.push_back(b.cap);
    matched_ = matched_caps(micro_, cage_, tiles_, places);
    for (std::size_t b = 0; b < micro_.bridges.size(); ++b)
      if (auto defect = prove(b)) return std::move(*defect);
    for (std::size_t b = 0; b < micro_.bridges.size(); ++b)
      if (const auto other = disjoint_.add(std::move(slices_[b])))
        return BridgeDefect{"R4", b,
                            "it is not proved disjoint from bridge " + std::to_string(*other)};
    for (std::size_t b = 0; b < micro_.bridges.size(); ++b) out_[b].cuts = disjoint_[b].cuts();
    return std::move(out_);
  }

 private:
  std::optional<BridgeDefect> prove(std::size_t number) {
    const MicroBridge& bridge = micro_.bridges[number];
    const auto fails = [&](const char* condition, std::string message) {
      return BridgeDefect{condition, number, std::move(message)};
    };
    auto matrix = find_bridge_matrix(bridge);
    if (!matrix) return fails("R1", "no matrix was found that shows that it is one to one");
    const auto front = front_of(micro_, cage_, bridge.cap);
    if (!front) return fails("R2", "its wall lies in the border of the cage, or is collapsed");
    if (front->volume != bridge.volume)
      return fails("R2", "it lies in volume " + std::to_string(bridge.volume) +
                             ", but its wall leads to volume " + std::to_string(front->volume));
    const auto cap = cap_on_front(micro_, cage_, tiles_, bridge.cap, *front);
    if (!cap) return fails("R2", "the patches in its wall are not one cap of one patch");
    if (matched_.contains(bridge.cap)) return fails("R2", "its cap is equal to another one");
    if (!start_symmetry(bridge, *cap)) return fails("R2", "it does not start at the cap");
    if (!is_in_open_box(bridge, micro_.cage[bridge.volume], *front))
      return fails("R3",
                   "a point of its lists 1 and 2 is not beyond its wall, or not inside of "
                   "the parameters of its volume");
    BridgeSlices slices(bridge);
    if (!cut_off_tiles(cells_, bridge.cap, *front, slices))
      return fails("R3", "it is not proved to miss the cells with tiles");
    slices_.push_back(std::move(slices));
    out_.push_back({std::move(*matrix), {}});
    return std::nullopt;
  }

  const Microstructure& micro_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  TileCells cells_;
  DisjointBridges disjoint_;
  std::set<CapPlace> matched_;
  std::vector<BridgeSlices> slices_;
  std::vector<BridgeWitness> out_;
};

}  // namespace

std::uint64_t bridge_cost(const MicroBridge& bridge) {
  std::uint64_t bits = 0;
  for (const TilePoint& p : bridge.points)
    for (const Rational& x : p)
      bits =
          std::max<std::uint64_t>({bits, x.numerator().bit_length(), x.denominator().bit_length()});
  return static_cast<std::uint64_t>((bridge.degrees[0] + 1) * (bridge.degrees[1] + 1)) *
         (1 + bits) * (1 + bits) / 64;
}

std::variant<std::vector<BridgeWitness>, BridgeDefect> prove_bridges(
    const Microstructure& micro, const VModel& cage, const std::vector<AnalysedTile>& tiles) {
  return BridgeProver(micro, cage, tiles).run();
}

Result<std::vector<std::vector<std::uint8_t>>> walls_with_neighbours(const Microstructure& micro,
                                                                     const VModel& cage) {
  std::vector<std::vector<std::uint8_t>> out;
  for (const MicroGrid& grid : micro.grids) out.emplace_back(grid.tiles.size());
  const bool is_complete = for_each_wall_pair(micro, cage, [&](const WallPair& pair) {
    for (const CellWall& w : pair.walls)
      out[w.grid][w.cell] |= static_cast<std::uint8_t>(1u << w.wall);
    return true;
  });
  if (!is_complete)
    return Error{
        Code::kOverLimit,
        {},
        "more than " + std::to_string(kMaxWallMeetings) + " pairs of walls meet between grids"};
  return out;
}

}  // namespace veritope
