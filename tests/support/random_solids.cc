// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/random_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "robust/base/check.h"
#include "solids/patches/patch_transform.h"
#include "splines/de_casteljau.h"

namespace veritope::random_solids {
namespace {

using Cube = std::array<int, 3>;
using Face = std::array<Cube, 4>;  // counterclockwise from outside
using Point = PatchPoint;

std::vector<Cube> random_cubes(Random& random) {
  const std::size_t wanted = 1 + random.below(6);
  std::set<Cube> cubes = {{0, 0, 0}};
  while (cubes.size() < wanted) {
    auto from = cubes.begin();
    std::advance(from, static_cast<std::ptrdiff_t>(random.below(cubes.size())));
    Cube next = *from;
    next[random.below(3)] += random.below(2) != 0 ? 1 : -1;
    cubes.insert(next);
  }
  return {cubes.begin(), cubes.end()};
}

std::vector<Face> outer_faces(const std::vector<Cube>& cubes) {
  const std::set<Cube> all(cubes.begin(), cubes.end());
  std::vector<Face> out;
  for (const Cube& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int up : {0, 1}) {
        Cube next = cube;
        next[axis] += up != 0 ? 1 : -1;
        if (all.count(next) != 0) continue;
        Face face;
        face.fill(cube);
        const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
        for (Cube& p : face) p[axis] += up;
        ++face[1][i], ++face[2][i], ++face[2][j], ++face[3][j];
        if (up == 0) std::swap(face[1], face[3]);
        out.push_back(face);
      }
  return out;
}

// The genus of each component; nothing unless every edge has two faces and the faces at every vertex form one cycle.
std::optional<std::vector<std::int64_t>> genera(const std::vector<Face>& faces) {
  std::map<std::pair<Cube, Cube>, std::vector<std::size_t>> edges;
  std::map<Cube, std::vector<std::size_t>> vertices;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& a = faces[f][k];
      const auto& b = faces[f][(k + 1) % 4];
      edges[std::minmax(a, b)].push_back(f);
      vertices[a].push_back(f);
    }
  std::vector<std::size_t> root(faces.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](std::size_t f) {
    while (root[f] != f) f = root[f];
    return f;
  };
  for (const auto& [edge, at] : edges) {
    if (at.size() != 2) return std::nullopt;
    root[find(at[0])] = find(at[1]);
  }
  for (const auto& [vertex, at] : vertices) {
    std::set<std::size_t> seen = {at[0]};
    for (std::size_t before = 0; before != seen.size();) {
      before = seen.size();
      for (const auto& [edge, pair] : edges)
        if ((edge.first == vertex || edge.second == vertex) &&
            seen.count(pair[0]) + seen.count(pair[1]) == 1)
          seen.insert({pair[0], pair[1]});
    }
    if (seen.size() != at.size()) return std::nullopt;
  }
  std::map<std::size_t, std::int64_t> chi;
  for (std::size_t f = 0; f < faces.size(); ++f) ++chi[find(f)];
  for (const auto& [edge, at] : edges) --chi[find(at[0])];
  for (const auto& [vertex, at] : vertices) ++chi[find(at[0])];
  std::vector<std::int64_t> out;
  for (const auto& [component, value] : chi) out.push_back(1 - value / 2);
  std::sort(out.begin(), out.end());
  return out;
}

// Control points at multiples of 1/n of the corners' places, each moved by its own vector.
class MovedPoints {
 public:
  MovedPoints(int n, double share, Random& random) : n_(n), random_(random) {
    // |d| <= r if its components are at most r / sqrt(3) < 0.577 r.
    steps_ = static_cast<std::int64_t>(share / (4 * n) * 0.577 * kGrid);
  }
  const Point& at(const Cube& place) {
    const auto [found, is_new] = points_.try_emplace(place);
    if (is_new)
      for (std::size_t c = 0; c < 3; ++c)
        found->second[c] = Rational(place[c]) / Rational(n_) +
                           Rational(random_.between(-steps_, steps_)) / Rational(kGrid);
    return found->second;
  }

