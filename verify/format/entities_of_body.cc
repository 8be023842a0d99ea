// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/entities_of_body_internal.h"

#include <algorithm>

namespace veritope::certificate::internal {
namespace {

// A surface's breaks along one axis; the number of intervals between them.
std::uint64_t skip_breaks(ByteReader& r) {
  const std::uint32_t n = r.count(2);
  for (std::uint32_t i = 0; i < n && r.ok(); ++i) {
    r.zigzag();
    if (r.varint() != 0) continue;
    for (int part = 0; part < 2; ++part) {
      const std::uint64_t size = r.varint();
      size <= r.left() ? (void)r.raw(size) : r.fail();
    }
  }
  if (n < 2) r.fail();
  return n < 2 ? 0 : n - 1;
}

}  // namespace

std::vector<AfterEntities> guess_surfaces_of_version_1(ByteReader body, std::uint64_t patches) {
  AfterEntities h{0, body};
  const std::uint32_t entities = h.rest.count(1);
  h.rest.raw(entities);
  std::uint64_t found = entities;
  std::vector<AfterEntities> all;
  while (h.rest.ok()) {
    if (found == patches) all.push_back(h);
    if (h.surfaces == entities) break;
    const std::uint64_t u = skip_breaks(h.rest), v = skip_breaks(h.rest);
    ++h.surfaces;
    if (u == 0 || v > (std::uint64_t{1} << 40) / u) break;
    found += u * v - 1;
  }
  std::reverse(all.begin(), all.end());
  if (all.size() > kMostGuesses) all.erase(all.begin() + kMostGuesses, all.end());
  return all;
}

std::uint64_t num_patches(const std::vector<PatchEntity>& entities) {
  std::uint64_t n = 0;
  for (const PatchEntity& e : entities)
    n += e.is_other     ? 0
         : e.is_surface ? std::uint64_t{e.breaks[0].size() - 1} * (e.breaks[1].size() - 1)
                        : 1;
  return n;
}

}  // namespace veritope::certificate::internal
