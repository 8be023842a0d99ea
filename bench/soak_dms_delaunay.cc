// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_delaunay.cc: Delaunay tetrahedralizations of random sets of 10 to 10^4 points of all kinds against
// their definition, and beside CGAL's.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "tests/support/cgal_delaunay.h"
#include "tests/support/delaunay_laws.h"
#include "tests/support/point_sets.h"

namespace {

using namespace veritope;

struct Counts {
  std::uint64_t points = 0, tetrahedra = 0, beside_cgal = 0;
};

std::string broken_law(const PointSet& set, int kind, Counts& counts) {
  const auto ours = delaunay_tetrahedra(std::span<const Vec3d>(set.points));
  if (!ours) return "refused: " + ours.error().message;
  counts.points += set.points.size();
  counts.tetrahedra += ours->tetrahedra.size();
  const std::span<const Vec3d> points(set.points);
  std::string law = check_delaunay(points, *ours, set.points.size() <= 200);
  if (law.empty() && set.points.size() <= 500 && !volumes_add_up(points, *ours)) law = "volumes";
  if (!law.empty() || kind == kPointSetKinds - 1) return law;  // no peer for subnormal numbers
  ++counts.beside_cgal;
  std::vector<TetrahedronCorners> cgal = cgal_delaunay(points);
  for (TetrahedronCorners& t : cgal)
    for (std::uint32_t& v : t) v = ours->same_as[v];
  if (ours->tetrahedra.size() != cgal.size()) return "CGAL has another number of tetrahedra";
  return sorted_tetrahedra(ours->tetrahedra) == sorted_tetrahedra(cgal)
             ? ""
             : "CGAL has other tetrahedra";
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t sets = 1000, seed = 1, most = 10000;
  bench::read_arguments(argc, argv, {{"--sets", &sets}, {"--seed", &seed}, {"--most", &most}});
  Counts counts;
  long broken = 0;
  for (std::uint64_t i = 0; i < sets; ++i) {
    Random random(seed * 10'000'000 + i);
    const int kind = static_cast<int>(i % kPointSetKinds);
    // Numbers of points whose logarithms are uniform.
    const double part = random.unit();
    const auto count =
        static_cast<std::size_t>(10 * std::pow(static_cast<double>(most) / 10, part));
    const PointSet set = make_point_set(kind, count, random);
    const std::string law = broken_law(set, kind, counts);
    if (law.empty()) continue;
    ++broken;
    std::fprintf(stderr, "set %llu (%s, %zu points): %s\n", static_cast<unsigned long long>(i),
                 set.kind.c_str(), set.points.size(), law.c_str());
  }
  std::printf(
      "{\"name\":\"dms_delaunay\",\"value\":%ld,\"goal\":\"0 broken "
      "laws\",\"sets\":%llu,\"points\":%llu,"
      "\"tetrahedra\":%llu,\"beside_cgal\":%llu}\n",
      broken, static_cast<unsigned long long>(sets), static_cast<unsigned long long>(counts.points),
      static_cast<unsigned long long>(counts.tetrahedra),
      static_cast<unsigned long long>(counts.beside_cgal));
  return broken == 0 ? 0 : 1;
}