 private:
  static constexpr int kGrid = 1 << 14;
  int n_;
  Random& random_;
  std::int64_t steps_;
  std::map<Cube, Point> points_;
};

// Whether two faces at one vertex look in opposite directions: then no plane through it has both sheets' normals on one
// side, moved or not.
bool has_opposed_faces(const std::vector<Face>& faces) {
  std::map<Cube, std::set<Cube>> normals;
  for (const Face& face : faces) {
    Cube normal;  // the cross product of two edges
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      normal[k] = (face[1][i] - face[0][i]) * (face[3][j] - face[0][j]) -
                  (face[1][j] - face[0][j]) * (face[3][i] - face[0][i]);
    }
    for (const Cube& vertex : face) {
      if (normals[vertex].count({-normal[0], -normal[1], -normal[2]}) != 0) return true;
      normals[vertex].insert(normal);
    }
  }
  return false;
}

PatchOrigin numbered(const Patches& patches) {
  return {PatchOrigin::Kind::kBuilt, patches.size(), {}};
}

void add_tensor(Patches& to, const Face& face, int n, MovedPoints& points) {
  Patch::Tensor map({n, n}, 3, false);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      Cube place;
      for (std::size_t c = 0; c < 3; ++c)
        place[c] = n * face[0][c] + i * (face[1][c] - face[0][c]) + j * (face[3][c] - face[0][c]);
      for (std::size_t c = 0; c < 3; ++c)
        map.component(static_cast<int>(c))[static_cast<std::size_t>(i * (n + 1) + j)] =
            points.at(place)[c];
    }
  to.push_back(make_patch(std::move(map), numbered(to)).value());
}

void add_triangle(Patches& to, const std::array<Cube, 3>& corners, int n, MovedPoints& points) {
  Patch::Triangle map(n, 3, false);
  for_each_triangle_index(n, [&](int i, int j, int k) {
    Cube place;
    for (std::size_t c = 0; c < 3; ++c)
      place[c] = i * corners[0][c] + j * corners[1][c] + k * corners[2][c];
    for (std::size_t c = 0; c < 3; ++c)
      map.component(static_cast<int>(c))[triangle_index(j, k)] = points.at(place)[c];
  });
  to.push_back(make_patch(std::move(map), numbered(to)).value());
}

Patches shifted(const Patches& patches, const Point& by) {
  AffineMap map{3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {by[0], by[1], by[2]}};
  return affine_image(patches, map).value();
}
Patches joined(const Patches& a, const Patches& b) {
  Patches out;
  for (const Patches* part : {&a, &b})
    for (const Patch& p : *part)
      out.push_back(p.is_triangle() ? make_patch(p.triangle(), numbered(out)).value()
                                    : make_patch(p.tensor(), numbered(out)).value());
  return out;
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  Point out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  return out;
}
Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A place on a patch: (u, v) of a tensor patch, the barycentric coordinates (1 - u - v, u, v) of a triangle.
struct Contact {
  Point point, along_u, along_v;
};
Point evaluated(const Patch& patch, const Rational& u, const Rational& v) {
  const auto value = patch.is_triangle()
                         ? evaluate<Rational>(patch.triangle(), {Rational(1) - u - v, u, v})
                         : evaluate<Rational, 2>(patch.tensor(), {u, v});
  return {value[0], value[1], value[2]};
}
// Exact: the central difference of a polynomial of degree n has fewer than n/2 error terms, and Romberg's scheme
// removes one with each halving.
Point derivative(const Patch& patch, const Rational& u, const Rational& v, bool along_u) {
  std::vector<Point> table;
  Rational h(1);
  for (int k = 0; 2 * k <= patch.max_degree(); ++k, h = h / Rational(2)) {
    const Point p = along_u ? evaluated(patch, u + h, v) : evaluated(patch, u, v + h),
                q = along_u ? evaluated(patch, u - h, v) : evaluated(patch, u, v - h);
    Point d = minus(p, q);
    for (Rational& x : d) x = x / (Rational(2) * h);
    table.push_back(d);
  }
  Rational four(1);
  for (std::size_t level = 1; level < table.size(); ++level) {
    four = four * Rational(4);
    for (std::size_t k = table.size() - 1; k >= level; --k)
      for (std::size_t c = 0; c < 3; ++c)
        table[k][c] = (four * table[k][c] - table[k - 1][c]) / (four - Rational(1));
  }
  return table.back();
}
Contact contact_at(const Patch& patch, const Rational& u, const Rational& v) {
  return {evaluated(patch, u, v), derivative(patch, u, v, true), derivative(patch, u, v, false)};
}

