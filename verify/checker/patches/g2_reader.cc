// SPDX-License-Identifier: Apache-2.0 OR MIT
// g2_reader.cc: surfaces and volumes of GoTools, docs/certificates/reading-rule-g2.md, section 2.
#include "token_reader.h"

namespace {

const int64_t kSurfaceClass = 200, kVolumeClass = 700;
const int64_t kMostOrder = kMostSplineDegree + 1;

Entity object(TokenReader* in) {
  Entity e;
  const int64_t number = in->value(-kMostInteger, kMostInteger);
  expect(number == kSurfaceClass || number == kVolumeClass,
         "neither a spline surface (200) nor a spline volume (700)");
  in->next();
  e.kind = number == kSurfaceClass ? Entity::kSurface : Entity::kOther;
  in->integers(2);  // the version
  in->integers(in->count());
  e.components = in->integer(1, kMostCoordinates);
  e.is_rational = in->integer(0, 1) == 1;
  e.components += e.is_rational;
  std::vector<uint64_t> size;
  uint64_t points = 1;
  for (int a = 0; a < (number == kSurfaceClass ? 2 : 3); ++a) {
    size.push_back(in->count());
    const int64_t order = in->integer(2, std::min(kMostOrder, int64_t(size.back())));
    e.degrees.push_back(order - 1);
    e.knots.push_back(in->decimals(size.back() + uint64_t(order)));
    check_knots(e.knots.back(), order - 1, false);
    points = in->product(points, size.back());
  }
  e.numbers = in->decimals(in->product(points, uint64_t(e.components)));
  e.places = first_axis_fastest(size, size);
  check_entity(e, std::vector<bool>(size.size()));
  return e;
}

}  // namespace

std::vector<Entity> read_g2_model(const std::string& file, size_t* at) {
  TokenReader in(file, false, at);
  std::vector<Entity> entities;
  do entities.push_back(object(&in));
  while (!in.is_at_end());
  return entities;
}
