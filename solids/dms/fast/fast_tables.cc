// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_table.h"
#include "solids/dms/fast/fast_pair_internal.h"
#include "solids/dms/fast/fast_tables_internal.h"

namespace veritope::internal {
namespace {

// Local coordinates times coefficients stay below 2^200, and sums of products of eight barycentric coordinates below
// 2^600: nothing overflows. What is lost to underflow is far below the floors of the bounds.
constexpr double kMostOfLeaf = 0x1p150;
constexpr std::size_t kMaxNodes = 20'000;

// Rounds the sets of knots of one tetrahedron. A method that meets a number out of range says so by is_good_.
class FastRounding {
 public:
  FastRounding(const DmsModel& model, DmsTable& table, std::uint32_t tetrahedron,
               const FastPlace& place, std::span<const double> greatest)
      : model_(model), table_(table), tetrahedron_(tetrahedron), greatest_(greatest) {
    out_.place = place;
    out_.is_separate = model.control.is_separate;
  }

  std::optional<FastTables> run(bool with_gradient) {
    for_each_tetrahedral_index(model_.condition_degree(), [&](const TetrahedralIndex& gamma) {
      if (is_good_) add_top(gamma, with_gradient);
    });
    if (!is_good_) return std::nullopt;
    return std::move(out_);
  }

 private:
  void fail() { is_good_ = false; }

  std::uint32_t frame_of(const SimplexFrame<Rational>* frame) {
    const auto [at, is_new] =
        frames_.emplace(frame, static_cast<std::uint32_t>(out_.frames.size()));
    if (!is_new) return at->second;
    out_.frame_low.resize(4 * out_.frames.size() + 4);
    const auto rounded = out_.place.round(*frame, out_.frame_low.data() + 4 * out_.frames.size());
    if (!rounded) fail();
    out_.frames.push_back(rounded.value_or(FastFrame{}));
    return at->second;
  }

  // 2^(3 exponent) / |d|: the height in local coordinates.
  Rational local_height(const SimplexFrame<Rational>& frame) const {
    return Rational::power_of_two(std::int64_t{3} * out_.place.exponent) *
           (frame.height.sign() == Sign::kNegative ? -frame.height : frame.height);
  }

  FastId value_of(const KnotSet& set) {
    const auto found = ids_.find(set);
    if (found != ids_.end()) return found->second;
    const FastId id = set.size() > 5 ? node(set) : leaf(set);
    ids_.emplace(set, id);
    return id;
  }

  FastId node(const KnotSet& set) {
    const SimplexFrame<Rational>* const frame = table_.frame(set);
    if (frame == nullptr || !is_good_) return 0;
    FastTables::Node made{};
    for (std::size_t m = 0; m < 4; ++m) made.part[m] = value_of(set.without(frame->knots[m]));
    if (made.part == std::array<FastId, 4>{}) return 0;
    made.frame = frame_of(frame);
    if (out_.nodes.size() == kMaxNodes) fail();
    out_.nodes.push_back(made);
    return static_cast<FastId>(2 * out_.nodes.size());
  }

  // The next function of the leaf at hand.
  FastLinear round(const std::array<Rational, 4>& l, const Rational& factor, double most) {
    const auto made = out_.place.round(l, factor, most, &out_.leaf_low.emplace_back());
    if (!made) fail();
    return made.value_or(FastLinear{});
  }

  FastId leaf(const KnotSet& set) {
    const SimplexFrame<Rational>* const frame = set.size() == 4 ? table_.frame(set) : widest(set);
    if (frame == nullptr) return 0;
    FastLeaf made{};
    const Rational height = local_height(*frame);
    if (set.size() == 4) {
      made.upper = 1, made.flat = 4;
      made.g[0] = round({height, {}, {}, {}}, Rational(1), kMostBarycentric);
      for (std::size_t m = 0; m < 4; ++m)
        made.g[m + 1] = round(frame->lambda[m], Rational(1), kMostBarycentric);
    } else {
      set_fibre(set, *frame, height, made);
    }
    out_.leaves.push_back(made);
    out_.leaf_low.resize(5 * out_.leaves.size());
    out_.leaf_sets.push_back(set);
    return static_cast<FastId>(2 * out_.leaves.size() - 1);
  }

