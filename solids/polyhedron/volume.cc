// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "robust/base/parallel.h"
#include "robust/binary64.h"
#include "robust/integer.h"
#include "solids/polyhedron/chunk_internal.h"

namespace veritope {
namespace {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

using internal::kChunk;

// All coordinates are integers times 2^unit, of absolute value below 2^bits.
struct Lattice {
  int unit = 0;
  int bits = 0;
};

void widen(double v, int& least, int& greatest) {
  const Binary64 s = split(v);
  if (s.mantissa == 0) return;
  const auto m = static_cast<std::uint64_t>(s.mantissa < 0 ? -s.mantissa : s.mantissa);
  least = std::min(least, s.exponent + std::countr_zero(m));
  greatest = std::max(greatest, s.exponent + static_cast<int>(std::bit_width(m)));
}

Lattice find_lattice(const std::vector<Vec3d>& positions, unsigned jobs) {
  constexpr int kFar = 1 << 20;
  std::vector<std::array<int, 2>> ends(num_chunks(positions.size(), kChunk));
  parallel_for(positions.size(), kChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 int least = kFar, greatest = -kFar;
                 for (std::size_t i = begin; i < end; ++i) {
                   widen(positions[i].x, least, greatest);
                   widen(positions[i].y, least, greatest);
                   widen(positions[i].z, least, greatest);
                 }
                 ends[chunk] = {least, greatest};
               });
  int least = kFar, greatest = -kFar;
  for (const auto& e : ends) {
    least = std::min(least, e[0]);
    greatest = std::max(greatest, e[1]);
  }
  return least == kFar ? Lattice{0, 0} : Lattice{least, greatest - least};
}

// A 320-bit two's complement sum; |sum| < 2^31 terms of 2^249 fit.
class Sum320 {
 public:
  // Adds area * height, |area| < 2^127, |height| < 2^122.
  void add_product(Int128 area, Int128 height) {
    const bool negative = (area < 0) != (height < 0);
    const UInt128 a = magnitude(area), h = magnitude(height);
    const auto a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
    const auto h0 = static_cast<std::uint64_t>(h), h1 = static_cast<std::uint64_t>(h >> 64);
    const UInt128 low = UInt128{a0} * h0, high = UInt128{a1} * h1;
    const UInt128 mid1 = UInt128{a0} * h1 + (low >> 64);
    const UInt128 mid2 = UInt128{a1} * h0 + static_cast<std::uint64_t>(mid1);
    const UInt128 top = high + (mid1 >> 64) + (mid2 >> 64);
    std::array<std::uint64_t, 5> term{
        static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(mid2),
        static_cast<std::uint64_t>(top), static_cast<std::uint64_t>(top >> 64), 0};
    add(term, negative);
  }
  void add(const Sum320& other) { add(other.limbs_, false); }

  Integer to_integer() const {
    if ((limbs_[4] >> 63) == 0) return Integer::from_limbs(limbs_.data(), 5, false);
    Sum320 opposite;
    opposite.add(limbs_, true);
    return Integer::from_limbs(opposite.limbs_.data(), 5, true);
  }

