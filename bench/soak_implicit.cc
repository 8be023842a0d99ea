// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_implicit.cc: --cases N --seed S [--jobs J]. orient3d of implicit points against the point
// itself in GMP's rationals, found by Cramer's rule. Every kind of points in turn; of four query
// planes one is a plane that defines the point, one contains the line. One JSON line a figure.
#include <gmpxx.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "predicates/implicit_point.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "tests/predicates/point_generators.h"

namespace {

using namespace veritope;

struct Rationals {
  mpq_class x, y, z;
};
Rationals exact(const Vec3d& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }
Rationals minus(const Rationals& a, const Rationals& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Rationals cross(const Rationals& a, const Rationals& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
mpq_class dot(const Rationals& a, const Rationals& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Rationals normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return cross(minus(exact(b), exact(a)), minus(exact(c), exact(a)));
}
int side(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Rationals& d) {
  return sgn(dot(normal(a, b, c), minus(d, exact(a))));
}

bool intersection(const std::array<Vec3d, 5>& v, Rationals& out) {
  const Rationals n = normal(v[2], v[3], v[4]), p = exact(v[0]), u = minus(exact(v[1]), p);
  const mpq_class d = dot(n, u);
  if (sgn(d) == 0) return false;
  const mpq_class t = dot(n, minus(exact(v[2]), p)) / d;
  out = {p.x + t * u.x, p.y + t * u.y, p.z + t * u.z};
  return true;
}
bool intersection(const std::array<Vec3d, 9>& v, Rationals& out) {
  std::array<Rationals, 3> n;
  std::array<mpq_class, 3> k;
  for (int i = 0; i < 3; ++i) {
    n[i] = normal(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
    k[i] = dot(n[i], exact(v[3 * i]));
  }
  const Rationals a = cross(n[1], n[2]), b = cross(n[2], n[0]), c = cross(n[0], n[1]);
  const mpq_class d = dot(n[0], a);
  if (sgn(d) == 0) return false;
  out = {(k[0] * a.x + k[1] * b.x + k[2] * c.x) / d, (k[0] * a.y + k[1] * b.y + k[2] * c.y) / d,
         (k[0] * a.z + k[1] * b.z + k[2] * c.z) / d};
  return true;
}

struct Counts {
  std::uint64_t cases = 0, zeros = 0, undefined = 0, wrong = 0;
  TierCounts tiers;
};

template <typename Point, std::size_t N>
void judge(const std::array<Vec3d, N>& defining, const Point& point,
           const std::array<Vec3d, 3>& plane, const std::string& what, Counts& counts) {
  Rationals at;
  const bool exists = intersection(defining, at);
  ++counts.cases;
  bool right = exists == point.is_defined();
  if (right && exists) {
    const int expected = side(plane[0], plane[1], plane[2], at);
    right = to_int(orient3d(plane[0], plane[1], plane[2], point, &counts.tiers)) == expected;
    counts.zeros += expected == 0;
  }
  counts.undefined += !exists;
  if (!right && counts.wrong++ == 0) {
    std::string text = what + ":";
    for (const Vec3d& p : defining) {
      char buffer[128];
      std::snprintf(buffer, sizeof buffer, " {%a, %a, %a}", p.x, p.y, p.z);
      text += buffer;
    }
    std::fprintf(stderr, "wrong: %s\n", text.c_str());
  }
}

Counts run_chunk(std::uint64_t seed, std::size_t begin, std::size_t end) {
  Random random(seed);
  Counts counts;
  for (std::size_t i = begin; i < end; ++i) {
    const auto kind = static_cast<generate::Kind>(i / 2 % generate::kNumKinds);
    const generate::Points one = generate::points(kind, random),
                           two = generate::points(kind, random),
                           query = generate::points(kind, random);
    const std::uint64_t which = random.below(4);
    const std::string what = std::string(generate::kKindNames[static_cast<int>(kind)]) + " seed " +
                             std::to_string(seed) + " number " + std::to_string(i);
    if (i % 2 == 0) {
      const std::array<Vec3d, 5> v = one;
      std::array<Vec3d, 3> plane{query[0], query[1], query[2]};
      if (which == 0) plane = {v[3], v[2], v[4]};
      if (which == 1) plane = {v[1], v[0], query[0]};
      judge(v, LinePlanePoint(v[0], v[1], v[2], v[3], v[4]), plane, "lpi " + what, counts);
    } else {
      const std::array<Vec3d, 9> v{one[0], one[1], one[2], one[3], one[4],
                                   two[0], two[1], two[2], two[3]};
      std::array<Vec3d, 3> plane{query[0], query[1], query[2]};
      if (which < 2) plane = {v[3 * which + 4], v[3 * which + 3], v[3 * which + 5]};
      judge(v, ThreePlanePoint(v), plane, "tpi " + what, counts);
    }
  }
  return counts;
}

void figure(const std::string& name, double value, const std::string& goal) {
  std::printf("{\"name\":\"%s\",\"value\":%.17g,\"goal\":\"%s\"}\n", name.c_str(), value,
              goal.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cases = 1000000, seed = 1;
  unsigned jobs = 2;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc || (name != "--cases" && name != "--seed" && name != "--jobs")) {
      std::fprintf(stderr, "usage: soak_implicit [--cases N] [--seed S] [--jobs J]\n");
      return 2;
    }
    const std::uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (name == "--cases") cases = value;
    if (name == "--seed") seed = value;
    if (name == "--jobs") jobs = static_cast<unsigned>(value);
  }
  if (const Status status = check_fp(); !status) {
    std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
    return 5;
  }
  constexpr std::size_t kChunk = 20000;
  std::vector<Counts> parts(num_chunks(cases, kChunk));
  parallel_for(cases, kChunk, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    parts[chunk] = run_chunk(seed * 0x9e3779b97f4a7c15u + chunk, begin, end);
  });
  Counts total;
  for (const Counts& part : parts) {
    total.cases += part.cases, total.zeros += part.zeros, total.undefined += part.undefined;
    total.wrong += part.wrong, total.tiers += part.tiers;
  }
  figure("implicit_cases", static_cast<double>(total.cases), ">= 1e6");
  figure("implicit_wrong_signs", static_cast<double>(total.wrong), "0");
  figure("implicit_zeros_fraction",
         static_cast<double>(total.zeros) / static_cast<double>(total.cases), ">= 0.3");
  figure("implicit_undefined_fraction",
         static_cast<double>(total.undefined) / static_cast<double>(total.cases), "reported");
  constexpr const char* kTierNames[] = {"filter", "lattice", "interval", "exact"};
  for (std::size_t t = 0; t < kNumTiers; ++t) {
    figure(std::string("implicit_decided_by_") + kTierNames[t],
           static_cast<double>(total.tiers.decided[t]), "reported");
  }
  return total.wrong == 0 ? 0 : 1;
}
