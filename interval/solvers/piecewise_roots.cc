// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/piecewise_roots.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "interval/solvers/bernstein_system.h"
#include "interval/solvers/polynomial_roots.h"
#include "interval/solvers/root_isolation.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

constexpr int kBorderPrecision = 512;

template <std::size_t N>
class PiecewiseSearch {
 public:
  using Cell = typename PiecewiseEquations<N>::Cell;

  PiecewiseSearch(const PiecewiseEquations<N>& system, const SolverOptions& options)
      : system_(system), options_(options), domain_(system.domain()) {}

  Result<RootReport<N>> run() {
    for (std::size_t a = 0; a < N; ++a) cells_.size[a] = system_.breaks[a].size() - 1;
    for (std::size_t i = 0; i < cells_.count(); ++i)
      if (const Status status = search(cell_at(i)); !status) return status.error();
    const ScopedUpward upward;
    for (const IsolatedRoot<N>& root : at_borders_) settle(root);
    for (auto& part : unsettled_)
      if (!is_known(part)) out_.clusters.push_back({part, OpenReason::kPrecision, {}});
    merge_clusters();
    return std::move(out_);
  }

 private:
  Cell cell_at(std::size_t offset) const {
    Cell out;
    for (std::size_t a = N; a-- > 0; offset /= cells_.size[a]) out[a] = offset % cells_.size[a];
    return out;
  }

  Status search(const Cell& cell) {
    if (system_.is_free) {
      const ScopedUpward upward;
      if (system_.is_free(cell)) return ok_status();
    }
    SolverOptions options = options_;
    options.max_boxes -= std::min(options.max_boxes, out_.effort.boxes);
    const auto equations = system_.equations(cell);
    const ExactBox<N> place = system_.place(cell);
    const Result<RootReport<N>> found =
        polynomial_roots<N>(std::span<const ExactPolynomial<N>>(equations), options);
    if (!found) return found.error();
    out_.effort.boxes += found->effort.boxes, out_.effort.frames += found->effort.frames;
    out_.effort.precision = std::max(out_.effort.precision, found->effort.precision);
    for (IsolatedRoot<N> root : found->roots) {
      root.box = placed(root.box, place);
      root.unique_in = placed(root.unique_in, place);
      if (root.exact) root.exact = placed_point(*root.exact, place);
      if (is_inside(root.box, place)) {
        root.unique_in =
            intersection(root.unique_in, continued(cell));  // where these formulas hold
        set_place(root);
        out_.roots.push_back(std::move(root));
      } else {
        at_borders_.push_back(std::move(root));  // its uniqueness holds for one cell's formulas
      }
    }
    for (RootCluster<N> cluster : found->clusters) {
      cluster.box = placed(cluster.box, place);
      if (cluster.exact) cluster.exact = placed_point(*cluster.exact, place);
      out_.clusters.push_back(std::move(cluster));
    }
    return ok_status();
  }
  static std::array<Rational, N> placed_point(std::array<Rational, N> local,
                                              const ExactBox<N>& place) {
    for (std::size_t i = 0; i < N; ++i) local[i] = place[i].lo + place[i].width() * local[i];
    return local;
  }
  // True if the box meets no inner border.
  bool is_inside(const ExactBox<N>& box, const ExactBox<N>& place) const {
    for (std::size_t i = 0; i < N; ++i)
      if ((box[i].lo <= place[i].lo && domain_[i].lo < place[i].lo) ||
          (place[i].hi <= box[i].hi && place[i].hi < domain_[i].hi))
        return false;
    return true;
  }

