// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_crossing.cc: X1 to X3 of docs/certificates/patch-invalid.md.
#include "invalid.h"

namespace {

uint64_t choose(int n, int k) {
  uint64_t r = 1;
  for (int i = 0; i < k; ++i) r = r * uint64_t(n - i) / uint64_t(i + 1);
  return k < 0 || k > n ? 0 : r;
}
// A triangle's net in (s, t): B_ijk(1 - s, s (1 - t), s t) = B_(p-i)(s) times B_k(t) of degree p - i, so row m is the
// row of the triangle with j + k = m, its degree m raised to p; times a positive factor.
Net triangle_net(const Patch& patch) {
  const int p = patch.shape.p;
  Big factor = 1;
  for (int l = 0; l <= p; ++l) {
    const Big c = int64_t(choose(p, l));
    factor = factor * divide(c, gcd(factor, c), nullptr);
  }
  Net r;
  for (int m = 0; m <= p; ++m)
    for (int l = 0; l <= p; ++l)
      for (int x = 0; x < 4; ++x) {
        Big sum;
        for (int k = 0; k <= m; ++k)
          sum = sum + Big(int64_t(choose(m, k) * choose(p - m, l - k))) *
                          patch.net[size_t(4 * patch.shape.at3(m - k, k) + x)];
        r.push_back(sum * divide(factor, Big(int64_t(choose(p, l))), nullptr));
      }
  return r;
}
Net restricted_net(const Net& net, size_t rows, size_t columns, const Part& u, const Part& v) {
  const Net cut = restricted(net, rows, u);
  Net r;
  for (size_t i = 0; i < rows; ++i) {
    const auto row = cut.begin() + int64_t(4 * columns * i);
    const Net one = restricted(Net(row, row + int64_t(4 * columns)), columns, v);
    r.insert(r.end(), one.begin(), one.end());
  }
  return r;
}

struct Range {
  Ratio least, most;
};
Range control_values(const Net& net, const Big* y) {
  Range r;
  for (size_t i = 0; i < net.size(); i += 4) {
    const Ratio v(y[0] * net[i] + y[1] * net[i + 1] + y[2] * net[i + 2], net[i + 3]);
    if (i == 0 || compare(v, r.least) < 0) r.least = v;
    if (i == 0 || compare(r.most, v) < 0) r.most = v;
  }
  return r;
}

}  // namespace

Part read_interval(Bytes* bytes) {
  Part t;
  t.k = int(bytes->at_most(bytes->varint(), 62, "an interval counts 2^-k, k ="));
  t.a = int64_t(bytes->varint());
  t.b = int64_t(bytes->at_most(bytes->varint(), uint64_t(1) << t.k, "an interval leaves [0, 1]:"));
  require(t.a <= t.b, "B1", "an interval's ends fall");
  return t;
}
void check_intervals(const Crossing& x, bool b_is_triangle, const char* id) {
  int points = 0;
  for (const RestrictedPatch& s : x.sheet)
    for (const Part& t : s.t) points += t.is_point();
  require(points == 1, id, "intervals that are points:", uint64_t(points));
  for (const Part& t : x.sheet[0].t)
    require(t.a > 0 && t.b < int64_t(1) << t.k, id, "A is not in the open domain");
  require(!b_is_triangle || x.sheet[1].t[0].a > 0, id, "the interval of s in B contains 0");
}

Net tensor_net(const Patch& patch) {
  return patch.shape.is_triangle ? triangle_net(patch) : patch.net;
}
void check_crossing(const Crossing& x, const Patch& a, const Patch& b) {
  check_intervals(x, b.shape.is_triangle, "X1");
  const RestrictedPatch &s = x.sheet[0], &t = x.sheet[1];
  require(s.patch != t.patch || are_apart(s.t[0], t.t[0]) || are_apart(s.t[1], t.t[1]), "X1",
          "A and B are not disjoint");
  check_signs(x, a, b, "X2", "X3");
}
void check_signs(const Crossing& x, const Patch& a, const Patch& b, const char* id2,
                 const char* id3) {
  Big det;
  for (int i = 0; i < 3; ++i)
    det = det + x.y[0][i] * (x.y[1][(i + 1) % 3] * x.y[2][(i + 2) % 3] -
                             x.y[1][(i + 2) % 3] * x.y[2][(i + 1) % 3]);
  require(det.sign() != 0, id2, "det Y is 0");

  const Patch* const patches[2] = {&a, &b};
  Net whole[2], cut[2];
  size_t rows[2], columns[2];
  for (int i = 0; i < 2; ++i) {
    const Shape& s = patches[i]->shape;
    whole[i] = tensor_net(*patches[i]);
    rows[i] = size_t(s.p) + 1, columns[i] = size_t(s.q) + 1;
    cut[i] = restricted_net(whole[i], rows[i], columns[i], x.sheet[i].t[0], x.sheet[i].t[1]);
  }
  int row = 0;
  for (int i = 0; i < 2; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      Part t[2] = {x.sheet[i].t[0], x.sheet[i].t[1]};
      if (t[axis].is_point()) continue;
      const Range other = control_values(cut[1 - i], x.y[row]);
      for (int high = 0; high < 2; ++high) {
        t[axis] = x.sheet[i].t[axis];
        (high == 0 ? t[axis].b : t[axis].a) = high == 0 ? t[axis].a : t[axis].b;
        const Range own =
            control_values(restricted_net(whole[i], rows[i], columns[i], t[0], t[1]), x.y[row]);
        const Range &of_a = i == 0 ? own : other, &of_b = i == 0 ? other : own;
        require(high == 0 ? compare(of_a.most, of_b.least) < 0 : compare(of_b.most, of_a.least) < 0,
                id3, "A and B are not separated on the faces of parameter", uint64_t(row));
      }
      ++row;
    }
}
