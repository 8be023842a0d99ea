// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "solids/dms/dms_iso_cells_internal.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kMaxBits = 600;  // of numbers of points on planes of knots

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}
int sign_as_int(const Rational& x) { return static_cast<int>(x.sign()); }
Rational thirty_seconds(int k) { return Rational(k) / Rational(32); }

}  // namespace

IsoCells::IsoCells(const DmsModel& model, const DmsIsoOptions& options)
    : model_(model),
      options_(options),
      knots_(model),
      evaluator_(model),
      interpolation_(model.degree, 4),
      rule_(model.degree),
      squared_within_(options.within * options.within),
      local_(model, knots_, model.num_coordinates + options.attribute, options.level) {
  std::vector<bool> is_used(model.clouds.size());
  for (const TetrahedronCorners& t : model.tetrahedra)
    for (const std::uint32_t v : t) is_used[v] = true;
  for (std::uint32_t v = 0; v < model.clouds.size(); ++v) {
    const DmsPoint& at = model.knot(v, 0);
    vertices.push_back({at, is_used[v] ? sign_as_int(value_at(at)) : 0});
  }
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t) {
    IsoCell cell;
    cell.corners = model.tetrahedra[t];
    cell.tetrahedron = t;
    cell.form = first_form(cell);
    add_cell(std::move(cell));
  }
}

DmsCorners IsoCells::zeros(const IsoCell& cell) const {
  DmsCorners out = 0;
  for (std::size_t m = 0; m < 4; ++m)
    if (vertices[cell.corners[m]].sign == 0) out |= 1u << m;
  return out;
}

Rational IsoCells::squared_length(std::uint32_t a, std::uint32_t b) const {
  const DmsPoint d = difference(vertices[a].at, vertices[b].at);
  return dot_product(d, d);
}

IsoEdge IsoCells::longest_edge(const IsoCell& cell) const {
  IsoEdge found;
  for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
    const auto [i, j] = kDmsEdges[e];
    Rational length = squared_length(cell.corners[i], cell.corners[j]);
    if (length > found.squared_length) found = {e, std::move(length)};
  }
  return found;
}

bool IsoCells::is_wide(const IsoCell& cell) const {
  return std::any_of(kDmsEdges.begin(), kDmsEdges.end(), [&](const auto& edge) {
    return is_long(squared_length(cell.corners[edge[0]], cell.corners[edge[1]]));
  });
}

Rational IsoCells::value_at(const DmsPoint& point) {
  const auto place = evaluator_.locate(point);
  VT_CHECK(place.has_value(), "points of cells are in the domain");
  return evaluator_.component(*place, model_.num_coordinates + options_.attribute) - options_.level;
}

DmsPoint IsoCells::between(std::uint32_t a, std::uint32_t b, const Rational& t) const {
  DmsPoint out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = vertices[a].at[c] + t * (vertices[b].at[c] - vertices[a].at[c]);
  return out;
}

std::array<DmsPoint, 4> IsoCells::points(const IsoCell& cell) const {
  std::array<DmsPoint, 4> out;
  for (std::size_t m = 0; m < 4; ++m) out[m] = vertices[cell.corners[m]].at;
  return out;
}

DmsRegion IsoCells::region(const IsoCell& cell) const {
  const auto corners = points(cell);
  std::vector<DmsPlane> planes = face_planes(corners);
  const std::vector<DmsPlane> wider = face_planes(knots_.corners(cell.tetrahedron));
  planes.insert(planes.end(), wider.begin(), wider.end());
  return {knots_, {corners.begin(), corners.end()}, planes};
}

DmsIsoForm IsoCells::first_form(const IsoCell& cell) {
  return local_.form(cell.tetrahedron, region(cell).supports());
}

DmsIsoForm IsoCells::polynomial_on(const IsoCell& cell) {
  const auto corners = points(cell);
  std::vector<DmsPoint> values;
  for (const DmsPoint& p : interpolation_.points(corners))
    values.push_back({value_at(p), Rational(), Rational()});
  DmsIsoForm form;
  for (const DmsPoint& b : interpolation_.coefficients(values))
    form.coefficients.push_back(enclose(b[0]));
  return form;
}