  // With the fifth knot a = sum of κ_w w, the points of the fibre over u have the coordinates t of a and λ_w(u) - t κ_w
  // of w. These must not be negative.
  void set_fibre(const KnotSet& set, const SimplexFrame<Rational>& frame, const Rational& height,
                 FastLeaf& made) {
    KnotSet rest = set;
    for (const KnotNumber w : frame.knots) rest = rest.without(w);
    const std::array<Rational, 4> kappa = frame.barycentric(table_.point(rest[0]).at());
    std::size_t count = 0;
    const auto add = [&](Sign sign, std::uint32_t& of_sign) {
      for (std::size_t m = 0; m < 4; ++m) {
        if (kappa[m].sign() != sign) continue;
        ++of_sign;
        made.g[count++] = sign == Sign::kZero
                              ? round(frame.lambda[m], Rational(1), kMostBarycentric)
                              : round(frame.lambda[m], height / kappa[m], kMostOfLeaf);
      }
    };
    add(Sign::kPositive, made.upper), add(Sign::kNegative, made.lower);
    add(Sign::kZero, made.flat);
    if (!is_in_range(nearest_double(height), kMostBarycentric)) fail();
  }

  // The frame of four of the five knots with the greatest volume, nearly.
  const SimplexFrame<Rational>* widest(const KnotSet& set) {
    double most = 0;
    KnotSet best;
    for (std::size_t i = 0; i < set.size(); ++i) {
      if (i > 0 && set[i] == set[i - 1]) continue;
      const KnotSet four = set.without(set[i]);
      const double volume = approx_volume(four);
      if (volume > most) most = volume, best = four;
    }
    const SimplexFrame<Rational>* const frame = most > 0 ? table_.frame(best) : nullptr;
    return frame != nullptr ? frame : table_.frame(set);
  }
  double approx_volume(const KnotSet& four) const {
    double e[3][3];
    for (std::size_t i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c)
        e[i][c] = (table_.point(four[i + 1]).rounded()[c] - table_.point(four[0]).rounded()[c]) *
                  out_.place.scale;
    return std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                    e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
  }

  void add_top(const TetrahedralIndex& gamma, bool with_gradient) {
    FastTables::Top top;
    top.set = table_.knots().up_to(gamma);
    top.at = value_of(top.set);
    const auto w = table_.knots().tetrahedron(gamma);
    const SimplexFrame<Rational>* const frame = table_.frame(KnotSet{w[0], w[1], w[2], w[3]});
    VT_CHECK(frame != nullptr, "the four last knots of a basis function are independent");
    top.frame = frame_of(frame);
    const Rational volume =
        frame->volume * Rational::power_of_two(std::int64_t{-3} * out_.place.exponent);
    if (out_.is_separate) {
      add_separate(gamma, volume, with_gradient, top);
    } else {
      add_shared(gamma, *frame, volume, with_gradient, top);
    }
    for (const KnotNumber k : top.set) {
      if (std::exchange(out_.is_used[k], true)) continue;
      out_.knots[k] = to_point(table_.point(k).rounded());
      for (std::size_t c = 0; c < 3; ++c) {
        out_.knot_boxes[k].lo[c] = round_down(table_.point(k).at()[c]);
        out_.knot_boxes[k].hi[c] = round_up(table_.point(k).at()[c]);
      }
    }
    out_.tops.push_back(top);
  }

  static void push(const Rational& x, std::vector<double>& high, std::vector<double>& low) {
    const FastPair pair = pair_of(x);
    high.push_back(pair.hi), low.push_back(pair.lo);
  }
  std::span<const Rational> control(const TetrahedralIndex& beta) const {
    return model_.value(control_of(model_, tetrahedron_, beta));
  }
  // The greatest of the numbers in units of the greatest control values, rounded up.
  double weight(std::span<const double> numbers, std::size_t per_component) {
    double most = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double by = greatest_[i / per_component % greatest_.size()];
      if (!(std::abs(numbers[i]) <= 0x1p500)) fail();
      if (numbers[i] != 0) most = std::max(most, std::abs(numbers[i]) / by);
    }
    if (!(most <= kMostOfLeaf)) fail();
    return most * (1 + 0x1p-50) + kFloor;
  }

