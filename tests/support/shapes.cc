// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "predicates/orient3d.h"
#include "robust/rational.h"

namespace veritope::shapes {
namespace {

using Face = std::array<std::uint32_t, 3>;

[[noreturn]] void bad(const std::string& why, std::string_view at) {
  throw std::invalid_argument("shape text: " + why + " at '" + std::string(at.substr(0, 40)) + "'");
}

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> out(1);
  for (char c : text) {
    if (c == separator) {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> out;
  for (std::string& w : split_at(text, ' '))
    if (!w.empty()) out.push_back(std::move(w));
  return out;
}

double number(const std::string& text) {
  const auto parts = split_at(text, '/');
  const auto value = [&](const std::string& s) {
    char* end = nullptr;
    const double v = std::strtod(s.c_str(), &end);
    if (s.empty() || *end != '\0' || !std::isfinite(v)) bad("no number", text);
    return v;
  };
  const double v = parts.size() == 2 ? value(parts[0]) / value(parts[1]) : value(text);
  return v == 0 ? 0 : v;  // no -0
}

Vec3d point(const std::string& text) {
  const auto c = split_at(text, ',');
  if (c.size() != 3) bad("a point has three coordinates", text);
  return {number(c[0]), number(c[1]), number(c[2])};
}

// Finds vertices again by their place.
class Builder {
 public:
  std::uint32_t vertex(const Vec3d& p) {
    const auto [it, is_new] =
        at_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) mesh_.positions.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    return it->second;
  }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
    mesh_.faces.push_back({i, j, k});
  }
  void quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  void tetrahedron(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    triangle(a, c, b);
    triangle(a, b, d);
    triangle(b, c, d);
    triangle(c, a, d);
  }
  TriangleMesh& mesh() { return mesh_; }

 private:
  std::map<std::array<double, 3>, std::uint32_t> at_;
  TriangleMesh mesh_;
};

void add_box(Builder& out, const Vec3d& lo, const Vec3d& hi, int n) {
  const auto at = [&](int axis, int i) {
    return i == 0 ? lo[axis] : (i == n ? hi[axis] : lo[axis] + (hi[axis] - lo[axis]) * i / n);
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto corner = [&](int side, int u, int v) {
          std::array<double, 3> p{};
          p[static_cast<std::size_t>(axis)] = side == 0 ? lo[axis] : hi[axis];
          p[static_cast<std::size_t>((axis + 1) % 3)] = at((axis + 1) % 3, i + u);
          p[static_cast<std::size_t>((axis + 2) % 3)] = at((axis + 2) % 3, j + v);
          return Vec3d{p[0], p[1], p[2]};
        };
        out.quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
        out.quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
      }
}

// Multiples of 2^-10: midpoints and small integer maps of such coordinates are exact.
double snapped(double v) { return std::round(v * 1024) / 1024 + 0.0; }
Vec3d snapped(const Vec3d& p) { return {snapped(p.x), snapped(p.y), snapped(p.z)}; }

std::uint32_t add(TriangleMesh& mesh, const Vec3d& p) {
  mesh.positions.push_back(p);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

double turn(int i, int n) { return 2 * std::numbers::pi * i / n; }

// Triangulates the polygon `rim`, counter-clockwise as seen from outside; only the fan uses `centre`.
void add_cap(TriangleMesh& mesh, const std::vector<std::uint32_t>& rim, Cap cap, const Vec3d& centre) {
  const std::size_t n = rim.size();
  if (cap == Cap::kCentreFan) {
    const std::uint32_t c = add(mesh, centre);
    for (std::size_t i = 0; i < n; ++i) mesh.faces.push_back({c, rim[i], rim[(i + 1) % n]});
  } else if (cap == Cap::kRimFan) {
    for (std::size_t i = 1; i + 1 < n; ++i) mesh.faces.push_back({rim[0], rim[i], rim[i + 1]});
  } else {
    for (std::size_t lo = 0, hi = n - 1; lo + 1 < hi;) {
      mesh.faces.push_back({rim[lo], rim[lo + 1], rim[hi]});
      if (++lo + 1 >= hi) break;
      mesh.faces.push_back({rim[lo], rim[hi - 1], rim[hi]});
      --hi;
    }
  }
}

std::vector<std::uint32_t> reversed(std::vector<std::uint32_t> rim) {
  std::reverse(rim.begin(), rim.end());
  return rim;
}

// Two rings joined by 2 n triangles that run from corner i below to corner i + shift above.
void add_band(TriangleMesh& mesh, const std::vector<std::uint32_t>& below, const std::vector<std::uint32_t>& above,
              std::size_t shift) {
  const std::size_t n = below.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n, k = (i + shift) % n, l = (k + 1) % n;
    mesh.faces.push_back({below[i], below[j], above[l]});
    mesh.faces.push_back({below[i], above[l], above[k]});
  }
}

bool is_exact(double got, const Rational& want) { return Rational::from_double(got) == want; }

}  // namespace

