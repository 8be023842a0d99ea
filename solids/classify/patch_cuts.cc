// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_cuts.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace veritope {
namespace {

struct BySizeOfBox {
  bool operator()(const PatchPiece& a, const PatchPiece& b) const {
    return extent(a.box()) < extent(b.box());
  }
};

}  // namespace

std::vector<PatchPiece> pieces_of(const PatchComplex& complex, std::size_t about) {
  std::vector<PatchPiece> heap;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    heap.emplace_back(complex.patch(p), p);
  std::make_heap(heap.begin(), heap.end(), BySizeOfBox());
  while (!heap.empty() && heap.size() < about && heap.front().can_halve()) {
    std::pop_heap(heap.begin(), heap.end(), BySizeOfBox());
    auto [low, high] = heap.back().halves(heap.back().longer_axis());
    heap.back() = std::move(low);
    std::push_heap(heap.begin(), heap.end(), BySizeOfBox());
    heap.push_back(std::move(high));
    std::push_heap(heap.begin(), heap.end(), BySizeOfBox());
  }
  return heap;
}

}  // namespace veritope
