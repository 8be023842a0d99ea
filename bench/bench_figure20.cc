// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_figure20.cc [--svg FILE] [--points N]: figure 20 of seed 001 [GRF03]: how many systems of a ray and a
// patch are solved for N uniform points, by extended simplicial chains and by counting crossings of a ray (Jordan), for
// solids of PN triangles. Both reject patches first by the same prism: the control points over the base triangle,
// between two planes across its normal and three planes along it, parallel to the edges. The chain begins a solve for
// each prism that holds the point, Jordan for each prism that its ray meets. One JSON line for each solid and number of
// points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/models.h"
#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_sources.h"
#include "solids/patches/pn_mesh.h"
#include "solids/base/box_hierarchy.h"

namespace veritope::bench {
namespace {

Point3d minus(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point3d cross(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point3d& a, const Point3d& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// n·p <= d.
struct HalfSpace {
  Point3d n;
  double d;
};

struct Prism {
  std::array<HalfSpace, 5> sides;
  Box3d box;

  explicit Prism(const Patch& patch) {
    std::vector<Point3d> points;
    for (std::size_t i = 0; i < patch.num_control(); ++i)
      points.push_back({nearest_double(patch.component(0)[i]),
                        nearest_double(patch.component(1)[i]),
                        nearest_double(patch.component(2)[i])});
    std::array<Point3d, 3> c;
    for (std::uint32_t k = 0; k < 3; ++k) c[k] = approx_point(patch.corner(k));
    const Point3d n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    const auto bounded = [&](const Point3d& normal) {
      double most = -std::numeric_limits<double>::infinity();
      for (const Point3d& p : points) most = std::max(most, dot(normal, p));
      return HalfSpace{normal, most};
    };
    sides[0] = bounded(n);
    sides[1] = bounded({-n[0], -n[1], -n[2]});
    for (std::size_t e = 0; e < 3; ++e)
      sides[2 + e] = bounded(cross(minus(c[(e + 1) % 3], c[e]), n));
    box = empty_box();
    for (const Point3d& p : corners()) add(p, &box);
  }

  bool contains(const Point3d& q) const {
    return std::all_of(sides.begin(), sides.end(),
                       [&](const HalfSpace& s) { return dot(s.n, q) <= s.d; });
  }
  // The part q + t r, t >= 0.
  bool meets_ray(const Point3d& q, const Point3d& r) const {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (const HalfSpace& s : sides) {
      const double speed = dot(s.n, r), rest = s.d - dot(s.n, q);
      if (speed > 0)
        to = std::min(to, rest / speed);
      else if (speed < 0)
        from = std::max(from, rest / speed);
      else if (rest < 0)
        return false;
    }
    return from <= to;
  }

 private:
  // Where two neighbouring sides along the normal meet each of the two across it.
  std::vector<Point3d> corners() const {
    std::vector<Point3d> out;
    for (std::size_t across = 0; across < 2; ++across)
      for (std::size_t e = 0; e < 3; ++e) {
        const HalfSpace &a = sides[across], &b = sides[2 + e], &c = sides[2 + (e + 1) % 3];
        const Point3d bc = cross(b.n, c.n), ca = cross(c.n, a.n), ab = cross(a.n, b.n);
        const double determinant = dot(a.n, bc);
        Point3d p;
        for (std::size_t k = 0; k < 3; ++k)
          p[k] = (a.d * bc[k] + b.d * ca[k] + c.d * ab[k]) / determinant;
        out.push_back(p);
      }
    return out;
  }
};

struct Solves {
  std::uint64_t points = 0, chain = 0, jordan = 0;
};

std::vector<Solves> count(const std::vector<Patch>& patches, std::uint64_t most_points) {
  std::vector<Prism> prisms;
  std::vector<Box3d> boxes;
  Box3d all = empty_box();
  for (const Patch& p : patches) {
    prisms.emplace_back(p);
    boxes.push_back(prisms.back().box);
    all = hull(all, boxes.back());
  }
  const BoxHierarchy tree(boxes);
  const Point3d r{0, 0, 1};
  Random random(1);
  std::vector<Solves> out;
  Solves sum;
  for (std::uint64_t next = 100; next <= most_points; next *= 10) {
    for (; sum.points < next; ++sum.points) {
      Point3d q;
      for (std::size_t k = 0; k < 3; ++k)
        q[k] = all.lo[k] + random.unit() * (all.hi[k] - all.lo[k]);
      const auto column = [&](const Box3d& b) {
        return b.lo[0] <= q[0] && q[0] <= b.hi[0] && b.lo[1] <= q[1] && q[1] <= b.hi[1] &&
               q[2] <= b.hi[2];
      };
      tree.visit(column, [&](std::uint32_t i) {
        sum.jordan += prisms[i].meets_ray(q, r) ? 1 : 0;
        sum.chain += prisms[i].contains(q) ? 1 : 0;
      });
    }
    out.push_back(sum);
  }
  return out;
}

struct Curve {
  std::string name;
  std::size_t patches;
  std::vector<Solves> solves;
};

// Both axes logarithmic: points from 10^2, solves from 1.
void write_svg(const std::string& path, const std::vector<Curve>& curves) {
  std::ofstream out(path);
  constexpr double kWidth = 560, kHeight = 420, kLeft = 60, kBottom = 50;
  const auto x = [&](double points) { return kLeft + (std::log10(points) - 2) * 100; };
  const auto y = [&](double solves) {
    return kHeight - kBottom - std::log10(std::max(solves, 1.0)) * 48;
  };
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth << "\" height=\"" << kHeight
      << "\" font-family=\"sans-serif\" font-size=\"11\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (int p = 2; p <= 6; ++p)
    out << "<text x=\"" << x(std::pow(10, p)) - 8 << "\" y=\"" << kHeight - kBottom + 16 << "\">10^"
        << p << "</text>\n";
  for (int p = 0; p <= 7; ++p)
    out << "<text x=\"20\" y=\"" << y(std::pow(10, p)) + 4 << "\">10^" << p << "</text>\n";
  out << "<text x=\"250\" y=\"" << kHeight - 12 << "\">points</text>\n"
      << "<text x=\"8\" y=\"14\">solves begun; full: chain, dashed: Jordan</text>\n";
  constexpr const char* kColours[] = {"#1b6ca8", "#c0392b", "#2e8b57",
                                      "#8e44ad", "#d68910", "#444"};
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (const bool is_chain : {true, false}) {
      out << "<polyline fill=\"none\" stroke=\"" << kColours[c % 6] << "\""
          << (is_chain ? "" : " stroke-dasharray=\"4 3\"") << " points=\"";
      for (const Solves& s : curves[c].solves)
        out << x(static_cast<double>(s.points)) << ','
            << y(static_cast<double>(is_chain ? s.chain : s.jordan)) << ' ';
      out << "\"/>\n";
      if (is_chain)
        out << "<text x=\"70\" y=\"" << 34 + 14 * c << "\" fill=\"" << kColours[c % 6] << "\">"
            << curves[c].name << ", " << curves[c].patches << " patches</text>\n";
    }
  out << "</svg>\n";
}

std::vector<Patch> pn_patches(const TriangleMesh& mesh) {
  std::vector<Vec3d> normals(mesh.positions.size());
  for (const auto& t : mesh.faces) {
    const Point3d a = to_point(mesh.positions[t[0]]), b = to_point(mesh.positions[t[1]]),
                  c = to_point(mesh.positions[t[2]]), n = cross(minus(b, a), minus(c, a));
    for (const std::uint32_t v : t) {
      normals[v].x += n[0];
      normals[v].y += n[1];
      normals[v].z += n[2];
    }
  }
  return patches_of(rounded(make_pn_mesh(mesh, normals).value()).value());
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  using namespace veritope::bench;
  std::uint64_t points = 1'000'000;
  std::string svg;
  read_arguments(argc, argv, {{"--points", &points}, {"--svg", &svg}});
  std::vector<Curve> curves;
  const auto run = [&](const std::string& name, const std::vector<Patch>& patches) {
    curves.push_back({name, patches.size(), count(patches, points)});
    for (const Solves& s : curves.back().solves)
      std::printf(
          "{\"row\":\"figure20_%s_%zu\",\"points\":%llu,\"chain\":%llu,\"jordan\":%llu,"
          "\"ratio\":%.1f}\n",
          name.c_str(), patches.size(), static_cast<unsigned long long>(s.points),
          static_cast<unsigned long long>(s.chain), static_cast<unsigned long long>(s.jordan),
          static_cast<double>(s.jordan) / static_cast<double>(std::max<std::uint64_t>(s.chain, 1)));
    std::fflush(stdout);
  };
  run("torus", patch_shapes::pn_torus(20, 13));
  run("torus", patch_shapes::pn_torus(40, 26));
  run("ball", pn_patches(data_model("solid1/releases__larger_sphere.off")));
  run("knot", pn_patches(data_model("solid1/releases__knot.off")));
  run("fertility", pn_patches(data_model("solid1/vcglib__fertility_tri.off")));
  if (!svg.empty()) write_svg(svg, curves);
  return 0;
}