TriangleMesh parse(std::string_view text) {
  Builder out;
  std::size_t last = 0;
  for (const std::string& command : split_at(text, ';')) {
    const auto w = words(command);
    if (w.empty()) continue;
    const auto points = [&](std::size_t n) {
      if (w.size() != n + 1) bad(std::to_string(n) + " points wanted", command);
      std::vector<Vec3d> p;
      for (std::size_t i = 1; i <= n; ++i) p.push_back(point(w[i]));
      return p;
    };
    TriangleMesh& mesh = out.mesh();
    const std::size_t before = mesh.faces.size();
    if (w[0] == "tri") {
      const auto p = points(3);
      out.triangle(p[0], p[1], p[2]);
    } else if (w[0] == "tet") {
      const auto p = points(4);
      out.tetrahedron(p[0], p[1], p[2], p[3]);
    } else if (w[0] == "box") {
      const auto p = points(2);
      add_box(out, p[0], p[1], 1);
    } else if (w[0] == "flip") {
      for (std::size_t f = last; f < mesh.faces.size(); ++f) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
      continue;
    } else if (w[0] == "v") {
      for (std::size_t i = 1; i < w.size(); ++i) mesh.positions.push_back(point(w[i]));
    } else if (w[0] == "f") {
      for (std::size_t i = 1; i < w.size(); ++i) {
        const auto ids = split_at(w[i], ',');
        if (ids.size() != 3) bad("a triangle has three ids", w[i]);
        Face f{};
        for (std::size_t k = 0; k < 3; ++k) f[k] = static_cast<std::uint32_t>(std::stoul(ids[k]));
        mesh.faces.push_back(f);
      }
    } else {
      bad("unknown command", command);
    }
    last = before;
  }
  for (const Face& f : out.mesh().faces)
    for (std::uint32_t v : f)
      if (v >= out.mesh().positions.size()) bad("no such vertex", std::to_string(v));
  return std::move(out.mesh());
}

std::string to_text(const TriangleMesh& mesh) {
  std::string out = "v";
  const auto coordinate = [](double v) {
    char digits[64];
    if (std::abs(v) < 1e6 && v == std::trunc(v)) {
      std::snprintf(digits, sizeof digits, "%.0f", v + 0.0);
    } else {
      std::snprintf(digits, sizeof digits, "%a", v);
    }
    return std::string(digits);
  };
  for (const Vec3d& p : mesh.positions) out += " " + coordinate(p.x) + "," + coordinate(p.y) + "," + coordinate(p.z);
  out += " ; f";
  for (const Face& f : mesh.faces)
    out += " " + std::to_string(f[0]) + "," + std::to_string(f[1]) + "," + std::to_string(f[2]);
  return out;
}

TriangleMesh box(Vec3d lo, Vec3d hi, int parts) {
  Builder out;
  add_box(out, lo, hi, parts);
  return std::move(out.mesh());
}

