// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/improper_pairs.h"

#include <algorithm>
#include <optional>
#include <span>

#include "predicates/triangle_triangle.h"
#include "robust/base/parallel.h"
#include "robust/base/work_share.h"
#include "solids/polyhedron/approx_overlap.h"
#include "solids/polyhedron/box_tree.h"
#include "solids/polyhedron/facet_meetings.h"
#include "solids/polyhedron/separator.h"

namespace veritope {
namespace {

// The work of the box groups per facet: ordinary meshes need 5 to 25.
constexpr std::uint64_t kBudgetPerFacet = 96;

IndexedTriangle indexed(const TriangleMesh& mesh, std::uint32_t f) {
  const auto& t = mesh.faces[f];
  return {{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, {t[0], t[1], t[2]}};
}

// Calls visit(pair) for pairs of two different faces, one of each group, ascending, as long as it returns true. Both
// groups ascend; they are the same one, or have no face in common.
template <typename Visit>
void for_each_pair(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, Visit visit) {
  std::size_t i = 0, k = 0;
  const bool is_one = a.data() == b.data();
  while (i < a.size() || (!is_one && k < b.size())) {
    const bool is_first = is_one || k == b.size() || (i < a.size() && a[i] < b[k]);
    const std::uint32_t f = is_first ? a[i++] : b[k++];
    const std::span<const std::uint32_t> others =
        is_one ? a.subspan(i) : is_first ? b.subspan(k) : a.subspan(i);
    for (const std::uint32_t g : others)
      if (!visit(FacetPair{f, g})) return;
  }
}

// A pair with its place in the list. Copies cover each other, and M2 lists them: they come last, so that the first of
// the list, a certificate's witness of M7, is another pair if there is one.
struct ListedPair {
  FacetPair pair;
  double size = 0;  // approximate; for the order alone
  bool is_of_copies = false;

  bool precedes(const ListedPair& other) const {
    if (is_of_copies != other.is_of_copies) return other.is_of_copies;
    return size != other.size ? size > other.size : pair < other.pair;
  }
};
constexpr auto kPrecedes = [](const ListedPair& a, const ListedPair& b) { return a.precedes(b); };

// REQUIRES f < g.
double approx_size(const TriangleMesh& mesh, std::uint32_t f, std::uint32_t g) {
  return approx_common_extent(indexed(mesh, f).point, indexed(mesh, g).point);
}

std::vector<FacetPair> first_of(std::vector<ListedPair> list, std::size_t max_listed) {
  std::sort(list.begin(), list.end(), kPrecedes);
  if (list.size() > max_listed) list.resize(max_listed);
  std::vector<FacetPair> out;
  out.reserve(list.size());
  for (const ListedPair& listed : list) out.push_back(listed.pair);
  return out;
}

// The pairs that one task found: all counted, grouped into places; kept are the first kMostUnordered without their
// sizes, and once there are more, or if there are copies, the largest.
class Finds {
 public:
  Finds() = default;
  Finds(const TriangleMesh& mesh, const FaceCopies& copies, std::size_t max_listed)
      : mesh_(&mesh),
        copies_(&copies),
        max_listed_(max_listed),
        is_ordered_(!copies.groups().empty()) {}

  void decide(std::uint32_t f, std::uint32_t g) {
    if (is_proper(triangle_triangle(indexed(*mesh_, f), indexed(*mesh_, g)))) [[likely]] return;
    const auto group = [&](const std::uint32_t& face) {
      const std::span<const std::uint32_t> all = copies_->of(face);
      return all.empty() ? std::span(&face, 1) : all;
    };
    add(group(f), group(g), copies_->count(f) * copies_->count(g), false);
  }
  // The pairs of one group among themselves.
  void add_copies(const FaceCopies::Group& group) {
    add(group, group, std::uint64_t{group.size()} * (group.size() - 1) / 2, true);
    for (const std::uint32_t face : group) places_->add_face(face);
  }
  std::uint64_t count() const { return count_; }
  void order() {
    if (is_ordered_) return;
    is_ordered_ = true;
    for (const auto& [f, g] : unordered_) keep({{f, g}, approx_size(*mesh_, f, g), false});
    unordered_ = {};
  }
  const std::vector<FacetPair>& unordered() const { return unordered_; }
  const std::vector<ListedPair>& largest() const { return largest_; }
  const std::optional<ImproperPlaces>& places() const { return places_; }

 private:
  void add(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, std::uint64_t pairs,
           bool are_copies) {
    count_ += pairs;
    if (!places_) places_.emplace(*mesh_);
    const std::uint32_t f = a.front(), g = are_copies ? b[1] : b.front();
    places_->add(f, g, pairs);
    if (max_listed_ == 0) return;
    if (!is_ordered_ && unordered_.size() == kMostUnordered) order();
    if (!is_ordered_) {
      unordered_.emplace_back(std::min(f, g), std::max(f, g));
      return;
    }
    ListedPair listed{{}, approx_size(*mesh_, std::min(f, g), std::max(f, g)), are_copies};
    for_each_pair(a, b, [&](const FacetPair& pair) {
      listed.pair = pair;
      return keep(listed);
    });
  }
  // Whether a greater pair of the same size may be kept after this one.
  bool keep(const ListedPair& pair) {
    if (largest_.size() < max_listed_) {
      largest_.push_back(pair);
      std::push_heap(largest_.begin(), largest_.end(), kPrecedes);
    } else if (pair.precedes(largest_.front())) {
      std::pop_heap(largest_.begin(), largest_.end(), kPrecedes);
      largest_.back() = pair;
      std::push_heap(largest_.begin(), largest_.end(), kPrecedes);
    } else {
      return false;
    }
    return true;
  }

  const TriangleMesh* mesh_ = nullptr;
  const FaceCopies* copies_ = nullptr;
  std::size_t max_listed_ = 0;
  bool is_ordered_ = false;
  std::uint64_t count_ = 0;
  std::vector<FacetPair> unordered_;
  std::vector<ListedPair> largest_;  // a heap; the last one of the list is in front
  std::optional<ImproperPlaces> places_;
};

struct SeparatorWalk {
  const TriangleMesh& mesh;
  const BoxTree& tree;
  SeparatorFinder finder;
  Finds finds;

  bool stop() const { return false; }
  bool node_pair(const TreeRange& a, const TreeRange& b, std::uint64_t) {
    return is_worth_separating(a, b) &&
           finder.find(tree.facets(a), tree.facets(b)).has_value();
  }
  void leaf_pair(std::uint32_t i, std::uint32_t j) {
    finds.decide(tree.order()[i], tree.order()[j]);
  }
};

std::vector<Finds> walk_with_separators(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets,
                                        const VertexStars& stars, const Finds& none, unsigned jobs,
                                        WorkShare* work) {
  const BoxTree tree(mesh, median_order(mesh, facets, jobs), stars, jobs);
  const auto parts = tree.parts();
  const double largest = largest_coordinate(mesh);
  std::vector<Finds> finds(parts.size());
  WorkStep step(work, static_cast<double>(parts.size()));
  parallel_for(parts.size(), 1, jobs, [&](std::size_t k, std::size_t, std::size_t) {
    const std::size_t i = parts.size() - 1 - k;  // the longest parts are the last ones: they start first
    SeparatorWalk walk{mesh, tree, SeparatorFinder(mesh, largest), none};
    tree.walk(parts[i], walk);
    finds[i] = std::move(walk.finds);
    step.add(1);
  });
  return finds;
}

}  // namespace

ImproperPairs find_improper_pairs(const TriangleMesh& mesh, const BoxGroups& boxes,
                                  const std::vector<std::uint32_t>& facets, const VertexStars& stars,
                                  std::size_t max_listed, unsigned jobs, const FaceCopies& copies,
                                  WorkShare* work, MeetingCollector* collector) {
  ImproperPairs out;
  out.is_ordered = max_listed == 0 || !copies.groups().empty();
  if (facets.empty()) return out;
  const Finds none(mesh, copies, max_listed);
  std::vector<Finds> finds(boxes.num_tasks(), none);
  const std::uint64_t budget = kBudgetPerFacet * facets.size() + 4096;
  out.long_thin = !boxes.for_each_overlap(budget, jobs, [&](std::size_t task, std::span<const FacetPair> pairs) {
    const auto decide = [&](std::uint32_t f, std::uint32_t g) { finds[task].decide(f, g); };
    if (collector != nullptr) return collector->take(task, pairs, decide);
    for (const auto& [f, g] : pairs) decide(f, g);
  }, work);
  if (out.long_thin) finds = walk_with_separators(mesh, facets, stars, none, jobs, work);
  finds.push_back(none);
  for (const FaceCopies::Group& group : copies.groups()) finds.back().add_copies(group);
  ImproperPlaces places(mesh);
  for (const Finds& part : finds) {
    if (part.places()) places.add(*part.places());
    out.count += part.count();
  }
  out.places = places.take();
  out.is_ordered = out.is_ordered || out.count > kMostUnordered;
  std::vector<ListedPair> largest;
  for (Finds& part : finds) {
    if (out.is_ordered) part.order();
    largest.insert(largest.end(), part.largest().begin(), part.largest().end());
    out.pairs.insert(out.pairs.end(), part.unordered().begin(), part.unordered().end());
  }
  if (out.is_ordered) out.pairs = first_of(std::move(largest), max_listed);
  return out;
}

std::vector<FacetPair> largest_pairs(const TriangleMesh& mesh, const std::vector<FacetPair>& pairs,
                                     std::size_t max_listed) {
  std::vector<ListedPair> list;
  list.reserve(pairs.size());
  for (const auto& [f, g] : pairs) list.push_back({{f, g}, approx_size(mesh, f, g), false});
  return first_of(std::move(list), max_listed);
}

}  // namespace veritope
