// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/collar.h"

#include <algorithm>
#include <utility>

namespace veritope {
namespace {

using internal::kNone;

class Search {
 public:
  Search(const CommonSubdivision& complex, const CollarOptions& options)
      : c_(complex), options_(options) {
    out_.boundary = analyse_boundary(complex);
  }

  Result<Collar> run() {
    if (const Status chosen = read_choice(); !chosen) return chosen.error();
    if (!out_.boundary.is_manifold()) {
      refuse_manifold();
      return std::move(out_);
    }
    pair_components();
    collapse();
    return std::move(out_);
  }

 private:
  Status read_choice() {
    if (options_.max_attempts == 0)
      return Error{Code::kBadArgument, {}, "a collar needs at least one attempt"};
    chosen_.assign(out_.boundary.bodies.size(), kNone);
    for (const std::uint32_t f : options_.d_plus) {
      if (f >= c_.num_faces())
        return Error{Code::kBadArgument,
                     {},
                     "d+: face " + std::to_string(f) + " of " + std::to_string(c_.num_faces())};
      const std::uint32_t component = out_.boundary.component_of_face[f];
      if (component == kNone)
        return Error{
            Code::kBadArgument, {}, "d+: " + name_of(c_, 2, f) + " is not on the boundary"};
      std::uint32_t& chosen = chosen_[out_.boundary.components[component].body];
      if (chosen != kNone && chosen != component)
        return Error{Code::kBadArgument,
                     {},
                     "d+: " + name_of(c_, 2, f) +
                         " is on another boundary component of its body than " +
                         name_of(c_, 2, out_.boundary.components[chosen].first_face)};
      chosen = component;
    }
    return ok_status();
  }

  void refuse_manifold() {
    out_.outcome = CollarOutcome::kNotManifold;
    if (!out_.boundary.bad_edges.empty()) {
      const BadEdge& bad = out_.boundary.bad_edges.front();
      out_.message =
          name_of(c_, 1, bad.edge) + " has " + std::to_string(bad.num_faces) + " boundary faces";
    } else {
      const BadVertex& bad = out_.boundary.bad_vertices.front();
      out_.message = "the boundary faces at " + name_of(c_, 0, bad.vertex) + " form " +
                     std::to_string(bad.num_cycles) + " cycles";
    }
  }

  void pair_components() {
    const ComplexBoundary& b = out_.boundary;
    out_.bodies.resize(b.bodies.size());
    std::vector<std::uint32_t> num(b.bodies.size(), 0);
    for (std::uint32_t i = 0; i < b.components.size(); ++i) {
      CollarBody& body = out_.bodies[b.components[i].body];
      (num[b.components[i].body]++ == 0 ? body.d_plus : body.d_minus) = i;
    }
    for (std::uint32_t i = 0; i < out_.bodies.size(); ++i) {
      CollarBody& body = out_.bodies[i];
      if (num[i] == 2 && b.components[body.d_plus].euler() == b.components[body.d_minus].euler()) {
        choose_side(body, chosen_[i]);
        continue;
      }
      if (out_.message.empty()) refuse_product(i, num[i]);
      body.d_plus = body.d_minus = kNone;
    }
  }

  void choose_side(CollarBody& body, std::uint32_t chosen) const {
    const auto faces = [&](std::uint32_t i) { return out_.boundary.components[i].faces; };
    if (chosen != kNone ? chosen == body.d_minus : faces(body.d_minus) < faces(body.d_plus))
      std::swap(body.d_plus, body.d_minus);
  }

  void refuse_product(std::uint32_t body, std::uint32_t num) {
    out_.outcome = CollarOutcome::kNotProduct;
    out_.message = "the body of " + name_of(c_, 3, out_.boundary.bodies[body].first_cell) + " has ";
    if (num != 2) {
      out_.message += std::to_string(num) + " boundary component" + (num == 1 ? "" : "s");
    } else {
      const auto genus = [&](std::uint32_t i) {
        return std::to_string(out_.boundary.components[i].genus());
      };
      out_.message += "boundary components of genus " + genus(out_.bodies[body].d_plus) + " and " +
                      genus(out_.bodies[body].d_minus);
    }
  }

  void collapse() {
    for (unsigned attempt = 0; attempt < options_.max_attempts; ++attempt) {
      std::vector<std::uint32_t> bodies, sides;
      for (std::uint32_t i = 0; i < out_.bodies.size(); ++i) {
        CollarBody& body = out_.bodies[i];
        if (body.d_plus == kNone || body.is_product) continue;
        if (attempt > 0 && chosen_[i] == kNone) std::swap(body.d_plus, body.d_minus);
        ++body.attempts;
        body.is_product = true;
        bodies.push_back(i);
        sides.push_back(body.d_plus);
      }
      if (bodies.empty()) break;
      take(collapse_greedily(c_, out_.boundary, bodies, sides, order(attempt),
                             options_.seed + attempt));
    }
    if (!out_.message.empty()) return;
    out_.outcome = last_.stuck.empty() ? CollarOutcome::kCollar : CollarOutcome::kUndecided;
    if (!last_.stuck.empty())
      out_.message = "no order that was tried collapses the body of " +
                     name_of(c_, 3, out_.boundary.bodies[last_.stuck.front()].first_cell) + ": " +
                     std::to_string(last_.remaining[2]) + " faces, " +
                     std::to_string(last_.remaining[1]) + " edges are left, " +
                     name_of(c_, last_.remains_at[0], last_.remains_at[1]) + " among them";
  }

  /// Both sides breadth first, then both in each of the random orders in turn.
  static CollapseOrder order(unsigned attempt) {
    if (attempt < 2) return CollapseOrder::kBreadthFirst;
    return attempt / 2 % 2 == 1 ? CollapseOrder::kShuffledBreadthFirst
                                : CollapseOrder::kRandomFront;
  }

  void take(CollapseAttempt attempt) {
    const auto append = [](std::vector<Collapse>& to, std::vector<Collapse>& from) {
      if (to.empty()) return to.swap(from);
      to.insert(to.end(), from.begin(), from.end());
    };
    append(out_.collapses.cells, attempt.sequence.cells);
    append(out_.collapses.faces, attempt.sequence.faces);
    append(out_.collapses.edges, attempt.sequence.edges);
    for (const std::uint32_t body : attempt.stuck) out_.bodies[body].is_product = false;
    out_.remaining = attempt.remaining;
    last_ = std::move(attempt);
  }

  const CommonSubdivision& c_;
  const CollarOptions& options_;
  std::vector<std::uint32_t>
      chosen_;  // the boundary component that the caller wants as d+ of each body, or kNone
  CollapseAttempt last_;
  Collar out_;
};

}  // namespace

std::vector<std::uint32_t> Collar::d_plus_faces() const {
  std::vector<std::uint32_t> out;
  for (std::uint32_t f = 0; f < boundary.component_of_face.size(); ++f) {
    const std::uint32_t component = boundary.component_of_face[f];
    if (component == CommonSubdivision::kNone || bodies.empty()) continue;
    const CollarBody& body = bodies[boundary.components[component].body];
    if (body.is_product && body.d_plus == component) out.push_back(f);
  }
  return out;
}

Result<Collar> find_collar(const CommonSubdivision& complex, const CollarOptions& options) {
  return Search(complex, options).run();
}

}  // namespace veritope
