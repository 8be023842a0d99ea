// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/fast_dms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "solids/dms/fast/fast_pair_internal.h"
#include "solids/dms/fast/fast_region_internal.h"
#include "solids/dms/fast/fast_store_internal.h"

namespace veritope {
namespace {

using internal::FastCell;
using internal::FastDmsKernels;
using internal::FastRegion;
using internal::FastRegionUnit;
using internal::is_in_box;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kChunk = 256;
// The errors of errors, and what underflow may lose (docs/bounds/fast_dms.md, 6).
constexpr double kRaise = 1 + 0x1p-40, kLost = 0x1p-600;

const FastDmsKernels* kernels_of(FastDmsBackEnd back_end) {
  if (back_end == FastDmsBackEnd::kBaseline) return &internal::kFastDmsBaseline;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return internal::fast_dms_avx2();
#endif
  return nullptr;
}

const FastDmsKernels* checked_kernels(FastDmsBackEnd back_end) {
  const FastDmsKernels* const found = kernels_of(back_end);
  VT_CHECK(found != nullptr, "this processor lacks the back end's instructions");
  return found;
}

// A row of a chunk's points for the kernels, with room for whole vectors.
struct FastChunk {
  alignas(32) double at[3][kChunk + 4] = {};
  alignas(32) double lambda[4][kChunk + 4] = {};
  std::uint32_t list[kChunk + 4] = {};
  double error[2 * kChunk] = {};
  std::uint8_t is_open[kChunk] = {};
  std::vector<double> value, gradient;
};

}  // namespace

bool is_available(FastDmsBackEnd back_end) { return kernels_of(back_end) != nullptr; }
FastDmsBackEnd widest_fast_dms_back_end() {
  static const FastDmsBackEnd widest =
      is_available(FastDmsBackEnd::kAvx2) ? FastDmsBackEnd::kAvx2 : FastDmsBackEnd::kBaseline;
  return widest;
}

class FastDms::Work {
 public:
  Work(const DmsModel& model, const FastDmsOptions& options)
      : options_(options),
        evaluator_(model),
        kernels_(checked_kernels(options.back_end)),
        components_(model.num_components()),
        exact_first_(options.exact_first.value_or(
            model.degree > 3 ? std::size_t{4} << (2 * (model.degree - 3)) : 4)),
        slots_(model.tetrahedra.size()),
        cells_(model, evaluator_, *kernels_),
        store_(model, evaluator_, cells_, options.with_gradient, options.max_bytes) {
    chunk_.value.resize(kChunk * components_);
    if (options.with_gradient) chunk_.gradient.resize(3 * kChunk * components_);
  }

  std::size_t components() const { return components_; }
  const FastDmsCounts& counts() const { return counts_; }
  std::size_t num_near(std::uint32_t t) {
    const FastRegion* const r = store_.region(t);
    return r == nullptr ? 0 : r->num_tops;
  }

  void evaluate(std::span<const Vec3d> points, const FastDmsOutput& out, ExactPoints exact) {
    VT_CHECK(out.value != nullptr && (out.gradient != nullptr || out.gradient_bound == nullptr),
             "a FastDms writes values, and bounds of what it writes");
    VT_CHECK(out.gradient == nullptr || options_.with_gradient, "derivatives need with_gradient");
    VT_CHECK(out.gradient_bound == nullptr || out.value_bound != nullptr,
             "bounds of derivatives come with those of values");
    const ScopedDefaultFp nearest;
    points_ = points, out_ = out, exact_ = exact;
    is_rounded_.assign(points.size(), 0);
    for (const auto& [i, p] : exact) is_rounded_[i] = 1;
    locate_all();
    for (const std::uint32_t t : met_) evaluate_inside(t);
    for (const std::uint32_t t : met_) slots_[t].count = 0;
    std::sort(exactly_.begin(), exactly_.end());
    for (const std::uint32_t i : exactly_) evaluate_exactly(i);
    exactly_.clear();
  }

 private:
  struct Slot {
    std::size_t seen = 0;
    std::uint32_t count = 0, first = 0;  // of the points at hand
  };

