// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/overlap_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "robust/base/random.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_covering.h"
#include "solids/dms/fast/dms_inverse_internal.h"
#include "solids/dms/fast/sampled_dms_internal.h"

namespace veritope {
namespace {

constexpr std::size_t kMostOfTetrahedron = 64;  // of one tetrahedron
constexpr int kShareBits = 8;                   // of the barycentric coordinates of samples
constexpr int kMostSteps = 24;                  // of Newton's iteration
constexpr double kFarthest = 4;                 // a step of it, in tetrahedra
constexpr double kDone = 0x1p-40;               // the last one
constexpr double kApart = 0x1p-16;              // between two preimages
constexpr int kLeastLevel = 2, kMostLevel = 32,
              kLevelsAtOnce = 3;  // of small tetrahedra: 2^-level of the large one
constexpr int kPlaceBits = 6;     // of their middles, beyond the level

using internal::minus;
using internal::PlainMatrix;

Point3d product(const PlainMatrix& m, const Point3d& v) {
  Point3d out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[i] += m[3 * i + k] * v[k];
  return out;
}
double greatest_of(const Point3d& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

// The greatest of several numbers says nothing of a NaN among them, and a norm may overflow.
template <std::size_t N>
bool are_finite(const std::array<double, N>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

struct ImageSample {
  std::uint32_t tetrahedron = 0;
  std::array<int, 4> shares{};  // barycentric coordinates, times 2^kShareBits
  Point3d at{}, image{};
  PlainMatrix derivative{};
};

// Sample a has its image near that of b. The greater the score, the less likely is it that they are neighbours.
struct SamplePair {
  double score = 0;
  std::uint32_t a = 0, b = 0;
};

// A tetrahedron of the domain. Distances in it are changes of barycentric coordinates, which affine maps keep.
struct Frame {
  Point3d corner;
  PlainMatrix edges, to_shares;  // columns; the inverse
};

class OverlapSearch {
 public:
  OverlapSearch(const DmsModel& model, const OverlapSearchOptions& options)
      : model_(model),
        options_(options),
        sampled_(model),
        knots_(model),
        evaluator_(model),
        covering_(model, knots_, evaluator_) {}

  std::optional<DmsCoveredPlace> run() {
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) frames_.push_back(frame_of(t));
    each_ = std::clamp(options_.max_points / model_.tetrahedra.size(), std::size_t{1},
                       kMostOfTetrahedron);
    for (std::uint32_t t = 0; t < model_.tetrahedra.size() && goes_on(); ++t) {
      if (samples_.size() + each_ > options_.max_points) break;
      sample(t);
    }
    std::vector<Box3d> boxes;
    for (const ImageSample& s : samples_) boxes.push_back(neighbourhood(s));
    const BoxHierarchy tree(boxes);
    for (std::uint32_t a = 0; a < samples_.size(); ++a) {
      const Box3d at{samples_[a].image, samples_[a].image};
      tree.visit([&](const Box3d& box) { return is_inside(at, box); },
                 [&](std::uint32_t b) { add_pair(a, b); });
    }
    keep_best_pairs();
    for (const SamplePair& pair : pairs_)
      if (goes_on()) seek_preimage(samples_[pair.a], samples_[pair.b]);
    return found_;
  }

 private:
  bool goes_on() const {
    return !found_ && sampled_.num_exact() <= options_.max_exact && places_ < options_.max_places;
  }

  Frame frame_of(std::uint32_t t) const {
    const auto corners = knots_.corners(t);
    Frame out;
    for (std::size_t c = 0; c < 3; ++c) {
      out.corner[c] = nearest_double(corners[0][c]);
      for (std::size_t m = 0; m < 3; ++m)
        out.edges[3 * c + m] = nearest_double(corners[m + 1][c] - corners[0][c]);
    }
    out.to_shares = internal::inverse_of(out.edges).value_or(PlainMatrix{});
    return out;
  }
  DmsPoint point_of(std::uint32_t t, const std::array<int, 4>& shares, int bits) const {
    const auto corners = knots_.corners(t);
    DmsPoint out;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c)
        out[c] += Rational(shares[m]) * Rational::power_of_two(-bits) * corners[m][c];
    return out;
  }

  void sample(std::uint32_t t) {
    points_.clear();
    std::vector<ImageSample> made;
    for (std::size_t i = 0; i < each_; ++i) {
      ImageSample s;
      s.tetrahedron = t;
      do {
        s.shares[0] = 1 << kShareBits;
        for (std::size_t m = 1; m < 4; ++m) {
          s.shares[m] = static_cast<int>(random_.below(1 << kShareBits));
          s.shares[0] -= s.shares[m];
        }
      } while (s.shares[0] <= 0);
      const Frame& f = frames_[t];
      const double unit = std::ldexp(1.0, -kShareBits);
      s.at = product(f.edges, {s.shares[1] * unit, s.shares[2] * unit, s.shares[3] * unit});
      for (std::size_t c = 0; c < 3; ++c) s.at[c] += f.corner[c];
      made.push_back(s);
      points_.push_back({s.at[0], s.at[1], s.at[2]});
    }
    sampled_.evaluate(points_);
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i].image = sampled_.image(i);
      made[i].derivative = sampled_.derivative(i);
      if (are_finite(made[i].image) && are_finite(made[i].derivative)) samples_.push_back(made[i]);
    }
  }
  // Around the image of what is nearer to this sample than to most others.
  Box3d neighbourhood(const ImageSample& s) const {
    const double reach = 1 / std::cbrt(static_cast<double>(each_));
    const PlainMatrix along = internal::multiplied(s.derivative, frames_[s.tetrahedron].edges);
    Box3d out{s.image, s.image};
    for (std::size_t c = 0; c < 3; ++c) {
      double width = 0;
      for (std::size_t m = 0; m < 3; ++m) width += std::abs(along[3 * c + m]);
      out.lo[c] -= width * reach, out.hi[c] += width * reach;
    }
    return out;
  }

