// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/complex_oracle.h"

#include <algorithm>
#include <map>

namespace veritope::oracle {
namespace {

using Segment = std::pair<GridPoint, GridPoint>;

unsigned finest(std::span<const OctreeCell> cells) {
  unsigned level = 0;
  for (const OctreeCell& c : cells) level = std::max(level, c.level);
  return level;
}

struct Cube {
  GridPoint low;
  int size;
};

std::vector<Cube> cubes(std::span<const OctreeCell> cells) {
  const unsigned level = finest(cells);
  std::vector<Cube> out;
  for (const OctreeCell& c : cells) {
    const int size = 1 << (level - c.level);
    out.push_back(
        {{static_cast<int>(c.i) * size, static_cast<int>(c.j) * size, static_cast<int>(c.k) * size},
         size});
  }
  return out;
}

GridPoint moved(GridPoint p, unsigned axis, int by) {
  p[axis] += by;
  return p;
}

bool contains(const GridSquare& outer, const GridSquare& inner) {
  if (outer.axis != inner.axis || outer.low[outer.axis] != inner.low[outer.axis]) return false;
  for (unsigned a = 0; a < 3; ++a)
    if (a != outer.axis &&
        (inner.low[a] < outer.low[a] || inner.low[a] + inner.size > outer.low[a] + outer.size))
      return false;
  return true;
}

// The parts of a face: it is split into quadrants while smaller faces of cells lie in it.
void parts(const GridSquare& face, const std::vector<GridSquare>& sides,
           std::vector<GridSquare>& out) {
  const bool split = std::any_of(sides.begin(), sides.end(), [&](const GridSquare& s) {
    return s.size < face.size && contains(face, s);
  });
  if (!split) return out.push_back(face);
  const int half = face.size / 2;
  for (int q = 0; q < 4; ++q) {
    GridPoint low = moved(face.low, (face.axis + 1) % 3, q & 1 ? half : 0);
    low = moved(low, (face.axis + 2) % 3, q & 2 ? half : 0);
    parts({face.axis, low, half}, sides, out);
  }
}

std::array<GridPoint, 4> corners(const GridSquare& s) {
  const unsigned b = (s.axis + 1) % 3, c = (s.axis + 2) % 3;
  return {s.low, moved(s.low, b, s.size), moved(moved(s.low, b, s.size), c, s.size),
          moved(s.low, c, s.size)};
}

// The parts of the segment between two corners, cut at the points that lie inside it.
std::vector<Segment> cut(GridPoint from, GridPoint to, const std::set<GridPoint>& points) {
  if (to < from) std::swap(from, to);
  const unsigned axis = from[0] != to[0] ? 0 : from[1] != to[1] ? 1 : 2;
  std::vector<Segment> out;
  GridPoint last = from;
  for (int at = from[axis] + 1; at < to[axis]; ++at) {
    GridPoint p = from;
    p[axis] = at;
    if (!points.contains(p)) continue;
    out.push_back({last, p});
    last = p;
  }
  out.push_back({last, to});
  return out;
}

template <typename T>
std::size_t position(const std::vector<T>& sorted, const T& item) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), item) -
                                  sorted.begin());
}

// The connected classes of `items`, joined where `sets` intersect.
template <typename T>
std::size_t num_classes(const std::vector<std::set<T>>& sets) {
  std::vector<std::size_t> label(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i) label[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < sets.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (label[i] == label[j]) continue;
        if (std::none_of(sets[i].begin(), sets[i].end(),
                         [&](const T& x) { return sets[j].contains(x); }))
          continue;
        label[i] = label[j] = std::min(label[i], label[j]);
        changed = true;
      }
  }
  return std::set<std::size_t>(label.begin(), label.end()).size();
}

}  // namespace

