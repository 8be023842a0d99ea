// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/fold_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "robust/base/random.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/fast/sampled_dms_internal.h"

namespace veritope {
namespace {

constexpr std::size_t kFewestSamples = 16, kMostSamples = 2048;  // of one tetrahedron
constexpr std::size_t kStarts = 8;                               // from which the search goes on
constexpr std::size_t kRounds = 24, kPointsOfRound = 32;
constexpr std::array<double, 3> kScales = {1, 0x1p-3, 0x1p-6};  // of parts at the corners

struct Sample {
  double determinant = HUGE_VAL;
  double reach = 0;  // how far from it the next ones lie
  Vec3d at;
};

class FoldSearch {
 public:
  FoldSearch(const DmsModel& model, const FoldSearchOptions& options)
      : model_(model), options_(options), sampled_(model), evaluator_(model) {}

  std::optional<DmsFold> run(std::uint32_t first) {
    const std::size_t budget = options_.max_points / 2, count = model_.tetrahedra.size() - first;
    const std::size_t each = std::clamp(budget / count, kFewestSamples, kMostSamples);
    for (std::size_t i = 0; i < count && (i + 1) * each <= budget && goes_on(); ++i)
      sample(first + static_cast<std::uint32_t>(i), each);
    const std::vector<Sample> starts = least_;
    for (const Sample& start : starts)
      if (goes_on()) go_down(start);
    return fold_;
  }

 private:
  bool goes_on() const { return !fold_ && sampled_.num_exact() <= options_.max_exact; }

  // Most points are near a face or an edge; the parts at a corner are similar to the tetrahedron.
  void sample(std::uint32_t t, std::size_t count) {
    std::array<Point3d, 4> corners;
    double size = 0;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c) {
        corners[m][c] = nearest_double(model_.knot(model_.tetrahedra[t][m], 0)[c]);
        size = std::max(size, std::abs(corners[m][c] - corners[0][c]));
      }
    points_.clear();
    reaches_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 4> share;
      double sum = 0;
      for (double& s : share) {
        const double u = random_.unit();
        sum += s = u * u * u;
      }
      const double scale = kScales[i % kScales.size()];
      const Point3d& corner = corners[i / kScales.size() % 4];
      Point3d p{};
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t m = 0; m < 4; ++m) p[c] += share[m] / sum * corners[m][c];
        p[c] = corner[c] + scale * (p[c] - corner[c]);
      }
      points_.push_back({p[0], p[1], p[2]});
      reaches_.push_back(scale * size / 8);
    }
    evaluate();
  }

  void go_down(Sample from) {
    for (std::size_t round = 0; round < kRounds && goes_on(); ++round) {
      points_.clear();
      for (std::size_t i = 0; i < kPointsOfRound; ++i) {
        const auto moved = [&](double x) { return x + from.reach * (2 * random_.unit() - 1); };
        points_.push_back({moved(from.at.x), moved(from.at.y), moved(from.at.z)});
      }
      reaches_.assign(kPointsOfRound, from.reach);
      least_.clear();
      evaluate();
      if (!least_.empty() && least_.front().determinant < from.determinant)
        from = least_.front();
      else
        from.reach /= 2;
    }
  }

  // Keeps those with the least determinants in least_; a determinant below 0 is looked at exactly.
  void evaluate() {
    sampled_.evaluate(points_);
    for (std::size_t i = 0; i < points_.size() && !fold_; ++i) {
      const double d = internal::determinant_of(sampled_.derivative(i));
      if (!std::isfinite(d)) continue;  // outside of the domain
      if (d < 0) look_closer(points_[i]);
      least_.push_back({d, reaches_[i], points_[i]});
    }
    std::stable_sort(least_.begin(), least_.end(), [](const Sample& a, const Sample& b) {
      return a.determinant < b.determinant;
    });
    if (least_.size() > kStarts) least_.resize(kStarts);
  }
  // A rounded point, if that will do, is easier to read.
  void look_closer(const Vec3d& p) {
    const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    int exponent = 0;
    std::frexp(most, &exponent);
    for (const int bits : {8, 16, 32}) {
      if (exponent - bits < -1000 || fold_) break;
      const double unit = std::ldexp(1.0, exponent - bits);
      const auto round = [&](double x) { return std::round(x / unit) * unit; };
      examine({round(p.x), round(p.y), round(p.z)});
    }
    if (!fold_) examine(p);
  }
  void examine(const Vec3d& p) {
    const DmsPoint at{Rational::from_double(p.x), Rational::from_double(p.y),
                      Rational::from_double(p.z)};
    const auto place = evaluator_.locate(at);
    if (!place) return;
    const auto g = evaluator_.evaluate(*place).gradient;
    Rational value = dot_product(g[0], cross_product(g[1], g[2]));
    if (value.sign() == Sign::kNegative) fold_ = DmsFold{place->tetrahedron, at, std::move(value)};
  }

  const DmsModel& model_;
  const FoldSearchOptions& options_;
  internal::SampledDms sampled_;
  DmsEvaluator evaluator_;
  Random random_{1};
  std::vector<Vec3d> points_;
  std::vector<double> reaches_;
  std::vector<Sample> least_;
  std::optional<DmsFold> fold_;
};

}  // namespace

std::optional<DmsFold> find_fold(const DmsModel& model, std::uint32_t first,
                                 const FoldSearchOptions& options) {
  return FoldSearch(model, options).run(first);
}

}  // namespace veritope
