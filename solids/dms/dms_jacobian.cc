// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_jacobian.h"

#include <algorithm>
#include <map>
#include <queue>
#include <unordered_map>
#include <utility>

#include "solids/dms/dms_determinant.h"
#include "solids/dms/dms_monotone.h"
#include "solids/dms/dms_piece.h"
#include "solids/dms/dms_region.h"

namespace veritope {
namespace {

using Corners = std::array<DmsPoint, 4>;
constexpr std::array<std::array<std::size_t, 2>, 6> kEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

constexpr int kMostSampledLevels = 60;

Rational squared_length(const DmsPoint& a, const DmsPoint& b) {
  const DmsPoint d = difference(a, b);
  return dot_product(d, d);
}
int longest_edge(const Corners& corners) {
  int found = 0;
  Rational most(-1);
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = kEdges[static_cast<std::size_t>(e)];
    Rational length = squared_length(corners[i], corners[j]);
    if (length > most) most = std::move(length), found = e;
  }
  return found;
}
DmsPoint middle_of(const DmsPoint& a, const DmsPoint& b) {
  DmsPoint out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = (a[c] + b[c]) / Rational(2);
  return out;
}
Rational determinant_of_gradient(const DmsValue& value) {
  const auto& g = value.gradient;
  return dot_product(g[0], cross_product(g[1], g[2]));
}

class JacobianProof {
 public:
  JacobianProof(const DmsModel& model, const JacobianSearchOptions& options)
      : model_(model),
        options_(options),
        knots_(model),
        evaluator_(model),
        pieces_(model, evaluator_) {}

  std::variant<std::vector<DmsLeafTree>, DmsOpenLeaf> run() {
    std::vector<DmsLeafTree> trees;
    for (std::uint32_t t = 0; t < model_.tetrahedra.size() && !refuted_ && !open_; ++t) {
      trees.emplace_back();
      grow(t, trees.back());
    }
    if (open_ && !refuted_) seek_negative(static_cast<std::uint32_t>(trees.size()) - 1);
    if (refuted_) return std::move(*refuted_);
    if (open_) return std::move(*open_);
    return trees;
  }

 private:
  struct Node {
    Corners corners;
    int level;
    bool is_positive = false;  // the determinant is known to be
  };
  // What is found of a part without a leaf.
  enum class Next { kCut, kOpen, kRefuted };
  // A part of a tetrahedron, with the least determinant that was met there.
  struct Sampled {
    double least = 0;
    std::uint32_t tetrahedron = 0;
    Node node;
  };

  void begin(std::uint32_t t) {
    root_planes_ = face_planes(knots_.corners(t));
    root_ = t;
  }
  void grow(std::uint32_t t, DmsLeafTree& tree) {
    begin(t);
    values_.clear();
    std::vector<Node> todo{{knots_.corners(t), 0}};
    std::size_t leaves = 0;
    while (!todo.empty()) {
      Node node = std::move(todo.back());
      todo.pop_back();
      std::optional<TetrahedralPolynomial> determinant;
      if (auto leaf = find_leaf(node.corners, determinant)) {
        tree.emplace_back(std::move(*leaf));
        ++leaves;
        continue;
      }
      const Next next = look_at(t, node, determinant);
      if (next == Next::kRefuted) return;
      if (next == Next::kOpen || node.level == options_.max_levels ||
          leaves + todo.size() >= options_.max_leaves) {
        open_ = DmsOpenLeaf{t, node.corners, std::nullopt, {}, false};
        return;
      }
      const int edge = longest_edge(node.corners);
      tree.emplace_back(DmsEdgeCut{edge});
      auto [first, second] = halves(node, edge);
      todo.push_back(std::move(second));
      todo.push_back(std::move(first));
    }
  }
  static std::pair<Node, Node> halves(const Node& node, int edge) {
    const auto [i, j] = kEdges[static_cast<std::size_t>(edge)];
    const DmsPoint middle = middle_of(node.corners[i], node.corners[j]);
    Node second{node.corners, node.level + 1, node.is_positive}, first = second;
    second.corners[i] = middle;
    first.corners[j] = middle;
    return {std::move(first), std::move(second)};
  }