TriangleMesh prism(int sides, double radius, double height) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> low, high;
  for (int i = 0; i < sides; ++i) {
    const double x = radius * std::cos(turn(i, sides)), y = radius * std::sin(turn(i, sides));
    low.push_back(add(mesh, snapped(Vec3d{x, y, 0})));
    high.push_back(add(mesh, snapped(Vec3d{x, y, height})));
  }
  add_band(mesh, low, high, 0);
  add_cap(mesh, reversed(low), Cap::kRimFan, {});
  add_cap(mesh, high, Cap::kRimFan, {});
  return mesh;
}

TriangleMesh torus(int around, int across, double big, double small) {
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double r = big + small * std::cos(turn(j, across));
      add(mesh, snapped(Vec3d{r * std::cos(turn(i, around)), r * std::sin(turn(i, around)),
                              small * std::sin(turn(j, across))}));
    }
  const auto id = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return mesh;
}

TriangleMesh star_polyhedron(Random& random, int level) {
  Builder octahedron;
  for (int k = 0; k < 8; ++k) {
    const Vec3d x{(k & 1) != 0 ? -8.0 : 8.0, 0, 0}, y{0, (k & 2) != 0 ? -8.0 : 8.0, 0}, z{0, 0, (k & 4) != 0 ? -8.0 : 8.0};
    const bool mirrored = ((k & 1) ^ (k >> 1 & 1) ^ (k >> 2)) != 0;
    mirrored ? octahedron.triangle(x, z, y) : octahedron.triangle(x, y, z);
  }
  TriangleMesh mesh = std::move(octahedron.mesh());
  for (int i = 0; i < level; ++i) mesh = subdivided(mesh);
  for (Vec3d& p : mesh.positions) {
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z), r = 1 + 3 * random.unit();
    p = snapped(Vec3d{p.x / length * r, p.y / length * r, p.z / length * r});
  }
  return mesh;
}

TriangleMesh bipyramid(int sides) {
  TriangleMesh mesh;
  const std::uint32_t top = add(mesh, {0, 0, 1}), bottom = add(mesh, {0, 0, -1});
  for (int i = 0; i < sides; ++i) add(mesh, {2 * std::cos(turn(i, sides)), 2 * std::sin(turn(i, sides)), 0});
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<std::uint32_t>(2 + i), b = static_cast<std::uint32_t>(2 + (i + 1) % sides);
    mesh.faces.push_back({top, a, b});
    mesh.faces.push_back({bottom, b, a});
  }
  return mesh;
}

TriangleMesh cone(int sides) {
  TriangleMesh mesh;
  const std::uint32_t apex = add(mesh, {0, 0, 3});
  std::vector<std::uint32_t> rim;
  for (int i = 0; i < sides; ++i) rim.push_back(add(mesh, {std::cos(turn(i, sides)), std::sin(turn(i, sides)), 0}));
  for (std::size_t i = 0; i < rim.size(); ++i) mesh.faces.push_back({apex, rim[i], rim[(i + 1) % rim.size()]});
  add_cap(mesh, reversed(rim), Cap::kRimFan, {});
  return mesh;
}

TriangleMesh tilted_cylinder(int sides, Cap cap, double length) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> low, high;
  const double s = std::sqrt(14.0), ax = 3 / s, ay = 2 / s, az = 1 / s;  // u, v, axis: right-handed, orthonormal
  const double h = std::sqrt(13.0), ux = -2 / h, uy = 3 / h;
  const double vx = -az * uy, vy = az * ux, vz = ax * uy - ay * ux;
  for (int i = 0; i < sides; ++i) {
    const double c = std::cos(turn(i, sides)), d = std::sin(turn(i, sides));
    const Vec3d p{c * ux + d * vx, c * uy + d * vy, d * vz};
    low.push_back(add(mesh, p));
    high.push_back(add(mesh, {p.x + length * ax, p.y + length * ay, p.z + length * az}));
  }
  add_band(mesh, low, high, 0);
  add_cap(mesh, reversed(low), cap, {0, 0, 0});
  add_cap(mesh, high, cap, {length * ax, length * ay, length * az});
  return mesh;
}

