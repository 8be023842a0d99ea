// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_sweeps.cc: Q1 and Q2 of docs/certificates/microstructure.md.
#include "micro_sweeps.h"

#include "micro_growth.h"

namespace {

// Limits of this checker, of the work of Q2.
const uint64_t kFreeWork = uint64_t(1) << 34, kWorkOfSweep = 1 << 18;

// Whether the symmetric matrix is positive definite: each pivot is > 0, as the leading minors are then.
bool is_definite(Near (*m)[3]) {
  for (size_t p = 0; p < 3; ++p) {
    if (!is_positive(m[p][p])) return false;
    for (size_t r = p + 1; r < 3; ++r)
      for (size_t c = r; c < 3; ++c) m[r][c] = m[r][c] - quotient(m[p][r] * m[p][c], m[p][p]);
  }
  return true;
}
// Whether K C + (K C)^T is.
bool is_definite(const Near (*k)[3], const Near (*c)[3]) {
  Near product[3][3], sum[3][3];
  for (size_t r = 0; r < 3; ++r)
    for (size_t s = 0; s < 3; ++s)
      product[r][s] = k[r][0] * c[0][s] + k[r][1] * c[1][s] + k[r][2] * c[2][s];
  for (size_t r = 0; r < 3; ++r)
    for (size_t s = 0; s < 3; ++s) sum[r][s] = product[r][s] + product[s][r];
  return is_definite(sum);
}

class GrowthCheck {
 public:
  GrowthCheck(TileParts* parts, const MicroSweep& sweep, uint64_t number)
      : sweep_(sweep), number_(number), axis_(sweep.wall / 2) {
    for (size_t i = 0; i < 9; ++i) k_[i / 3][i % 3] = near_of(sweep.matrix[i]);
    const MicroGrid& g = parts->file().grids[sweep.grid];
    size_t i[3], box[3];
    g.place_of(sweep.cell, i);
    parts->box_of_cell(g, i, box);
    jet_.map = parts->maps().net(g.volume, box);
    for (size_t a = 0; a < 3; ++a) {
      const std::vector<Ratio>& t = parts->maps().knots(g.volume, a);
      const Ratio length = t[box[a] + 1] - t[box[a]];
      jet_.by[a] = derivative_of(jet_.map, a, near_of(span_of(length.d, length.n)));
      cell_[a][0] = parts->break_in(g, box, a, i[a]);
      cell_[a][1] = parts->break_in(g, box, a, i[a] + 1);
    }
  }
  // Products of coefficients on the slab: those on the wall are fewer.
  uint64_t work() const {
    const uint64_t count = jet_.map.v.size() / jet_.map.stride;
    return jet_.map.stride == 4 ? 18 * count * count : 27 * count;
  }
  void check_slab() const {
    const Span &begin = cell_[axis_][0], &end = cell_[axis_][1];
    const double more = std::ldexp(1.0, -46);  // the ends are at most 1
    const double depth = sweep_.depth.hi * (end.hi - begin.lo) + more;
    Span slab = {begin.lo - more, end.hi + more};
    if (sweep_.depth.hi < 1 && sweep_.wall % 2 == 0) slab.hi = begin.hi + depth;
    if (sweep_.depth.hi < 1 && sweep_.wall % 2 == 1) slab.lo = end.lo - depth;
    const Growth growth = growth_of(restricted(slab, false));
    const size_t count = growth.d[0][0].v.size();
    for (size_t at = 0; at < count; ++at) {
      Near c[3][3];
      set_matrix(growth, at, c);
      require(is_definite(k_, c), "Q2", "K C is not positive on the slab, of sweep", number_);
    }
  }
  void check_axis() const {
    const Growth growth = growth_of(restricted(cell_[axis_][sweep_.wall % 2], true));
    Near at_begin[3], at_end[3];  // l s g
    const Near speed = near_of(sweep_.speed);
    for (size_t k = 0; k < 3; ++k) {
      at_begin[k] = near_of(sweep_.axis[0][k]) * speed;
      at_end[k] = (near_of(sweep_.axis[1][k]) - near_of(sweep_.axis[0][k])) * speed;
      if (sweep_.wall % 2 == 0) at_begin[k].v = -at_begin[k].v, at_end[k].v = -at_end[k].v;
    }
    const size_t count = growth.d[0][(axis_ + 1) % 3].v.size();
    for (size_t at = 0; at < count; ++at)
      for (const Near* g : {at_begin, at_end}) {
        Near c[3][3];
        set_matrix(growth, at, c);
        const Near weight =
            growth.is_rational ? Near{growth.square.v[at], growth.square.error} : Near{1, 0};
        for (size_t k = 0; k < 3; ++k) c[k][axis_] = weight * g[k];
        require(is_definite(k_, c), "Q2", "K C is not positive beyond the wall, of sweep", number_);
      }
  }

 private:
  // On the cell, but along the axis; if is_flat, at a value there.
  Jet restricted(const Span& along, bool is_flat) const {
    Jet r = jet_;
    for (DoubleNet* net : {&r.map, &r.by[0], &r.by[1], &r.by[2]})
      for (size_t a = 0; a < 3; ++a) {
        const double lo = a == axis_ ? along.lo : cell_[a][0].lo,
                     hi = a == axis_ ? along.hi : cell_[a][1].hi;
        restrict_net(net, a, std::min(1.0, std::max(0.0, lo)), std::max(0.0, std::min(1.0, hi)));
        if (is_flat && a == axis_) flatten(net, a);
      }
    return r;
  }
  static void set_matrix(const Growth& growth, size_t at, Near (*c)[3]) {
    for (size_t r = 0; r < 3; ++r)
      for (size_t s = 0; s < 3; ++s) {
        const DoubleNet& d = growth.d[r][s];
        c[r][s] = Near{d.v[at], d.error};
      }
  }

  const MicroSweep& sweep_;
  const uint64_t number_;
  const size_t axis_;
  Near k_[3][3];
  Jet jet_;
  Span cell_[3][2];  // where the box of knots is [0, 1]
};

}  // namespace

void check_growth(TileParts* parts, const MicroSweep& sweep, uint64_t number, uint64_t* work) {
  const GrowthCheck check(parts, sweep, number);
  *work += check.work();
  require(*work <= kFreeWork + kWorkOfSweep * parts->file().sweeps.size(), "Q2",
          "this checker has a limit of products of coefficients:", *work);
  check.check_slab();
  check.check_axis();
}

void check_sweeps(const MicroFile& file, const std::vector<bool>& is_meeting) {
  if (file.sweeps.empty()) return;
  VolumeMaps maps(file.cage);
  TileParts parts(file, &maps);
  SweepPairs pairs(&parts);
  uint64_t work = 0;
  for (size_t i = 0; i < file.sweeps.size(); ++i) {
    const MicroSweep& b = file.sweeps[i];
    patch_of_cap(file, b.grid, b.cell, b.wall, "Q1", i);
    require(!is_meeting[i], "Q1", "the cap is equal to another one, of sweep", i);
    check_growth(&parts, b, i, &work);
    pairs.check_tiles(b, i);
  }
  pairs.check_sweeps();
}
