// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/improper_pairs.h"

#include <algorithm>
#include <optional>

#include "predicates/triangle_triangle.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/box_tree.h"
#include "solids/polyhedron/separator.h"

namespace veritope {
namespace {

// The work of the box groups per facet: ordinary meshes need 5 to 25.
constexpr std::uint64_t kBudgetPerFacet = 96;

IndexedTriangle indexed(const TriangleMesh& mesh, std::uint32_t f) {
  const auto& t = mesh.faces[f];
  return {{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, {t[0], t[1], t[2]}};
}

// The pairs that one task found: all counted, grouped into places, the least kept.
class Finds {
 public:
  void decide(const TriangleMesh& mesh, std::uint32_t f, std::uint32_t g, std::size_t max_listed) {
    if (is_proper(triangle_triangle(indexed(mesh, f), indexed(mesh, g)))) [[likely]] return;
    ++count_;
    if (!places_) places_.emplace(mesh);
    places_->add(f, g);
    if (max_listed == 0) return;
    const FacetPair pair = std::minmax(f, g);
    if (least_.size() < max_listed) {
      least_.push_back(pair);
      std::push_heap(least_.begin(), least_.end());
    } else if (pair < least_.front()) {
      std::pop_heap(least_.begin(), least_.end());
      least_.back() = pair;
      std::push_heap(least_.begin(), least_.end());
    }
  }
  std::uint64_t count() const { return count_; }
  const std::vector<FacetPair>& least() const { return least_; }
  const std::optional<ImproperPlaces>& places() const { return places_; }

 private:
  std::uint64_t count_ = 0;
  std::vector<FacetPair> least_;  // a heap, greatest first
  std::optional<ImproperPlaces> places_;
};

struct SeparatorWalk {
  const TriangleMesh& mesh;
  const BoxTree& tree;
  std::size_t max_listed;
  SeparatorFinder finder;
  Finds finds;

  bool stop() const { return false; }
  bool node_pair(const TreeRange& a, const TreeRange& b, std::uint64_t) {
    return is_worth_separating(a, b) &&
           finder.find(tree.facets(a), tree.facets(b)).has_value();
  }
  void leaf_pair(std::uint32_t i, std::uint32_t j) {
    finds.decide(mesh, tree.order()[i], tree.order()[j], max_listed);
  }
};

std::vector<Finds> walk_with_separators(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets,
                                        const VertexStars& stars, std::size_t max_listed, unsigned jobs) {
  const BoxTree tree(mesh, median_order(mesh, facets, jobs), stars, jobs);
  const auto parts = tree.parts();
  const double largest = largest_coordinate(mesh);
  std::vector<Finds> finds(parts.size());
  parallel_for(parts.size(), 1, jobs, [&](std::size_t k, std::size_t, std::size_t) {
    const std::size_t i = parts.size() - 1 - k;  // the longest parts are the last ones: they start first
    SeparatorWalk walk{mesh, tree, max_listed, SeparatorFinder(mesh, largest), {}};
    tree.walk(parts[i], walk);
    finds[i] = std::move(walk.finds);
  });
  return finds;
}

}  // namespace

ImproperPairs find_improper_pairs(const TriangleMesh& mesh, const BoxGroups& boxes,
                                  const std::vector<std::uint32_t>& facets, const VertexStars& stars,
                                  std::size_t max_listed, unsigned jobs) {
  ImproperPairs out;
  if (facets.empty()) return out;
  std::vector<Finds> finds(boxes.num_tasks());
  const std::uint64_t budget = kBudgetPerFacet * facets.size() + 4096;
  out.long_thin = !boxes.for_each_overlap(budget, jobs, [&](std::size_t task, std::span<const FacetPair> pairs) {
    for (const auto& [f, g] : pairs) finds[task].decide(mesh, f, g, max_listed);
  });
  if (out.long_thin) finds = walk_with_separators(mesh, facets, stars, max_listed, jobs);
  ImproperPlaces places(mesh);
  for (const Finds& part : finds) {
    if (part.places()) places.add(*part.places());
    out.count += part.count();
    out.first.insert(out.first.end(), part.least().begin(), part.least().end());
  }
  out.places = places.take();
  std::sort(out.first.begin(), out.first.end());
  if (out.first.size() > max_listed) out.first.resize(max_listed);
  return out;
}

}  // namespace veritope