Rational in_unit(Random& random) { return Rational(random.between(6, 26)) / Rational(64); }
// A place inside: u, v and 1 - u - v are at least 6/64.
Contact random_contact(const Patch& patch, Random& random) {
  const Rational u = in_unit(random), v = in_unit(random);
  const Rational scale(patch.is_triangle() ? 1 : 2);
  return contact_at(patch, scale * u, scale * v);
}

bool is_transversal(const Contact& a, const Contact& b) {
  const Point m = cross(a.along_u, a.along_v), n = cross(b.along_u, b.along_v), k = cross(m, n);
  const Rational mm = dot(m, m), nn = dot(n, n), kk = dot(k, k);
  return mm != Rational(0) && nn != Rational(0) && Rational(64) * kk >= mm * nn;
}

const Patch& any(const Patches& patches, Random& random) {
  return patches[random.below(patches.size())];
}

Model crossing_shells(Random& random) {
  for (;;) {
    const Model a = perturbed_blocks(random, 0.5), b = perturbed_blocks(random, 0.5);
    const Contact p = random_contact(any(a.patches, random), random),
                  q = random_contact(any(b.patches, random), random);
    if (!is_transversal(p, q)) continue;
    Model out;
    out.patches = joined(a.patches, shifted(b.patches, minus(p.point, q.point)));
    out.description = "two shells with a planted crossing: " + a.description + "; " + b.description;
    return out;
  }
}

// The control points that do not lie on the patch's border.
std::vector<std::size_t> inner_control(const Patch& patch) {
  std::vector<std::size_t> out;
  if (patch.is_triangle()) {
    for_each_triangle_index(patch.triangle().degree(), [&](int i, int j, int k) {
      if (i > 0 && j > 0 && k > 0) out.push_back(triangle_index(j, k));
    });
    return out;
  }
  const auto& d = patch.tensor().degrees();
  for (int i = 1; i < d[0]; ++i)
    for (int j = 1; j < d[1]; ++j) out.push_back(static_cast<std::size_t>(i * (d[1] + 1) + j));
  return out;
}

// The patch with all coordinates of the control points `which` moved by d.
Patch moved(const Patch& patch, const std::vector<std::size_t>& which, const Point& d) {
  const auto apply = [&](auto map) {
    for (std::size_t c = 0; c < 3; ++c)
      for (const std::size_t i : which) map.component(static_cast<int>(c))[i] += d[c];
    return make_patch(std::move(map), patch.origin()).value();
  };
  return patch.is_triangle() ? apply(patch.triangle()) : apply(patch.tensor());
}

bool share_a_corner(const Patch& a, const Patch& b) {
  for (std::uint32_t i = 0; i < a.num_sides(); ++i)
    for (std::uint32_t j = 0; j < b.num_sides(); ++j)
      if (a.corner(i) == b.corner(j)) return true;
  return false;
}

