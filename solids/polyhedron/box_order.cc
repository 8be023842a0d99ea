// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/box_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "robust/base/parallel.h"
#include "robust/binary64.h"
#include "solids/base/range_tree.h"
#include "solids/polyhedron/chunk_internal.h"

namespace veritope {
namespace {

constexpr unsigned kBits =
    11;  // of a coordinate, and of a radix pass: three passes sort the 33-bit code
constexpr std::size_t kRadix = std::size_t{1} << kBits;
constexpr unsigned kIndexBits = 31;
using internal::kChunk;

// The low 11 bits of v, two zeros between neighbours.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 16) & 0xff0000ffu;
  v = (v | v << 8) & 0x0f00f00fu;
  v = (v | v << 4) & 0xc30c30c3u;
  return (v | v << 2) & 0x249249249u;
}

std::uint64_t cell(float unit) {
  return static_cast<std::uint64_t>(
      std::min(unit * static_cast<float>(kRadix), static_cast<float>(kRadix - 1)));
}

std::uint64_t morton_code(const TriangleMesh& mesh, std::uint32_t facet, const UnitScale& scale) {
  const auto& t = mesh.faces[facet];
  const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  const auto centre = [](float p, float q, float r) {
    return 0.5f * (std::min({p, q, r}) + std::max({p, q, r}));
  };
  return spread(cell(centre(scale.x(a.x), scale.x(b.x), scale.x(c.x)))) << 2 |
         spread(cell(centre(scale.y(a.y), scale.y(b.y), scale.y(c.y)))) << 1 |
         spread(cell(centre(scale.z(a.z), scale.z(b.z), scale.z(c.z))));
}

// One stable pass of a least-significant-digit radix sort; each block of keys counts and places on its own.
void radix_pass(const std::uint64_t* from, std::uint64_t* to, std::size_t n, unsigned shift,
                std::size_t blocks, unsigned jobs) {
  std::vector<std::array<std::uint32_t, kRadix>> counts(blocks);
  const auto cut = [&](std::size_t j) { return n * j / blocks; };
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    counts[j].fill(0);
    for (std::size_t i = cut(j); i < cut(j + 1); ++i) ++counts[j][from[i] >> shift & (kRadix - 1)];
  });
  std::uint32_t sum = 0;
  for (std::size_t digit = 0; digit < kRadix; ++digit)
    for (auto& c : counts) {
      const std::uint32_t k = c[digit];
      c[digit] = sum;
      sum += k;
    }
  parallel_for(blocks, 1, jobs, [&](std::size_t j, std::size_t, std::size_t) {
    for (std::size_t i = cut(j); i < cut(j + 1); ++i)
      to[counts[j][from[i] >> shift & (kRadix - 1)]++] = from[i];
  });
}

// In doubles: parts of a model that are far from each other must not become points.
struct Centre {
  Point3d at;
  std::uint32_t number;  // of the facet, or of the vertex that is the apex of a fan
  std::uint32_t group = 0;
};

// Items of several groups: moves those of lower groups before `mid`, those of higher ones after it, and narrows
// [begin, end) to those of the group that `mid` cuts.
void split_groups(std::vector<Centre>& items, std::size_t& begin, std::size_t mid,
                  std::size_t& end) {
  const auto it = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(it(begin), it(mid), it(end),
                   [](const Centre& a, const Centre& b) { return a.group < b.group; });
  const std::uint32_t group = items[mid].group;
  const auto first =
      std::partition(it(begin), it(mid), [group](const Centre& c) { return c.group < group; });
  const auto last =
      std::partition(it(mid), it(end), [group](const Centre& c) { return c.group <= group; });
  begin = static_cast<std::size_t>(first - items.begin());
  end = static_cast<std::size_t>(last - items.begin());
}

// Halves [begin, end) as the certificate's tree does, floor(n / 2) positions to the left: between groups; inside a
// group at the median along the longest side of the centres' box. The result does not depend on the order of the items.
// Returns the middle.
std::size_t halve(std::vector<Centre>& items, std::size_t begin, std::size_t end) {
  const std::size_t mid = begin + (end - begin) / 2;
  if (std::any_of(items.begin() + static_cast<std::ptrdiff_t>(begin),
                  items.begin() + static_cast<std::ptrdiff_t>(end),
                  [g = items[begin].group](const Centre& c) { return c.group != g; })) {
    split_groups(items, begin, mid, end);
  }
  split_at_median(std::span(items).subspan(begin, end - begin), mid - begin);
  return mid;
}

void arrange(std::vector<Centre>& items, std::size_t begin, std::size_t end) {
  if (end - begin < 2) return;
  const std::size_t mid = halve(items, begin, end);
  arrange(items, begin, mid);
  arrange(items, mid, end);
}

// The first levels one by one, all ranges of a level at once; then each range on its own.
void arrange_all(std::vector<Centre>& items, unsigned jobs) {
  std::vector<std::size_t> cuts{0, items.size()};
  for (int level = 0; level < 6 && items.size() >= kChunk; ++level) {
    std::vector<std::size_t> finer(2 * cuts.size() - 1);
    parallel_for(cuts.size() - 1, 1, jobs, [&](std::size_t i, std::size_t, std::size_t) {
      finer[2 * i] = cuts[i];
      finer[2 * i + 1] = halve(items, cuts[i], cuts[i + 1]);
    });
    finer.back() = cuts.back();
    cuts = std::move(finer);
  }
  parallel_for(cuts.size() - 1, 1, jobs, [&](std::size_t i, std::size_t, std::size_t) {
    arrange(items, cuts[i], cuts[i + 1]);
  });
}

