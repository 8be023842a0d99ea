// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/patch_tree.h"

#include <algorithm>

#include "interval/enclosure/net_internal.h"

namespace veritope {
namespace {

double middle(double a, double b) { return a + 0.5 * (b - a); }

/// Which part of the way from a to b lies before m.
Interval fraction(double m, double a, double b) {
  return (Interval(m) - Interval(a)) / (Interval(b) - Interval(a));
}

}  // namespace

PatchTree::PatchTree(const EnclosedSurface& surface) : surface_(surface) {
  Node root{};
  root.i1 = static_cast<std::uint32_t>(surface.num_spans(0));
  root.j1 = static_cast<std::uint32_t>(surface.num_spans(1));
  nodes_.push_back(root);
  build_groups(kRoot);
}

void PatchTree::build_groups(Id id) {
  Node n = nodes_[id];
  n.u0 = surface_.breaks(0)[n.i0], n.u1 = surface_.breaks(0)[n.i1];
  n.v0 = surface_.breaks(1)[n.j0], n.v1 = surface_.breaks(1)[n.j1];
  if (n.is_single()) {
    n.has_net = true;
    n.net = nets_.size();
    const Interval* const piece = surface_.piece(n.i0, n.j0);
    nets_.insert(nets_.end(), piece, piece + surface_.net_size());
    n.hull = surface_.hull_of_net(piece);
    nodes_[id] = n;
    return;
  }
  const bool cut_u = n.i1 - n.i0 >= n.j1 - n.j0;
  n.first_child = static_cast<Id>(nodes_.size());
  n.num_children = 2;
  Node low = n, high = n;
  low.num_children = high.num_children = 0;
  if (cut_u) {
    low.i1 = high.i0 = (n.i0 + n.i1) / 2;
  } else {
    low.j1 = high.j0 = (n.j0 + n.j1) / 2;
  }
  nodes_.push_back(low);
  nodes_.push_back(high);
  build_groups(n.first_child);
  build_groups(n.first_child + 1);
  n.hull = hull(nodes_[n.first_child].hull, nodes_[n.first_child + 1].hull);
  nodes_[id] = n;
}

bool PatchTree::can_split(Id id) const {
  const Node& n = nodes_[id];
  const double um = middle(n.u0, n.u1), vm = middle(n.v0, n.v1);
  return !n.is_single() || (n.u0 < um && um < n.u1 && n.v0 < vm && vm < n.v1);
}

void PatchTree::append_part(const Node& parent, bool second_u, bool second_v, double um, double vm,
                            const Interval* net) {
  Node part = parent;
  part.num_children = 0, part.has_derivatives = false;
  (second_u ? part.u0 : part.u1) = um;
  (second_v ? part.v0 : part.v1) = vm;
  part.net = nets_.size();
  nets_.insert(nets_.end(), net, net + surface_.net_size());
  part.hull = surface_.hull_of_net(net);
  nodes_.push_back(part);
}

void PatchTree::split_piece(Id id) {
  const Node n = nodes_[id];
  const double um = middle(n.u0, n.u1), vm = middle(n.v0, n.v1);
  const auto cut_u = internal::cut_at(fraction(um, n.u0, n.u1)),
             cut_v = internal::cut_at(fraction(vm, n.v0, n.v1));
  const internal::NetShape shape{surface_.degrees()[0] + 1, surface_.degrees()[1] + 1,
                                 static_cast<std::size_t>(surface_.num_components())};
  const int du = static_cast<int>(shape.rows) - 1, dv = static_cast<int>(shape.columns) - 1;
  const Id first = static_cast<Id>(nodes_.size());
  for (const bool second_u : {false, true}) {
    std::vector<Interval> half(net(id), net(id) + shape.size());
    internal::on_u_lines(half.data(), shape, [&](Interval* l, std::size_t s) {
      second_u ? internal::keep_right(l, s, du, cut_u) : internal::keep_left(l, s, du, cut_u);
    });
    for (const bool second_v : {false, true}) {
      std::vector<Interval> quarter = half;
      internal::on_v_lines(quarter.data(), shape, [&](Interval* l, std::size_t s) {
        second_v ? internal::keep_right(l, s, dv, cut_v) : internal::keep_left(l, s, dv, cut_v);
      });
      append_part(n, second_u, second_v, um, vm, quarter.data());
    }
  }
  nodes_[id].first_child = first;
  nodes_[id].num_children = 4;
}

PatchTree::Id PatchTree::children(Id id) {
  if (nodes_[id].num_children == 0) split_piece(id);
  return nodes_[id].first_child;
}

const PatchTree::Node& PatchTree::with_derivatives(Id id) {
  Node& n = nodes_[id];
  if (!n.has_derivatives) {
    const auto range =
        surface_.range(Interval::from_bounds(n.u0, n.u1), Interval::from_bounds(n.v0, n.v1));
    n.du = range.du, n.dv = range.dv;
    n.has_derivatives = true;
  }
  return n;
}

}  // namespace veritope