std::optional<Model> crossing_itself(Random& random) {
  Model m = perturbed_blocks(random, 0.5);
  const std::size_t a = random.below(m.patches.size()), b = random.below(m.patches.size());
  const std::vector<std::size_t> which = inner_control(m.patches[a]);
  if (a == b || which.empty() || share_a_corner(m.patches[a], m.patches[b])) return std::nullopt;
  const Rational u = Rational(2) * in_unit(random), v = Rational(2) * in_unit(random);
  const Rational scale(m.patches[a].is_triangle() ? 2 : 1);
  const Contact p = contact_at(m.patches[a], u / scale, v / scale),
                q = random_contact(m.patches[b], random);
  const Point one{1, 1, 1};
  const Rational weight =
      (evaluated(moved(m.patches[a], which, one), u / scale, v / scale)[0] - p.point[0]);
  Point d = minus(q.point, p.point);
  for (Rational& x : d) x = x / weight;
  m.patches[a] = moved(m.patches[a], which, d);
  if (!is_transversal(contact_at(m.patches[a], u / scale, v / scale), q)) return std::nullopt;
  m.description = "patch " + std::to_string(a) + " drawn to a point of patch " + std::to_string(b) +
                  ": " + m.description;
  m.genus.clear();
  return m;
}

// The map that takes the frame `from` to the frame `to`; nothing if `from` is dependent.
std::optional<std::array<Point, 3>> frame_map(const std::array<Point, 3>& from,
                                              const std::array<Point, 3>& to) {
  const Rational det = dot(from[0], cross(from[1], from[2]));
  if (det == Rational(0)) return std::nullopt;
  // Rows of the inverse of the matrix with columns `from`.
  const std::array<Point, 3> inverse = {cross(from[1], from[2]), cross(from[2], from[0]),
                                        cross(from[0], from[1])};
  std::array<Point, 3> rows;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      Rational sum(0);
      for (std::size_t k = 0; k < 3; ++k) sum = sum + to[k][r] * inverse[k][c];
      rows[r][c] = sum / det;
    }
  return rows;
}

std::optional<Model> tangent_shells(Random& random) {
  const Model a = perturbed_blocks(random, 0.5), b = perturbed_blocks(random, 0.5);
  const Contact p = random_contact(any(a.patches, random), random),
                q = random_contact(any(b.patches, random), random);
  const Point n = cross(p.along_u, p.along_v), m = cross(q.along_u, q.along_v);
  const Rational turn = Rational(random.between(-3, 3)) / Rational(4);
  Point u = p.along_u, v = p.along_v, back;
  for (std::size_t c = 0; c < 3; ++c) {
    u[c] = u[c] + turn * p.along_v[c];
    back[c] = -n[c];
  }
  const auto rows = frame_map({q.along_u, q.along_v, m}, {u, v, back});
  if (!rows) return std::nullopt;
  AffineMap map{3, 3, {}, {0, 0, 0}};
  for (const Point& row : *rows) map.linear.insert(map.linear.end(), row.begin(), row.end());
  const Patches turned = affine_image(b.patches, map).value();
  Point image;
  for (std::size_t r = 0; r < 3; ++r) image[r] = dot((*rows)[r], q.point);
  Model out;
  out.patches = joined(a.patches, shifted(turned, minus(p.point, image)));
  out.description =
      "two shells tangent in a planted point: " + a.description + "; " + b.description;
  return out;
}

// A corner, the middle of a side, or a point inside.
Point random_place(const Patch& patch, std::uint64_t kind, Random& random) {
  if (kind == 2) return random_contact(patch, random).point;
  const std::uint32_t side = static_cast<std::uint32_t>(random.below(patch.num_sides()));
  if (kind == 0) return *point_of(patch.corner(side));
  const auto value =
      evaluate<Rational, 1>(patch.side(side), {Rational(random.between(16, 48)) / Rational(64)});
  return {value[0], value[1], value[2]};
}

Model pinched_shells(Random& random) {
  const Model a = perturbed_blocks(random, 0.5), b = perturbed_blocks(random, 0.5);
  // Not face on face, which is a crossing.
  const std::uint64_t first = random.below(3),
                      second = first == 2 ? random.below(2) : random.below(3);
  const Point p = random_place(any(a.patches, random), first, random),
              q = random_place(any(b.patches, random), second, random);
  static constexpr const char* kNames[] = {"vertex", "edge", "face"};
  Model out;
  out.patches = joined(a.patches, shifted(b.patches, minus(p, q)));
  out.description = std::string("two shells in contact, ") + kNames[first] + " and " +
                    kNames[second] + ": " + a.description + "; " + b.description;
  return out;
}

