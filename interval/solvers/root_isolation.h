// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/root_isolation.h: all roots of a system of equations in a box, each proved, the rest proved free of
// roots. Design: docs/design/0012-certified-solvers.md. Sources: [SP93] (Bernstein subdivision), [Neu90] 5.2.
#pragma once
#include <concepts>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "interval/solvers/bernstein_system.h"
#include "interval/solvers/root_report.h"
#include "interval/upward.h"

namespace veritope {

/// N equations in N unknowns on a box, the frame. A piece stands for the equations on a part of the frame;
/// examine(piece) returns what Examination describes, and its proofs hold on that part; zoom(box) is the same system
/// with better numbers on a smaller frame, or empty.
template <typename S, std::size_t N>
concept EquationSystem = requires(const S& s, const typename S::Piece& piece,
                                  const ExactBox<N>& box, std::array<Rational, N> point) {
  { s.frame() } -> std::convertible_to<ExactBox<N>>;
  { s.precision() } -> std::convertible_to<int>;
  { s.whole() } -> std::convertible_to<typename S::Piece>;
  { s.examine(piece) } -> std::same_as<Examination<N>>;
  {
    s.halves(piece, std::size_t{})
    } -> std::same_as<std::pair<typename S::Piece, typename S::Piece>>;
  { s.zoom(box, int{}) } -> std::same_as<std::optional<S>>;
  { s.vanishes_at(point) } -> std::same_as<bool>;  // exactly; false if unknown
};

namespace internal {

/// The box `examined`, inflated by kInflation of its sides on each side.
template <std::size_t N>
ExactBox<N> inflated_place(const ExactBox<N>& examined) {
  ExactBox<N> out = examined;
  for (std::size_t i = 0; i < N; ++i) {
    const Rational more = examined[i].width() * Rational::from_double(kInflation);
    out[i] = {examined[i].lo - more, examined[i].hi + more};
  }
  return out;
}
template <std::size_t N>
ExactBox<N> exact_box(const Box<N>& box) {
  ExactBox<N> out;
  for (std::size_t i = 0; i < N; ++i)
    out[i] = {Rational::from_double(box[i].lo()), Rational::from_double(box[i].hi())};
  return out;
}
/// The root of an examination in the coordinates of the frame.
template <std::size_t N>
ExactBox<N> place_of_root(const Box<N>& root, const ExactBox<N>& inflated) {
  ExactBox<N> local;
  for (std::size_t i = 0; i < N; ++i)  // from [-1,1] to [0,1]
    local[i] = {(Rational::from_double(root[i].lo()) + Rational(1)) / Rational(2),
                (Rational::from_double(root[i].hi()) + Rational(1)) / Rational(2)};
  return placed(local, inflated);
}

}  // namespace internal

namespace internal {

/// The hull of the parts of a system's frame, halved a few times, that may hold roots. Empty if none does.
template <std::size_t N, EquationSystem<N> S>
std::optional<ExactBox<N>> hull_of_live_parts(const S& system, SolverEffort& effort) {
  struct Part {
    typename S::Piece piece;
    Box<N> local;
  };
  std::vector<Part> parts{{system.whole(), Box<N>::filled(Interval::from_bounds(0, 1))}};
  std::optional<ExactBox<N>> settled;
  for (std::size_t level = 0; level <= 3 * N; ++level) {
    std::vector<Part> halved;
    for (const Part& part : parts) {
      const Examination<N> seen = system.examine(part.piece);
      ++effort.boxes;
      if (seen.kind == Examination<N>::Kind::kNoRoot) continue;
      ExactBox<N> local = exact_box(part.local);
      if (seen.kind == Examination<N>::Kind::kOneRoot) {
        const ExactBox<N> root = place_of_root(seen.root, inflated_place(local));
        if (!touches(root, local)) continue;
        local = intersection(root, local);
      }
      if (level < 3 * N) {
        const std::size_t axis = level % N;
        auto pieces = system.halves(part.piece, axis);
        auto boxes = split(part.local, axis);
        halved.push_back({std::move(pieces.first), boxes.first});
        halved.push_back({std::move(pieces.second), boxes.second});
        continue;
      }
      const ExactBox<N> live = placed(local, system.frame());
      settled = settled ? hull(*settled, live) : live;
    }
    parts = std::move(halved);
  }
  return settled;
}

}  // namespace internal

/// Narrows the box of a proved root to sides of at most `width`, or as far as max_precision bits and the system's
/// numbers go. REQUIRES a live ScopedUpward, width > 0. @cost one zoom and one examination per step; once there are
/// many digits, a step doubles them.
template <std::size_t N, EquationSystem<N> S>
void refine_root(const S& system, const Rational& width, int max_precision, IsolatedRoot<N>& root,
                 SolverEffort& effort) {
  const Rational least = width / Rational(8);
  while (width < root.box.width()) {
    ExactBox<N> frame = shortened(root.box, least);
    for (ExactInterval& s : frame.side)
      if (s.width() < least) s = {s.lo - least / Rational(2), s.hi + least / Rational(2)};
    const std::optional<S> near = system.zoom(frame, max_precision);
    if (!near) return;
    ++effort.frames, ++effort.boxes;
    effort.precision = std::max(effort.precision, near->precision());
    const auto narrow_to = [&](const std::optional<ExactBox<N>>& part) {
      VT_CHECK(part && touches(*part, root.box), "a proved root has gone");
      const Rational before = root.box.width();
      root.box = intersection(shortened(*part, least), root.box);
      return root.box.width() * Rational(4) <= before * Rational(3);
    };
    const Examination<N> found = near->examine(near->whole());
    bool narrowed = false;
    if (found.kind == Examination<N>::Kind::kOneRoot)
      narrowed = narrow_to(internal::place_of_root(found.root, internal::inflated_place(frame)));
    if (!narrowed) narrowed = narrow_to(internal::hull_of_live_parts<N>(*near, effort));
    if (!narrowed) return;
  }
}

/// The search behind isolate_roots.
template <std::size_t N, EquationSystem<N> S>
class RootSearch {
 public:
  RootSearch(const S& system, const SolverOptions& options) : system_(system), options_(options) {}

