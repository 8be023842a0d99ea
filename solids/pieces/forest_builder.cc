// SPDX-License-Identifier: LGPL-3.0-or-later
// The roots of a PieceForest: exact coefficients to doubles with bounds.
#include <algorithm>
#include <bit>
#include <cmath>

#include "interval/exact_box.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "solids/pieces/piece_forest.h"
#include "solids/pieces/piece_net_internal.h"
#include "solids/pieces/root_choice_internal.h"

namespace veritope {
namespace {

FormShape shape_of(const Patch& patch) {
  if (patch.is_triangle()) return {true, patch.triangle().degree(), 0};
  return {false, patch.tensor().degree(0), patch.tensor().degree(1)};
}

}  // namespace

class ForestBuilder {
  using Part = PieceForest::Part;

 public:
  ForestBuilder(const PatchComplex& complex, PieceForest::FrameChoice choice, MemoryBudget* budget)
      : choice_(choice) {
    forest_.complex_ = &complex;
    forest_.node_share_ = MemoryShare(budget);
    forest_.form_share_ = MemoryShare(budget);
    forest_.store_.charge(budget);
  }

  Result<PieceForest> build() {
    if (const Status status = choose_frame(); !status) return status.error();
    const auto patches = forest_.complex_->patches();
    const ScopedUpward upward;
    for (std::uint32_t p = 0; p < patches.size(); ++p) {
      PieceForest::Form form = form_of(p);
      if (!is_in_range(form))
        return Error{Code::kOverLimit,
                     {},
                     to_string(patches[p].origin()) +
                         " has coordinates, weights or derivatives out of the range of binary64"};
      forest_.forms_.push_back(std::move(form));
    }
    if (choice_ == PieceForest::FrameChoice::kWhole)
      internal::choose_straight_roots(*forest_.complex_, &forest_.forms_);
    else
      for (PieceForest::Form& form : forest_.forms_) internal::choose_square_roots(&form);
    add_roots();
    return std::move(forest_);
  }

 private:
  static Error over_limit(const Patch& patch) {
    return Error{Code::kOverLimit,
                 {},
                 to_string(patch.origin()) + " has a coordinate out of the range of binary64"};
  }
  // The box of the control points.
  static ExactBox<3> box_of(const Patch& patch) {
    ExactBox<3> out;
    for (std::size_t i = 0; i < patch.num_control(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational& v = patch.component(static_cast<int>(k))[i];
        const Rational x = patch.is_rational() ? v / patch.component(3)[i] : v;
        if (i == 0 || x < out[k].lo) out[k].lo = x;
        if (i == 0 || out[k].hi < x) out[k].hi = x;
      }
    return out;
  }
  Status choose_frame() {
    ExactBox<3> all_patches;
    bool is_first = true;
    for (const Patch& patch : forest_.complex_->patches()) {
      const ExactBox<3> box = box_of(patch);
      for (const ExactInterval& s : box.side)
        if (!std::isfinite(nearest_double(s.lo)) || !std::isfinite(nearest_double(s.hi)))
          return over_limit(patch);
      all_patches = is_first ? box : hull(all_patches, box);
      const Rational own = box.width();
      if (own.sign() == Sign::kPositive &&
          (least_length_.sign() == Sign::kZero || own < least_length_))
        least_ = box, least_length_ = own;
      is_first = false;
    }
    PieceForest::Frame& frame = forest_.frame_;
    // Exponents of the coordinates, of the lengths, and of the greatest of each; of a flat model the lengths do not
    // count.
    const Rational half = Rational(1) / Rational(2);
    std::array<Rational, 3> most, length;
    Rational all, longest;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [lo, hi] = all_patches[k];
      most[k] = std::max(abs(lo), abs(hi));
      length[k] = hi - lo;
      all = std::max(all, most[k]), longest = std::max(longest, length[k]);
    }
    if (all.sign() == Sign::kZero) return ok_status();
    frame.scale.fill(-exponent(all));
    if (choice_ != PieceForest::FrameChoice::kFitted) return ok_status();
    if (*std::min_element(length.begin(), length.end()) * Rational(kFar) <= longest) {
      for (std::size_t k = 0; k < 3; ++k)
        frame.scale[k] = -exponent(length[k].sign() == Sign::kZero ? longest : length[k]);
    } else if (longest * Rational(kFar) < all) {
      frame.scale.fill(-exponent(longest));
    } else {
      move_to_least_patch(longest);
      return ok_status();
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational step = Rational::power_of_two(-frame.scale[k]);
      const Rational steps = (all_patches[k].lo + all_patches[k].hi) * half / step + half;
      frame.shift[k] = Rational(floor_divide(steps.numerator(), steps.denominator())) * step;
    }
    return ok_status();
  }
  static constexpr int kFar = 16;
  static constexpr int kTinyBits = 32;
  // Doubles are finest near 0. A patch that is tiny compared with the model is moved there, so that its boxes have room
  // for their grid. This helps one such place only.
  void move_to_least_patch(const Rational& longest) {
    if (least_length_.sign() == Sign::kZero ||
        longest < Rational::power_of_two(kTinyBits) * least_length_)
      return;
    for (std::size_t k = 0; k < 3; ++k)
      forest_.frame_.shift[k] = coarsest_multiple(least_[k].lo, least_[k].lo + least_length_);
  }
  // The multiple of the greatest power of two in [lo, hi]. REQUIRES lo < hi.
  static Rational coarsest_multiple(const Rational& lo, const Rational& hi) {
    if (lo.sign() != Sign::kPositive && hi.sign() != Sign::kNegative) return Rational();
    for (int bits = exponent(std::max(abs(lo), abs(hi)));; --bits) {
      const Rational step = Rational::power_of_two(bits);
      const Rational last = hi / step;
      const Rational x = Rational(floor_divide(last.numerator(), last.denominator())) * step;
      if (lo <= x) return x;
    }
  }
  // REQUIRES v > 0. 2^(result - 2) < v < 2^result.
  static int exponent(const Rational& v) {
    return static_cast<int>(static_cast<std::int64_t>(v.numerator().bit_length()) -
                            static_cast<std::int64_t>(v.denominator().bit_length())) +
           1;
  }

