// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/mfem_topology.h"

#include <algorithm>
#include <span>

namespace veritope {
namespace {

constexpr std::uint64_t kMost = std::uint64_t{1} << 62;

// The two corners of each local edge, so ordered that the edge runs along the axis. The order of
// edges is MFEM's.
constexpr std::array<std::array<int, 2>, 1> kSegmentEdges = {{{0, 1}}};
constexpr std::array<std::array<int, 2>, 4> kSquareEdges = {{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
constexpr std::array<std::array<int, 2>, 12> kCubeEdges = {{{0, 1},
                                                            {1, 2},
                                                            {3, 2},
                                                            {0, 3},
                                                            {4, 5},
                                                            {5, 6},
                                                            {7, 6},
                                                            {4, 7},
                                                            {0, 4},
                                                            {1, 5},
                                                            {2, 6},
                                                            {3, 7}}};
constexpr std::array<std::array<int, 4>, 6> kCubeFaces = {
    {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};

std::span<const std::array<int, 2>> local_edges(int dimension) {
  if (dimension == 1) return kSegmentEdges;
  if (dimension == 2) return kSquareEdges;
  return kCubeEdges;
}
int axis_of_edge(int local) { return local >= 8 ? 2 : local % 2; }

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > kMost / a ? kMost : a * b;
}
std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return std::min(kMost, a + b); }

// The orientation of `test` relative to `base`: 2i if it starts i places later, 2i + 1 if it also
// runs the other way.
int quad_orientation(const std::array<std::uint64_t, 4>& base,
                     const std::array<std::uint64_t, 4>& test) {
  int i = 0;
  while (i < 3 && test[static_cast<std::size_t>(i)] != base[0]) ++i;
  return test[static_cast<std::size_t>(i + 1) % 4] == base[1] ? 2 * i : 2 * i + 1;
}
// Whether `test` is `base`, read as the orientation says.
bool fits(const std::array<std::uint64_t, 4>& base, const std::array<std::uint64_t, 4>& test,
          int orientation) {
  const auto first = static_cast<std::size_t>(orientation / 2);
  for (std::size_t k = 0; k < 4; ++k)
    if (test[(orientation % 2 == 0 ? first + k : first + 4 - k) % 4] != base[k]) return false;
  return true;
}

}  // namespace

MfemNumbering::MfemNumbering(const MfemTopology& topology,
                             const std::vector<std::uint64_t>& num_control)
    : topology_(topology), num_control_(num_control) {
  patches_.resize(topology.patches.size());
  if (!find_edges()) return;
  num_points_ = topology.num_vertices;
  if (topology.dimension > 1)
    for (const MfemTopology::Edge& e : topology.edges) {
      edge_offset_.push_back(num_points_);
      num_points_ = sum(num_points_, num_control[e.knot_vector] - 2);
    }
  if (topology.dimension == 3) number_faces();
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    Patch& patch = patches_[p];
    patch.offset = num_points_;
    std::uint64_t inner = 1, all = 1;
    for (int a = 0; a < topology.dimension; ++a) {
      const std::uint64_t n = num_control[knot_vector(p, a)];
      patch.size[static_cast<std::size_t>(a)] = n;
      inner = product(inner, n - 2);
      all = product(all, n);
    }
    num_points_ = sum(num_points_, inner);
    num_patch_points_ = sum(num_patch_points_, all);
  }
}

bool MfemNumbering::find_edges() {
  for (std::uint64_t e = 0; e < topology_.edges.size(); ++e) {
    const auto [low, high] = std::minmax(topology_.edges[e].from, topology_.edges[e].to);
    if (!edge_of_.emplace(std::pair{low, high}, e).second) {
      fault_ = "the edge " + std::to_string(low) + " " + std::to_string(high) + " is listed twice";
      return false;
    }
  }
  const auto locals = local_edges(topology_.dimension);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto& v = topology_.patches[p];
    for (const auto& [a, b] : locals) {
      const auto [low, high] =
          std::minmax(v[static_cast<std::size_t>(a)], v[static_cast<std::size_t>(b)]);
      const auto found = edge_of_.find({low, high});
      if (found == edge_of_.end() || low == high) {
        fault_ = "patch " + std::to_string(p) + " has an edge " + std::to_string(low) + " " +
                 std::to_string(high) + " that is not among the edges";
        return false;
      }
      patches_[p].edges.push_back(found->second);
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
      const auto again = static_cast<std::ptrdiff_t>(i) + 1;
      if (std::find(v.begin() + again, v.end(), v[i]) == v.end()) continue;
      fault_ = "patch " + std::to_string(p) + " names vertex " + std::to_string(v[i]) + " twice";
      return false;
    }
    for (std::size_t i = 0; i < locals.size(); ++i) {
      const std::uint64_t k = topology_.edges[patches_[p].edges[i]].knot_vector;
      if (k == knot_vector(p, axis_of_edge(static_cast<int>(i)))) continue;
      fault_ = "opposite edges of patch " + std::to_string(p) + " have different knot vectors";
      return false;
    }
  }
  return true;
}