BruteComplex brute_complex(std::span<const OctreeCell> cells, EdgeRule rule) {
  const std::vector<Cube> cube = cubes(cells);
  std::vector<std::vector<GridSquare>> sides(cube.size());
  std::vector<GridSquare> all;
  for (std::size_t c = 0; c < cube.size(); ++c)
    for (unsigned a = 0; a < 3; ++a)
      for (const int end : {0, cube[c].size})
        sides[c].push_back({a, moved(cube[c].low, a, end), cube[c].size});
  for (const auto& s : sides) all.insert(all.end(), s.begin(), s.end());

  BruteComplex out;
  std::vector<std::vector<GridSquare>> of_cell(cube.size());
  std::set<GridSquare> faces;
  for (std::size_t c = 0; c < cube.size(); ++c) {
    for (const GridSquare& s : sides[c]) parts(s, all, of_cell[c]);
    faces.insert(of_cell[c].begin(), of_cell[c].end());
  }
  out.faces.assign(faces.begin(), faces.end());
  out.face_cells.resize(out.faces.size());
  out.cell_faces.resize(cube.size());
  for (std::size_t c = 0; c < cube.size(); ++c)
    for (const GridSquare& s : of_cell[c]) {
      out.face_cells[position(out.faces, s)].insert(c);
      out.cell_faces[c].insert(position(out.faces, s));
    }

  std::set<GridPoint> points;
  std::vector<std::set<GridPoint>> points_of_cell(cube.size());
  for (std::size_t c = 0; c < cube.size(); ++c)
    for (const GridSquare& s : of_cell[c])
      for (const GridPoint& p : corners(s)) {
        points.insert(p);
        points_of_cell[c].insert(p);
      }
  out.vertices.assign(points.begin(), points.end());

  std::set<Segment> edges;
  std::vector<std::set<Segment>> of_face(out.faces.size());
  for (std::size_t f = 0; f < out.faces.size(); ++f) {
    std::set<GridPoint> near;
    if (rule == EdgeRule::kFaceNeighbours)
      for (const std::size_t c : out.face_cells[f])
        for (const std::size_t g : out.cell_faces[c])
          for (const std::size_t d : out.face_cells[g])
            near.insert(points_of_cell[d].begin(), points_of_cell[d].end());
    const auto corner = corners(out.faces[f]);
    for (unsigned i = 0; i < 4; ++i)
      for (const Segment& s :
           cut(corner[i], corner[(i + 1) % 4], rule == EdgeRule::kEveryVertex ? points : near))
        of_face[f].insert(s);
    edges.insert(of_face[f].begin(), of_face[f].end());
  }
  out.edges.assign(edges.begin(), edges.end());
  out.face_edges.resize(out.faces.size());
  for (std::size_t f = 0; f < out.faces.size(); ++f)
    for (const Segment& s : of_face[f]) out.face_edges[f].insert(position(out.edges, s));
  return out;
}

std::vector<std::size_t> BruteComplex::bad_edges() const {
  std::vector<std::size_t> num(edges.size()), out;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (face_cells[f].size() == 1)
      for (const std::size_t e : face_edges[f]) ++num[e];
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (num[e] != 0 && num[e] != 2) out.push_back(e);
  return out;
}

std::vector<std::size_t> BruteComplex::bad_vertices() const {
  std::map<GridPoint, std::vector<std::set<std::size_t>>>
      at;  // for each boundary face, its edges there
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (face_cells[f].size() != 1) continue;
    std::map<GridPoint, std::set<std::size_t>> here;
    for (const std::size_t e : face_edges[f]) {
      here[edges[e].first].insert(e);
      here[edges[e].second].insert(e);
    }
    for (const auto& [p, set] : here) at[p].push_back(set);
  }
  std::vector<std::size_t> out;
  for (const auto& [p, sets] : at)
    if (num_classes(sets) > 1) out.push_back(position(vertices, p));
  return out;
}

std::vector<std::set<std::size_t>> BruteComplex::boundary_components() const {
  std::map<std::size_t, std::vector<std::size_t>> at;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (face_cells[f].size() == 1)
      for (const std::size_t e : face_edges[f]) at[e].push_back(f);
  std::vector<std::set<std::size_t>> out;
  std::set<std::size_t> seen;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (face_cells[f].size() != 1 || seen.contains(f)) continue;
    std::vector<std::size_t> open{f};
    out.emplace_back();
    while (!open.empty()) {
      const std::size_t g = open.back();
      open.pop_back();
      if (!seen.insert(g).second) continue;
      out.back().insert(g);
      for (const std::size_t e : face_edges[g])
        for (const std::size_t h : at[e]) open.push_back(h);
    }
  }
  return out;
}

