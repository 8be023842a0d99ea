// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_glue.cc: V3, and the classes of corners and edges that section 7 of docs/certificates/vmodel.md counts.
#include "../patches/star_poly.h"
#include "vmodel.h"

namespace {

bool is_odd(unsigned symmetry) { return __builtin_popcount(symmetry) % 2 == 1; }

struct Net {  // of a face: homogeneous points, the second parameter fastest
  size_t m, n;
  std::vector<Big> v;
  Big& at(size_t i, size_t j, size_t c) { return v[4 * (i * n + j) + c]; }
};
Net face_net(const VPiece& p, size_t axis, bool at_end) {
  const size_t first = other_axis(axis, 0), second = other_axis(axis, 1);
  Net r = {p.n[first], p.n[second], {}};
  size_t i[3];
  i[axis] = at_end ? p.n[axis] - 1 : 0;
  for (i[first] = 0; i[first] < r.m; ++i[first])
    for (i[second] = 0; i[second] < r.n; ++i[second])
      for (size_t c = 0; c < 4; ++c) r.v.push_back(p.net[p.at(i[0], i[1], i[2]) + c]);
  return r;
}
Net moved_net(Net a, unsigned symmetry) {
  const bool is_turned = (symmetry & 1) != 0;
  Net r = {is_turned ? a.n : a.m, is_turned ? a.m : a.n, std::vector<Big>(a.v.size())};
  for (size_t i = 0; i < a.m; ++i)
    for (size_t j = 0; j < a.n; ++j) {
      const std::pair<size_t, size_t> to = moved(i, j, a.m, a.n, symmetry);
      for (size_t c = 0; c < 4; ++c) r.at(to.first, to.second, c) = a.at(i, j, c);
    }
  return r;
}
// Bernstein coefficients become those of powers of the parameters.
void to_powers(Net* a) {
  for (int turn = 0; turn < 2; ++turn) {
    for (size_t i = 0; i < a->m; ++i) {
      int64_t binomial = 1;
      for (size_t k = 0; k < a->n; ++k) {
        for (size_t c = 0; c < 4; ++c) {
          for (size_t j = a->n - 1; j > k; --j)
            a->at(i, j, c) = a->at(i, j, c) - a->at(i, j - 1, c);
          a->at(i, k, c) = a->at(i, k, c) * Big(binomial);
        }
        binomial = binomial * int64_t(a->n - 1 - k) / int64_t(k + 1);
      }
    }
    *a = moved_net(std::move(*a), 1);
  }
}
bool is_zero(Net& a, size_t i, size_t j) {
  for (size_t c = 0; c < 4; ++c)
    if (a.at(i, j, c).sign() != 0) return false;
  return true;
}
// A text that is equal for maps that agree, in any degrees, up to a positive factor.
std::string key_of(Net a) {
  to_powers(&a);
  size_t m = 1, n = 1;
  Big common;
  for (size_t i = 0; i < a.m; ++i)
    for (size_t j = 0; j < a.n; ++j) {
      if (is_zero(a, i, j)) continue;
      m = std::max(m, i + 1), n = std::max(n, j + 1);
      for (size_t c = 0; c < 4; ++c) common = gcd(common, a.at(i, j, c));
    }
  std::string r;
  const auto put = [&r](uint64_t v) {
    for (int k = 0; k < 8; ++k) r += char(v >> 8 * k & 255);
  };
  put(m), put(n);
  for (size_t i = 0; i < m; ++i)
    for (size_t j = 0; j < n; ++j)
      for (size_t c = 0; c < 4; ++c) {
        const Big x = divide(a.at(i, j, c), common, nullptr);
        put(2 * x.m.size() + x.neg);
        for (uint64_t limb : x.m) put(limb);
      }
  return r;
}

int hand(uint64_t face, const VCell& cell) {
  const uint64_t axis = face / 2;
  return (face % 2 != 0 ? 1 : -1) * (axis == 1 ? -1 : 1) * (cell.is_reversed ? -1 : 1);
}

}  // namespace