  // Settles a root of one cell's formulas near an inner border. If it is shown to be a root of the system, that root is
  // added; if it is known, or shown not to be a root, nothing is; otherwise a cluster is.
  void settle(const IsolatedRoot<N>& root) {
    for (int shrink = 4; shrink <= 64; shrink += 6) {
      const Rational margin = domain_.width() * Rational::power_of_two(-shrink);
      ExactBox<N> around = root.box;
      for (ExactInterval& s : around.side) s = {s.lo - margin, s.hi + margin};
      const Look look = look_at(around);
      ++out_.effort.boxes, ++out_.effort.frames;
      if (look.is_free) return;
      if (!look.root) continue;
      IsolatedRoot<N> proved{*look.root, around, RootPlace::kInside, {}};
      refine(proved);
      if (!touches(proved.box, domain_)) return;
      bool is_clear = true;
      for (const IsolatedRoot<N>& known : out_.roots) {
        if (is_subset(proved.box, known.unique_in) || is_subset(known.box, around)) return;
        is_clear = is_clear && !touches(proved.box, known.box);
      }
      if (!is_clear) continue;
      if (root.exact && root.place != RootPlace::kAtBoundary && around.contains(*root.exact))
        proved.exact = root.exact;  // it lies in its cell
      if (proved.exact) proved.box = narrowed(proved);
      set_place(proved);
      out_.roots.push_back(std::move(proved));
      return;
    }
    unsettled_.push_back(root.box);
  }
  // True if the box lies where a root that was proved later, from another cell, is the only one.
  bool is_known(const ExactBox<N>& box) const {
    return std::any_of(out_.roots.begin(), out_.roots.end(), [&](const IsolatedRoot<N>& known) {
      return is_subset(box, known.unique_in);
    });
  }
  void set_place(IsolatedRoot<N>& root) const {
    bool inside = true, on_face = false;
    for (std::size_t i = 0; i < N; ++i) {
      inside = inside && domain_[i].lo < root.box[i].lo && root.box[i].hi < domain_[i].hi;
      on_face =
          on_face ||
          (root.exact && ((*root.exact)[i] == domain_[i].lo || (*root.exact)[i] == domain_[i].hi));
    }
    root.place = on_face                ? RootPlace::kOnBoundary
                 : inside || root.exact ? RootPlace::kInside
                                        : RootPlace::kAtBoundary;
  }
  void refine(IsolatedRoot<N>& root) {
    while (options_.root_width < root.box.width()) {
      ExactBox<N> frame = shortened(root.box, options_.root_width);
      for (ExactInterval& s : frame.side) {
        const Rational more = s.width() / Rational(4) + options_.root_width / Rational(64);
        s = {s.lo - more, s.hi + more};
      }
      const Look look = look_at(frame);
      ++out_.effort.boxes;
      if (!look.root) return;
      // At a kink the contraction may be slow; a box that does not contract is as narrow as it gets.
      const ExactBox<N> next = intersection(shortened(*look.root, options_.root_width), root.box);
      const bool is_progress = next.width() * Rational(16) < root.box.width() * Rational(15);
      root.box = next;
      if (!is_progress) return;
    }
  }
  // A box as wide as asked around a root that is known exactly.
  ExactBox<N> narrowed(const IsolatedRoot<N>& root) const {
    ExactBox<N> out = root.box;
    const Rational reach = options_.root_width / Rational(4);
    for (std::size_t i = 0; i < N; ++i) {
      const Rational& x = (*root.exact)[i];
      const Rational lo = x - reach, hi = x + reach;
      if (out[i].lo < lo) out[i].lo = lo;
      if (hi < out[i].hi) out[i].hi = hi;
    }
    return out;
  }