TriangleMesh hyperboloid(int sides, int twist) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> low, high;
  for (int i = 0; i < sides; ++i) {
    const double c = std::cos(turn(i, sides)), s = std::sin(turn(i, sides));
    low.push_back(add(mesh, {c, s, -3}));
    high.push_back(add(mesh, {c, s, 3}));
  }
  add_band(mesh, low, high, static_cast<std::size_t>(twist));
  add_cap(mesh, reversed(low), Cap::kCentreFan, {0, 0, -3});
  add_cap(mesh, high, Cap::kCentreFan, {0, 0, 3});
  return mesh;
}

TriangleMesh saddle() { return polycube({{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}); }

TriangleMesh wave(int sides, double height) {
  TriangleMesh mesh;
  const std::uint32_t top = add(mesh, {0, 0, 0}), bottom = add(mesh, {0, 0, -4 * height - 4});
  std::vector<std::uint32_t> rim;
  for (int i = 0; i < sides; ++i)
    rim.push_back(add(mesh, snapped(Vec3d{4 * std::cos(turn(i, sides)), 4 * std::sin(turn(i, sides)),
                                          i % 2 == 0 ? height : -height})));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    mesh.faces.push_back({top, rim[i], rim[(i + 1) % rim.size()]});
    mesh.faces.push_back({bottom, rim[(i + 1) % rim.size()], rim[i]});
  }
  return mesh;
}

TriangleMesh polycube(const std::vector<std::array<int, 3>>& cells) {
  const std::set<std::array<int, 3>> inside(cells.begin(), cells.end());
  Builder out;
  for (const auto& cell : inside)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        auto other = cell;
        other[axis] += side == 1 ? 1 : -1;
        if (inside.count(other) != 0) continue;
        const auto corner = [&](int u, int v) {
          auto p = cell;
          p[axis] += side;
          p[(axis + 1) % 3] += u;
          p[(axis + 2) % 3] += v;
          return Vec3d{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
        };
        side == 1 ? out.quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1))
                  : out.quad(corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0));
      }
  return std::move(out.mesh());
}

TriangleMesh random_polycube(Random& random, int size, int num_cells) {
  std::vector<std::array<int, 3>> cells;
  const auto any = [&] { return static_cast<int>(random.below(static_cast<std::uint64_t>(size))); };
  for (int i = 0; i < num_cells; ++i) cells.push_back({any(), any(), any()});
  return polycube(cells);
}

TriangleMesh nested_boxes(int depth) {
  std::vector<TriangleMesh> parts;
  for (int i = 0; i < depth; ++i) {
    const double r = 2 * (depth - i);
    parts.push_back(box({-r, -r, -r}, {r, r, r}));
    if (i % 2 == 1) parts.back() = reversed(std::move(parts.back()));
  }
  return joined(parts);
}

TriangleMesh box_grid(int n, double gap) {
  std::vector<TriangleMesh> parts;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) {
        const Vec3d lo{x * (1 + gap), y * (1 + gap), z * (1 + gap)};
        parts.push_back(box(lo, {lo.x + 1, lo.y + 1, lo.z + 1}));
      }
  return joined(parts);
}