std::pair<size_t, size_t> moved(size_t i, size_t j, size_t m, size_t n, unsigned symmetry) {
  if ((symmetry & 1) != 0) std::swap(i, j), std::swap(m, n);
  return std::make_pair((symmetry & 2) != 0 ? m - 1 - i : i, (symmetry & 4) != 0 ? n - 1 - j : j);
}
std::string face_key(const VPiece& piece, size_t axis, bool at_end, unsigned symmetry) {
  return key_of(moved_net(face_net(piece, axis, at_end), symmetry));
}
uint64_t corner_of(uint64_t face, size_t s, size_t t) {
  const size_t axis = size_t(face / 2);
  return face % 2 << axis | s << other_axis(axis, 0) | t << other_axis(axis, 1);
}
uint64_t side_of(uint64_t face, size_t which, size_t end) {
  const size_t across = size_t(face / 2), axis = other_axis(across, which);
  const size_t e = other_axis(axis, 0) == across ? size_t(face % 2) : end;
  const size_t f = other_axis(axis, 1) == across ? size_t(face % 2) : end;
  return edge_number(axis, e, f);
}

Pairs::Pairs(const VBody& body) : body_(body), first_(body.faces.size(), ~uint64_t(0)) {
  for (uint64_t f = 0; f < body.faces.size(); ++f) {
    const FaceCode& c = body.faces[f];
    if (c.code < 3) continue;
    if (body.faces[c.other].code != 2 || first_[c.other] != ~uint64_t(0))
      fail(0, "face " + std::to_string(c.other) + " is named, and has no code 2 or another name");
    first_[f] = first_[c.other] = f;
    ++count_;
  }
  for (uint64_t f = 0; f < body.faces.size(); ++f)
    if (body.faces[f].code == 2 && first_[f] == ~uint64_t(0))
      fail(0, "no face names face " + std::to_string(f));
}
void Pairs::fail(uint64_t face, const std::string& why) {
  if (face >= wrong_) return;
  wrong_ = face;
  why_ = why;
}
void Pairs::check() {
  if (wrong_ != ~uint64_t(0)) throw Rejected{"V3", why_};
}

void Pairs::see(size_t cell, const VPiece& p) {
  const VCell& c = body_.cells[cell];
  for (size_t k = 0; k < 6; ++k) {
    const size_t axis = k / 2, first = other_axis(axis, 0), second = other_axis(axis, 1);
    const uint64_t f = 6 * uint64_t(cell) + k;
    if (first_[f] == ~uint64_t(0) || p.index[axis] != k % 2 * (c.intervals(axis) - 1)) continue;
    unsigned symmetry = 0;
    std::pair<size_t, size_t> at(p.index[first], p.index[second]);
    if (first_[f] == f) {
      symmetry = body_.faces[f].symmetry;
      at = moved(at.first, at.second, c.intervals(first), c.intervals(second), symmetry);
    }
    maps_[f][at] = face_key(p, axis, k % 2 != 0, symmetry);
    if (maps_[f].size() == c.intervals(first) * c.intervals(second)) compare(first_[f]);
  }
}
void Pairs::compare(uint64_t f) {
  const uint64_t g = body_.faces[f].other;
  const auto size = [this](uint64_t face) {
    const VCell& c = body_.cells[face / 6];
    const size_t axis = size_t(face % 6 / 2);
    return c.intervals(other_axis(axis, 0)) * c.intervals(other_axis(axis, 1));
  };
  const auto of_f = maps_.find(f), of_g = maps_.find(g);
  if (of_f == maps_.end() || of_g == maps_.end() || of_f->second.size() != size(f) ||
      of_g->second.size() != size(g))
    return;
  const std::string both = "faces " + std::to_string(f) + " and " + std::to_string(g);
  const int product = hand(f % 6, body_.cells[f / 6]) * hand(g % 6, body_.cells[g / 6]);
  if (product != (is_odd(body_.faces[f].symmetry) ? 1 : -1))
    fail(f + 1, both + " are glued with the same orientation");
  else if (!have_equal_breaks(f))
    fail(f + 1, "the breaks of " + both + " differ");
  else if (of_f->second != of_g->second)
    fail(f + 1, both + " are not equal");
  maps_.erase(of_f);
  maps_.erase(of_g);
}
bool Pairs::have_equal_breaks(uint64_t f) const {
  const uint64_t g = body_.faces[f].other;
  const unsigned symmetry = body_.faces[f].symmetry;
  for (size_t k = 0; k < 2; ++k) {  // the parameter of g
    const size_t of_f = (symmetry & 1) != 0 ? 1 - k : k;
    const std::vector<Ratio>& a = body_.cells[f / 6].breaks[other_axis(size_t(f % 6 / 2), of_f)];
    const std::vector<Ratio>& b = body_.cells[g / 6].breaks[other_axis(size_t(g % 6 / 2), k)];
    if (a.size() != b.size()) return false;
    const bool is_reversed = (symmetry & (k == 0 ? 2u : 4u)) != 0;
    const size_t last = a.size() - 1;
    const Ratio length_a = a[last] - a[0], length_b = b[last] - b[0];
    for (size_t i = 1; i < last; ++i) {
      const Ratio x = is_reversed ? a[last] - a[last - i] : a[i] - a[0], y = b[i] - b[0];
      if (!(x.n * length_b.n * y.d * length_a.d == y.n * length_a.n * x.d * length_b.d))
        return false;
    }
  }
  return true;
}