// Whether all knots but one may lie in a plane, at which N_γ may then jump: by E2 of DMS-1 those of three corners.
bool IsoCells::may_jump(const DmsSupport& support) {
  const auto [found, is_new] = jumps_.try_emplace(knots_.key(support), false);
  if (!is_new) return found->second;
  const TetrahedronCorners& t = model_.tetrahedra[support.tetrahedron];
  for (std::size_t apex = 0; apex < 4; ++apex) {
    if (support.gamma[apex] != 0) continue;
    const DmsPoint &a = model_.knot(t[(apex + 1) % 4], 0), &b = model_.knot(t[(apex + 2) % 4], 0),
                   &c = model_.knot(t[(apex + 3) % 4], 0);
    const DmsPoint normal = cross_product(difference(b, a), difference(c, a));
    bool is_flat = true;
    for (std::size_t m = 0; m < 4; ++m)
      for (int i = 1; m != apex && i <= support.gamma[m]; ++i)
        is_flat = is_flat &&
                  dot_product(normal, difference(model_.knot(t[m], i), a)).sign() == Sign::kZero;
    if (is_flat) return found->second = true;
  }
  return false;
}

void IsoCells::drop_far_supports(std::uint32_t number) {
  DmsIsoForm& form = cells[number].form;
  DmsRegion near = region(cells[number]);
  std::size_t kept = 0;
  for (std::size_t s = 0; s < form.supports.size(); ++s) {
    if (near.misses(knots_.knots(form.supports[s])) && !may_jump(form.supports[s])) continue;
    form.supports[kept] = form.supports[s];
    for (std::size_t m = 0; m < 4; ++m) {
      form.rests[4 * kept + m] = form.rests[4 * s + m];
      form.shares[4 * kept + m] = form.shares[4 * s + m];
    }
    ++kept;
  }
  form.supports.resize(kept);
  form.rests.resize(4 * kept);
  form.shares.resize(4 * kept);
  if (std::all_of(form.rests.begin(), form.rests.end(),
                  [](const Interval& x) { return x.lo() == 0 && x.hi() == 0; }))
    form.supports.clear(), form.rests.clear(), form.shares.clear();
}

// Lower bounds of the limits of all N_γ that are not 0, along the segment to the middle of the tetrahedron (DMS-4.L2).
IsoCells::Shares IsoCells::shares_at(const DmsPoint& point, std::uint32_t tetrahedron) {
  DmsPoint middle;
  for (const DmsPoint& p : knots_.corners(tetrahedron))
    for (std::size_t c = 0; c < 3; ++c) middle[c] += p[c] / Rational(4);
  const DmsPlace place{tetrahedron, EntryPath::inward(ExactPoint3(point), ExactPoint3(middle))};
  Shares out;
  evaluator_.for_each_basis(
      place, model_.degree - 1,
      [&](std::uint32_t t, const TetrahedralIndex& gamma, const Rational& value) {
        out.emplace(knots_.key({t, gamma}), std::max(0.0, round_down(value)));
      });
  return out;
}

void IsoCells::set_shares(DmsIsoForm& form, std::size_t corner, const Shares& shares) const {
  for (std::size_t s = 0; s < form.supports.size(); ++s) {
    const auto found = shares.find(knots_.key(form.supports[s]));
    form.shares[4 * s + corner] = found == shares.end() ? 0 : found->second;
  }
}

void IsoCells::add_shares(std::uint32_t number) {
  IsoCell& cell = cells[number];
  if (cell.has_shares || cell.form.is_polynomial()) return;
  cell.has_shares = true;
  for (std::size_t m = 0; m < 4; ++m)
    set_shares(cell.form, m, shares_at(vertices[cell.corners[m]].at, cell.tetrahedron));
}

void IsoCells::add_cell(IsoCell cell) {
  if (cell.off == 0) cell.off = rule_.sign_on(cell.form, kAllCorners);
  if (cell.off != 0) cell.form = {};
  const auto number = static_cast<std::uint32_t>(cells.size());
  for (const auto& [i, j] : kDmsEdges)
    at_edge_[edge_key(cell.corners[i], cell.corners[j])].push_back(number);
  for (const std::uint32_t v : cell.corners)
    if (vertices[v].sign == 0) at_zero_[v].push_back(number);
  cells.push_back(std::move(cell));
  ++num_alive;
}

std::vector<std::uint32_t> IsoCells::around(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t c : at_edge_.at(edge_key(a, b)))
    if (cells[c].is_alive) out.push_back(c);
  return out;
}

