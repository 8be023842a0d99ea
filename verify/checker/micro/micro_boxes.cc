// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_boxes.cc: F3 of docs/certificates/microstructure.md: tiles that star boxes prove.
#include "../patches/star_box.h"
#include "micro.h"

namespace {

Entity surface_of(const MicroPatch& s) {
  Entity e;
  e.kind = Entity::kSurface;
  e.components = 3;
  e.degrees = {s.p, s.q};
  for (int64_t degree : e.degrees) {
    std::vector<Ratio> knots(size_t(degree + 1), Ratio(Big(0)));
    knots.resize(size_t(2 * degree + 2), Ratio(Big(1)));
    e.knots.push_back(Numbers(std::move(knots)));
  }
  std::vector<Ratio> numbers;
  for (const Big& x : s.net) numbers.push_back(lowest(Ratio(x, s.scale)));
  for (uint64_t i = 0; 3 * i < numbers.size(); ++i) e.places.push_back(i);
  e.numbers = Numbers(std::move(numbers));
  return e;
}

}  // namespace

void check_boxes(const MicroTile& tile, uint64_t file_bytes) {
  require(!tile.has_range, "F3", "a tile with a range has star boxes");
  std::vector<Entity> entities;
  for (const MicroPatch& s : tile.patches) entities.push_back(surface_of(s));
  StarBody star = read_star_body("VTS2", entities, tile.boxes, [](StarBytes*) {});
  const StarCheck check(&star, file_bytes + tile.boxes.left(), false);
  require(star.num_reversed == 0, "F3", "flags of patches:", star.num_reversed);
  for (const std::vector<Ratio>& b : star.breaks)
    require(b.size() == 2, "F3", "a patch has added breaks");
  require(check.x.components == 1, "F3", "the shells of a tile are", check.x.components);
  require(check.walks.bodies == 1, "F3", "the bodies of a tile are", check.walks.bodies);
}