  // Coordinates in the frame, relative to a point near the patch; weights of approximately 1.
  PieceForest::Form form_of(std::uint32_t number) const {
    const Patch& patch = forest_.complex_->patch(number);
    PieceForest::Form form;
    form.shape = shape_of(patch);
    form.determinant = determinant_shape(form.shape);
    form.is_rational = patch.is_rational();
    for (std::uint32_t s = 0; s < patch.num_sides(); ++s)
      if (forest_.complex_->is_collapsed({number, s}))
        form.collapsed |= static_cast<std::uint8_t>(1u << s);
    const std::size_t n = form.shape.count();
    Rational factor(1);
    if (form.is_rational) {
      Rational largest = patch.component(3)[0];
      for (const Rational& w : patch.component(3)) largest = std::max(largest, w);
      factor = Rational(1) / largest;
    }
    std::vector<Interval> control;
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const auto component = patch.component(c);
      const double origin = nearest_double(forest_.in_frame(
          k, form.is_rational ? component[0] / patch.component(3)[0] : component[0]));
      form.origin[k] = origin;
      const Rational unit = Rational::power_of_two(forest_.frame_.scale[k]);
      const Rational shift = forest_.frame_.shift[k] * unit + Rational::from_double(origin);
      for (std::size_t i = 0; i < n; ++i)
        control.push_back(enclose(
            form.is_rational ? factor * (unit * component[i] - shift * patch.component(3)[i])
                             : unit * component[i] - shift));
    }
    if (form.is_rational)
      for (const Rational& w : patch.component(3)) control.push_back(enclose(factor * w));
    const auto determinants =
        determinant_form<Interval>(form.shape, form.is_rational, control.data());
    fill_net(control, PieceForest::layout(form, Part::kControl), &form.root_control);
    std::vector<Interval> all;
    for (const std::vector<Interval>& d : determinants) all.insert(all.end(), d.begin(), d.end());
    fill_net(all, PieceForest::layout(form, Part::kDeterminants), &form.root_determinants);
    return form;
  }

  static void fill_net(const std::vector<Interval>& from, const PieceForest::Layout& at,
                       std::vector<double>* net) {
    net->resize(at.size());
    for (std::size_t c = 0; c < at.components; ++c) {
      double error = 0, size = 0;
      for (std::size_t i = 0; i < at.count; ++i) {
        const MidRad m = mid_rad(from[at.begin(c) + i]);
        (*net)[at.begin(c) + i] = m.mid;
        error = std::max(error, m.rad);
        size = std::max(size, std::abs(m.mid));
      }
      (*net)[at.error(c)] = error;
      (*net)[at.magnitude(c)] = size;
    }
  }

  static bool is_in_range(const PieceForest::Form& form) {
    const auto is_small = [](double v) { return std::abs(v) < 0x1p900; };
    return std::all_of(form.root_control.begin(), form.root_control.end(), is_small) &&
           std::all_of(form.root_determinants.begin(), form.root_determinants.end(), is_small);
  }

  void add_roots() {
    std::vector<Box3d> boxes;
    for (std::uint32_t p = 0; p < forest_.forms_.size(); ++p) {
      PieceForest::Form& form = forest_.forms_[p];
      form.first_root = static_cast<PieceForest::Id>(forest_.nodes_.size());
      const std::uint64_t rows = std::uint64_t{1} << form.root_bits[0],
                          columns = std::uint64_t{1} << form.root_bits[1];
      form.num_roots = static_cast<std::uint32_t>(rows * columns);
      for (std::uint64_t i = 0; i < rows; ++i)
        for (std::uint64_t j = 0; j < columns; ++j) {
          PieceForest::Node node;
          node.patch = p, node.i = i, node.j = j;
          forest_.nodes_.push_back(node);
          const auto id = static_cast<PieceForest::Id>(forest_.nodes_.size() - 1);
          forest_.nodes_[id].hull = forest_.tight_hull(id);
          boxes.push_back(forest_.nodes_[id].hull);
        }
    }
    forest_.num_roots_ = forest_.nodes_.size();
    forest_.node_share_.resize_anyway(forest_.nodes_.capacity() * PieceForest::kBytesOfNode);
    std::uint64_t forms = boxes.size() * 2 * sizeof(Box3d);  // with the tree over them
    for (const PieceForest::Form& form : forest_.forms_)
      forms += 2 * sizeof form +
               (form.root_control.size() + form.root_determinants.size()) * sizeof(double);
    forest_.form_share_.resize_anyway(forms);
    forest_.roots_ = BoxHierarchy(std::move(boxes));
  }

  PieceForest::FrameChoice choice_;
  ExactBox<3> least_;      // of the smallest patch that is more than a point
  Rational least_length_;  // the length of that patch; 0 if all are points
  PieceForest forest_;
};

Result<PieceForest> PieceForest::make(const PatchComplex& complex, FrameChoice choice,
                                      MemoryBudget* budget) {
  return ForestBuilder(complex, choice, budget).build();
}

}  // namespace veritope
