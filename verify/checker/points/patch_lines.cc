// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "patch_lines.h"

namespace {

const uint64_t kMostOfPoint = 1 << 22, kFree = 1 << 25, kOfByte = 96, kOfPoint = 1 << 12;

typedef std::vector<Big> Row;
bool all_of(const Row& row, int least, int most) {  // whether all signs are between these
  for (const Big& v : row)
    if (v.sign() < least || v.sign() > most) return false;
  return true;
}
void halve(const Row& c, Row* lower, Row* upper) {  // times 2^(size - 1)
  const size_t n = c.size();
  Row v = c;
  lower->resize(n), upper->resize(n);
  for (size_t s = 0; s < n; ++s) {
    (*lower)[s] = shifted(v[0], int64_t(n - 1 - s));
    (*upper)[n - 1 - s] = shifted(v[n - 1 - s], int64_t(n - 1 - s));
    for (size_t m = 0; m + 1 < n - s; ++m) v[m] = v[m] + v[m + 1];
  }
}

Mark from_end(const Mark& t) { return Mark(shifted(Big(1), t.k) - t.n, t.k); }

}  // namespace

PointUnits::PointUnits(uint64_t bytes, uint64_t points)
    : limit(kFree + kOfByte * bytes + kOfPoint * points) {}
void PointUnits::add(uint64_t units) {
  done += units;
  done_on_point += units;
  require(done <= limit, "B1", "more work than allowed, units", limit);
  require(done_on_point <= kMostOfPoint, "B1", "more work than allowed on a point, units",
          kMostOfPoint);
}

void SidesAhead::add(const Rectangle& at) {
  const Grid& grid = nets_.grids()[at.patch];
  for (int side = 0; side < 4; ++side) {
    const int along = side % 2;
    const bool rises = side < 2;
    Interval r = {0, Mark(), at.lo[along], at.hi[along], rises ? 1 : -1};
    if (!at.is_on_border(side)) {
      r.line = (uint64_t(at.patch) << 1 | uint64_t(along)) << 1 | 1;
      r.place = side == 0 ? at.lo[1] : side == 1 ? at.hi[0] : side == 2 ? at.hi[1] : at.lo[0];
    } else if (!grid.is_collapsed(side)) {
      r.line = uint64_t(grid.pair[side]) << 1;
      r.sign = grid.is_second[side] ? -1 : 1;
      if (rises == grid.is_second[side]) {  // its parameter falls where that of the pair rises
        r.lo = from_end(at.hi[along]);
        r.hi = from_end(at.lo[along]);
      }
    } else {
      continue;
    }
    intervals_.push_back(std::move(r));
  }
}

bool SidesAhead::sum(int64_t* result) {
  std::sort(intervals_.begin(), intervals_.end(), before);
  *result = 0;
  for (size_t first = 0, last = 0; first < intervals_.size(); first = last) {
    while (last < intervals_.size() && intervals_[last].is_on_line_of(intervals_[first])) ++last;
    *result += number_of_line(first, last);
  }
  return !is_left_over_;
}

int64_t SidesAhead::number_of_line(size_t first, size_t last) {
  typedef std::pair<Mark, int> End;
  std::vector<End> ends;
  for (size_t i = first; i < last; ++i) {
    ends.push_back(End(intervals_[i].lo, intervals_[i].sign));
    ends.push_back(End(intervals_[i].hi, -intervals_[i].sign));
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.first < b.first; });
  int64_t surplus = 0, sum = 0;
  Curve whole;
  for (size_t i = 0, next = 0; i < ends.size(); i = next) {
    for (; next < ends.size() && ends[next].first == ends[i].first; ++next)
      surplus += ends[next].second;
    if (surplus == 0) continue;  // true at the last end
    if (whole.x.empty()) whole = curve_of(intervals_[first]);
    sum += surplus * crossing_number(whole, ends[i].first, ends[next].first);
  }
  return sum;
}

void SidesAhead::add_point(uint32_t patch, int at, Curve* to) {
  const std::vector<Big>& net = nets_.of(patch);
  to->x.push_back(net[size_t(3 * at + (axis_ + 1) % 3)]);
  to->y.push_back(net[size_t(3 * at + (axis_ + 2) % 3)]);
}

SidesAhead::Curve SidesAhead::curve_of(const Interval& on) {
  Curve r;
  if (on.line % 2 == 0) {
    const uint32_t patch = uint32_t(on.line >> 1) / 4, e = uint32_t(on.line >> 1) % 4;
    const Grid& grid = nets_.grids()[patch];
    const int side = int(grid.is_triangle ? (e + 1) % 3 : e);
    for (int i = 0; i <= grid.shape.side_degree(side); ++i)
      add_point(patch, grid.shape.on_side(side, i), &r);
    r.bits = uint64_t(grid.bits + nets_.bits_of_point());
    return r;
  }
  const uint32_t patch = uint32_t(on.line >> 2);
  const int along = int(on.line >> 1 & 1), across = 1 - along;
  const Grid& grid = nets_.grids()[patch];
  const Big one = shifted(Big(1), on.place.k);
  for (int i = 0; i <= grid.degree(along); ++i) {
    Curve row;
    for (int j = 0; j <= grid.degree(across); ++j)
      add_point(patch, along == 0 ? grid.shape.at(i, j) : grid.shape.at(j, i), &row);
    r.x.push_back(value_at(std::move(row.x), on.place.n, one));
    r.y.push_back(value_at(std::move(row.y), on.place.n, one));
  }
  r.bits = uint64_t(grid.bits + nets_.bits_of_point() + grid.degree(across) * on.place.k);
  return r;
}

int64_t SidesAhead::crossing_number(const Curve& whole, const Mark& begin, const Mark& end) {
  struct Part {
    Row x, y;
    Mark lo, hi;
    int64_t halvings;
  };
  const uint64_t size = whole.x.size();
  std::vector<Part> todo(1);
  todo[0].x = on_part(whole.x, begin, end);
  todo[0].y = on_part(whole.y, begin, end);
  todo[0].lo = begin, todo[0].hi = end, todo[0].halvings = 0;
  int64_t sum = 0;
  while (!todo.empty()) {
    const Part part = std::move(todo.back());
    todo.pop_back();
    const Row &x = part.x, &y = part.y;
    const uint64_t h = whole.bits + (size - 1) * uint64_t(std::max(part.lo.k, part.hi.k));
    units_.add(8 + (size * size * h >> 11));
    if (all_of(y, 0, 1) || all_of(y, -1, -1) || all_of(x, -1, 0)) continue;
    if (all_of(x, 0, 1)) {
      sum += int(y.back().sign() >= 0) - int(y[0].sign() >= 0);
      continue;
    }
    if (part.halvings == kMostHalvingsOnRay) {
      is_left_over_ = true;
      continue;
    }
    Part low, high;
    halve(x, &low.x, &high.x);
    halve(y, &low.y, &high.y);
    low.halvings = high.halvings = part.halvings + 1;
    low.lo = part.lo, high.hi = part.hi;
    low.hi = high.lo = middle(part.lo, part.hi);
    todo.push_back(std::move(low));
    todo.push_back(std::move(high));
  }
  return sum;
}
