// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/predicates_fuzz.cc: the bytes are up to six points and a byte of options; every predicate
// and every tier on them is compared with GMP's rationals. The mutator knows points: it makes them
// equal, collinear, coplanar and cospherical, and changes exponents.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "predicates/compare_along.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/segment_segment2d.h"
#include "predicates/segment_triangle.h"
#include "predicates/side_of_plane.h"
#include "predicates/triangle_triangle.h"
#include "predicates/triangle_witness.h"
#include "robust/base/random.h"
#include "tests/predicates/rational_clip_oracle.h"
#include "tests/predicates/rational_oracle.h"

namespace veritope {
namespace {

constexpr std::size_t kNumPoints = 6, kNumCoordinates = 3 * kNumPoints;

// A whole input: coordinates little-endian, then the options. Missing bytes are zero; infinities
// and NaNs lose their top exponent bit.
struct Input {
  std::array<double, kNumCoordinates> c{};
  std::uint8_t options = 0;

  static Input decode(const std::uint8_t* data, std::size_t size) {
    Input in;
    std::memcpy(in.c.data(), data, size < sizeof in.c ? size : sizeof in.c);
    if (size > sizeof in.c) in.options = data[sizeof in.c];
    for (double& v : in.c) {
      if (!std::isfinite(v))
        v = std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) & ~(std::uint64_t{1} << 62));
    }
    return in;
  }
  std::size_t encode(std::uint8_t* data, std::size_t max_size) const {
    if (max_size < sizeof c + 1) return 0;
    std::memcpy(data, c.data(), sizeof c);
    data[sizeof c] = options;
    return sizeof c + 1;
  }
  Vec3d point(std::size_t i) const { return {c[3 * i], c[3 * i + 1], c[3 * i + 2]}; }
  void set(std::size_t i, const Vec3d& p) {
    c[3 * i] = p.x, c[3 * i + 1] = p.y, c[3 * i + 2] = p.z;
  }
};

void require(bool holds, const char* what, const Input& in) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  for (std::size_t i = 0; i < kNumPoints; ++i) {
    std::fprintf(stderr, "  {%a, %a, %a}\n", in.c[3 * i], in.c[3 * i + 1], in.c[3 * i + 2]);
  }
  std::fprintf(stderr, "  options %u\n", in.options);
  std::abort();
}

bool agrees(Sign3 tier, Sign sign) { return !is_certain(tier) || to_sign(tier) == sign; }

void check_planar_signs(const Input& in) {
  const Vec3d a = in.point(0), b = in.point(1), c = in.point(2), d = in.point(3);
  const Vec2d a2{a.x, a.y}, b2{b.x, b.y}, c2{c.x, c.y}, d2{d.x, d.y};
  {
    const Sign s = oracle::orient2d(a2, b2, c2);
    require(orient2d(a2, b2, c2) == s, "orient2d", in);
    require(agrees(orient2d_filter(a2, b2, c2), s) &&
                agrees(internal::orient2d_zero_line(a2, b2, c2), s) &&
                agrees(internal::orient2d_lattice(a2, b2, c2), s) &&
                agrees(internal::orient2d_interval(a2, b2, c2), s) &&
                internal::orient2d_exact(a2, b2, c2) == s,
            "a tier of orient2d", in);
  }
  {
    const Sign s = oracle::in_circle(a2, b2, c2, d2);
    require(in_circle(a2, b2, c2, d2) == s, "in_circle", in);
    require(agrees(in_circle_filter(a2, b2, c2, d2), s) &&
                agrees(internal::in_circle_lattice(a2, b2, c2, d2), s) &&
                agrees(internal::in_circle_interval(a2, b2, c2, d2), s) &&
                internal::in_circle_exact(a2, b2, c2, d2) == s,
            "a tier of in_circle", in);
  }
  const SegmentContact s = segment_segment2d(a2, b2, c2, d2);
  require(segment_segment2d(d2, c2, b2, a2) == s, "symmetry of segment_segment2d", in);
  const bool meet =
      oracle::orient2d(a2, b2, c2) * oracle::orient2d(a2, b2, d2) == Sign::kNegative &&
      oracle::orient2d(c2, d2, a2) * oracle::orient2d(c2, d2, b2) == Sign::kNegative;
  require((s == SegmentContact::kCrossing) == meet, "a crossing of segment_segment2d", in);
}