void MfemNumbering::number_faces() {
  std::map<std::array<std::uint64_t, 4>, std::uint64_t> known;
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (std::size_t f = 0; f < 6; ++f) {
      std::array<std::uint64_t, 4> vertices;
      for (std::size_t i = 0; i < 4; ++i)
        vertices[i] = topology_.patches[p][static_cast<std::size_t>(kCubeFaces[f][i])];
      auto key = vertices;
      std::sort(key.begin(), key.end());
      const auto [at, is_new] = known.emplace(key, faces_.size());
      patches_[p].faces[f] = at->second;
      if (!is_new) {
        const int orientation = quad_orientation(faces_[at->second].vertices, vertices);
        patches_[p].orientations[f] = orientation;
        if (!fits(faces_[at->second].vertices, vertices, orientation))
          fault_ = "patch " + std::to_string(p) + " has the vertices of a face in another cycle";
        continue;
      }
      const auto inner = [&](std::size_t a, std::size_t b) {
        const auto [low, high] = std::minmax(vertices[a], vertices[b]);
        return num_control_[topology_.edges[edge_of_.at({low, high})].knot_vector] - 2;
      };
      faces_.push_back({vertices, num_points_});
      num_points_ = sum(num_points_, product(inner(0, 1), inner(1, 2)));
    }
}

std::uint64_t MfemNumbering::knot_vector(std::size_t patch, int axis) const {
  constexpr std::array<std::size_t, 3> kFirst = {0, 1, 8};
  return topology_.edges[patches_[patch].edges[kFirst[static_cast<std::size_t>(axis)]]].knot_vector;
}

std::optional<bool> MfemNumbering::is_reversed(std::size_t patch, int axis) const {
  const auto locals = local_edges(topology_.dimension);
  // With one parameter, MFEM uses only the sign of the edge.
  if (topology_.dimension == 1) {
    const auto& e = topology_.edges[patches_[patch].edges[0]];
    return e.from > e.to;
  }
  std::optional<bool> answer;
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (axis_of_edge(static_cast<int>(i)) != axis) continue;
    const std::uint64_t first = topology_.patches[patch][static_cast<std::size_t>(locals[i][0])];
    const bool is_backwards = topology_.edges[patches_[patch].edges[i]].from != first;
    if (answer && *answer != is_backwards) return std::nullopt;
    answer = is_backwards;
  }
  return answer;
}

// n counts along the axis, not along the edge.
std::uint64_t MfemNumbering::on_edge(const Patch& patch, std::size_t p, int local, std::uint64_t n,
                                     std::uint64_t size) const {
  const auto [a, b] = local_edges(topology_.dimension)[static_cast<std::size_t>(local)];
  const auto& v = topology_.patches[p];
  const bool is_up = v[static_cast<std::size_t>(a)] < v[static_cast<std::size_t>(b)];
  return edge_offset_[patch.edges[static_cast<std::size_t>(local)]] + (is_up ? n : size - 1 - n);
}