void Pairs::count_classes(uint64_t* points, uint64_t* curves) const {
  const std::vector<VCell>& cells = body_.cells;
  Classes corners(8 * cells.size()), edges(12 * cells.size());
  for (uint64_t f = 0; f < body_.faces.size(); ++f) {
    const FaceCode& code = body_.faces[f];
    if (code.code != 3) continue;
    const uint64_t g = code.other;
    for (size_t a = 0; a < 2; ++a)
      for (size_t b = 0; b < 2; ++b) {
        const std::pair<size_t, size_t> to = moved(a, b, 2, 2, code.symmetry);
        corners.unite(8 * (f / 6) + corner_of(f % 6, a, b),
                      8 * (g / 6) + corner_of(g % 6, to.first, to.second));
        const size_t which = a ^ (code.symmetry & 1);  // side along a at the end b
        const size_t end = b ^ (code.symmetry >> (which == 0 ? 2 : 1) & 1);
        edges.unite(12 * (f / 6) + side_of(f % 6, a, b), 12 * (g / 6) + side_of(g % 6, which, end));
      }
  }
  for (size_t c = 0; c < cells.size(); ++c) {
    for (size_t edge = 0; edge < 12; ++edge) {
      if (!cells[c].edges[edge]) continue;
      const size_t axis = edge / 4;
      const size_t corner = (edge % 2) << other_axis(axis, 0) | (edge / 2 % 2)
                                                                    << other_axis(axis, 1);
      corners.unite(8 * c + corner, 8 * c + (corner | size_t(1) << axis));
    }
    for (uint64_t f = 0; f < 6; ++f) {
      if (cells[c].faces[f] != Collapse::kFirst && cells[c].faces[f] != Collapse::kSecond) continue;
      const size_t left =
          cells[c].faces[f] == Collapse::kFirst ? 1 : 0;  // the parameter of the curve
      edges.unite(12 * c + side_of(f, left, 0), 12 * c + side_of(f, left, 1));
    }
  }
  *points = *curves = 0;
  for (uint32_t i = 0; i < corners.parent.size(); ++i) *points += corners.find(i) == i;
  std::vector<bool> is_seen(edges.parent.size());
  for (uint32_t i = 0; i < edges.parent.size(); ++i) {
    if (cells[i / 12].edges[i % 12]) continue;
    const uint32_t root = edges.find(i);
    *curves += !is_seen[root];
    is_seen[root] = true;
  }
}