  RootReport<N> run() {
    std::deque<S> frames{system_};
    while (!frames.empty()) {
      const S frame = std::move(frames.front());
      frames.pop_front();
      ++effort_.frames;
      effort_.precision = std::max(effort_.precision, frame.precision());
      search(frame, frames);
    }
    return report();
  }

 private:
  struct Node {
    typename S::Piece piece;
    Box<N> local;  // of the frame's [0,1]^N
    int depth;
  };
  struct Found {
    IsolatedRoot<N> root;
    bool is_outside;  // of the domain
  };
  // How often a piece must be halved before it may count as exhausted, and the least side in a frame: doubles cut it
  // exactly at its middle.
  static constexpr int kMinDepth = 5 * static_cast<int>(N);
  static constexpr double kLeastSide = 0x1p-44;

  // The largest box of doubles inside `box`, in the frame's coordinates; sides that contain no interval are empty.
  static Box<N> inside(const ExactBox<N>& box, const ExactBox<N>& frame) {
    const ExactBox<N> local = seen_from(box, frame);
    Box<N> out;
    for (std::size_t i = 0; i < N; ++i) {
      const double lo = round_up(local[i].lo), hi = round_down(local[i].hi);
      out[i] = lo <= hi ? Interval::from_bounds(lo, hi) : Interval::empty();
    }
    return out;
  }

  void search(const S& frame, std::deque<S>& frames) {
    covered_.clear();
    for (const Found& f : found_) cover(f, frame);
    std::vector<ExactBox<N>> hard;
    std::deque<Node> nodes;
    nodes.push_back({frame.whole(), Box<N>::filled(Interval::from_bounds(0, 1)), 0});
    while (!nodes.empty()) {
      Node node = std::move(nodes.front());
      nodes.pop_front();
      const auto put_aside = [&] {
        hard.push_back(placed(internal::exact_box(node.local), frame.frame()));
      };
      if (effort_.boxes >= options_.max_boxes) {
        give_up(placed(internal::exact_box(node.local), frame.frame()), OpenReason::kBudget);
        continue;
      }
      if (is_covered(node.local)) continue;
      ++effort_.boxes;
      const Examination<N> seen = frame.examine(node.piece);
      if (seen.kind == Examination<N>::Kind::kNoRoot) continue;
      if (seen.kind == Examination<N>::Kind::kOneRoot) {
        if (!add(frame, node.local, seen.root)) put_aside();
      } else if ((seen.is_exhausted && node.depth >= kMinDepth) ||
                 wid(node.local[seen.axis]) < kLeastSide) {
        put_aside();
      } else {
        auto pieces = frame.halves(node.piece, seen.axis);
        auto parts = split(node.local, seen.axis);
        nodes.push_back({std::move(pieces.first), parts.first, node.depth + 1});
        nodes.push_back({std::move(pieces.second), parts.second, node.depth + 1});
      }
    }
    for (const ExactBox<N>& part : component_hulls(std::move(hard))) descend(frame, part, frames);
  }

  void descend(const S& frame, const ExactBox<N>& part, std::deque<S>& frames) {
    const Rational width = part.width();
    if (width <= options_.least_width) return give_up(part, OpenReason::kNarrow);
    // Equations that are dependent on a curve leave parts as large as the frame.
    if (frame.frame().width() < width * Rational(2)) return give_up(part, OpenReason::kPrecision);
    if (auto near = frame.zoom(part, options_.max_precision)) {
      frames.push_back(std::move(*near));
    } else {
      give_up(part, OpenReason::kPrecision);
    }
  }
  void give_up(const ExactBox<N>& part, OpenReason reason) {
    open_[static_cast<std::size_t>(reason)].push_back(part);
  }