TriangleMesh nested_scene(Random& random, int shells) {
  struct Room {
    Vec3d lo, hi;
    int depth;
  };
  std::vector<Room> rooms{{{0, 0, 0}, {4096, 4096, 4096}, 0}};
  std::vector<TriangleMesh> parts;
  while (static_cast<int>(parts.size()) < shells) {
    const std::size_t pick = random.below(rooms.size());
    const Room room = rooms[pick];
    rooms.erase(rooms.begin() + static_cast<std::ptrdiff_t>(pick));
    const int axis = static_cast<int>(random.below(3));
    if (random.below(3) == 0 && room.hi[axis] - room.lo[axis] >= 64) {  // two rooms side by side
      Room a = room, b = room;
      const double middle = (room.lo[axis] + room.hi[axis]) / 2;
      (axis == 0 ? a.hi.x : axis == 1 ? a.hi.y : a.hi.z) = middle;
      (axis == 0 ? b.lo.x : axis == 1 ? b.lo.y : b.lo.z) = middle;
      rooms.push_back(a);
      rooms.push_back(b);
      continue;
    }
    const Vec3d size{room.hi.x - room.lo.x, room.hi.y - room.lo.y, room.hi.z - room.lo.z};
    if (std::min({size.x, size.y, size.z}) < 16 || room.depth == 6) {
      if (rooms.empty()) break;
      continue;
    }
    const auto margin = [&](double s) { return 1.0 + static_cast<double>(random.below(static_cast<std::uint64_t>(s / 8))); };
    const Room inner{{room.lo.x + margin(size.x), room.lo.y + margin(size.y), room.lo.z + margin(size.z)},
                     {room.hi.x - margin(size.x), room.hi.y - margin(size.y), room.hi.z - margin(size.z)},
                     room.depth + 1};
    parts.push_back(box(inner.lo, inner.hi));
    if (room.depth % 2 == 1) parts.back() = reversed(std::move(parts.back()));
    rooms.push_back(inner);
  }
  return joined(parts);
}

TriangleMesh needles(Random& random, int num) {
  std::vector<TriangleMesh> parts;
  int side = 1;
  while (side * side * side < num) ++side;
  for (int i = 0; i < num; ++i) {
    const Vec3d cell{2.0 * (i % side), 2.0 * (i / side % side), 2.0 * (i / side / side)};
    const auto any = [&] { return Vec3d{cell.x + random.unit(), cell.y + random.unit(), cell.z + random.unit()}; };
    const Vec3d a = any(), b = any();
    const Vec3d c{b.x + 1e-3 * random.unit(), b.y + 1e-3, b.z}, d{b.x, b.y, b.z + 1e-3};
    Builder out;
    orient3d(a, b, c, d) == Sign::kPositive ? out.tetrahedron(a, b, c, d) : out.tetrahedron(a, c, b, d);
    parts.push_back(std::move(out.mesh()));
  }
  return joined(parts);
}

TriangleMesh needle_soup(Random& random, int num_triangles) {
  Builder out;
  for (int i = 0; i < num_triangles; ++i) {
    const auto any = [&] { return Vec3d{8 * random.unit(), 8 * random.unit(), 8 * random.unit()}; };
    const Vec3d a = any(), b = any();
    out.triangle(a, b, {b.x + 0x1p-8 * random.unit(), b.y + 0x1p-8 * random.unit(), b.z});
  }
  return std::move(out.mesh());
}

TriangleMesh grid_soup(Random& random, int num_triangles, int grid) {
  Builder out;
  const auto any = [&] {
    const auto c = [&] { return static_cast<double>(random.below(static_cast<std::uint64_t>(grid))); };
    const double x = c(), y = c(), z = c();
    return Vec3d{x, y, z};
  };
  for (int i = 0; i < num_triangles; ++i) {
    const Vec3d a = any(), b = any(), c = any();
    out.triangle(a, b, c);
  }
  return std::move(out.mesh());
}

TriangleMesh random_indexed(Random& random, int num_triangles, int num_vertices, int grid) {
  TriangleMesh mesh;
  const auto c = [&] { return static_cast<double>(random.below(static_cast<std::uint64_t>(grid))); };
  for (int i = 0; i < num_vertices; ++i) {
    const double x = c(), y = c(), z = c();
    add(mesh, {x, y, z});
  }
  const auto id = [&] { return static_cast<std::uint32_t>(random.below(static_cast<std::uint64_t>(num_vertices))); };
  for (int i = 0; i < num_triangles; ++i) {
    const std::uint32_t a = id(), b = id(), d = id();
    mesh.faces.push_back({a, b, d});
  }
  return mesh;
}