int BruteComplex::euler(const std::set<std::size_t>& some) const {
  std::set<std::size_t> e;
  std::set<GridPoint> v;
  for (const std::size_t f : some) e.insert(face_edges[f].begin(), face_edges[f].end());
  for (const std::size_t i : e) {
    v.insert(edges[i].first);
    v.insert(edges[i].second);
  }
  return static_cast<int>(v.size()) - static_cast<int>(e.size()) + static_cast<int>(some.size());
}

std::array<std::size_t, 4> BruteComplex::collapse(const std::set<std::size_t>& d_plus) const {
  // sides[d][t]: the cells of dimension d - 1 in the boundary of t.
  std::array<std::vector<std::set<std::size_t>>, 4> sides;
  for (const auto& e : edges)
    sides[1].push_back({position(vertices, e.first), position(vertices, e.second)});
  sides[2] = face_edges;
  sides[3] = cell_faces;
  sides[0].resize(vertices.size());
  std::array<std::vector<bool>, 4> stays;
  for (unsigned d = 0; d < 4; ++d) stays[d].resize(sides[d].size());
  for (const std::size_t f : d_plus) {
    stays[2][f] = true;
    for (const std::size_t e : face_edges[f]) {
      stays[1][e] = true;
      for (const std::size_t v : sides[1][e]) stays[0][v] = true;
    }
  }
  std::array<std::vector<bool>, 4> gone;
  for (unsigned d = 0; d < 4; ++d) gone[d].resize(sides[d].size());
  for (unsigned d = 3; d > 0; --d)
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<std::vector<std::size_t>> above(sides[d - 1].size());
      for (std::size_t t = 0; t < sides[d].size(); ++t)
        if (!gone[d][t])
          for (const std::size_t s : sides[d][t]) above[s].push_back(t);
      for (std::size_t s = 0; s < above.size(); ++s) {
        if (stays[d - 1][s] || gone[d - 1][s] || above[s].size() != 1 || gone[d][above[s][0]])
          continue;
        gone[d - 1][s] = gone[d][above[s][0]] = changed = true;
      }
    }
  std::array<std::size_t, 4> out{};
  for (unsigned d = 0; d < 4; ++d)
    for (std::size_t i = 0; i < sides[d].size(); ++i) out[d] += !gone[d][i] && !stays[d][i];
  return out;
}

VoxelLinks voxel_links(std::span<const OctreeCell> cells) {
  std::set<GridPoint> occupied;
  int n = 1 << finest(cells);
  for (const Cube& c : cubes(cells))
    for (int z = 0; z < c.size; ++z)
      for (int y = 0; y < c.size; ++y)
        for (int x = 0; x < c.size; ++x)
          occupied.insert({c.low[0] + x, c.low[1] + y, c.low[2] + z});
  VoxelLinks out;
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        std::array<bool, 8> full;
        for (int q = 0; q < 8; ++q)
          full[static_cast<unsigned>(q)] =
              occupied.contains({x - 1 + (q & 1), y - 1 + (q >> 1 & 1), z - 1 + (q >> 2)});
        bool on_bad_edge = false;
        for (unsigned a = 0; a < 3; ++a)
          for (unsigned up = 0; up < 2; ++up) {
            const unsigned b = 1u << (a + 1) % 3, c = 1u << (a + 2) % 3, base = up << a;
            const bool p = full[base], q = full[base | b | c], r = full[base | b],
                       s = full[base | c];
            if (p != q || r != s || p == r) continue;
            on_bad_edge = true;
            if (up == 1) out.bad_edges.insert({{x, y, z}, a});
          }
        if (on_bad_edge) continue;
        for (const bool kind : {false, true}) {
          std::vector<std::set<unsigned>>
              squares;  // for each voxel of that kind, the coordinate squares at the point
          for (unsigned q = 0; q < 8; ++q)
            if (full[q] == kind) {
              squares.emplace_back();
              for (unsigned a = 0; a < 3; ++a) squares.back().insert(8 * a + (q & ~(1u << a)));
            }
          if (num_classes(squares) > 1) out.bad_points.insert({x, y, z});
        }
      }
  return out;
}

}  // namespace veritope::oracle