void check_signs(const Input& in) {
  check_planar_signs(in);
  const Vec3d a = in.point(0), b = in.point(1), c = in.point(2), d = in.point(3), e = in.point(4);
  {
    const Sign s = oracle::orient3d(a, b, c, d);
    require(orient3d(a, b, c, d) == s, "orient3d", in);
    require(agrees(orient3d_filter(a, b, c, d), s) &&
                agrees(internal::orient3d_lattice(a, b, c, d), s) &&
                agrees(internal::orient3d_interval(a, b, c, d), s) &&
                internal::orient3d_exact(a, b, c, d) == s,
            "a tier of orient3d", in);
  }
  {
    const Sign s = oracle::in_sphere(a, b, c, d, e);
    require(in_sphere(a, b, c, d, e) == s, "in_sphere", in);
    require(agrees(in_sphere_filter(a, b, c, d, e), s) &&
                agrees(internal::in_sphere_lattice(a, b, c, d, e), s) &&
                agrees(internal::in_sphere_interval(a, b, c, d, e), s) &&
                internal::in_sphere_exact(a, b, c, d, e) == s,
            "a tier of in_sphere", in);
  }
  {
    const PlaneCoefficients f{a, c.x};
    const Sign s = oracle::side_of_plane(f, b);
    require(side_of_plane(f, b) == s, "side_of_plane", in);
    require(agrees(side_of_plane_filter(f, b), s) &&
                agrees(internal::side_of_plane_lattice(f, b), s) &&
                agrees(internal::side_of_plane_interval(f, b), s) &&
                internal::side_of_plane_exact(f, b) == s,
            "a tier of side_of_plane", in);
  }
  {
    const Sign s = oracle::compare_along(a, b, c);
    require(compare_along(a, b, c) == s, "compare_along", in);
    require(agrees(compare_along_filter(a, b, c), s) &&
                agrees(internal::compare_along_lattice(a, b, c), s) &&
                agrees(internal::compare_along_interval(a, b, c), s) &&
                internal::compare_along_exact(a, b, c) == s,
            "a tier of compare_along", in);
  }
}

void check_triangles(const Input& in) {
  IndexedTriangle t{{in.point(0), in.point(1), in.point(2)}, {0, 1, 2}};
  IndexedTriangle u{{in.point(3), in.point(4), in.point(5)}, {3, 4, 5}};
  // The two low bits are the number of common corners.
  const unsigned common = in.options & 3u;
  for (unsigned i = 0; i < common && i < 3; ++i) u.point[i] = t.point[i], u.id[i] = t.id[i];
  if ((in.options & 4u) != 0) std::swap(u.point[0], u.point[2]), std::swap(u.id[0], u.id[2]);
  if (oracle::degenerate(t.point)) return;
  const Vec3d p = in.point(3), q = in.point(4);
  require(segment_triangle(p, q, t.point) == oracle::contact(p, q, t.point), "segment_triangle",
          in);
  if (oracle::degenerate(u.point)) return;
  const TriangleContact contact = triangle_triangle(t, u);
  require(contact == oracle::contact(t, u), "triangle_triangle", in);
  require(contact == triangle_triangle(u, t), "symmetry of triangle_triangle", in);
  if (contact != TriangleContact::kImproper && contact != TriangleContact::kCoplanarOverlap) return;
  const TriangleWitness w = triangle_witness(t, u);
  const auto check = [&](const std::array<Integer, 3>& weight, const IndexedTriangle& tri) {
    Integer sum;
    for (const Integer& x : weight) {
      require(x.sign() != Sign::kNegative, "a weight of triangle_witness", in);
      sum += x;
    }
    for (int axis = 0; axis < 3; ++axis) {
      Rational v;
      for (int i = 0; i < 3; ++i)
        v += Rational(weight[i]) * Rational::from_double(tri.point[i][axis]);
      require(v == w.point[axis] * Rational(sum), "the point of triangle_witness", in);
    }
  };
  check(w.t_weight, t);
  check(w.u_weight, u);
}