// False, and nothing is done, if g is c at the point and that is not allowed.
bool IsoCells::cut_at(std::uint32_t a, std::uint32_t b, const Rational& t, bool may_be_zero) {
  struct Parts {
    std::uint32_t cell;
    std::size_t edge;
    std::pair<DmsIsoForm, DmsIsoForm> forms;
  };
  std::vector<Parts> parts;
  std::unordered_map<std::uint32_t, Shares> shares;  // of each tetrahedron
  DmsPoint at = between(a, b, t);
  int sign = 0;
  for (const std::uint32_t c : around(a, b)) {
    const IsoCell& cell = cells[c];
    for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
      const auto [i, j] = kDmsEdges[e];
      const bool is_forward = cell.corners[i] == a && cell.corners[j] == b;
      if (!is_forward && !(cell.corners[i] == b && cell.corners[j] == a)) continue;
      Parts& part = parts.emplace_back(Parts{c, e, {}});
      if (cell.off != 0) {
        sign = cell.off;
        continue;
      }
      part.forms = rule_.cut(cell.form, e, is_forward ? t : Rational(1) - t);
      if (cell.has_shares && !cell.form.is_polynomial()) {
        const auto [found, is_new] = shares.try_emplace(cell.tetrahedron);
        if (is_new) found->second = shares_at(at, cell.tetrahedron);
        set_shares(part.forms.first, j, found->second);
        set_shares(part.forms.second, i, found->second);
      }
      const Sign3 s = rule_.at_corner(part.forms.first, j).sign();
      if (sign == 0 && s == Sign3::kPositive) sign = 1;
      if (sign == 0 && s == Sign3::kNegative) sign = -1;
    }
  }
  if (sign == 0) sign = sign_as_int(value_at(at));
  if (sign == 0 && !may_be_zero) return false;
  const auto middle = static_cast<std::uint32_t>(vertices.size());
  vertices.push_back({std::move(at), sign});
  for (Parts& part : parts) {
    const auto [i, j] = kDmsEdges[part.edge];
    IsoCell first = std::move(cells[part.cell]);
    cells[part.cell] = {first.corners, first.tetrahedron, false, 0, 0, false, {}};
    --num_alive;
    IsoCell second = first;
    first.corners[j] = middle;
    second.corners[i] = middle;
    first.form = std::move(part.forms.first);
    second.form = std::move(part.forms.second);
    // Coefficients that are 0 beside a vertex with g = c are to be seen to be 0.
    if (sign == 0 && first.off == 0 && first.form.is_polynomial()) {
      first.form = polynomial_on(first);
      second.form = polynomial_on(second);
    }
    add_cell(std::move(first));
    add_cell(std::move(second));
  }
  at_edge_.erase(edge_key(a, b));
  return true;
}

void IsoCells::cut(std::uint32_t cell, std::size_t edge, const Rational& place, bool may_be_zero) {
  const std::uint32_t a = cells[cell].corners[kDmsEdges[edge][0]],
                      b = cells[cell].corners[kDmsEdges[edge][1]];
  if (cut_at(a, b, place, may_be_zero)) return;
  for (const int k : {16, 15, 18, 13, 20, 11})
    if (cut_at(a, b, thirty_seconds(k), false)) return;
  cut_at(a, b, thirty_seconds(16), true);
}

bool IsoCells::cut_at_knots(std::uint32_t number) {
  if (cells[number].form.is_polynomial()) return false;
  DmsRegion near = region(cells[number]);
  const auto three = near.find_cut(cells[number].form.supports);
  if (!three) {
    cells[number].form = polynomial_on(cells[number]);
    return true;
  }
  const DmsPoint& o = knots_.point((*three)[0]);
  const DmsPoint normal = cross_product(difference(knots_.point((*three)[1]), o),
                                        difference(knots_.point((*three)[2]), o));
  std::array<Rational, 4> height;
  for (std::size_t m = 0; m < 4; ++m)
    height[m] = dot_product(normal, difference(vertices[cells[number].corners[m]].at, o));
  for (const auto& [i, j] : kDmsEdges) {
    if (sign_as_int(height[i]) * sign_as_int(height[j]) >= 0) continue;
    const Rational t = height[i] / (height[i] - height[j]);
    if (t.denominator().bit_length() > kMaxBits) continue;
    if (cut_at(cells[number].corners[i], cells[number].corners[j], t, false)) return true;
  }
  return false;
}

}  // namespace veritope::internal