  struct Look {
    bool is_free = false;             // no root in the box and the domain
    std::optional<ExactBox<N>> root;  // exactly one root in the box, and it is here
  };
  // Examines the box with all cells that meet it, each with its formulas on the whole box.
  Look look_at(const ExactBox<N>& box) {
    std::vector<Bezier<Interval, N>> parts;
    std::size_t central = 0;
    Look out;
    out.is_free = true;
    for (std::size_t i = 0; i < cells_.count(); ++i) {
      const Cell cell = cell_at(i);
      const ExactBox<N> place = continued(cell);
      if (!touches(place, box)) continue;
      if (place.contains(box.middle())) central = parts.size();
      parts.push_back(
          enclosed_on(equations(cell), seen_from(box, system_.place(cell)), kBorderPrecision));
      out.is_free = out.is_free && excludes(parts.back());
    }
    if (out.is_free) return out;
    const auto inverse = elimination(parts[central]).inverse;
    if (!inverse) return out;
    IntervalMatrix<N> derivatives;
    for (auto& row : derivatives) row.fill(Interval::empty());
    std::array<Interval, N> centre, half;
    half.fill(Interval(0.5));
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const Bezier<Interval, N> g = combined(*inverse, parts[p]);
      const IntervalMatrix<N> hulls = derivative_hulls(g);
      for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
          derivatives[i][j] = hull(derivatives[i][j], hulls[i][j]);
      if (p != central) continue;
      // On [-1,1]^N the map is doubled, so that its derivative stays near I.
      const std::vector<Interval> values = evaluate(g, half);
      for (std::size_t i = 0; i < N; ++i) centre[i] = Interval(2) * values[i];
    }
    if (const auto root = krawczyk(centre, derivatives))
      out.root = internal::place_of_root(*root, box);
    return out;
  }
  static bool excludes(const Bezier<Interval, N>& part) {
    return examine(part).kind == Examination<N>::Kind::kNoRoot;
  }
  // The place of the cell; for an outermost cell, together with what lies beyond.
  ExactBox<N> continued(const Cell& cell) const {
    ExactBox<N> out = system_.place(cell);
    const Rational far = domain_.width() * Rational(2);
    for (std::size_t i = 0; i < N; ++i) {
      if (cell[i] == 0) out[i].lo -= far;
      if (cell[i] + 1 == cells_.size[i]) out[i].hi += far;
    }
    return out;
  }
  // The equations, raised to one degree, as components of one map.
  const Bezier<Rational, N>& equations(const Cell& cell) {
    auto& slot = cache_[cells_.at(cell)];
    if (!slot) {
      const auto list = system_.equations(cell);
      slot =
          PolynomialSystem<N>::make(std::span<const ExactPolynomial<N>>(list)).value().equations();
    }
    return *slot;
  }

  void merge_clusters() {
    std::vector<RootCluster<N>> merged;
    for (RootCluster<N>& cluster : out_.clusters) {
      for (std::size_t i = 0; i < merged.size();) {
        if (merged[i].reason != cluster.reason || !touches(merged[i].box, cluster.box)) {
          ++i;
          continue;
        }
        cluster.box = hull(cluster.box, merged[i].box);
        if (!cluster.exact) cluster.exact = merged[i].exact;
        merged.erase(merged.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
      }
      merged.push_back(std::move(cluster));
    }
    out_.clusters = std::move(merged);
  }

  const PiecewiseEquations<N>& system_;
  const SolverOptions& options_;
  ExactBox<N> domain_;
  Grid<N> cells_;
  RootReport<N> out_;
  std::vector<IsolatedRoot<N>> at_borders_;
  std::vector<ExactBox<N>> unsettled_;
  std::map<std::size_t, std::optional<Bezier<Rational, N>>> cache_;
};

}  // namespace

template <std::size_t N>
ExactBox<N> PiecewiseEquations<N>::domain() const {
  ExactBox<N> out;
  for (std::size_t a = 0; a < N; ++a) out[a] = {breaks[a].front(), breaks[a].back()};
  return out;
}
template <std::size_t N>
ExactBox<N> PiecewiseEquations<N>::place(const Cell& cell) const {
  ExactBox<N> out;
  for (std::size_t a = 0; a < N; ++a) out[a] = {breaks[a][cell[a]], breaks[a][cell[a] + 1]};
  return out;
}

template <std::size_t N>
Result<RootReport<N>> piecewise_roots(const PiecewiseEquations<N>& system,
                                      const SolverOptions& options) {
  if (const Status status = check_options(options); !status) return status.error();
  return PiecewiseSearch<N>(system, options).run();
}

#define VT_INSTANTIATE(N)                                                      \
  template struct PiecewiseEquations<N>;                                       \
  template Result<RootReport<N>> piecewise_roots(const PiecewiseEquations<N>&, \
                                                 const SolverOptions&);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
VT_INSTANTIATE(4)
#undef VT_INSTANTIATE

}  // namespace veritope
