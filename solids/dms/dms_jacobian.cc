// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_jacobian.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "solids/dms/dms_monotone.h"
#include "solids/dms/dms_region.h"
#include "solids/dms/dms_values.h"

namespace veritope {
namespace {

using Corners = std::array<DmsPoint, 4>;
constexpr std::array<std::array<std::size_t, 2>, 6> kEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

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
        interpolation_(model.degree, 4) {}

  std::variant<std::vector<DmsLeafTree>, DmsOpenLeaf> run() {
    std::vector<DmsLeafTree> trees;
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) {
      trees.emplace_back();
      if (auto open = grow(t, trees.back())) return std::move(*open);
    }
    return trees;
  }

 private:
  struct Node {
    Corners corners;
    int level;
  };

  std::optional<DmsOpenLeaf> grow(std::uint32_t t, DmsLeafTree& tree) {
    const Corners root = knots_.corners(t);
    root_planes_ = face_planes(root);
    std::vector<Node> open{{root, 0}};
    std::size_t leaves = 0;
    while (!open.empty()) {
      const Node node = std::move(open.back());
      open.pop_back();
      if (auto leaf = find_leaf(node.corners)) {
        tree.emplace_back(std::move(*leaf));
        ++leaves;
        continue;
      }
      auto negative = find_negative(node.corners);
      if (negative || node.level == options_.max_levels ||
          leaves + open.size() >= options_.max_leaves)
        return DmsOpenLeaf{t, node.corners, std::move(negative)};
      const int edge = longest_edge(node.corners);
      const auto [i, j] = kEdges[static_cast<std::size_t>(edge)];
      tree.emplace_back(DmsEdgeCut{edge});
      const DmsPoint middle = middle_of(node.corners[i], node.corners[j]);
      Node second{node.corners, node.level + 1}, first = second;
      second.corners[i] = middle;
      first.corners[j] = middle;
      open.push_back(std::move(second));
      open.push_back(std::move(first));
    }
    return std::nullopt;
  }

  std::optional<DmsLeaf> find_leaf(const Corners& corners) {
    std::vector<DmsPlane> planes = face_planes(corners);
    planes.insert(planes.end(), root_planes_.begin(), root_planes_.end());
    DmsRegion region(knots_, {corners.begin(), corners.end()}, planes);
    const std::vector<DmsSupport> supports = region.supports();
    std::vector<const EnclosedMatrix*> all;
    for (const DmsSupport& support : supports) all.push_back(&derivative(support));
    if (auto matrix = find_monotone_matrix(all)) return DmsLeaf{false, std::move(*matrix)};
    if (region.find_cut(supports)) return std::nullopt;
    return find_polynomial_leaf(corners);
  }
  std::optional<DmsLeaf> find_polynomial_leaf(const Corners& corners) {
    const auto values = values_at(evaluator_, interpolation_.points(corners));
    if (!values) return std::nullopt;
    const std::vector<DmsPoint> b = interpolation_.coefficients(*values);
    std::vector<EnclosedMatrix> derivatives;
    for (const TetrahedralIndex& gamma : knots_.gammas()) {
      Corners four;
      for (std::size_t m = 0; m < 4; ++m) four[m] = b[tetrahedral_index(raised(gamma, m))];
      derivatives.emplace_back(linear_part(corners, four));
    }
    std::vector<const EnclosedMatrix*> all;
    for (const EnclosedMatrix& d : derivatives) all.push_back(&d);
    if (auto matrix = find_monotone_matrix(all)) return DmsLeaf{true, std::move(*matrix)};
    return std::nullopt;
  }

  // The barycentre or a corner, if the determinant is below 0 there.
  std::optional<DmsPoint> find_negative(const Corners& corners) {
    std::vector<DmsPoint> points(1);
    for (const DmsPoint& p : corners) {
      points.push_back(p);
      for (std::size_t c = 0; c < 3; ++c) points[0][c] += p[c] / Rational(4);
    }
    for (const DmsPoint& p : points)
      if (const auto place = evaluator_.locate(p);
          place && determinant_of_gradient(evaluator_.evaluate(*place)).sign() == Sign::kNegative)
        return p;
    return std::nullopt;
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
  SimplexInterpolation interpolation_;
  std::vector<DmsPlane> root_planes_;
  std::unordered_map<std::uint64_t, EnclosedMatrix> derivatives_;
};

}  // namespace

std::variant<std::vector<DmsLeafTree>, DmsOpenLeaf> prove_jacobian(
    const DmsModel& model, const JacobianSearchOptions& options) {
  return JacobianProof(model, options).run();
}

}  // namespace veritope
