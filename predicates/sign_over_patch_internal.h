// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/sign_over_patch_internal.h: the search of sign_over_patch.h, over boxes or triangles.
#pragma once
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "interval/interval.h"
#include "interval/numeric.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "predicates/sign_over_patch.h"
#include "robust/base/check.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {

/// What the search needs from a Domain. A Cut says where a piece was halved; a Region knows its corners.
///   static constexpr kDimension, kCorners (of reports)
///   Region whole(); std::vector<std::pair<std::size_t, Point>> corners(region): coefficient and point
///   Cut choose(region, values, depth); std::pair<Region, Region> halves(region, cut)
///   std::vector<R> half(values, cut, which): of the coefficients; R Interval or Rational
///   Point middle(region), in its interior, and place(region): for the report
template <typename Domain>
class SignSearch {
 public:
  using Point = typename Domain::Point;
  using Report = SignReport<Domain::kDimension, Domain::kCorners>;

  SignSearch(const Domain& domain, std::vector<Rational> exact, const SignBudget& budget)
      : domain_(domain), exact_(std::move(exact)), budget_(budget) {
    VT_CHECK(budget.max_pieces >= 1, "a search looks at one piece at least");
  }

  Report run() {
    const ScopedUpward upward;
    Piece root;
    root.region = domain_.whole();
    for (const Rational& v : exact_) root.rounded.push_back(enclose(v));
    queue_.push_back(std::move(root));
    while (!queue_.empty()) {
      if (report_.num_pieces == budget_.max_pieces) return undecided(queue_.front());
      const Piece piece = std::move(queue_.front());
      queue_.pop_front();
      look_at(piece);
      if (is_done_) return report_;
    }
    VT_CHECK(positive_.has_value() != negative_.has_value(), "all pieces have one sign");
    report_.answer = positive_ ? PatchSign::kPositive : PatchSign::kNegative;
    return report_;
  }

 private:
  using Cut = typename Domain::Cut;
  struct Piece {
    typename Domain::Region region;
    std::vector<Interval> rounded;
    std::vector<std::pair<Cut, int>> path;  // from the whole
  };
  struct Signs {
    bool positive = false, negative = false, zero = false, uncertain = false;
    void add(Sign3 s) {
      positive |= s == Sign3::kPositive, negative |= s == Sign3::kNegative;
      zero |= s == Sign3::kZero, uncertain |= s == Sign3::kUncertain;
    }
  };

  void look_at(const Piece& piece) {
    ++report_.num_pieces;
    report_.depth = std::max(report_.depth, static_cast<int>(piece.path.size()));
    std::vector<Sign3> signs;
    Signs all = signs_of(piece.rounded, signs);
    // Uncertain coefficients matter unless the piece is to be halved anyway.
    if (all.uncertain && !(all.positive && all.negative)) {
      ++report_.num_exact;
      all = signs_of(exact_values(piece), signs);
    }
    if (!all.positive && !all.negative && !all.uncertain) return finish(PatchSign::kZero);
    bool has_zero_corner = false;
    for (const auto& [coefficient, point] : domain_.corners(piece.region)) {
      note(signs[coefficient], point);
      has_zero_corner |= signs[coefficient] == Sign3::kZero;
      if (is_done_) return;
    }
    // Coefficients >= 0, not all 0, and corners > 0: a face of the closed set has a positive coefficient at its corner,
    // and Bernstein polynomials are positive inside their face.
    const bool has_one_sign = !all.uncertain && all.positive != all.negative;
    if (has_one_sign && !has_zero_corner) return;
    if (has_one_sign) return note_inside(piece, all);
    if (static_cast<int>(piece.path.size()) >= budget_.max_depth) {
      is_done_ = true;
      report_ = undecided(piece);
      return;
    }
    halve(piece);
  }
  // Notes that a corner is zero and the inside is not: mixed, with the sign of the middle of the piece.
  void note_inside(const Piece& piece, const Signs& all) {
    note(all.positive ? Sign3::kPositive : Sign3::kNegative, domain_.middle(piece.region));
    VT_CHECK(is_done_, "a zero and another sign");
  }

  template <typename R>
  static Signs signs_of(const std::vector<R>& values, std::vector<Sign3>& out) {
    Signs all;
    out.clear();
    for (const R& v : values) {
      if constexpr (std::is_same_v<R, Interval>) {
        out.push_back(v.sign());
      } else {
        out.push_back(to_sign3(v.sign()));
      }
      all.add(out.back());
    }
    return all;
  }
  std::vector<Rational> exact_values(const Piece& piece) const {
    std::vector<Rational> values = exact_;
    for (const auto& [cut, which] : piece.path) values = domain_.half(values, cut, which);
    return values;
  }
  void halve(const Piece& piece) {
    const Cut cut = domain_.choose(piece.region, piece.rounded, piece.path.size());
    const auto regions = domain_.halves(piece.region, cut);
    for (int which = 0; which < 2; ++which) {
      Piece half;
      half.region = which == 0 ? regions.first : regions.second;
      half.rounded = domain_.half(piece.rounded, cut, which);
      half.path = piece.path;
      half.path.emplace_back(cut, which);
      queue_.push_back(std::move(half));
    }
  }

  void note(Sign3 sign, const Point& at) {
    if (sign == Sign3::kUncertain) return;
    auto& slot = sign == Sign3::kPositive   ? positive_
                 : sign == Sign3::kNegative ? negative_
                                            : zero_;
    if (!slot) slot = SignWitness<Domain::kDimension>{at, to_sign(sign)};
    if (static_cast<int>(positive_.has_value()) + static_cast<int>(negative_.has_value()) +
            static_cast<int>(zero_.has_value()) <
        2)
      return;
    report_.witnesses = {positive_ ? *positive_ : *zero_, negative_ ? *negative_ : *zero_};
    finish(PatchSign::kMixed);
  }
  void finish(PatchSign answer) { report_.answer = answer, is_done_ = true; }
  Report undecided(const Piece& piece) {
    Report out = report_;
    out.answer = PatchSign::kUndecided;
    out.place = domain_.place(piece.region);
    out.num_left = queue_.size() + (is_done_ ? 1 : 0);
    return out;
  }

  const Domain& domain_;
  std::vector<Rational> exact_;
  SignBudget budget_;
  std::deque<Piece> queue_;
  std::optional<SignWitness<Domain::kDimension>> positive_, negative_, zero_;
  Report report_;
  bool is_done_ = false;
};

inline Rational halved(const Rational& a) { return a * Rational::power_of_two(-1); }

/// Both halves of a line of Bernstein coefficients: those of [1/2, 1] replace it, those of [0, 1/2] go to `left`.
template <typename R>
void halve_keeping_right(std::vector<R>& line, std::vector<R>& left) {
  left.resize(line.size());
  split_keeping_right(line.data(), 1, static_cast<int>(line.size()) - 1, left.data(), 1,
                      HalfBlend<R>{R(RingNumbers<R>::ratio(1, 2))});
}

}  // namespace veritope::internal