// A point goes to a place that the others determine.
void move_point(Input& in, Random& random, std::uint64_t how) {
  const auto any_point = [&] { return static_cast<std::size_t>(random.below(kNumPoints)); };
  const auto combine = [&](const Vec3d& o, const Vec3d& u, double s, const Vec3d& v, double t) {
    return Vec3d{o.x + s * (u.x - o.x) + t * (v.x - o.x), o.y + s * (u.y - o.y) + t * (v.y - o.y),
                 o.z + s * (u.z - o.z) + t * (v.z - o.z)};
  };
  const auto factor = [&] {
    return std::ldexp(static_cast<double>(random.between(-5, 5)),
                      static_cast<int>(random.between(-3, 1)));
  };
  switch (how) {
    case 0: in.set(any_point(), in.point(any_point())); break;  // equal
    case 1:
      in.set(any_point(), combine(in.point(any_point()), in.point(any_point()), factor(), {}, 0));
      break;  // collinear
    case 2:
    case 3:  // coplanar
      in.set(any_point(), combine(in.point(any_point()), in.point(any_point()), factor(),
                                  in.point(any_point()), factor()));
      break;
    case 4: {  // cospherical: a corner of the box of two points
      const Vec3d p = in.point(any_point()), q = in.point(any_point());
      in.set(any_point(), {random.below(2) ? p.x : q.x, random.below(2) ? p.y : q.y,
                           random.below(2) ? p.z : q.z});
      break;
    }
    default: break;
  }
}

// Numbers change, whatever points they belong to.
void change_numbers(Input& in, Random& random, std::uint64_t how) {
  const auto any_coordinate = [&]() -> double& { return in.c[random.below(kNumCoordinates)]; };
  switch (how) {
    case 5: {  // one coordinate by some units in the last place
      double& v = any_coordinate();
      for (std::int64_t steps = random.between(1, 3); steps > 0; --steps)
        v = std::nextafter(v, random.below(2) ? 1e308 : -1e308);
      break;
    }
    case 6: any_coordinate() = any_coordinate(); break;
    case 7: {
      double& v = any_coordinate();
      v = -v;
      break;
    }
    case 8: {  // one coordinate's exponent
      double& v = any_coordinate();
      v = std::ldexp(v, static_cast<int>(random.between(-70, 70)));
      break;
    }
    case 9: {  // all exponents, or those of an axis
      const int scale = static_cast<int>(random.between(-1100, 1100));
      const std::uint64_t axis = random.below(4);
      for (std::size_t i = 0; i < kNumCoordinates; ++i) {
        if (axis == 3 || i % 3 == axis) in.c[i] = std::ldexp(in.c[i], scale);
      }
      break;
    }
    case 10: {
      constexpr double kSpecial[] = {0,         -0.0,     1,       5e-324, 0x1.fffffffffffffp1023,
                                     0x1p-1022, 0x1p-537, 0x1p511, 0.1};
      any_coordinate() = kSpecial[random.below(9)];
      break;
    }
    case 11: {  // small grid
      for (double& v : in.c) v = static_cast<double>(random.between(-2, 2));
      break;
    }
    case 12: {
      double& v = any_coordinate();
      v = std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) ^
                                (std::uint64_t{1} << random.below(64)));
      break;
    }
    default: in.options = static_cast<std::uint8_t>(random.below(8)); break;
  }
}

// One change that a geometer would make.
void mutate(Input& in, Random& random) {
  const std::uint64_t how = random.below(14);
  how < 5 ? move_point(in, random, how) : change_numbers(in, random, how);
  for (double& v : in.c) {
    if (!std::isfinite(v)) v = 0x1.fffffffffffffp1023;
  }
}

}  // namespace
}  // namespace veritope

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const veritope::Input in = veritope::Input::decode(data, size);
  veritope::check_signs(in);
  veritope::check_triangles(in);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  veritope::Input in = veritope::Input::decode(data, size);
  veritope::Random random(seed);
  for (std::uint64_t changes = 1 + random.below(3); changes > 0; --changes)
    veritope::mutate(in, random);
  const std::size_t written = in.encode(data, max_size);
  return written == 0 ? size : written;
}