  void add_pair(std::uint32_t first, std::uint32_t second) {
    const ImageSample &a = samples_[first], &b = samples_[second];
    const auto back = internal::inverse_of(b.derivative);
    if (first == second || !back) return;
    const PlainMatrix& to_shares = frames_[b.tetrahedron].to_shares;
    const Point3d step = product(*back, minus(a.image, b.image)), apart = minus(a.at, b.at);
    const double distance = greatest_of(product(to_shares, apart));
    // Where the derivative leads from b back to a, it is likely that a is the only preimage nearby.
    if (!(greatest_of(product(to_shares, minus(apart, step))) > distance / 2)) return;
    const double score = distance / greatest_of(product(to_shares, step));
    if (!(score > 0)) return;
    if (pairs_.size() >= 4 * options_.max_pairs) keep_best_pairs();
    pairs_.push_back({score, first, second});
  }
  void keep_best_pairs() {
    std::sort(pairs_.begin(), pairs_.end(), [](const SamplePair& p, const SamplePair& q) {
      return std::tie(q.score, p.a, p.b) < std::tie(p.score, q.a, q.b);
    });
    if (pairs_.size() > options_.max_pairs) pairs_.resize(options_.max_pairs);
  }
  // Seeks a preimage of a's image near b.
  void seek_preimage(const ImageSample& a, const ImageSample& b) {
    const PlainMatrix& to_shares = frames_[b.tetrahedron].to_shares;
    const auto v = preimage(a.image, b.at, to_shares);
    if (!v || greatest_of(product(to_shares, minus(*v, a.at))) < kApart) return;
    ++places_;
    show(a, *v);
  }
  std::optional<Point3d> preimage(const Point3d& x, Point3d from, const PlainMatrix& to_shares) {
    for (int i = 0; i < kMostSteps; ++i) {
      points_.assign(1, {from[0], from[1], from[2]});
      sampled_.evaluate(points_);
      const auto back = internal::inverse_of(sampled_.derivative(0));
      if (!back) return std::nullopt;
      const Point3d step = product(*back, minus(x, sampled_.image(0)));
      const double size = greatest_of(product(to_shares, step));
      if (!(size < kFarthest)) return std::nullopt;
      if (size < kDone) return from;
      for (std::size_t c = 0; c < 3; ++c) from[c] += step[c];
    }
    return std::nullopt;
  }

  void show(const ImageSample& a, const Point3d& v) {
    const auto place = evaluator_.locate(
        {Rational::from_double(v[0]), Rational::from_double(v[1]), Rational::from_double(v[2])});
    if (!place) return;
    DmsCoveredPlace out;
    out.at = point_of(a.tetrahedron, a.shares, kShareBits);
    out.tetrahedron_of_point = a.tetrahedron;
    out.tetrahedron = place->tetrahedron;
    const auto at = evaluator_.locate(out.at);
    if (!at) return;
    const DmsValue value = evaluator_.evaluate(*at);
    const DmsPoint x{value.value[0], value.value[1], value.value[2]};
    const Frame& f = frames_[out.tetrahedron];
    const Point3d shares = product(f.to_shares, minus(v, f.corner));
    for (int level = kLeastLevel; level <= kMostLevel; level += kLevelsAtOnce) {
      if (!make_corners(level, shares, out)) continue;
      if (contains(out.corners, out.at) || !covering_.covers(out.tetrahedron, out.corners, x))
        continue;
      found_ = std::move(out);
      return;
    }
  }
  // A tetrahedron similar to the large one, around the place with these coordinates; false if it does not fit.
  bool make_corners(int level, const Point3d& shares, DmsCoveredPlace& out) const {
    const int bits = level + kPlaceBits;
    std::array<Rational, 4> middle{Rational(1)};
    const Rational unit = Rational::power_of_two(-bits);
    for (std::size_t m = 1; m < 4; ++m) {
      const double rounded = std::round(std::ldexp(shares[m - 1], bits));
      middle[m] = Rational::from_double(rounded) * unit;
      middle[0] -= middle[m];
    }
    const auto large = knots_.corners(out.tetrahedron);
    const Rational quarter = Rational::power_of_two(-2), size = Rational::power_of_two(-level);
    for (const Rational& x : middle)
      if (x < quarter * size) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      out.corners[i] = {};
      for (std::size_t m = 0; m < 4; ++m) {
        const Rational share = middle[m] + size * (Rational(m == i ? 1 : 0) - quarter);
        for (std::size_t c = 0; c < 3; ++c) out.corners[i][c] += share * large[m][c];
      }
    }
    return true;
  }

  const DmsModel& model_;
  const OverlapSearchOptions& options_;
  internal::SampledDms sampled_;
  DmsKnotTable knots_;
  DmsEvaluator evaluator_;
  DmsCovering covering_;
  Random random_{1};
  std::size_t each_ = 1, places_ = 0;
  std::vector<Frame> frames_;
  std::vector<ImageSample> samples_;
  std::vector<SamplePair> pairs_;
  std::vector<Vec3d> points_;
  std::optional<DmsCoveredPlace> found_;
};

}  // namespace

std::optional<DmsCoveredPlace> find_overlap(const DmsModel& model,
                                            const OverlapSearchOptions& options) {
  return OverlapSearch(model, options).run();
}

}  // namespace veritope
