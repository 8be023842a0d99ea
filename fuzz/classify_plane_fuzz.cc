// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/classify_plane_fuzz.cc: points with respect to a closed loop of curves of the plane: rays along both axes, the
// region, the normal chain from two origins and the reversed loop agree; points on curves are on them.
// A byte for the number of curves and its flags; for each curve a byte for its degree and three for each control point;
// then four for each point.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "solids/chain/associated_function.h"
#include "solids/chain/plane_cell.h"
#include "solids/chain/plane_region.h"

namespace veritope::fuzz {
namespace {

[[noreturn]] void fail(const char* what, const PointIn<2>& p) {
  std::fprintf(stderr, "%s at %s %s\n", what, p[0].to_string().c_str(), p[1].to_string().c_str());
  std::abort();
}

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const std::uint8_t out = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return out;
  }
  bool is_empty() const { return bytes_.empty(); }

 private:
  std::span<const std::uint8_t> bytes_;
};

Rational coordinate(std::uint8_t byte) {
  return Rational(static_cast<std::int8_t>(byte)) / Rational(12);
}

std::vector<PlaneArc> loop_of(Bytes& bytes) {
  const std::uint8_t flags = bytes.next();
  const std::uint8_t n = 1 + flags % 4;
  const bool is_rational = (flags & 4) != 0;
  std::vector<PlaneArc> out;
  PointIn<2> from{coordinate(bytes.next()), coordinate(bytes.next())};
  const PointIn<2> first = from;
  for (std::uint8_t i = 0; i < n; ++i) {
    const std::size_t degree = 1 + bytes.next() % 5;
    PlaneArc::Curve map({static_cast<int>(degree)}, is_rational ? 3 : 2, is_rational);
    for (std::size_t k = 0; k <= degree; ++k) {
      PointIn<2> p = from;
      if (k > 0) p = {coordinate(bytes.next()), coordinate(bytes.next())};
      if (k == degree && i + 1 == n) p = first;
      const std::uint8_t byte = is_rational ? bytes.next() : 0;
      // Some weights are beyond binary64.
      const Rational w = is_rational && byte % 16 == 15
                             ? Rational::power_of_two(byte > 128 ? 1200 : -1200)
                             : Rational(is_rational ? 1 + byte % 16 : 1);
      for (int c = 0; c < 2; ++c) map.component(c)[k] = w * p[static_cast<std::size_t>(c)];
      if (is_rational) map.component(2)[k] = w;
      if (k == degree) from = p;
    }
    out.push_back(PlaneArc::make(std::move(map)).value());
  }
  return out;
}

std::vector<PlaneArc> reversed(const std::vector<PlaneArc>& arcs) {
  std::vector<PlaneArc> out;
  for (const PlaneArc& arc : arcs) {
    PlaneArc::Curve map = arc.curve();
    for (int c = 0; c < map.num_components(); ++c)
      std::reverse(map.component(c).begin(), map.component(c).end());
    out.push_back(PlaneArc::make(std::move(map)).value());
  }
  return out;
}

// The middle of a curve, moved by little or not at all; a lattice point; a control point.
PointIn<2> point_of(const std::vector<PlaneArc>& arcs, Bytes& bytes) {
  const std::uint8_t kind = bytes.next(), a = bytes.next(), b = bytes.next(), c = bytes.next();
  if (kind % 4 == 0) return {coordinate(a), coordinate(b)};
  const PlaneArc::Curve& curve = arcs[a % arcs.size()].curve();
  std::vector<std::vector<Rational>> rows;
  for (int k = 0; k < curve.num_components(); ++k)
    rows.emplace_back(curve.component(k).begin(), curve.component(k).end());
  const Rational t = Rational(b) / Rational(255);
  for (auto& row : rows)
    for (std::size_t n = row.size() - 1; n > 0; --n)
      for (std::size_t i = 0; i < n; ++i) row[i] = row[i] + t * (row[i + 1] - row[i]);
  const Rational w = curve.is_rational() ? rows[2][0] : Rational(1);
  PointIn<2> out{rows[0][0] / w, rows[1][0] / w};
  if (kind % 4 == 1 && !PlaneArc(arcs[a % arcs.size()]).parameter_of(out))
    fail("a point of a curve has no parameter", out);
  if (kind % 4 > 1 && c != 0)
    out[kind % 2] += Rational(c % 2 == 0 ? 1 : -1) * Rational::power_of_two(-2 * (c / 2));
  return out;
}

class Agreement {
 public:
  explicit Agreement(const std::vector<PlaneArc>& arcs)
      : arcs_(arcs),
        region_(PlaneRegion::make(arcs).value()),
        backward_(PlaneRegion::make(reversed(arcs)).value()),
        chains_{AssociatedFunction<2>(plane_chain(arcs, {0, 0})),
                AssociatedFunction<2>(plane_chain(arcs, {Rational(1) / Rational(7), -3}))} {}

  void check(const PointIn<2>& p) const {
    const PlaneAnswer answer = region_.classify(p), opposite = backward_.classify(p);
    if (answer.is_on() != opposite.is_on() || answer.winding != -opposite.winding)
      fail("the reversed loop differs", p);
    const ChainPoint<2> q(p);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::optional<int> sum(0);
      for (const PlaneArc& arc : arcs_) {
        const auto n = arc.passes(q, axis);
        if (n.has_value() == arc.parameter_of(p).has_value()) fail("on, or off?", p);
        sum = n && sum ? std::optional<int>(*sum + *n) : std::nullopt;
      }
      if (sum.has_value() == answer.is_on()) fail("the region is not its curves", p);
      if (sum && *sum != answer.winding) fail("two rays differ", p);
    }
    for (const AssociatedFunction<2>& f : chains_) {
      const auto beside = f.value_beside(p);
      if (!answer.is_on() && !beside) fail("a chain has no value off the curves", p);
      if (!answer.is_on() && *beside != Integer(answer.winding)) fail("a chain differs", p);
    }
  }

 private:
  const std::vector<PlaneArc>& arcs_;
  PlaneRegion region_, backward_;
  std::array<AssociatedFunction<2>, 2> chains_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace veritope;
  if (size > 120) return 0;
  fuzz::Bytes bytes({data, size});
  const std::vector<PlaneArc> arcs = fuzz::loop_of(bytes);
  const fuzz::Agreement agreement(arcs);
  for (int i = 0; i < 6 && !bytes.is_empty(); ++i) agreement.check(fuzz::point_of(arcs, bytes));
  return 0;
}