std::uint64_t MfemNumbering::on_face(const Patch& patch, int local, std::uint64_t m,
                                     std::uint64_t n, std::uint64_t size_m,
                                     std::uint64_t size_n) const {
  const auto f = static_cast<std::size_t>(local);
  const std::uint64_t offset = faces_[patch.faces[f]].offset, back_m = size_m - 1 - m,
                      back_n = size_n - 1 - n;
  switch (patch.orientations[f]) {
    case 0: return offset + m + n * size_m;
    case 1: return offset + n + m * size_n;
    case 2: return offset + n + back_m * size_n;
    case 3: return offset + back_m + n * size_m;
    case 4: return offset + back_m + back_n * size_m;
    case 5: return offset + back_n + back_m * size_n;
    case 6: return offset + back_n + m * size_n;
    default: return offset + m + back_n * size_m;
  }
}

std::uint64_t MfemNumbering::point(std::size_t p, const std::array<std::uint64_t, 3>& index) const {
  const Patch& patch = patches_[p];
  const auto& v = topology_.patches[p];
  // 0: at the start, 1: within, 2: at the end; `in` counts from 0 within.
  std::array<int, 3> where{};
  std::array<std::uint64_t, 3> in{}, size{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(topology_.dimension); ++a) {
    size[a] = patch.size[a] - 2;
    where[a] = index[a] == 0 ? 0 : index[a] + 1 == patch.size[a] ? 2 : 1;
    in[a] = where[a] == 1 ? index[a] - 1 : 0;
  }
  const auto [i, j, k] = in;
  const auto [I, J, K] = size;
  if (topology_.dimension == 1)
    // MFEM numbers the inner points of a patch with one parameter in reverse: Or1D with orientation 0.
    return where[0] == 0 ? v[0] : where[0] == 2 ? v[1] : patch.offset + (I - 1 - i);
  if (topology_.dimension == 2) switch (3 * where[1] + where[0]) {
      case 0: return v[0];
      case 1: return on_edge(patch, p, 0, i, I);
      case 2: return v[1];
      case 3: return on_edge(patch, p, 3, j, J);
      case 4: return patch.offset + i + j * I;
      case 5: return on_edge(patch, p, 1, j, J);
      case 6: return v[3];
      case 7: return on_edge(patch, p, 2, i, I);
      default: return v[2];
    }
  switch (9 * where[2] + 3 * where[1] + where[0]) {
    case 0: return v[0];
    case 1: return on_edge(patch, p, 0, i, I);
    case 2: return v[1];
    case 3: return on_edge(patch, p, 3, j, J);
    case 4: return on_face(patch, 0, i, J - 1 - j, I, J);
    case 5: return on_edge(patch, p, 1, j, J);
    case 6: return v[3];
    case 7: return on_edge(patch, p, 2, i, I);
    case 8: return v[2];
    case 9: return on_edge(patch, p, 8, k, K);
    case 10: return on_face(patch, 1, i, k, I, K);
    case 11: return on_edge(patch, p, 9, k, K);
    case 12: return on_face(patch, 4, J - 1 - j, k, J, K);
    case 13: return patch.offset + I * (J * k + j) + i;
    case 14: return on_face(patch, 2, j, k, J, K);
    case 15: return on_edge(patch, p, 11, k, K);
    case 16: return on_face(patch, 3, I - 1 - i, k, I, K);
    case 17: return on_edge(patch, p, 10, k, K);
    case 18: return v[4];
    case 19: return on_edge(patch, p, 4, i, I);
    case 20: return v[5];
    case 21: return on_edge(patch, p, 7, j, J);
    case 22: return on_face(patch, 5, i, j, I, J);
    case 23: return on_edge(patch, p, 5, j, J);
    case 24: return v[7];
    case 25: return on_edge(patch, p, 6, i, I);
    default: return v[6];
  }
}

}  // namespace veritope
