// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/boundary_faces.h"

#include <algorithm>
#include <compare>
#include <optional>
#include <string>
#include <utility>

#include "robust/base/entity_error.h"
#include "solids/patches/patch_net.h"
#include "splines/bspline_components.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Axis = KnotAxis<Rational>;
using Index = std::array<std::size_t, 3>;

constexpr const char* kParameterNames[] = {"u", "v", "w"};
constexpr std::uint64_t kMostBits = 8192, kMostKnotBits = 2048;
constexpr std::size_t kMostInside =
    1000;  // control points that are tried for a hand, after the corners

// ---- section 1 of the rule: volumes

// Why the layers of control points at the ends of the axis are not the boundary; nothing if they are.
std::optional<std::string> fault_of_axis(const Axis& axis) {
  const auto p = static_cast<std::size_t>(axis.degree), n = axis.num_control();
  const auto& knots = axis.knots;
  if (knots[0] != knots[p] || knots[n] != knots[n + p]) return "its ends are not clamped";
  for (const Rational& t : knots)
    if (t.numerator().bit_length() > kMostKnotBits || t.denominator().bit_length() > kMostKnotBits)
      return "a knot has over " + std::to_string(kMostKnotBits) + " bits";
  for (std::size_t i = p + 1; i + p < n; ++i)
    if (knots[i] == knots[i + p])
      return "the knot " + knots[i].to_string() + " occurs more often than the degree";
  return std::nullopt;
}

// Whether the homogeneous coordinates of control point i without attributes, brought to integers, and their denominator
// are short; so are its attributes, one by one.
bool is_short(const ExactVolume& volume, std::size_t i) {
  for (int c = 3; c < volume.dimension(); ++c) {
    const Rational& x = volume.component(c)[i];
    if (std::max(x.numerator().bit_length(), x.denominator().bit_length()) > kMostBits)
      return false;
  }
  std::vector<int> components = {0, 1, 2};
  if (volume.is_rational()) components.push_back(volume.dimension());
  std::uint64_t at_most = 0, longest = 0;
  for (const int c : components) {
    const Rational& x = volume.component(c)[i];
    at_most += x.denominator().bit_length();
    longest = std::max(longest, x.numerator().bit_length());
  }
  if (at_most + longest <= kMostBits) return true;
  Integer common(1);
  for (const int c : components) common = lcm(common, volume.component(c)[i].denominator());
  if (common.bit_length() > kMostBits) return false;
  for (const int c : components) {
    const Rational& x = volume.component(c)[i];
    if ((x.numerator() * divide_exactly(common, x.denominator())).bit_length() > kMostBits)
      return false;
  }
  return true;
}

std::optional<std::string> fault_of_volume(const ExactVolume& volume) {
  if (volume.dimension() < 3)
    return "a volume with " + std::to_string(volume.dimension()) + " coordinates";
  for (std::size_t a = 0; a < 3; ++a)
    if (const auto text = fault_of_axis(volume.axis(a)))
      return std::string("axis ") + kParameterNames[a] + ": " + *text;
  for (std::size_t i = 0; i < volume.grid().count(); ++i)
    if (!is_short(volume, i))
      return "control point " + std::to_string(i) + " has numbers of over " +
             std::to_string(kMostBits) + " bits";
  return std::nullopt;
}

std::optional<Error> fault_of_entity(const SplineEntity& entity, std::uint64_t number) {
  const auto* const volume = std::get_if<ExactVolume>(&entity.shape);
  std::optional<std::string> fault;
  if (volume == nullptr)
    fault = std::string("a ") + spline_kind_name(entity);
  else
    fault = fault_of_volume(*volume);
  if (!fault) return std::nullopt;
  return error_at_entity(Code::kBadArgument, number, std::move(*fault));
}

// ---- section 2: hands

class HandOf {
 public:
  explicit HandOf(const ExactVolume& volume) : volume_(volume), grid_(volume.grid()) {}

