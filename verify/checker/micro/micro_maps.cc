// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "micro_maps.h"

namespace {

const size_t kMostNumbers = 1 << 25;  // of nets that are kept

}  // namespace

VolumeMaps::VolumeMaps(const std::vector<Entity>& cage)
    : cells_(cage.size()),
      units_(cage.size()),
      cutters_(cage.size()),
      work_(Units{0, ~uint64_t(0) / 2, "B2"}) {
  for (size_t v = 0; v < cage.size(); ++v) {
    cells_[v].volume = &cage[v];
    cells_[v].is_reversed = false;
    for (size_t a = 0; a < 3; ++a) {
      const std::vector<Ratio>& t = cage[v].knots[a];
      const Ratio length = t.back() - t[0];
      for (size_t i = 0; i < t.size(); ++i) {
        if (i > 0 && compare(t[i - 1], t[i]) == 0) continue;
        cells_[v].breaks[a].push_back(t[i]);
        units_[v].knots[a].push_back(span_of(ratio_quotient(t[i] - t[0], length)));
      }
      std::vector<Span>& spans = units_[v].knots[a];  // so that both bounds never decrease
      for (size_t i = 1; i < spans.size(); ++i) {
        spans[i].hi = std::max(spans[i].hi, spans[i - 1].hi);
        const size_t back = spans.size() - 1 - i;
        spans[back].lo = std::min(spans[back].lo, spans[back + 1].lo);
      }
    }
  }
}
VPiece VolumeMaps::piece(uint64_t volume, const size_t* i) {
  std::unique_ptr<PieceCutter>& cutter = cutters_[volume];
  if (cutter == nullptr) cutter.reset(new PieceCutter(cells_[volume], kWholeCell, &work_));
  return cutter->cut(i[0], i[1], i[2]);
}
const DoubleNet& VolumeMaps::net(uint64_t volume, const size_t* i) {
  const std::array<uint64_t, 4> key = {{volume, i[0], i[1], i[2]}};
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  if (numbers_ > kMostNumbers) known_.clear(), numbers_ = 0;
  const VPiece p = piece(volume, i);
  DoubleNet& r = known_[key];
  r.stride = p.is_rational ? 4 : 3;
  std::copy(p.n, p.n + 3, r.n);
  int64_t bits = 0;  // of the longest weight
  for (size_t c = 3; c < p.net.size(); c += 4) bits = std::max(bits, p.net[c].bits());
  const Big unit = shifted(Big(1), bits);
  for (size_t c = 0; c < p.net.size(); c += 4)
    for (size_t k = 0; k < r.stride; ++k)
      r.add(span_of(p.net[c + k], p.is_rational ? unit : p.net[c + 3]));
  numbers_ += r.v.size();
  return r;
}
std::vector<Big> VolumeMaps::point(uint64_t volume, const Ratio* x) {
  size_t index[3];
  Ratio at[3];  // in the box
  for (size_t a = 0; a < 3; ++a) {
    const std::vector<Ratio>& t = knots(volume, a);
    index[a] = 0;
    while (index[a] + 2 < t.size() && compare(t[index[a] + 1], x[a]) < 0) ++index[a];
    at[a] = ratio_quotient(x[a] - t[index[a]], t[index[a] + 1] - t[index[a]]);
  }
  const VPiece p = piece(volume, index);
  std::vector<Big> v = p.net;
  for (size_t a = 0; a < 3; ++a) {  // de Casteljau's scheme along the first axis that is left
    const size_t inner = v.size() / p.n[a];
    const Big rest = at[a].d - at[a].n;
    for (size_t step = 1; step < p.n[a]; ++step)
      for (size_t i = 0; i + step * inner < v.size(); ++i)
        v[i] = rest * v[i] + at[a].n * v[i + inner];
    v.resize(inner);
  }
  return v;
}
