// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_slices.cc: R3 and R4 of docs/certificates/microstructure.md for the boxes of slices.
#include "micro_bridges.h"

namespace {

const uint64_t kNoCell = ~uint64_t(0);

// The intervals [b_i, b_(i+1)] that have a common point with [lo, hi]: first <= i < last.
void find_intervals(const std::vector<Ratio>& b, const Ratio& lo, const Ratio& hi, size_t* first,
                    size_t* last) {
  const auto less = [](const Ratio& x, const Ratio& y) { return compare(x, y) < 0; };
  const size_t not_below = size_t(std::lower_bound(b.begin(), b.end(), lo, less) - b.begin());
  const size_t above = size_t(std::upper_bound(b.begin(), b.end(), hi, less) - b.begin());
  *first = not_below == 0 ? 0 : not_below - 1;
  *last = std::min(above, b.size() - 1);
}

}  // namespace

// With s = a / c and t = b / d, the coefficients in [s, t] are the polar forms at (s, s), (s, t) and (t, t); the one at
// (x, y) is (1 - x)(1 - y) L0 + ((1 - x) y + x (1 - y)) L1 + x y L2.
RatioBox box_of_slice(const MicroBridge& bridge, size_t slice) {
  const Ratio* const ends = &bridge.cut[slice];
  RatioBox r;
  for (size_t form = 0; form < 3; ++form) {
    const Ratio &x = ends[form == 2], &y = ends[form != 0];
    const Big x1 = x.d - x.n, y1 = y.d - y.n;
    const Big factor[3] = {x1 * y1, x1 * y.n + x.n * y1, x.n * y.n};
    Big least[3], most[3];
    for (size_t i = 0; i < bridge.net.size(); i += 9)
      for (size_t k = 0; k < 3; ++k) {
        Big sum;
        for (size_t list = 0; list < 3; ++list)
          if (factor[list].sign() != 0) sum = sum + factor[list] * bridge.net[i + 3 * list + k];
        if (i == 0 || sum < least[k]) least[k] = sum;
        if (i == 0 || most[k] < sum) most[k] = sum;
      }
    for (size_t k = 0; k < 3; ++k) {
      const Ratio lo(least[k], bridge.scale * x.d * y.d), hi(most[k], lo.d);
      if (form == 0 || compare(lo, r.lo[k]) < 0) r.lo[k] = lo;
      if (form == 0 || compare(r.hi[k], hi) < 0) r.hi[k] = hi;
    }
  }
  return r;
}

Slices::Slices(const MicroFile& file)
    : file_(file),
      most_pairs_((uint64_t(1) << 26) + 1024 * file.bridges.size()),
      most_slices_((uint64_t(1) << 20) + 64 * file.bridges.size()) {}

void Slices::check_cells(const MicroBridge& b, const OtherSide& other) {
  const uint32_t number = uint32_t(&b - file_.bridges.data());
  for (uint32_t j = 0; j + 1 < b.cut.size(); ++j) {
    require(slices_.size() < most_slices_, "R3", "this checker has a limit of slices");
    const RatioBox box = box_of_slice(b, j);
    slices_.push_back(Slice{number, j});
    boxes_.push_back(outer(box));
    for (size_t g = first_grid_of(file_, b.volume);
         g < file_.grids.size() && file_.grids[g].volume == b.volume; ++g)
      check_grid(file_.grids[g], box, g == b.grid && j == 0 && !other.is_face ? b.cell : kNoCell,
                 number);
  }
}
void Slices::check_grid(const MicroGrid& g, const RatioBox& box, uint64_t own, uint64_t bridge) {
  size_t first[3], last[3], i[3];
  for (size_t k = 0; k < 3; ++k) {
    find_intervals(g.breaks[k], box.lo[k], box.hi[k], &first[k], &last[k]);
    if (first[k] >= last[k]) return;
  }
  for (i[0] = first[0]; i[0] < last[0]; ++i[0])
    for (i[1] = first[1]; i[1] < last[1]; ++i[1]) {
      add_pairs(last[2] - first[2], "R3");
      for (i[2] = first[2]; i[2] < last[2]; ++i[2])
        require(g.tile[g.cell(i)] == 0 || g.cell(i) == own, "R3",
                "a slice may meet a cell that holds a tile, of bridge", bridge);
    }
}

void Slices::check_pairs() {
  std::map<uint64_t, std::vector<uint32_t>> by_volume;
  for (uint32_t s = 0; s < slices_.size(); ++s)
    by_volume[file_.bridges[slices_[s].bridge].volume].push_back(s);
  for (const auto& of : by_volume) {
    std::vector<DoubleBox> boxes;
    for (uint32_t s : of.second) boxes.push_back(boxes_[s]);
    const BoxTree tree(boxes);
    for (uint32_t i = 0; i < boxes.size(); ++i)
      tree.each(boxes[i], [&](uint32_t j) {
        const Slice &s = slices_[of.second[i]], &t = slices_[of.second[j]];
        if (j <= i || s.bridge == t.bridge) return true;
        add_pairs(1, "R4");
        require(!meet(box_of_slice(file_.bridges[s.bridge], s.number),
                      box_of_slice(file_.bridges[t.bridge], t.number)),
                "R4", "slices of two bridges meet, of bridge", s.bridge);
        return true;
      });
  }
}