  // A negative determinant in this tetrahedron or a later one. Parts take turns: the one with the least sample, then
  // the one that waits longest. A part never has a greater sample than its halves that keep the corner, so the least
  // samples alone would lead into one corner for ever.
  void seek_negative(std::uint32_t first) {
    std::vector<std::optional<Sampled>> parts;
    std::priority_queue<std::pair<double, std::size_t>> by_sample;  // the sample's opposite
    const auto add = [&](std::uint32_t t, const Node& node) {
      const double least = sample(t, node);
      by_sample.emplace(-least, parts.size());
      parts.push_back(Sampled{least, t, node});
    };
    std::size_t looked_at = 0, oldest = 0;
    for (std::uint32_t t = first; t < model_.tetrahedra.size() && !refuted_; ++t) {
      if (looked_at++ >= options_.max_sampled) break;
      begin(t);
      const Node node{knots_.corners(t), 0};
      std::optional<TetrahedralPolynomial> determinant;
      if (t == first || !find_leaf(node.corners, determinant)) add(t, node);
    }
    for (; !refuted_ && looked_at < options_.max_sampled; ++looked_at) {
      while (!by_sample.empty() && !parts[by_sample.top().second]) by_sample.pop();
      if (by_sample.empty()) return;
      while (!parts[oldest]) ++oldest;
      const std::size_t at = looked_at % 2 == 0 ? oldest : by_sample.top().second;
      const Sampled next = std::move(*parts[at]);
      parts[at].reset();
      if (next.tetrahedron != root_) begin(next.tetrahedron);
      if (seek_in(next.tetrahedron, next.node)) continue;
      auto [a, b] = halves(next.node, longest_edge(next.node.corners));
      for (const Node* const half : {&a, &b})
        if (half->level <= kMostSampledLevels && !refuted_) add(next.tetrahedron, *half);
    }
  }
  // Whether all is known of the part, or a negative determinant is found.
  bool seek_in(std::uint32_t t, Node node) {
    const auto determinant = polynomial_determinant(node.corners);
    if (!determinant) return follow_cell(t, node);
    look_at(t, node, determinant);
    return true;
  }
  // The map is one polynomial in the cell of a point inside; where this polynomial has a negative determinant in the
  // part, the map may have one.
  bool follow_cell(std::uint32_t t, const Node& node) {
    const std::array<Rational, 4> shares{Rational(5) / Rational(26), Rational(6) / Rational(26),
                                         Rational(7) / Rational(26), Rational(8) / Rational(26)};
    DmsPoint middle;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c) middle[c] += shares[m] * node.corners[m][c];
    for (const int level : {4, 10, 24}) {
      const Rational size = Rational::power_of_two(-level), more = Rational::power_of_two(level);
      Corners cell;
      std::array<std::array<Rational, 4>, 4> outer;
      for (std::size_t m = 0; m < 4; ++m) {
        for (std::size_t c = 0; c < 3; ++c)
          cell[m][c] = middle[c] + size * (node.corners[m][c] - middle[c]);
        for (std::size_t k = 0; k < 4; ++k)
          outer[m][k] = shares[k] + more * (Rational(m == k ? 1 : 0) - shares[k]);
      }
      if (is_cut(cell)) continue;
      const auto coefficients = pieces_.coefficients(cell);
      if (!coefficients) return false;
      std::vector<DmsPoint> wide(coefficients->size());
      for (std::size_t c = 0; c < 3; ++c) {
        std::vector<Rational> one;
        for (const DmsPoint& p : *coefficients) one.push_back(p[c]);
        const TetrahedralPolynomial there =
            TetrahedralPolynomial(model_.degree, std::move(one)).on(outer);
        for (std::size_t i = 0; i < wide.size(); ++i) wide[i][c] = there.coefficients()[i];
      }
      const TetrahedralPolynomial determinant =
          determinant_of(model_.degree - 1, derivatives_of(node.corners, wide));
      const NegativePlace found = find_negative(determinant, options_.max_parts / 16);
      return found.at && is_refuted(t, node, place_of(node.corners, *found.at));
    }
    return false;
  }
  bool is_cut(const Corners& corners) const {
    std::vector<DmsPlane> planes = face_planes(corners);
    planes.insert(planes.end(), root_planes_.begin(), root_planes_.end());
    DmsRegion region(knots_, {corners.begin(), corners.end()}, planes);
    return region.find_cut(region.supports()).has_value();
  }
  static DmsPoint place_of(const Corners& corners, const std::array<Rational, 4>& shares) {
    DmsPoint at;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c) at[c] += shares[m] * corners[m][c];
    return at;
  }
  std::optional<TetrahedralPolynomial> polynomial_determinant(const Corners& corners) {
    if (is_cut(corners)) return std::nullopt;
    const auto derivatives = polynomial_derivatives(corners);
    if (!derivatives) return std::nullopt;
    return determinant_of(model_.degree - 1, *derivatives);
  }

  // `determinant` becomes that on the part if the map is one polynomial there.
  std::optional<DmsLeaf> find_leaf(const Corners& corners,
                                   std::optional<TetrahedralPolynomial>& determinant) {
    std::vector<DmsPlane> planes = face_planes(corners);
    planes.insert(planes.end(), root_planes_.begin(), root_planes_.end());
    DmsRegion region(knots_, {corners.begin(), corners.end()}, planes);
    const std::vector<DmsSupport> supports = region.supports();
    std::vector<const EnclosedMatrix*> all;
    for (const DmsSupport& support : supports) all.push_back(&derivative(support));
    if (auto matrix = find_monotone_matrix(all, corners)) return DmsLeaf{false, std::move(*matrix)};
    if (region.find_cut(supports)) return std::nullopt;
    return find_polynomial_leaf(corners, determinant);
  }
  std::optional<DmsLeaf> find_polynomial_leaf(const Corners& corners,
                                              std::optional<TetrahedralPolynomial>& determinant) {
    const auto exact = polynomial_derivatives(corners);
    if (!exact) return std::nullopt;
    const std::vector<EnclosedMatrix> derivatives(exact->begin(), exact->end());
    std::vector<const EnclosedMatrix*> all;
    for (const EnclosedMatrix& d : derivatives) all.push_back(&d);
    if (auto matrix = find_monotone_matrix(all, corners)) return DmsLeaf{true, std::move(*matrix)};
    determinant = determinant_of(model_.degree - 1, *exact);
    return std::nullopt;
  }
  // The Bernstein coefficients of the map, and of its derivative. REQUIRES that it is one polynomial there.
  std::optional<std::vector<DmsMatrix>> polynomial_derivatives(const Corners& corners) {
    const auto coefficients = pieces_.coefficients(corners);
    if (!coefficients) return std::nullopt;
    return derivatives_of(corners, *coefficients);
  }
  std::vector<DmsMatrix> derivatives_of(const Corners& corners,
                                        const std::vector<DmsPoint>& coefficients) const {
    std::vector<DmsMatrix> out;
    for (const TetrahedralIndex& gamma : knots_.gammas()) {
      Corners four;
      for (std::size_t m = 0; m < 4; ++m)
        four[m] = coefficients[tetrahedral_index(raised(gamma, m))];
      out.push_back(linear_part(corners, four));
    }
    return out;
  }

  // Seeks a negative determinant in a part without a leaf.
  Next look_at(std::uint32_t t, Node& node,
               const std::optional<TetrahedralPolynomial>& determinant) {
    if (node.is_positive) return Next::kCut;
    if (!determinant) {
      sample(t, node);
      return refuted_ ? Next::kRefuted : Next::kCut;
    }
    const auto& all = determinant->coefficients();
    if (std::all_of(all.begin(), all.end(),
                    [](const Rational& c) { return c.sign() == Sign::kZero; })) {
      refuted_ = DmsOpenLeaf{t, node.corners, std::nullopt, {}, true};
      return Next::kRefuted;
    }
    const NegativePlace found = find_negative(*determinant, options_.max_parts);
    node.is_positive = found.is_positive;
    if (!found.at) return found.is_positive ? Next::kCut : Next::kOpen;
    return is_refuted(t, node, place_of(node.corners, *found.at)) ? Next::kRefuted : Next::kOpen;
  }
  // The least determinant at the barycentre and the corners, rounded; refuted_ if it is below 0.
  double sample(std::uint32_t t, const Node& node) {
    DmsPoint middle;
    for (const DmsPoint& p : node.corners)
      for (std::size_t c = 0; c < 3; ++c) middle[c] += p[c] * Rational::power_of_two(-2);
    double least = value_at(t, node, middle);
    for (const DmsPoint& p : node.corners)
      if (!refuted_) least = std::min(least, value_at(t, node, p));
    return least;
  }
  double value_at(std::uint32_t t, const Node& node, const DmsPoint& p) {
    const auto found = values_.find(p);
    if (found != values_.end()) return found->second;
    return values_[p] = refuted_by(t, node, p).value_or(0);
  }
  bool is_refuted(std::uint32_t t, const Node& node, const DmsPoint& p) {
    return refuted_by(t, node, p).has_value() && refuted_;
  }
  // The determinant there, rounded; refuted_ if it is below 0. Nothing outside of the domain.
  std::optional<double> refuted_by(std::uint32_t t, const Node& node, const DmsPoint& p) {
    const auto place = evaluator_.locate(p);
    if (!place) return std::nullopt;
    Rational value = determinant_of_gradient(evaluator_.evaluate(*place));
    const double rounded = nearest_double(value);
    if (value.sign() == Sign::kNegative)
      refuted_ = DmsOpenLeaf{t, node.corners, p, std::move(value), false};
    return rounded;
  }

  const EnclosedMatrix& derivative(const DmsSupport& support) {
    const std::uint64_t key =
        support.tetrahedron * knots_.gammas().size() + tetrahedral_index(support.gamma);
    const auto found = derivatives_.find(key);
    if (found != derivatives_.end()) return found->second;
    return derivatives_.emplace(key, EnclosedMatrix(knots_.derivative(support))).first->second;
  }

  const DmsModel& model_;
  const JacobianSearchOptions& options_;
  DmsKnotTable knots_;
  DmsEvaluator evaluator_;
  DmsPieces pieces_;
  std::vector<DmsPlane> root_planes_;
  std::unordered_map<std::uint64_t, EnclosedMatrix> derivatives_;
  std::uint32_t root_ = 0;             // to which root_planes_ belong
  std::map<DmsPoint, double> values_;  // determinants at samples
  std::optional<DmsOpenLeaf> open_, refuted_;
};

}  // namespace

std::variant<std::vector<DmsLeafTree>, DmsOpenLeaf> prove_jacobian(
    const DmsModel& model, const JacobianSearchOptions& options) {
  return JacobianProof(model, options).run();
}

}  // namespace veritope