  // Nothing if corners have different signs; kZero if it is 0 at all of them.
  std::optional<Sign> at_corners() const {
    Sign found = Sign::kZero;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const Sign s = at_corner(corner);
      if (s == -found && s != Sign::kZero) return std::nullopt;
      if (s != Sign::kZero) found = s;
    }
    return found;
  }

  Sign inside() const {
    const std::size_t n0 = grid_.size[0] - 1, n1 = grid_.size[1] - 1, n2 = grid_.size[2] - 1;
    for (std::size_t m = 0; m < std::min(kMostInside, n0 * n1 * n2); ++m) {
      const std::size_t i = m % n0, j = m / n0 % n1, k = m / n0 / n1;
      if (const Sign s = at({i, j, k}, {i + 1, j + 1, k + 1}); s != Sign::kZero) return s;
    }
    return Sign::kZero;
  }

 private:
  Sign at_corner(std::size_t corner) const {
    Index from{}, to{};
    bool is_odd = false;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool is_end = (corner >> a & 1) != 0;
      from[a] = is_end ? grid_.size[a] - 1 : 0;
      to[a] = is_end ? from[a] - 1 : 1;
      is_odd = is_odd != is_end;
    }
    const Sign s = at(from, to);
    return is_odd ? -s : s;
  }

  // The sign of the determinant of the steps along the three axes, from one control point to `to` along each.
  Sign at(const Index& from, const Index& to) const {
    std::array<std::array<Rational, 3>, 3> step;
    const std::array<Rational, 3> origin = point(from);
    for (std::size_t a = 0; a < 3; ++a) {
      Index next = from;
      next[a] = to[a];
      step[a] = point(next);
      for (std::size_t c = 0; c < 3; ++c) step[a][c] -= origin[c];
    }
    Rational det;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
      det += step[0][c] * (step[1][d] * step[2][e] - step[1][e] * step[2][d]);
    }
    return det.sign();
  }

  std::array<Rational, 3> point(const Index& index) const {
    const std::size_t i = grid_.at(index);
    std::array<Rational, 3> out;
    for (int c = 0; c < 3; ++c) {
      out[static_cast<std::size_t>(c)] = volume_.component(c)[i];
      if (volume_.is_rational())
        out[static_cast<std::size_t>(c)] /= volume_.component(volume_.dimension())[i];
    }
    return out;
  }

  const ExactVolume& volume_;
  const Grid<3> grid_;
};

// ---- section 3: faces

VolumeFace face_at(const ExactVolume& volume, std::uint64_t number, std::size_t axis,
                   std::size_t end, bool is_right_handed) {
  VolumeFace face{number, axis, end, {(axis + 1) % 3, (axis + 2) % 3}, {}, {}};
  // The other two axes in cyclic order make normals point to the end of the axis.
  if ((end == 1) != is_right_handed) std::swap(face.axes[0], face.axes[1]);
  face.at = end == 0 ? volume.axis(axis).domain_begin() : volume.axis(axis).domain_end();
  return face;
}

ExactSurface surface_of(const ExactVolume& volume, const VolumeFace& face) {
  const Grid<3> from = volume.grid();
  const Axis &u = volume.axis(face.axes[0]), &v = volume.axis(face.axes[1]);
  std::vector<Rational> values;
  values.reserve(u.num_control() * v.num_control() *
                 static_cast<std::size_t>(volume.num_components()));
  Index index{};
  index[face.axis] = face.end == 0 ? 0 : from.size[face.axis] - 1;
  for (int c = 0; c < volume.num_components(); ++c)
    for (std::size_t i = 0; i < u.num_control(); ++i)
      for (std::size_t j = 0; j < v.num_control(); ++j) {
        index[face.axes[0]] = i;
        index[face.axes[1]] = j;
        values.push_back(volume.component(c)[from.at(index)]);
      }
  return {{u, v}, volume.num_components(), volume.is_rational(), std::move(values)};
}

// ---- section 4: faces that are left out

// The homogeneous control points of a face, for each axis its degree and its knots from 0 to 1.
struct Net {
  std::array<int, 2> degrees{};
  std::array<std::vector<Rational>, 2> knots;
  std::array<std::size_t, 2> size{};
  std::vector<Rational> values;  // four for each control point, the second axis fastest

  explicit Net(const ExactSurface& surface) : size(surface.grid().size) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Axis& axis = surface.axis(k);
      const Rational begin = axis.domain_begin(), length = axis.domain_end() - begin;
      degrees[k] = axis.degree;
      for (const Rational& t : axis.knots) knots[k].push_back((t - begin) / length);
    }
    const std::size_t count = size[0] * size[1];
    values.reserve(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
      for (int c = 0; c < 3; ++c) values.push_back(surface.component(c)[i]);
      values.push_back(surface.is_rational() ? surface.component(3)[i] : Rational(1));
    }
  }
  const Rational& at(std::size_t c, std::size_t i, std::size_t j) const {
    return values[4 * (i * size[1] + j) + c];
  }
};

bool is_without_area(const Net& q) {
  bool is_point = true, is_constant_in_u = true, is_constant_in_v = true;
  for (std::size_t i = 0; i < q.size[0]; ++i)
    for (std::size_t j = 0; j < q.size[1]; ++j)
      for (std::size_t c = 0; c < 4 && (is_point || is_constant_in_u || is_constant_in_v); ++c) {
        const Rational left = q.at(c, i, j) * q.at(3, 0, 0);
        is_point = is_point && left == q.at(c, 0, 0) * q.at(3, i, j);
        is_constant_in_u = is_constant_in_u && left == q.at(c, 0, j) * q.at(3, i, 0);
        is_constant_in_v = is_constant_in_v && left == q.at(c, i, 0) * q.at(3, 0, j);
      }
  return is_point || is_constant_in_u || is_constant_in_v;
}

