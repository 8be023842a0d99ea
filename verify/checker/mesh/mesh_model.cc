// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_model.cc: from the file to shells, neighbours and boxes: everything that needs no exact
// arithmetic.
#include <algorithm>
#include <array>

#include "geometry.h"

namespace {

// Makes vertices with equal positions one vertex; its id is the rank of their first occurrence.
void merge(Model* model) {
  std::vector<std::array<int64_t, 4>> places(model->vertices());
  for (size_t v = 0; v < places.size(); ++v) {
    std::copy_n(&model->key[3 * v], 3, &places[v][0]);
    places[v][3] = int64_t(v);
  }
  std::sort(places.begin(), places.end());  // a hash table could be attacked
  std::vector<uint32_t> id(places.size());  // the first vertex at the place; then the new id
  for (size_t i = 0, first = 0; i < places.size(); ++i) {
    if (!std::equal(&places[i][0], &places[i][3], &places[first][0])) first = i;
    id[size_t(places[i][3])] = uint32_t(places[first][3]);
  }
  uint32_t n = 0;
  for (uint32_t v = 0; v < id.size(); ++v) {
    if (id[v] == v) std::copy_n(&model->key[3 * size_t(v)], 3, &model->key[3 * size_t(n)]);
    id[v] = id[v] == v ? n++ : id[id[v]];
  }
  model->key.resize(3 * size_t(n));
  for (uint32_t& v : model->tri) v = id[v];
}

}  // namespace

Model read_model(std::string file, const std::string& format, bool as_indexed) {
  if (file.empty()) throw Refused{"byte 0: the file is empty"};
  for (const char* magic : {"\xff\xfe", "\xfe\xff", "\x1f\x8b", "PK\3\4", "PK\5\6", "BZh", "\xfd\x37zXZ",
                            "\x28\xb5\x2f\xfd", "version https://git-lfs"})
    if (file.compare(0, std::string(magic).size(), magic) == 0)
      throw Refused{"byte 0: compressed, UTF-16 or UTF-32 text, or a git-lfs pointer"};
  if (file.compare(0, 4, "\0\0\xfe\xff", 4) == 0) throw Refused{"byte 0: UTF-32 text"};
  Model model = read_triangles(std::move(file), format);
  if (!as_indexed || format == "stl") merge(&model);
  return model;
}

Lattice::Lattice(const Model& model) : low(1 << 12), bits(0) {
  for (uint32_t v : model.tri)
    for (int i = 0; i < 3; ++i) add(model.key[3 * size_t(v) + i]);
}
void Lattice::add(int64_t key) {
  if (key == 0) return;
  const int high = std::max(bits == 0 ? 0 : low + bits,
                            key_exponent(key) + bit_length(key_mantissa(key)));
  low = std::min(low, key_exponent(key) + __builtin_ctzll(key_mantissa(key)));
  bits = high - low;
}

namespace {

// Classes of triangles: each has a link to a smaller one of its class, or to itself.
uint32_t least(std::vector<uint32_t>* link, uint32_t f) {
  while ((*link)[f] != f) f = (*link)[f] = (*link)[(*link)[f]];
  return f;
}

}  // namespace

Surface::Surface(const Model& model)
    : shell(model.faces()), twin(model.tri.size()), first(model.vertices(), kNone) {
  const std::vector<uint32_t>& from = model.tri;
  std::vector<std::pair<uint64_t, uint32_t>> sorted;  // (lesser id, greater id), edge
  for (uint32_t e = 0; e < from.size(); ++e) {
    const uint64_t a = from[e], b = from[e % 3 == 2 ? e - 2 : e + 1];
    sorted.emplace_back(std::min(a, b) << 32 | std::max(a, b), e);
    shell[e / 3] = e / 3;
  }
  std::sort(sorted.begin(), sorted.end());
  for (size_t i = 0, j = 0; i < sorted.size(); i = j, ++edges) {
    const uint32_t e = sorted[i].second;
    for (j = i; j < sorted.size() && sorted[j].first == sorted[i].first; ++j) {
      const uint32_t f = least(&shell, e / 3), g = least(&shell, sorted[j].second / 3);
      shell[std::max(f, g)] = std::min(f, g);
    }
    const uint32_t other = sorted[j - 1].second;
    if (j - i == 2 && from[e] != from[other]) {
      twin[e] = other;
      twin[other] = e;
    } else {
      bad[0] = from[e];
    }
  }
  // Shells are numbered by their least triangles.
  for (uint32_t f = 0; f < shell.size(); ++f) shell[f] = shell[f] == f ? shells++ : shell[shell[f]];

  std::vector<bool> seen(from.size());
  for (uint32_t e = 0; e < from.size() && bad[0] == kNone; ++e) {
    if (seen[e]) continue;
    if (around(around(e)) == e) bad[1] = from[e];   // (v, p, q) and (v, q, p)
    if (first[from[e]] != kNone) bad[2] = from[e];  // a second cycle
    first[from[e]] = e;
    ++vertices;
    for (uint32_t k = e; !seen[k]; k = around(k)) seen[k] = true;
  }
}

Tree::Tree(const Model& model, const std::vector<uint32_t>& by_position,
           const std::vector<uint8_t>& star)
    : order(by_position), nodes(2 * by_position.size() - 1) {
  for (uint32_t f : order)
    for (int i = 0; i < 3; ++i) corners.push_back(model.tri[3 * size_t(f) + i]);
  build(root(), model, star);
}

void Tree::build(const Range& r, const Model& model, const std::vector<uint8_t>& star) {
  TreeNode& n = nodes[r.node];
  std::fill(n.common, n.common + 3, kNone);
  int found = 0;
  if (r.size() == 1) {
    for (int i = 0; i < 3; ++i) {
      const uint32_t v = corners[3 * size_t(r.lo) + i];
      const int64_t* const key = &model.key[3 * size_t(v)];
      if (star[v] != 0) n.common[found++] = v;
      for (int k = 0; k < 3; ++k) {
        n.min[k] = i == 0 ? key[k] : std::min(n.min[k], key[k]);
        n.max[k] = i == 0 ? key[k] : std::max(n.max[k], key[k]);
      }
    }
    return;
  }
  build(r.left(), model, star);
  build(r.right(), model, star);
  const TreeNode &a = nodes[r.left().node], &b = nodes[r.right().node];
  for (int k = 0; k < 3; ++k) {
    n.min[k] = std::min(a.min[k], b.min[k]);
    n.max[k] = std::max(a.max[k], b.max[k]);
    if (b.has(a.common[k])) n.common[found++] = a.common[k];
  }
}
