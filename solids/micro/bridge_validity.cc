// SPDX-License-Identifier: LGPL-3.0-or-later
// What docs/formats/micro-files.md demands of bridges, sweeps and materials.
#include <algorithm>
#include <string>

#include "solids/micro/micro_validity.h"

namespace veritope {
namespace {

Error beyond_limit(std::string message) { return {Code::kOverLimit, {}, std::move(message)}; }

Status check_cap_place(const Microstructure& micro, const CapPlace& cap, const std::string& where) {
  const auto must = [&](const char* what, std::uint64_t most, std::uint64_t value) {
    return bad_argument(where + what + " must be from 0 to " + std::to_string(most) + ", not " +
                        std::to_string(value));
  };
  if (micro.grids.empty()) return bad_argument(where + "there are 0 grids");
  if (cap.grid >= micro.grids.size()) return must("the grid", micro.grids.size() - 1, cap.grid);
  const std::vector<std::uint8_t>& tiles = micro.grids[cap.grid].tiles;
  if (cap.cell >= tiles.size()) return must("the cell", tiles.size() - 1, cap.cell);
  if (cap.wall < 0 || cap.wall > 5)
    return bad_argument(where + "the wall must be from 0 to 5, not " + std::to_string(cap.wall));
  if (tiles[cap.cell] != 0) return ok_status();
  return bad_argument(where + "cell " + std::to_string(cap.cell) + " of grid " +
                      std::to_string(cap.grid) + " holds no tile");
}

// Whether the coordinates of a point, or a vector, are short enough.
Status check_bits(const TilePoint& p, const std::string& where, const std::string& name) {
  constexpr auto kMost = static_cast<std::size_t>(kMaxBridgeBits);
  for (std::size_t c = 0; c < 3; ++c)
    if (std::max(p[c].numerator().bit_length(), p[c].denominator().bit_length()) > kMost)
      return beyond_limit(where + "coordinate " + std::to_string(c) + " of " + name +
                          " has a numerator or denominator of more than " + std::to_string(kMost) +
                          " bits");
  return ok_status();
}

Status check_net(const MicroBridge& bridge, const std::string& where) {
  for (const int degree : bridge.degrees)
    if (degree < 1 || degree > kMaxTileDegree)
      return Error{degree < 1 ? Code::kBadArgument : Code::kOverLimit,
                   {},
                   where + "a degree must be from 1 to 7, not " + std::to_string(degree)};
  if (bridge.points.size() != bridge.num_points())
    return bad_argument(where + "it has " + std::to_string(bridge.points.size()) +
                        " points, and the degrees (" + std::to_string(bridge.degrees[0]) + ", " +
                        std::to_string(bridge.degrees[1]) + ", 2) need " +
                        std::to_string(bridge.num_points()));
  for (std::size_t i = 0; i < bridge.points.size(); ++i)
    if (Status status = check_bits(bridge.points[i], where, "point " + std::to_string(i)); !status)
      return status;
  return ok_status();
}

}  // namespace

Status check_bridge(const Microstructure& micro, std::size_t bridge) {
  const MicroBridge& b = micro.bridges[bridge];
  const std::string where = "bridge " + std::to_string(bridge) + ": ";
  if (bridge >= kMaxMicroBridges)
    return beyond_limit("there are more than " + std::to_string(kMaxMicroBridges) + " bridges");
  if (Status status = check_cap_place(micro, b.cap, where); !status) return status;
  if (b.volume >= micro.cage.size())
    return bad_argument(where + "the volume must be from 0 to " +
                        std::to_string(micro.cage.size() - 1) + ", not " +
                        std::to_string(b.volume));
  if (Status status = check_net(b, where); !status) return status;
  if (bridge > 0 && !(micro.bridges[bridge - 1].cap < b.cap))
    return bad_argument(where +
                        "its grid, cell and wall do not come after those of the bridge "
                        "before it");
  return ok_status();
}

Status check_sweep(const Microstructure& micro, std::size_t sweep) {
  const MicroSweep& s = micro.sweeps[sweep];
  const std::string where = "sweep " + std::to_string(sweep) + ": ";
  if (sweep >= kMaxMicroBridges)
    return beyond_limit("there are more than " + std::to_string(kMaxMicroBridges) + " sweeps");
  if (!micro.bridges.empty())
    return bad_argument(where + "a microstructure with bridges has no sweeps");
  if (Status status = check_cap_place(micro, s.cap, where); !status) return status;
  for (std::size_t i = 0; i < s.axis.size(); ++i)
    if (Status status = check_bits(s.axis[i], where, i == 0 ? "vector e" : "vector f"); !status)
      return status;
  if (sweep > 0 && !(micro.sweeps[sweep - 1].cap < s.cap))
    return bad_argument(where +
                        "its grid, cell and wall do not come after those of the sweep before it");
  return ok_status();
}

Status check_material(const Microstructure& micro, std::size_t material) {
  const MicroMaterial& m = micro.materials[material];
  const std::string where = "material " + std::to_string(material) + ": ";
  if (material >= kMaxMicroMaterials)
    return beyond_limit("there are more than " + std::to_string(kMaxMicroMaterials) + " materials");
  if (m.values.size() != micro.grids.size())
    return bad_argument(where + "it has the values of " + std::to_string(m.values.size()) +
                        " grids of " + std::to_string(micro.grids.size()));
  for (std::size_t g = 0; g < m.values.size(); ++g) {
    const std::size_t count = micro.grids[g].corner_shape().count();
    const std::string grid = where + "grid " + std::to_string(g) + ": ";
    if (m.values[g].size() != count)
      return bad_argument(grid + std::to_string(count) + " values are needed, and there are " +
                          std::to_string(m.values[g].size()));
    for (const std::int64_t value : m.values[g])
      if (value > kMaxMaterialNumber || value < -kMaxMaterialNumber)
        return beyond_limit(grid + "the value " + std::to_string(value) +
                            " is not below 2^52 in absolute value");
  }
  return ok_status();
}

}  // namespace veritope