// Lowers the degree along an axis without inner knots by one, if the map allows it.
bool lower(Net& net, std::size_t axis) {
  const auto p = static_cast<std::size_t>(net.degrees[axis]);
  if (p < 2 || net.size[axis] != p + 1) return false;
  const std::size_t step = axis == 0 ? 4 * net.size[1] : 4, lines = net.values.size() / (p + 1);
  const auto first = [&](std::size_t line) {
    return axis == 0 ? line : line / 4 * 4 * net.size[1] + line % 4;
  };
  for (std::size_t line = 0; line < lines; ++line) {
    Rational sum, binomial(1);  // with its sign
    for (std::size_t i = 0; i <= p; ++i) {
      sum += binomial * net.values[first(line) + i * step];
      binomial *= Rational(Integer(-static_cast<std::int64_t>(p - i)),
                           Integer(static_cast<std::int64_t>(i + 1)));
    }
    if (sum.sign() != Sign::kZero) return false;
  }
  Net out = net;
  --out.degrees[axis];
  --out.size[axis];
  out.knots[axis].assign(2 * p, Rational());
  std::fill(out.knots[axis].begin() + static_cast<std::ptrdiff_t>(p), out.knots[axis].end(),
            Rational(1));
  out.values.clear();
  for (std::size_t i = 0; i < out.size[0]; ++i)
    for (std::size_t j = 0; j < out.size[1]; ++j)
      for (std::size_t c = 0; c < 4; ++c) {
        const auto k = static_cast<std::int64_t>(axis == 0 ? i : j);
        Rational r = Rational(net.degrees[axis]) * net.at(c, i, j);
        if (k > 0) {
          const std::size_t back = axis == 0 ? 4 * out.size[1] : 4;
          r -= Rational(k) * out.values[out.values.size() - back];
        }
        out.values.push_back(r / Rational(static_cast<std::int64_t>(p) - k));
      }
  net = std::move(out);
  return true;
}

// What is equal for equal faces: the least of the eight forms of a face in its lowest degrees, and whether even and odd
// symmetries lead to it.
struct FaceForm {
  std::array<int, 2> degrees{};
  std::array<std::vector<Rational>, 2> knots;
  std::vector<Rational> net;  // divided by its first weight
  bool is_even = false, is_odd = false;

  friend std::strong_ordering operator<=>(const FaceForm& a, const FaceForm& b) {
    if (const auto order = a.degrees <=> b.degrees; order != 0) return order;
    for (std::size_t k = 0; k < 2; ++k)
      if (const auto order = in_order(a.knots[k], b.knots[k]); order != 0) return order;
    return in_order(a.net, b.net);
  }

 private:
  static std::strong_ordering in_order(const std::vector<Rational>& a,
                                       const std::vector<Rational>& b) {
    return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
  }
};

FaceForm form_under(const Net& q, bool is_exchanged, std::array<bool, 2> is_reversed) {
  const std::array<std::size_t, 2> axes = {is_exchanged ? 1u : 0u, is_exchanged ? 0u : 1u};
  FaceForm out;
  for (std::size_t k = 0; k < 2; ++k) {
    out.degrees[k] = q.degrees[axes[k]];
    out.knots[k] = q.knots[axes[k]];
    if (!is_reversed[k]) continue;
    for (Rational& t : out.knots[k]) t = Rational(1) - t;
    std::reverse(out.knots[k].begin(), out.knots[k].end());
  }
  const std::size_t rows = q.size[axes[0]], columns = q.size[axes[1]];
  out.net.reserve(q.values.size());
  std::optional<Rational> first_weight;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      std::array<std::size_t, 2> at{};
      at[axes[0]] = is_reversed[0] ? rows - 1 - i : i;
      at[axes[1]] = is_reversed[1] ? columns - 1 - j : j;
      if (!first_weight) first_weight = q.at(3, at[0], at[1]);
      for (std::size_t c = 0; c < 4; ++c) out.net.push_back(q.at(c, at[0], at[1]) / *first_weight);
    }
  const bool is_odd = (is_exchanged != is_reversed[0]) != is_reversed[1];
  (is_odd ? out.is_odd : out.is_even) = true;
  return out;
}