  void locate_all() {
    met_.clear();
    where_.resize(points_.size());
    std::uint32_t inside = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::uint32_t t = cells_.locate(points_[i], is_rounded_[i]);
      if (t == internal::kFastUndecided) {
        ++counts_.near_faces;
        const auto place = evaluator_.locate(exact_point(static_cast<std::uint32_t>(i)));
        t = place ? place->tetrahedron : kNoTetrahedron;
      }
      where_[i] = t;
      if (out_.tetrahedron != nullptr) out_.tetrahedron[i] = t;
      if (t == kNoTetrahedron) {
        ++counts_.outside;
        write_outside(i);
      } else {
        if (slots_[t].count++ == 0) met_.push_back(t);
        ++inside;
      }
    }
    sorted_.resize(inside);
    std::uint32_t first = 0;
    for (const std::uint32_t t : met_) {
      slots_[t].first = first;
      first += std::exchange(slots_[t].count, 0);
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (where_[i] != kNoTetrahedron) {
        Slot& slot = slots_[where_[i]];
        sorted_[slot.first + slot.count++] = static_cast<std::uint32_t>(i);
      }
  }

  void put_off(std::size_t i, std::uint64_t& count) {
    ++count;
    exactly_.push_back(static_cast<std::uint32_t>(i));
  }

  // ---- values

  void evaluate_inside(std::uint32_t t) {
    Slot& slot = slots_[t];
    const std::span<const std::uint32_t> all = std::span(sorted_).subspan(slot.first, slot.count);
    slot.seen += all.size();
    const FastRegion* const here = slot.seen > exact_first_ ? store_.region(t) : nullptr;
    if (here == nullptr) {
      for (const std::uint32_t i : all) put_off(i, counts_.unprepared);
      return;
    }
    scratch_.resize(std::max(scratch_.size(), here->scratch));
    std::vector<std::uint32_t> ids;
    for (const int rounded : {0, 1}) {
      ids.clear();
      for (const std::uint32_t i : all)
        if (is_rounded_[i] == rounded) ids.push_back(i);
      for (std::size_t begin = 0; begin < ids.size(); begin += kChunk)
        evaluate_chunk(*here, *cells_.cell(t),
                       std::span(ids).subspan(begin, std::min(kChunk, ids.size() - begin)),
                       rounded);
    }
  }

