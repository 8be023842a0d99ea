// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_glue.cc: P1 of docs/certificates/star-box.md: paired sides, and the numbers of X.
#include "star_curve.h"

namespace {

uint32_t find(std::vector<uint32_t>* parent, uint32_t i) {
  while ((*parent)[i] != i) i = (*parent)[i] = (*parent)[(*parent)[i]];
  return i;
}
void unite(std::vector<uint32_t>* parent, uint32_t i, uint32_t j) {
  i = find(parent, i), j = find(parent, j);
  (*parent)[std::max(i, j)] = std::min(i, j);
}
// Corner i of a tensor patch is where its side i starts if the patch is not reversed; of a triangle, its corner i.
uint32_t end_of(const Patch& p, int e, bool last) {  // in the direction of travel
  const int n = p.shape.sides(), first = p.shape.is_triangle ? e + 1 : e;
  return uint32_t((first + (last != p.is_reversed)) % n);
}

typedef std::pair<std::string, uint32_t> Entry;  // a side 4 patch + e, by its curve

// The sides that are more than a point, sorted by their curves and by their curves passed backwards.
// Sides that are a point must not lie inside of an entity's domain.
void list_sides(std::vector<Patch>* patches, const char* id, std::vector<Entry>* forward,
                std::vector<Entry>* backward) {
  for (uint32_t i = 0; i < patches->size(); ++i) {
    Patch& p = (*patches)[i];
    std::fill(p.pair, p.pair + 4, kNoPair);
    for (int e = 0; e < p.shape.sides(); ++e) {
      const Curve c = side_curve(p, e, p.is_reversed);
      if (is_point(c)) {
        require(p.is_outer[e], id, "a side inside of an entity is collapsed, of patch", i);
        continue;
      }
      const Curve key = canonical(c);
      forward->push_back(Entry(text(key, false), 4 * i + uint32_t(e)));
      backward->push_back(Entry(text(key, true), 4 * i + uint32_t(e)));
    }
  }
  std::sort(forward->begin(), forward->end());
  std::sort(backward->begin(), backward->end());
}

std::vector<uint32_t> singletons(size_t count) {
  std::vector<uint32_t> parent(count);
  for (uint32_t i = 0; i < count; ++i) parent[i] = i;
  return parent;
}

// The ends of a collapsed side are one corner.
void unite_collapsed(const std::vector<Patch>& patches, std::vector<uint32_t>* corner) {
  for (uint32_t i = 0; i < patches.size(); ++i)
    for (int e = 0; e < patches[i].shape.sides(); ++e)
      if (patches[i].is_collapsed(e))
        unite(corner, 4 * i + end_of(patches[i], e, false), 4 * i + end_of(patches[i], e, true));
}

}  // namespace

Gluing::Gluing(std::vector<Patch>* patches, const char* id) {
  require(patches->size() < kNoPair / 4, "B2", "over a limit of this checker: 2^30 patches");
  std::vector<Entry> forward, backward;
  list_sides(patches, id, &forward, &backward);
  std::vector<uint32_t> corner = singletons(4 * patches->size()),
                        whole = singletons(patches->size());
  for (size_t i = 0; i < forward.size(); ++i) {
    const uint32_t a = forward[i].second, b = backward[i].second;
    require(i == 0 || forward[i - 1].first != forward[i].first, id,
            "two sides are the same curve, one of patch", a / 4);
    require(forward[i].first == backward[i].first, id,
            "a side has no opposite; it or another is of patch", a / 4);
    require(a != b, id, "a side is its own opposite, of patch", a / 4);
    Patch &p = (*patches)[a / 4], &q = (*patches)[b / 4];
    p.pair[a % 4] = std::min(a, b);  // numbered by its first side
    p.is_second[a % 4] = a > b;
    edges += a < b;
    unite(&whole, a / 4, b / 4);
    for (int last = 0; last < 2; ++last)
      unite(&corner, a / 4 * 4 + end_of(p, int(a % 4), last != 0),
            b / 4 * 4 + end_of(q, int(b % 4), last == 0));
  }
  unite_collapsed(*patches, &corner);

  chi.resize(patches->size());
  std::vector<uint32_t> number(patches->size());
  for (uint32_t i = 0; i < patches->size(); ++i) {
    Patch& p = (*patches)[i];
    const uint32_t c = find(&whole, i);
    p.component = number[i] = c == i ? components++ : number[c];
    ++chi[p.component];
    for (int e = 0; e < p.shape.sides(); ++e) {
      const uint32_t at = 4 * i + uint32_t(e);
      p.vertex[e] = find(&corner, at);
      vertices += p.vertex[e] == at;
      chi[p.component] += int(p.vertex[e] == at) - int(p.pair[e] == at);
    }
  }
  for (uint32_t i = 0; i < components; ++i) {
    require(chi[i] % 2 == 0 && chi[i] <= 2, id, "chi is odd or over 2, of component", i);
    genus += uint64_t(1 - chi[i] / 2);
  }
  chi.resize(components);
}