FaceForm form_of(Net net) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    while (lower(net, axis)) {
    }
  std::optional<FaceForm> best;
  for (unsigned symmetry = 0; symmetry < 8; ++symmetry) {
    FaceForm form =
        form_under(net, (symmetry & 1) != 0, {(symmetry & 2) != 0, (symmetry & 4) != 0});
    const auto order = best ? form <=> *best : std::strong_ordering::less;
    if (order == 0) {
      best->is_even = best->is_even || form.is_even;
      best->is_odd = best->is_odd || form.is_odd;
    } else if (order < 0) {
      best = std::move(form);
    }
  }
  return *std::move(best);
}

// REQUIRES equal forms.
bool are_equal_oddly(const FaceForm& a, const FaceForm& b) {
  return (a.is_even && b.is_odd) || (a.is_odd && b.is_even);
}

// The faces that are one of exactly two equal ones, with opposite normals.
std::vector<bool> find_walls(const std::vector<FaceForm>& forms) {
  std::vector<std::size_t> order(forms.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto by = forms[a] <=> forms[b];
    return by != 0 ? by < 0 : a < b;
  });
  std::vector<bool> out(forms.size());
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    for (end = i + 1; end < order.size() && (forms[order[end]] <=> forms[order[i]]) == 0;) ++end;
    if (end == i + 2 && are_equal_oddly(forms[order[i]], forms[order[i + 1]]))
      out[order[i]] = out[order[i + 1]] = true;
  }
  return out;
}

// Canonical nets in order, equal ones by their direction.
std::vector<CanonicalNet> in_order(std::vector<CanonicalNet> nets) {
  std::sort(nets.begin(), nets.end(), [](const CanonicalNet& a, const CanonicalNet& b) {
    const auto by = a <=> b;
    return by != 0 ? by < 0 : a.is_reversed < b.is_reversed;
  });
  return nets;
}

}  // namespace

std::optional<Sign> hand_at_corners(const ExactVolume& volume) {
  if (fault_of_volume(volume)) return Sign::kZero;
  return HandOf(volume).at_corners();
}

bool are_clamped_volumes(const SplineModel& model) {
  return std::none_of(model.entities.begin(), model.entities.end(),
                      [](const SplineEntity& e) { return fault_of_entity(e, 0).has_value(); });
}

Result<BoundaryFaces> boundary_faces(const SplineModel& model) {
  BoundaryFaces all;
  std::vector<FaceForm> forms;
  for (std::uint64_t e = 0; e < model.entities.size(); ++e) {
    if (auto error = fault_of_entity(model.entities[e], e)) return std::move(*error);
    const ExactVolume volume =
        first_coordinates(std::get<ExactVolume>(model.entities[e].shape), 3);
    const HandOf hand(volume);
    const std::optional<Sign> at_corners = hand.at_corners();
    if (!at_corners)
      return error_at_entity(Code::kBadArgument, e,
                             "the volume is folded: its corners have different hands");
    const bool is_right_handed =
        (*at_corners == Sign::kZero ? hand.inside() : *at_corners) != Sign::kNegative;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t end = 0; end < 2; ++end) {
        VolumeFace face = face_at(volume, e, axis, end, is_right_handed);
        ExactSurface surface = surface_of(volume, face);
        Net net(surface);
        if (is_without_area(net)) {
          ++all.num_flat;
          continue;
        }
        forms.push_back(form_of(std::move(net)));
        all.model.entities.push_back({std::move(surface), {}, {}, model.entities[e].place});
        all.faces.push_back(std::move(face));
      }
  }
  const std::vector<bool> is_wall = find_walls(forms);
  BoundaryFaces out;
  out.num_flat = all.num_flat;
  for (std::size_t i = 0; i < is_wall.size(); ++i) {
    if (is_wall[i]) continue;
    out.model.entities.push_back(std::move(all.model.entities[i]));
    out.faces.push_back(std::move(all.faces[i]));
  }
  out.num_walls = (is_wall.size() - out.faces.size()) / 2;
  if (out.faces.empty())
    return Error{
        Code::kEmpty, {}, "no face of a volume is left without walls and faces without area"};
  return out;
}

bool have_same_pieces(const BoundaryFaces& faces, std::span<const Patch> patches) {
  std::vector<CanonicalNet> own, others;
  for (const SplineEntity& entity : faces.model.entities)
    for (auto& piece : bezier_pieces(std::get<ExactSurface>(entity.shape)).pieces)
      own.push_back(canonical_net(make_patch(std::move(piece)).value()));
  if (own.size() != patches.size()) return false;
  for (const Patch& patch : patches) others.push_back(canonical_net(patch));
  own = in_order(std::move(own));
  others = in_order(std::move(others));
  return std::equal(own.begin(), own.end(), others.begin(),
                    [](const CanonicalNet& a, const CanonicalNet& b) {
                      return (a <=> b) == 0 && a.is_reversed == b.is_reversed;
                    });
}

}  // namespace veritope