Model beyond_the_bound(Random& random) { return perturbed_blocks(random, 1 + 4 * random.unit()); }

Model neighbours(Random& random) {
  const Model a = perturbed_blocks(random, 0.9), b = perturbed_blocks(random, 0.9);
  Point by;
  for (Rational& x : by) x = Rational(random.between(-160, 160)) / Rational(64);
  Model out;
  const auto at = [](const Patches& patches) { return *point_of(patches[0].corner(0)); };
  const Point home = minus(at(a.patches), at(b.patches));
  out.patches =
      joined(a.patches, shifted(b.patches, {home[0] + by[0], home[1] + by[1], home[2] + by[2]}));
  out.description = "two shells anywhere: " + a.description + "; " + b.description;
  return out;
}

template <typename Make>
Model first_of(Random& random, Make make) {
  for (;;)
    if (std::optional<Model> model = make(random)) return *std::move(model);
}

}  // namespace

AffineMap random_map(Random& random) {
  for (;;) {
    AffineMap map{3, 3, {}, {}};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        map.linear.push_back(Rational(random.between(-4, 4) + (row == column ? 5 : 0)) /
                             Rational(4));
      map.translation.push_back(Rational(random.between(-1000, 1000)) / Rational(7));
    }
    const auto& m = map.linear;
    const Rational determinant =
        dot({m[0], m[1], m[2]}, cross({m[3], m[4], m[5]}, {m[6], m[7], m[8]}));
    if (abs(determinant) > Rational(1) / Rational(4)) return map;
  }
}

Model perturbed_blocks(Random& random, double share, bool has_opposed) {
  std::vector<Cube> cubes;
  std::vector<Face> faces;
  Model out;
  for (;;) {
    cubes = random_cubes(random);
    faces = outer_faces(cubes);
    auto genus = genera(faces);
    if (!genus || has_opposed_faces(faces) != has_opposed) continue;
    out.genus = *std::move(genus);
    break;
  }
  out.bodies = 1;  // the cubes are connected through faces
  const int n = 2 + static_cast<int>(random.below(2));
  const std::uint64_t style = random.below(3);  // tensors, triangles, both
  MovedPoints points(n, share, random);
  for (const Face& face : faces)
    if (style == 0 || (style == 2 && random.below(2) != 0)) {
      add_tensor(out.patches, face, n, points);
    } else {
      add_triangle(out.patches, {face[0], face[1], face[2]}, n, points);
      add_triangle(out.patches, {face[0], face[2], face[3]}, n, points);
    }
  const bool is_bent = random.below(8) == 0;
  if (is_bent) {
    const std::size_t target = random.below(3);
    out.patches =
        sheared(out.patches, {target, (target + 1) % 3, (target + 1 + random.below(2)) % 3,
                              Rational(random.between(-8, 8)) / Rational(16)});
  }
  out.patches = affine_image(out.patches, random_map(random)).value();
  out.description = std::to_string(cubes.size()) + " cubes, degree " + std::to_string(n) +
                    ", share " + std::to_string(share) + (is_bent ? ", bent" : "");
  return out;
}

Model embedded(Random& random) { return perturbed_blocks(random, 0.2 + 0.77 * random.unit()); }

Model opposed(Random& random) { return perturbed_blocks(random, 0.2 + 0.77 * random.unit(), true); }

Model crossing(Random& random) {
  return random.below(2) != 0 ? crossing_shells(random) : first_of(random, crossing_itself);
}

Model touching(Random& random) {
  return random.below(2) != 0 ? first_of(random, tangent_shells) : pinched_shells(random);
}

Model unknown(Random& random) {
  return random.below(2) != 0 ? beyond_the_bound(random) : neighbours(random);
}

}  // namespace veritope::random_solids