  void add_shared(const TetrahedralIndex& gamma, const SimplexFrame<Rational>& frame,
                  const Rational& volume, bool with_gradient, FastTables::Top& top) {
    const std::size_t components = model_.num_components(), first = out_.value.size();
    for (std::size_t m = 0; m < 4; ++m)
      for (const Rational& c : control(raised(gamma, m)))
        push(volume * c, out_.value, out_.value_low);
    out_.value_weight.push_back(weight(std::span(out_.value).subspan(first), 1));
    if (!with_gradient) return;
    top.part[0] = top.at;
    const std::size_t start = out_.gradient.size();
    const Rational by = volume * Rational(model_.degree);
    for (std::size_t c = 0; c < components; ++c)
      for (std::size_t a = 0; a < 3; ++a) {
        Rational sum;
        for (std::size_t m = 0; m < 4; ++m)
          sum += frame.lambda[m][a + 1] * control(raised(gamma, m))[c];
        push(sum * by, out_.gradient, out_.gradient_low);
      }
    out_.gradient_weight.push_back(weight(std::span(out_.gradient).subspan(start), 3));
  }

  // The gradient of M(.|V) is the degree times the sum of those of λ_m times the values of the parts.
  void add_separate(const TetrahedralIndex& beta, const Rational& volume, bool with_gradient,
                    FastTables::Top& top) {
    const std::span<const Rational> c = control(beta);
    const std::size_t first = out_.value.size();
    for (const Rational& x : c) push(volume * x, out_.value, out_.value_low);
    out_.value_weight.push_back(weight(std::span(out_.value).subspan(first), 1));
    if (!with_gradient) return;
    const SimplexFrame<Rational>* const frame = table_.frame(top.set);
    const Rational by = volume * Rational(model_.degree);
    for (std::size_t m = 0; m < 4; ++m) {
      top.part[m] = value_of(top.set.without(frame->knots[m]));
      const std::size_t start = out_.gradient.size();
      for (const Rational& x : c)
        for (std::size_t a = 0; a < 3; ++a)
          push(frame->lambda[m][a + 1] * by * x, out_.gradient, out_.gradient_low);
      out_.gradient_weight.push_back(weight(std::span(out_.gradient).subspan(start), 3));
    }
  }

  const DmsModel& model_;
  DmsTable& table_;
  std::uint32_t tetrahedron_;
  std::span<const double> greatest_;
  bool is_good_ = true;
  FastTables out_;
  std::unordered_map<const SimplexFrame<Rational>*, std::uint32_t> frames_;
  std::unordered_map<KnotSet, FastId, KnotSetHash> ids_;
};

}  // namespace

std::size_t FastTables::bytes() const {
  return sizeof(FastTables) + leaves.size() * (sizeof(FastLeaf) + sizeof(KnotSet)) +
         frames.size() * sizeof(FastFrame) + nodes.size() * sizeof(Node) +
         tops.size() * sizeof(Top) + sizeof(FastLow) * (leaf_low.size() + frame_low.size()) +
         16 * (value.size() + gradient.size()) + 8 * (value_weight.size() + gradient_weight.size());
}

std::optional<FastTables> make_fast_tables(const DmsModel& model, const DmsEvaluator& evaluator,
                                           std::uint32_t tetrahedron, bool with_gradient,
                                           std::span<const double> greatest) {
  const auto place = FastPlace::around(evaluator.knot_box(tetrahedron));
  if (!place) return std::nullopt;
  DmsTable table = evaluator.make_table(tetrahedron);
  return FastRounding(model, table, tetrahedron, *place, greatest).run(with_gradient);
}

}  // namespace veritope::internal