  void evaluate_chunk(const FastRegion& here, const FastCell& at,
                      std::span<const std::uint32_t> ids, double rounded) {
    const std::size_t n = ids.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d& p = points_[ids[i]];
      chunk_.at[0][i] = p.x, chunk_.at[1][i] = p.y, chunk_.at[2][i] = p.z;
    }
    for (std::size_t i = n; i < n + 3; ++i)
      for (auto& axis : chunk_.at) axis[i] = axis[n - 1];
    std::fill_n(chunk_.value.begin(), n * components_, 0.0);
    if (out_.gradient != nullptr) std::fill_n(chunk_.gradient.begin(), 3 * n * components_, 0.0);
    std::fill_n(chunk_.error, 2 * n, 0.0);
    std::fill_n(chunk_.is_open, n, std::uint8_t{0});
    const double* const coordinates[3] = {chunk_.at[0], chunk_.at[1], chunk_.at[2]};
    double* const lambda[4] = {chunk_.lambda[0], chunk_.lambda[1], chunk_.lambda[2],
                               chunk_.lambda[3]};
    kernels_->barycentric(at.frame, at.place.origin, at.place.scale, coordinates, n, lambda);
    const internal::FastPoints points{{coordinates[0], coordinates[1], coordinates[2]},
                                      chunk_.value.data(),
                                      out_.gradient != nullptr ? chunk_.gradient.data() : nullptr,
                                      chunk_.error,
                                      chunk_.is_open};
    for (const auto& unit : here.units) {
      const std::size_t count = unit->is_own ? all_of(n) : near(*unit, n);
      if (count == 0) continue;
      const auto roundings = static_cast<double>(
          12 + unit->tops.size() * (unit->unit.is_separate ? 4 : 1) + here.units.size());
      const internal::FastCall call{rounded, roundings * 0x1p-53, scratch_.data()};
      (out_.value_bound != nullptr ? kernels_->bounded : kernels_->plain)(unit->unit, points,
                                                                          chunk_.list, count, call);
    }
    for (std::size_t i = 0; i < n; ++i) write(here, i, ids[i]);
  }
  std::size_t all_of(std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) chunk_.list[i] = static_cast<std::uint32_t>(i);
    return n;
  }
  // Lists the points that may be in the hull of the unit's knots.
  std::size_t near(const FastRegionUnit& unit, std::size_t n) {
    const double* const lambda[4] = {chunk_.lambda[0], chunk_.lambda[1], chunk_.lambda[2],
                                     chunk_.lambda[3]};
    const std::size_t most = kernels_->select(lambda, n, unit.high.data(), chunk_.list);
    std::size_t count = 0;
    for (std::size_t k = 0; k < most; ++k) {
      const std::uint32_t i = chunk_.list[k];
      chunk_.list[count] = i;
      count += is_in_box(unit.box, {chunk_.at[0][i], chunk_.at[1][i], chunk_.at[2][i]}) ? 1 : 0;
    }
    return count;
  }

  // Not a number is too great.
  bool is_narrow(double error, double slope) const {
    return error <= options_.tolerance &&
           (out_.gradient_bound == nullptr || slope <= options_.tolerance);
  }
  void write(const FastRegion& here, std::size_t i, std::uint32_t to) {
    const double error = chunk_.error[2 * i] * kRaise + kLost;
    const double slope = chunk_.error[2 * i + 1] * kRaise + kLost;
    if (chunk_.is_open[i] != 0 || (out_.value_bound != nullptr && !is_narrow(error, slope)))
      return write_pairs(here, i, to);
    ++counts_.fast;
    std::copy_n(chunk_.value.data() + i * components_, components_, out_.value + to * components_);
    if (out_.gradient != nullptr)
      std::copy_n(chunk_.gradient.data() + 3 * i * components_, 3 * components_,
                  out_.gradient + 3 * to * components_);
    if (out_.value_bound == nullptr) return;
    for (std::size_t c = 0; c < components_; ++c) {
      out_.value_bound[to * components_ + c] = bound(error, c);
      for (std::size_t a = 0; out_.gradient_bound != nullptr && a < 3; ++a)
        out_.gradient_bound[3 * (to * components_ + c) + a] = bound(slope, c);
    }
  }

  // With twice the digits; exactly if that is not enough.
  void write_pairs(const FastRegion& here, std::size_t i, std::uint32_t to) {
    internal::FastPairSums sums;
    sums.value.resize(components_);
    if (out_.gradient != nullptr) sums.gradient.resize(3 * components_);
    const DmsPoint point = exact_point(to);
    const double slack = static_cast<double>(4 * here.num_tops + 10) * 0x1p-102;
    for (const auto& unit : here.units) {
      bool is_near = unit->is_own || is_in_box(unit->box, points_[to]);
      for (std::size_t m = 0; m < 4; ++m)
        is_near = is_near && (unit->is_own || chunk_.lambda[m][i] <= unit->high[m]);
      if (is_near) internal::add_pairs(*unit, point, slack, out_.gradient != nullptr, sums);
    }
    if (sums.is_open) return put_off(to, counts_.open_sign);
    const double error = sums.error * kRaise + kLost, slope = sums.slope_error * kRaise + kLost;
    if (!is_narrow(error, slope)) return put_off(to, counts_.wide);
    ++counts_.pairs;
    for (std::size_t c = 0; c < components_; ++c) {
      put_pair(sums.value[c], error, c, out_.value, out_.value_bound, to * components_ + c);
      for (std::size_t a = 0; out_.gradient != nullptr && a < 3; ++a)
        put_pair(sums.gradient[3 * c + a], slope, c, out_.gradient, out_.gradient_bound,
                 3 * (to * components_ + c) + a);
    }
  }
  void put_pair(internal::FastPair x, double error, std::size_t component, double* to,
                double* bounds, std::size_t at) const {
    to[at] = x.hi;
    if (bounds != nullptr) bounds[at] = (bound(error, component) + std::abs(x.lo)) * kRaise;
  }
  double bound(double error, std::size_t component) const {
    const double most = store_.greatest(component);
    return most == 0 ? 0 : error * most * kRaise + kLost;
  }

  void write_outside(std::size_t i) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto fill = [&](double* to, std::size_t size, double x) {
      if (to != nullptr) std::fill_n(to + i * size, size, x);
    };
    fill(out_.value, components_, nan), fill(out_.value_bound, components_, kInfinity);
    fill(out_.gradient, 3 * components_, nan);
    fill(out_.gradient_bound, 3 * components_, kInfinity);
    if (out_.tetrahedron != nullptr) out_.tetrahedron[i] = kNoTetrahedron;
  }

  DmsPoint exact_point(std::uint32_t i) const {
    if (is_rounded_[i] == 0)
      return {Rational::from_double(points_[i].x), Rational::from_double(points_[i].y),
              Rational::from_double(points_[i].z)};
    const auto at = std::lower_bound(exact_.begin(), exact_.end(), i,
                                     [](const auto& p, std::size_t k) { return p.first < k; });
    return at->second;
  }
  void evaluate_exactly(std::uint32_t i) {
    const auto place = evaluator_.locate(exact_point(i));
    if (!place) return write_outside(i);
    const DmsValue value = evaluator_.evaluate(*place);
    if (out_.tetrahedron != nullptr) out_.tetrahedron[i] = place->tetrahedron;
    for (std::size_t c = 0; c < components_; ++c) {
      const std::size_t at = i * components_ + c;
      put(value.value[c], out_.value + at, out_.value_bound, at);
      for (std::size_t a = 0; out_.gradient != nullptr && a < 3; ++a)
        put(value.gradient[c][a], out_.gradient + 3 * at + a, out_.gradient_bound, 3 * at + a);
    }
  }
  static void put(const Rational& x, double* to, double* bounds, std::size_t at) {
    const double nearest = nearest_double(x);
    const bool is_finite = std::isfinite(nearest);
    *to = is_finite ? nearest : std::copysign(std::numeric_limits<double>::max(), nearest);
    if (bounds == nullptr) return;
    Rational off = is_finite ? x - Rational::from_double(nearest) : Rational();
    if (off.sign() == Sign::kNegative) off.negate();
    bounds[at] = is_finite ? round_up(off) : kInfinity;
  }

  FastDmsOptions options_;
  DmsEvaluator evaluator_;
  const FastDmsKernels* kernels_;
  std::size_t components_, exact_first_;
  std::vector<Slot> slots_;  // of the tetrahedra
  internal::FastCells cells_;
  internal::FastStore store_;
  FastDmsCounts counts_;

  // The call at hand.
  std::span<const Vec3d> points_;
  FastDmsOutput out_;
  ExactPoints exact_;
  std::vector<std::uint8_t> is_rounded_;
  std::vector<std::uint32_t> where_, met_, sorted_, exactly_;
  std::vector<double> scratch_;
  FastChunk chunk_;
};

std::array<double, 2> enclosure_of(double value, double bound) {
  if (!(bound < kInfinity)) return {-kInfinity, kInfinity};
  const ScopedDefaultFp nearest;
  // The sum of two numbers and its rounding error.
  const auto outward = [](double a, double b, double away) {
    const double s = a + b, t = s - a, rest = (a - (s - t)) + (b - t);
    return rest * away > 0 ? std::nextafter(s, away * kInfinity) : s;
  };
  return {outward(value, -bound, -1), outward(value, bound, 1)};
}

FastDms::FastDms(const DmsModel& model, const FastDmsOptions& options)
    : work_(std::make_unique<Work>(model, options)) {}
FastDms::~FastDms() = default;
std::size_t FastDms::num_components() const { return work_->components(); }
void FastDms::evaluate(std::span<const Vec3d> points, const FastDmsOutput& out, ExactPoints exact) {
  work_->evaluate(points, out, exact);
}
const FastDmsCounts& FastDms::counts() const { return work_->counts(); }
std::size_t FastDms::num_near(std::uint32_t tetrahedron) { return work_->num_near(tetrahedron); }

}  // namespace veritope