 private:
  static UInt128 magnitude(Int128 v) {
    return v < 0 ? -static_cast<UInt128>(v) : static_cast<UInt128>(v);
  }
  // Adds or subtracts: a - b = a + ~b + 1.
  void add(const std::array<std::uint64_t, 5>& term, bool subtract) {
    const std::uint64_t flip = subtract ? ~std::uint64_t{0} : 0;
    UInt128 carry = subtract ? 1 : 0;
    for (std::size_t i = 0; i < 5; ++i) {
      carry += UInt128{limbs_[i]} + (term[i] ^ flip);
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
  }
  std::array<std::uint64_t, 5> limbs_{};
};

// Coordinates as lattice integers of at most 62 bits: one exact product and a conversion.
struct ShortCoordinates {
  double scale;
  Int128 operator()(double v) const { return static_cast<std::int64_t>(v * scale); }
};

// Coordinates as lattice integers of at most 120 bits.
struct LongCoordinates {
  int unit;
  Int128 operator()(double v) const {
    const Binary64 s = split(v);
    if (s.mantissa == 0) return 0;
    const int shift = s.exponent - unit;
    return shift >= 0 ? Int128{s.mantissa} * (Int128{1} << shift) : Int128{s.mantissa} >> -shift;
  }
};

bool fits64(Int128 v) { return v == static_cast<std::int64_t>(v); }

struct ShellSum {
  std::uint32_t shell;
  Sum320 sum;
  Integer rest;  // facets whose edges are too long for 64 bits
};

template <typename Coordinate>
void add_facet(const Vec3d& a, const Vec3d& b, const Vec3d& c, Coordinate at, ShellSum& out) {
  const Int128 ax = at(a.x), ay = at(a.y);
  const Int128 ux = at(b.x) - ax, uy = at(b.y) - ay, vx = at(c.x) - ax, vy = at(c.y) - ay;
  const Int128 height = at(a.z) + at(b.z) + at(c.z);
  if (fits64(ux) && fits64(uy) && fits64(vx) && fits64(vy)) [[likely]] {
    // |u|, |v| < 2^63 would let the difference reach 2^127; a lattice of 120 bits with both products that large is
    // refused below.
    constexpr Int128 kLimit = Int128{1} << 62;
    if (ux < kLimit && -ux < kLimit && vy < kLimit && -vy < kLimit && uy < kLimit && -uy < kLimit &&
        vx < kLimit && -vx < kLimit) [[likely]] {
      out.sum.add_product(ux * vy - uy * vx, height);
      return;
    }
  }
  const auto wide = [](Int128 v) {
    const UInt128 m = v < 0 ? -static_cast<UInt128>(v) : static_cast<UInt128>(v);
    const std::uint64_t limbs[2] = {static_cast<std::uint64_t>(m),
                                    static_cast<std::uint64_t>(m >> 64)};
    return Integer::from_limbs(limbs, 2, v < 0);
  };
  out.rest += (wide(ux) * wide(vy) - wide(uy) * wide(vx)) * wide(height);
}

Integer exact_coordinate(double v, int unit) {
  const Binary64 s = split(v);
  Integer out(s.mantissa);
  if (s.exponent >= unit) return out.shift_left(static_cast<std::uint64_t>(s.exponent - unit));
  return out.shift_right(static_cast<std::uint64_t>(unit - s.exponent));
}

void add_facet_exactly(const Vec3d& a, const Vec3d& b, const Vec3d& c, int unit, ShellSum& out) {
  const auto at = [unit](double v) { return exact_coordinate(v, unit); };
  const Integer ax = at(a.x), ay = at(a.y);
  out.rest += ((at(b.x) - ax) * (at(c.y) - ay) - (at(b.y) - ay) * (at(c.x) - ax)) *
              (at(a.z) + at(b.z) + at(c.z));
}

}  // namespace

std::vector<Rational> shell_volumes(const TriangleMesh& mesh,
                                    std::span<const std::uint32_t> shell_of_face,
                                    std::size_t num_shells, unsigned jobs) {
  const Lattice lattice = find_lattice(mesh.positions, jobs);
  const bool is_short = lattice.bits <= 62 && lattice.unit >= -1000 && lattice.unit <= 1000;
  const ShortCoordinates short_coordinates{is_short ? exp2_int(-lattice.unit) : 0};
  const LongCoordinates long_coordinates{lattice.unit};
  std::vector<std::vector<ShellSum>> parts(num_chunks(mesh.faces.size(), kChunk));
  parallel_for(mesh.faces.size(), kChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 std::vector<ShellSum>& part = parts[chunk];
                 for (std::size_t f = begin; f < end; ++f) {
                   const std::uint32_t shell = shell_of_face[f];
                   if (shell >= num_shells) continue;
                   if (part.empty() || part.back().shell != shell) part.push_back({shell, {}, {}});
                   const auto& t = mesh.faces[f];
                   const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                               &c = mesh.positions[t[2]];
                   if (is_short) {
                     add_facet(a, b, c, short_coordinates, part.back());
                   } else if (lattice.bits <= 120) {
                     add_facet(a, b, c, long_coordinates, part.back());
                   } else {
                     add_facet_exactly(a, b, c, lattice.unit, part.back());
                   }
                 }
               });
  std::vector<Integer> sums(num_shells);
  for (const auto& part : parts)
    for (const ShellSum& s : part) sums[s.shell] += s.sum.to_integer() + s.rest;
  std::vector<Rational> out;
  out.reserve(num_shells);
  const Rational unit = Rational::power_of_two(3 * std::int64_t{lattice.unit}) / Rational(6);
  for (const Integer& s : sums) out.push_back(Rational(s) * unit);
  return out;
}

}  // namespace veritope
