// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_extras.cc: points, bridges, sweeps and materials of docs/formats/micro-files.md.
#include "../patches/star_extraction.h"
#include "micro_reader.h"

namespace {

const size_t kMostBridges = 1 << 22 /* and sweeps */, kMostMaterials = 16;
const int64_t kMostBridgeDegree = 7, kMostPlaceBits = 2304;
const int64_t kMostValue = int64_t(1) << 52;

// Integers with a common denominator, which comes first; none if they are too long for B2.
std::vector<Big> common_integers(const std::vector<Ratio>& v) {
  try {
    return integers_of(v, kMostBridgeBits);
  } catch (const Rejected&) {
    return {};
  }
}

}  // namespace

size_t MicroParts::points(size_t most, int64_t bits, std::vector<Ratio>* to) {
  size_t count = 0;
  short_list(most, "too many points", [&](size_t) {
    size_t components = 0;
    short_list(3, "a point has not three coordinates", [&](size_t) {
      to->push_back(read_number(string()));
      expect(std::max(to->back().n.bits(), to->back().d.bits()) <= bits,
             "the numbers of a coordinate are too long");
      ++components;
    });
    expect(components == 3, "a point has not three coordinates");
    ++count;
  });
  return count;
}

void MicroParts::bridge() {
  MicroBridge b;
  std::vector<Ratio> numbers(1, Ratio(Big(1)));
  size_t count = 0;
  object({"grid", "cell", "wall", "volume", "degrees", "points"}, [&](size_t key) {
    begin_of(key, &b);
    if (key == 3) b.volume = uint64_t(integer_in(0, int64_t(out.cage.size()) - 1));
    if (key == 4)
      short_list(2, "a bridge has two degrees",
                 [&](size_t i) { (i == 0 ? b.p : b.q) = int(integer_in(1, kMostBridgeDegree)); });
    if (key == 5) count = points(3 * 64, kMostPlaceBits, &numbers);
  });
  expect(b.q > 0, "a bridge has two degrees");
  expect(count == size_t(3 * (b.p + 1) * (b.q + 1)), "another number of points");
  check_begin_of(b, out.bridges);
  b.net = common_integers(numbers);
  if (!b.net.empty()) {
    b.scale = b.net[0];
    b.net.erase(b.net.begin());
  }
  out.bridges.push_back(std::move(b));
}
void MicroParts::bridges() {
  short_list(kMostBridges, "more than 2^22 bridges", [&](size_t) { bridge(); });
}

void MicroParts::sweep() {
  MicroSweep b;
  std::vector<Ratio> numbers;
  object({"grid", "cell", "wall", "axis"}, [&](size_t key) {
    begin_of(key, &b);
    if (key == 3) points(2, kMostPlaceBits, &numbers);
  });
  expect(numbers.size() == 6, "the axis of a sweep has not two vectors");
  for (size_t i = 0; i < 6; ++i) b.axis[i / 3][i % 3] = span_of(numbers[i]);
  check_begin_of(b, out.sweeps);
  out.sweeps.push_back(b);
}
void MicroParts::sweeps() {
  short_list(kMostBridges, "more than 2^22 sweeps", [&](size_t) { sweep(); });
  expect(out.sweeps.empty() || out.bridges.empty(), "the file has bridges and sweeps");
}

void MicroParts::values(const MicroGrid& g) {
  const uint64_t n = uint64_t(g.n[0] + 1) * (g.n[1] + 1) * (g.n[2] + 1);
  uint64_t count = 0;
  list([&] {
    expect(count++ < n, "more values than corners of cells");
    const std::string w = word();  // no more than 16 digits
    const bool is_minus = !w.empty() && w[0] == '-';
    const std::string digits = w.substr(is_minus);
    expect(is_natural(digits) && digits.size() <= 16 && !(is_minus && digits == "0") &&
               std::stoll(digits) < kMostValue,
           "a value is no integer below 2^52 in absolute value");
  });
  expect(count == n, "fewer values than corners of cells");
}
void MicroParts::materials() {
  short_list(kMostMaterials, "more than 16 materials", [&](size_t) {
    object({"name", "values"}, [&](size_t key) {
      if (key == 0) string();
      if (key != 1) return;
      size_t grids = 0;
      short_list(out.grids.size(), "more lists of values than grids",
                 [&](size_t g) { values(out.grids[g]), ++grids; });
      expect(grids == out.grids.size(), "fewer lists of values than grids");
    });
  });
}