TriangleMesh joined(std::span<const TriangleMesh> parts) {
  TriangleMesh out;
  for (const TriangleMesh& part : parts) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    out.positions.insert(out.positions.end(), part.positions.begin(), part.positions.end());
    for (const Face& f : part.faces) out.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  }
  return out;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  const std::array<TriangleMesh, 2> both{a, b};
  return joined(both);
}

TriangleMesh reversed(TriangleMesh mesh) {
  for (Face& f : mesh.faces) std::swap(f[1], f[2]);
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, Vec3d by) {
  for (Vec3d& p : mesh.positions) p = {p.x + by.x + 0.0, p.y + by.y + 0.0, p.z + by.z + 0.0};
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, int exponent) {
  for (Vec3d& p : mesh.positions) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  return mesh;
}

TriangleMesh merged(const TriangleMesh& mesh) {
  Builder out;
  for (const Face& f : mesh.faces)
    out.triangle(mesh.positions[f[0]], mesh.positions[f[1]], mesh.positions[f[2]]);
  return std::move(out.mesh());
}

int determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TriangleMesh mapped(const TriangleMesh& mesh, const Matrix& m, std::array<int, 3> shift) {
  TriangleMesh out = mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d& p = mesh.positions[i];
    std::array<double, 3> q{};
    for (std::size_t k = 0; k < 3; ++k) {
      q[k] = m[k][0] * p.x + m[k][1] * p.y + m[k][2] * p.z + shift[k] + 0.0;
      const Rational want = Rational(m[k][0]) * Rational::from_double(p.x) + Rational(m[k][1]) * Rational::from_double(p.y) +
                            Rational(m[k][2]) * Rational::from_double(p.z) + Rational(shift[k]);
      if (!is_exact(q[k], want)) throw std::invalid_argument("mapped: not exact");
    }
    out.positions[i] = {q[0], q[1], q[2]};
  }
  return out;
}

Matrix random_matrix(Random& random, int size) {
  for (;;) {
    Matrix m{};
    for (auto& row : m)
      for (int& c : row) c = static_cast<int>(random.between(-size, size));
    if (determinant(m) != 0) return m;
  }
}

TriangleMesh relabelled(const TriangleMesh& mesh, Random& random) {
  const auto shuffled = [&](std::size_t n) {
    std::vector<std::uint32_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(i);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
  };
  const auto new_id = shuffled(mesh.positions.size());
  TriangleMesh out;
  out.positions.resize(mesh.positions.size());
  for (std::size_t v = 0; v < new_id.size(); ++v) out.positions[new_id[v]] = mesh.positions[v];
  for (std::uint32_t f : shuffled(mesh.faces.size())) {
    const Face& t = mesh.faces[f];
    const std::size_t r = random.below(3);
    out.faces.push_back({new_id[t[r]], new_id[t[(r + 1) % 3]], new_id[t[(r + 2) % 3]]});
  }
  return out;
}

TriangleMesh subdivided(const TriangleMesh& mesh) {
  TriangleMesh out;
  out.positions = mesh.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, is_new] = middle.try_emplace(std::minmax(a, b), 0u);
    if (is_new) {
      const Vec3d p = mesh.positions[a], q = mesh.positions[b];  // copies: add may move the array
      const Vec3d m{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
      for (int k = 0; k < 3; ++k)
        if (!is_exact(m[k], (Rational::from_double(p[k]) + Rational::from_double(q[k])) / Rational(2)))
          throw std::invalid_argument("subdivided: a midpoint is not exact");
      it->second = add(out, m);
    }
    return it->second;
  };
  for (const Face& f : mesh.faces) {
    const std::uint32_t a = between(f[0], f[1]), b = between(f[1], f[2]), c = between(f[2], f[0]);
    out.faces.push_back({f[0], a, c});
    out.faces.push_back({a, f[1], b});
    out.faces.push_back({c, b, f[2]});
    out.faces.push_back({a, b, c});
  }
  return out;
}

}  // namespace veritope::shapes