Centre centre_of(const TriangleMesh& mesh, std::uint32_t facet) {
  const auto& t = mesh.faces[facet];
  Centre c;
  c.number = facet;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t j) { return mesh.positions[t[j]][static_cast<int>(k)]; };
    c.at[k] = at(0) + at(1) + at(2);
    if (!is_finite(c.at[k])) c.at[k] = at(0) / 4 + at(1) / 4 + at(2) / 4;
  }
  return c;
}

// Large fans become groups of their own, numbered from 1 as their apexes lie in space: facets of a fan need no test,
// and the fan of one side of a thin plate is apart from that of the other side, which no halves of both would be.
void group_fans(const TriangleMesh& mesh, std::vector<Centre>& items, unsigned jobs) {
  constexpr std::uint32_t kLarge = 64;  // facets
  std::vector<std::uint32_t> degree(mesh.positions.size());
  for (const Centre& c : items)
    for (const std::uint32_t v : mesh.faces[c.number]) ++degree[v];
  const auto apex_of = [&](std::uint32_t facet) {
    const auto& t = mesh.faces[facet];
    return *std::max_element(t.begin(), t.end(), [&](std::uint32_t a, std::uint32_t b) {
      return degree[a] != degree[b] ? degree[a] < degree[b] : a > b;
    });
  };
  std::vector<Centre> apexes;
  for (std::uint32_t v = 0; v < degree.size(); ++v) {
    const Vec3d& p = mesh.positions[v];
    if (degree[v] >= kLarge) apexes.push_back({{p.x, p.y, p.z}, v});
  }
  if (apexes.empty()) return;
  arrange(apexes, 0, apexes.size());
  std::vector<std::uint32_t> group(degree.size());
  for (std::size_t i = 0; i < apexes.size(); ++i)
    group[apexes[i].number] = static_cast<std::uint32_t>(i + 1);
  parallel_for(items.size(), kChunk, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) items[i].group = group[apex_of(items[i].number)];
  });
}

Box3d hull_of(const std::vector<Box3d>& boxes) {
  Box3d out = empty_box();
  for (const Box3d& box : boxes) out = hull(out, box);
  return out;
}

}  // namespace

Box3d bounding_box(std::span<const Vec3d> points, unsigned jobs) {
  std::vector<Box3d> parts(num_chunks(points.size(), kChunk));
  parallel_for(points.size(), kChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 Box3d box = empty_box();
                 for (std::size_t i = begin; i < end; ++i) add(to_point(points[i]), &box);
                 parts[chunk] = box;
               });
  return hull_of(parts);
}

Box3d bounding_box_of_faces(const TriangleMesh& mesh, unsigned jobs) {
  std::vector<Box3d> parts(num_chunks(mesh.faces.size(), kChunk));
  parallel_for(mesh.faces.size(), kChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 Box3d box = empty_box();
                 for (std::size_t f = begin; f < end; ++f)
                   for (std::uint32_t v : mesh.faces[f]) add(to_point(mesh.positions[v]), &box);
                 parts[chunk] = box;
               });
  return hull_of(parts);
}

UnitScale::UnitScale(const Box3d& box) {
  const auto& [lo, hi] = box;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max({largest, std::abs(lo[k]), std::abs(hi[k])});
  if (largest > 0x1p1000) pre_ = 0x1p-60;
  if (largest < 0x1p-900) pre_ = 0x1p120;
  double range = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    low_[k] = lo[k] * pre_;
    range = std::max(range, hi[k] * pre_ - low_[k]);
  }
  if (range > 0) scale_ = exp2_int(std::clamp(-std::ilogb(range) - 1, -1022, 1023));
}

std::vector<std::uint32_t> morton_order(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& facets,
                                        const UnitScale& scale, unsigned jobs) {
  const std::size_t n = facets.size();
  const std::size_t blocks = jobs == 0 ? 1 : jobs;
  auto keys = std::make_unique_for_overwrite<std::uint64_t[]>(n);
  auto other = std::make_unique_for_overwrite<std::uint64_t[]>(n);
  parallel_for(n, kChunk, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      keys[i] = morton_code(mesh, facets[i], scale) << kIndexBits | facets[i];
  });
  for (unsigned pass = 0; pass < 3; ++pass) {
    radix_pass(keys.get(), other.get(), n, kIndexBits + kBits * pass, blocks, jobs);
    keys.swap(other);
  }
  std::vector<std::uint32_t> order(n);
  parallel_for(n, kChunk, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      order[i] = static_cast<std::uint32_t>(keys[i] & ((std::uint64_t{1} << kIndexBits) - 1));
  });
  return order;
}

std::vector<std::uint32_t> median_order(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& facets, unsigned jobs) {
  std::vector<Centre> items(facets.size());
  parallel_for(facets.size(), kChunk, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) items[i] = centre_of(mesh, facets[i]);
  });
  group_fans(mesh, items, jobs);
  arrange_all(items, jobs);
  std::vector<std::uint32_t> order;
  order.reserve(items.size());
  for (const Centre& c : items) order.push_back(c.number);
  return order;
}

}  // namespace veritope