  void cover(const Found& f, const S& frame) {
    if (touches(f.root.unique_in, frame.frame()))
      covered_.push_back(inside(f.root.unique_in, frame.frame()));
  }
  bool is_covered(const Box<N>& local) const {
    for (const Box<N>& c : covered_)
      if (!c.is_empty() && is_subset(local, c)) return true;
    return false;
  }

  // Records the root unless it is known; returns false if that could not be decided.
  bool add(const S& frame, const Box<N>& local, const Box<N>& place) {
    Found f;
    f.root.unique_in = internal::inflated_place(placed(internal::exact_box(local), frame.frame()));
    f.root.box = internal::place_of_root(place, f.root.unique_in);
    refine_root(system_, options_.root_width, options_.max_precision, f.root, effort_);
    for (Found& known : found_) {
      const Sameness same = compare(f.root, known.root);
      if (same == Sameness::kUnknown) return false;
      if (same == Sameness::kSame) return true;
    }
    decide_place(f);
    cover(f, frame);
    found_.push_back(std::move(f));
    return true;
  }

  enum class Sameness { kSame, kDifferent, kUnknown };
  // A root in the other's box of uniqueness is the other root; roots in boxes that do not touch differ.
  Sameness compare(IsolatedRoot<N>& a, IsolatedRoot<N>& b) {
    for (Rational width = a.box.width();; width /= Rational(1 << 20)) {
      refine_root(system_, width, options_.max_precision, a, effort_);
      refine_root(system_, width, options_.max_precision, b, effort_);
      if (is_subset(a.box, b.unique_in) || is_subset(b.box, a.unique_in)) return Sameness::kSame;
      if (!touches(a.box, b.box)) return Sameness::kDifferent;
      if (width < a.box.width() || width.sign() == Sign::kZero) return Sameness::kUnknown;
    }
  }

  void decide_place(Found& f) {
    const ExactBox<N> domain = system_.frame();
    find_fraction(f.root.box, f.root.exact);
    const auto side_of = [&](const IsolatedRoot<N>& r) {
      bool inside = true;
      for (std::size_t i = 0; i < N; ++i)
        inside = inside && domain[i].lo < r.box[i].lo && r.box[i].hi < domain[i].hi;
      return inside;
    };
    if (!side_of(f.root) && !f.root.exact)
      refine_root(system_, options_.root_width * Rational::power_of_two(-60),
                  options_.max_precision, f.root, effort_);
    f.is_outside = !touches(f.root.box, domain);
    f.root.place = side_of(f.root) ? RootPlace::kInside : RootPlace::kAtBoundary;
    if (!f.root.exact || f.root.place == RootPlace::kInside) return;
    f.is_outside = !domain.contains(*f.root.exact);
    for (std::size_t i = 0; i < N; ++i)
      if ((*f.root.exact)[i] == domain[i].lo || (*f.root.exact)[i] == domain[i].hi)
        f.root.place = RootPlace::kOnBoundary;
    if (f.root.place == RootPlace::kAtBoundary) f.root.place = RootPlace::kInside;
  }
  // Admits short fractions only: those of a random root's box have denominators near its width's inverse square root.
  void find_fraction(const ExactBox<N>& box, std::optional<std::array<Rational, N>>& out) {
    std::array<Rational, N> point;
    for (std::size_t i = 0; i < N; ++i) {
      point[i] = simplest_member(box[i]);
      if (point[i].denominator().bit_length() > 16) return;
    }
    if (system_.vanishes_at(point)) out = point;
  }

  RootReport<N> report() {
    RootReport<N> out;
    for (Found& f : found_)
      if (!f.is_outside) out.roots.push_back(std::move(f.root));
    for (std::size_t r = 0; r < open_.size(); ++r)
      for (const ExactBox<N>& part : component_hulls(std::move(open_[r]))) {
        RootCluster<N> cluster{part, static_cast<OpenReason>(r), {}};
        find_fraction(part, cluster.exact);
        out.clusters.push_back(std::move(cluster));
      }
    out.effort = effort_;
    return out;
  }

  const S& system_;
  const SolverOptions& options_;
  SolverEffort effort_;
  std::vector<Found> found_;
  std::vector<Box<N>> covered_;  // proved boxes in the coordinates of the current frame
  std::array<std::vector<ExactBox<N>>, 3> open_;
};

/// All roots in the system's frame. Works in any rounding mode.
template <std::size_t N, EquationSystem<N> S>
RootReport<N> isolate_roots(const S& system, const SolverOptions& options) {
  const ScopedUpward upward;
  return RootSearch<N, S>(system, options).run();
}

}  // namespace veritope
