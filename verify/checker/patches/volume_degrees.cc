// SPDX-License-Identifier: Apache-2.0 OR MIT
// volume_degrees.cc: section 4 of docs/certificates/reading-rule-faces.md: a face in the lowest degrees.
#include "volume_faces.h"

namespace {

// A line of control points, one component, as integers over a common denominator.
struct Line {
  std::vector<Big> v;
  Big common = 1;

  Line(const Entity& e, uint64_t first, uint64_t step, uint64_t n, size_t component) {
    for (uint64_t i = 0; i < n; ++i) {
      const Big& d = e.number(first + i * step, component).d;
      common = common * divide(d, gcd(common, d), nullptr);
    }
    for (uint64_t i = 0; i < n; ++i) {
      const Ratio& x = e.number(first + i * step, component);
      v.push_back(x.n * divide(common, x.d, nullptr));
    }
  }
  bool has_lower_degree() const {
    const int64_t p = int64_t(v.size()) - 1;
    Big sum;
    u128 binomial = 1;  // of a degree below 64
    for (int64_t i = 0; i <= p; ++i) {
      sum = i % 2 == 0 ? sum + Big(int64_t(binomial)) * v[size_t(i)]
                       : sum - Big(int64_t(binomial)) * v[size_t(i)];
      binomial = binomial * u128(p - i) / u128(i + 1);
    }
    return sum.sign() == 0;
  }
  // Not in lowest terms where `common` has large prime factors.
  std::vector<Ratio> lowered() const {
    const int64_t p = int64_t(v.size()) - 1;
    std::vector<Ratio> r;
    Ratio last;
    for (int64_t i = 0; i < p; ++i) {
      const Big n = Big(p) * v[size_t(i)] * last.d - Big(i) * last.n;
      last = lowest(Ratio(n, last.d * Big(p - i)));
      r.push_back(shortened(last.n, last.d * common));
    }
    return r;
  }
};

bool lower(Entity* e, size_t axis) {
  const int64_t p = e->degrees[axis];
  if (p <= 1 || e->knots[axis].size() != 2 * size_t(p + 1)) return false;
  const uint64_t n[2] = {e->points_along(0), e->points_along(1)};
  const uint64_t others = n[1 - axis], step = axis == 0 ? n[1] : 1,
                 step_of_others = axis == 0 ? 1 : n[1];
  const size_t c = size_t(e->components);
  for (uint64_t k = 0; k < others; ++k)
    for (size_t j = 0; j < c; ++j)
      if (!Line(*e, k * step_of_others, step, n[axis], j).has_lower_degree()) return false;

  const uint64_t size[2] = {axis == 0 ? n[0] - 1 : n[0], axis == 0 ? n[1] : n[1] - 1};
  std::vector<Ratio> numbers(size[0] * size[1] * c);
  for (uint64_t k = 0; k < others; ++k)
    for (size_t j = 0; j < c; ++j) {
      const std::vector<Ratio> line = Line(*e, k * step_of_others, step, n[axis], j).lowered();
      for (uint64_t i = 0; i < line.size(); ++i)
        numbers[(axis == 0 ? i * size[1] + k : k * size[1] + i) * c + j] = line[i];
    }
  std::vector<Ratio> knots(2 * size_t(p));
  std::fill(knots.begin() + p, knots.end(), Ratio(Big(1)));
  e->degrees[axis] = p - 1;
  e->knots[axis] = std::move(knots);
  e->numbers = std::move(numbers);
  e->left_out = 0;
  e->places.resize(size[0] * size[1]);
  for (uint64_t i = 0; i < e->places.size(); ++i) e->places[i] = i;
  return true;
}

}  // namespace

Entity lowered(Entity face) {
  for (size_t axis = 0; axis < 2; ++axis)
    while (lower(&face, axis)) {
    }
  return face;
}
