// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "volume_point.h"

namespace {

const int64_t kMostPieceBits = 256, kMostBoxBits = 1 << 22;

// The span of the piece with this number; the last knot's index if no piece has it.
size_t span_of(const std::vector<Ratio>& t, uint64_t piece) {
  size_t i = 0;
  for (; i + 1 < t.size(); ++i)
    if (compare(t[i], t[i + 1]) < 0 && piece-- == 0) break;
  return i;
}

// Numbers brought to integers by their least common denominator, which comes last. B2 fails if one of these integers
// has more than this many bits.
std::vector<Big> integers(const std::vector<Ratio>& numbers, int64_t most, const char* why) {
  Big common = 1;
  for (const Ratio& x : numbers) {
    common = common * divide(x.d, gcd(common, x.d), nullptr);
    require(common.bits() <= most, "B2", why);
  }
  std::vector<Big> r;
  for (const Ratio& x : numbers) {
    r.push_back(x.n * divide(common, x.d, nullptr));
    require(r.back().bits() <= most, "B2", why);
  }
  r.push_back(common);
  return r;
}

// All but the last step of de Boor's scheme along the first axis of a box; the points that are left begin and end the
// last step. The box's axes change places: the first one becomes the last. All points get the same positive factor.
Points halved(Points box, const AxisPoint& x) {
  const size_t stride = box.size() / (x.p + 1);
  const Big low = x.t[x.p - 1], high = x.t[x.p], rest = Big(x.d - x.n), d = Big(x.d);
  const Big at = rest * low + Big(x.n) * high;  // times d, as the differences below
  for (size_t step = 1; step < x.p; ++step) {
    // Point k is a combination of points k and k + 1, for a span of p + 1 - step knots that holds the piece.
    const size_t left = x.p + 1 - step;
    std::vector<Big> length;
    Big common = 1;
    for (size_t k = 0; k < left; ++k) {
      length.push_back((x.t[k + x.p] - x.t[k + step - 1]) * d);
      common = common * divide(length[k], gcd(common, length[k]), nullptr);
    }
    for (size_t k = 0; k < left; ++k) {
      const Big by = divide(common, length[k], nullptr);
      const Big second = (at - x.t[k + step - 1] * d) * by, first = (x.t[k + x.p] * d - at) * by;
      for (size_t i = k * stride; i < (k + 1) * stride; ++i)
        box[i] = first * box[i] + second * box[i + stride];
    }
  }
  Points r;
  for (size_t i = 0; i < stride; i += 4)
    for (size_t k = 0; k < 2; ++k)
      for (size_t c = 0; c < 4; ++c) r.push_back(box[k * stride + i + c]);
  return r;
}

Big determinant(const std::vector<Points>& rows, size_t column, unsigned used) {
  if (column == 4) return 1;
  Big r;
  bool minus = false;
  for (unsigned k = 0; k < 4; ++k) {
    if ((used >> k & 1) != 0) continue;
    const Big part = rows[k][column] * determinant(rows, column + 1, used | 1u << k);
    r = minus ? r - part : r + part;
    minus = !minus;
  }
  return r;
}

}  // namespace

VolumePoint read_point(const Entity& e, Bytes* bytes) {
  VolumePoint r;
  for (size_t a = 0; a < 3; ++a) {
    AxisPoint& x = r.axis[a];
    const uint64_t piece = bytes->varint(), n = bytes->varint(), d = bytes->varint();
    x.span = span_of(e.knots[a], piece);
    require(x.span + 1 < e.knots[a].size(), "B1", "there is no piece", piece);
    require(d >= 1, "B1", "a parameter's denominator is 0");
    require(n <= d, "B1", "a parameter leaves its piece: its denominator is", d);
    x.p = size_t(e.degrees[a]), x.n = int64_t(n), x.d = int64_t(d);
  }
  return r;
}

Points box_of(const Entity& e, VolumePoint* point) {
  std::vector<uint64_t> at(1, 0);
  for (size_t a = 0; a < 3; ++a) {
    AxisPoint& x = point->axis[a];
    const std::vector<Ratio>& t = e.knots[a];
    std::vector<Ratio> near(t.begin() + long(x.span + 1 - x.p), t.begin() + long(x.span + 1 + x.p));
    x.t = integers(near, kMostPieceBits, "the knots of a piece are too long");
    std::vector<uint64_t> next;
    for (uint64_t i : at)
      for (size_t k = x.span - x.p; k <= x.span; ++k) next.push_back(i * e.points_along(a) + k);
    at.swap(next);
  }
  std::vector<Ratio> numbers;
  for (uint64_t i : at)
    for (size_t c = 0; c < 4; ++c)
      numbers.push_back(c < 3 || e.is_rational ? e.number(i, c) : Ratio(Big(1)));
  Points r = integers(numbers, std::min(kMostBits, kMostBoxBits / int64_t(at.size())),
                      "the numbers of a box are too long");
  r.pop_back();
  return r;
}

std::vector<Points> values_at(Points box, const VolumePoint& point) {
  for (const AxisPoint& x : point.axis) box = halved(std::move(box), x);  // eight points, u slowest
  std::vector<Points> rows;
  for (size_t by = 0; by < 4; ++by) {  // no derivative; by u, by v, by w
    Points row(4);
    for (size_t corner = 0; corner < 8; ++corner) {
      Big factor = 1;
      for (size_t a = 0; a < 3; ++a) {
        const AxisPoint& x = point.axis[a];
        const bool is_end = (corner >> (2 - a) & 1) != 0;
        const int64_t slope = is_end ? 1 : -1, value = is_end ? x.n : x.d - x.n;
        factor = factor * Big(by == a + 1 ? slope : value);
      }
      for (size_t c = 0; c < 4; ++c) row[c] = row[c] + factor * box[4 * corner + c];
    }
    rows.push_back(row);
  }
  return rows;
}
int sign_of_jacobian(const std::vector<Points>& values) {
  return -determinant(values, 0, 0).sign();
}
