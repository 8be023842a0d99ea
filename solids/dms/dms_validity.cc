// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_validity.h"

#include <algorithm>
#include <string>

namespace veritope {
namespace {

Error dms_error(Code code, std::string message) { return Error{code, {}, std::move(message)}; }

std::string tetrahedron_name(std::size_t number) { return "tetrahedron " + std::to_string(number); }

Status check_shared_key(const DmsModel& model, std::span<const std::uint32_t> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] >= model.clouds.size())
      return dms_error(Code::kIndexOutOfRange, "a control point is at vertex " +
                                                   std::to_string(vertices[i]) + " of " +
                                                   std::to_string(model.clouds.size()));
    if (i > 0 && vertices[i] < vertices[i - 1])
      return bad_argument("the vertices of a control point must not decrease, as " +
                          std::to_string(vertices[i - 1]) + ", " + std::to_string(vertices[i]) +
                          " do");
  }
  return ok_status();
}

Status check_separate_key(const DmsModel& model, std::span<const std::uint32_t> key) {
  if (key[0] >= model.tetrahedra.size())
    return dms_error(Code::kIndexOutOfRange, "a control point is of tetrahedron " +
                                                 std::to_string(key[0]) + " of " +
                                                 std::to_string(model.tetrahedra.size()));
  std::uint64_t sum = 0;
  for (std::size_t m = 1; m < 5; ++m) sum += key[m];
  if (sum == static_cast<std::uint64_t>(model.degree)) return ok_status();
  return bad_argument("the numbers of beta must add up to " + std::to_string(model.degree) +
                      ", and add up to " + std::to_string(sum));
}

}  // namespace

Status check_dms_degree(std::uint64_t degree) {
  if (degree >= 1 && degree <= kMaxDmsDegree) return ok_status();
  return dms_error(degree == 0 ? Code::kBadArgument : Code::kOverLimit,
                   "the degree must be from 1 to " + std::to_string(kMaxDmsDegree) + ", not " +
                       std::to_string(degree));
}

Status check_dms_attribute(const DmsModel& model, std::size_t number) {
  const auto begin = model.attributes.begin();
  const std::string& name = begin[static_cast<std::ptrdiff_t>(number)];
  if (name.empty())
    return bad_argument("the name of attribute " + std::to_string(number) + " is empty");
  const auto end = begin + static_cast<std::ptrdiff_t>(number);
  const auto before = std::find(begin, end, name);
  if (before == end) return ok_status();
  return bad_argument("attributes " + std::to_string(before - begin) + " and " +
                      std::to_string(number) + " have the same name");
}

Status check_own_attribute(const DmsModel& model, const DmsModel& own, std::size_t number) {
  if (model.attributes.size() + number >= kMaxDmsAttributes)
    return dms_error(Code::kOverLimit,
                     "more than " + std::to_string(kMaxDmsAttributes) + " attributes");
  const auto& names = model.attributes;
  const auto found = std::find(names.begin(), names.end(), own.attributes[number]);
  if (found == names.end()) return ok_status();
  return bad_argument("attribute " + std::to_string(number) +
                      " of the attribute domain has the name of attribute " +
                      std::to_string(found - names.begin()) + " of the model");
}

Status check_has_attributes(const DmsModel& own) {
  return own.attributes.empty() ? bad_argument("the attribute domain has no attributes")
                                : ok_status();
}

Status check_dms_number(const Rational& number) {
  if (number.numerator().bit_length() <= kMaxDmsBits &&
      number.denominator().bit_length() <= kMaxDmsBits)
    return ok_status();
  return dms_error(Code::kOverLimit,
                   "numerators and denominators must be below 2^" + std::to_string(kMaxDmsBits));
}

Status check_dms_cloud_size(const std::string& vertex, int degree, std::size_t size) {
  const auto n = static_cast<std::size_t>(degree);
  if (size == 1 || size == n || size == n + 1) return ok_status();
  const std::string first = n == 1 ? "1 or " : "1, " + std::to_string(n) + " or ";
  return bad_argument(vertex + " must have " + first + std::to_string(n + 1) + " knots, not " +
                      std::to_string(size));
}
Status check_dms_cloud(const DmsModel& model, std::size_t vertex) {
  return check_dms_cloud_size("vertex " + std::to_string(vertex), model.degree,
                              model.clouds[vertex].size());
}

Status check_dms_tetrahedron(const DmsModel& model, std::size_t number) {
  const TetrahedronCorners& corners = model.tetrahedra[number];
  for (std::size_t m = 0; m < 4; ++m) {
    if (corners[m] >= model.clouds.size())
      return dms_error(Code::kIndexOutOfRange, tetrahedron_name(number) + " has vertex " +
                                                   std::to_string(corners[m]) + " of " +
                                                   std::to_string(model.clouds.size()));
    for (std::size_t other = 0; other < m; ++other)
      if (corners[m] == corners[other])
        return bad_argument(tetrahedron_name(number) + " has vertex " + std::to_string(corners[m]) +
                            " twice");
  }
  return ok_status();
}

Status check_dms_key(const DmsModel& model, const DmsEntries& entries, std::size_t entry) {
  const std::size_t size = entries.key_size(model.degree);
  const auto key = std::span(entries.keys).subspan(entry * size, size);
  return entries.are_separate ? check_separate_key(model, key) : check_shared_key(model, key);
}

Status check_separate_clouds(const DmsModel& model) {
  const auto n = static_cast<std::size_t>(model.degree);
  for (std::size_t v = 0; v < model.clouds.size(); ++v) {
    const std::size_t size = model.clouds[v].size();
    if (size == 1 || size == n + 1) continue;
    Error error = bad_argument("with separate control points vertex " + std::to_string(v) +
                               " must have 1 or " + std::to_string(n + 1) + " knots, not " +
                               std::to_string(size));
    error.place.entity = v;
    return error;
  }
  return ok_status();
}

namespace {

Status check_dms_parts(const DmsModel& model) {
  for (std::size_t i = 0; i < model.attributes.size(); ++i)
    if (const Status status = check_dms_attribute(model, i); !status) return status;
  for (std::size_t v = 0; v < model.clouds.size(); ++v) {
    if (const Status status = check_dms_cloud(model, v); !status) return status;
    for (const DmsPoint& knot : model.clouds[v])
      for (const Rational& c : knot)
        if (const Status status = check_dms_number(c); !status) return status;
  }
  for (std::size_t t = 0; t < model.tetrahedra.size(); ++t)
    if (const Status status = check_dms_tetrahedron(model, t); !status) return status;
  for (const Rational& c : model.control.values)
    if (const Status status = check_dms_number(c); !status) return status;
  return ok_status();
}

// The control points as entries of a file.
DmsEntries entries_of(const DmsModel& model) {
  DmsEntries entries{model.control.is_separate, model.control.at, model.control.values};
  if (!entries.are_separate) return entries;
  const std::size_t count = num_tetrahedral_indices(model.degree);
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    std::size_t place = 0;
    for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
      if (place++ != c % count) return;
      entries.keys.push_back(static_cast<std::uint32_t>(c / count));
      for (const int i : beta) entries.keys.push_back(static_cast<std::uint32_t>(i));
    });
  }
  return entries;
}

}  // namespace

namespace {

// The rules of one spline.
Status validate_spline(const DmsModel& model) {
  if (model.degree < 0) return bad_argument("the degree must be from 1 to 9");
  if (const Status s = check_dms_degree(static_cast<std::uint64_t>(model.degree)); !s) return s;
  if (model.attributes.size() > kMaxDmsAttributes || model.clouds.size() > kMaxDmsVertices ||
      model.tetrahedra.size() > kMaxDmsTetrahedra)
    return dms_error(Code::kOverLimit, "too many attributes, vertices or tetrahedra");
  if (model.tetrahedra.empty()) return bad_argument("there are 0 tetrahedra");
  if (const Status status = check_dms_parts(model); !status) return status;
  if (model.control.is_separate)
    if (const Status status = check_separate_clouds(model); !status) return status;
  const DmsEntries entries = entries_of(model);
  const std::size_t key = entries.key_size(model.degree);
  if (entries.keys.size() % key != 0 ||
      entries.values.size() != entries.keys.size() / key * model.num_components())
    return bad_argument("the numbers of keys and values of control points do not agree");
  for (std::size_t e = 0; e < entries.keys.size() / key; ++e)
    if (const Status status = check_dms_key(model, entries, e); !status) return status;
  DmsModel bare{model.degree, model.attributes,     model.clouds, model.tetrahedra,
                {},           model.num_coordinates};
  if (const Status status = set_dms_control(bare, entries); !status) return status;
  if (bare.control == model.control) return ok_status();
  return bad_argument("the control points are not in ascending order");
}

Status validate_own(const DmsModel& model, const DmsModel& own) {
  if (own.num_coordinates != 0 || !own.attribute_domain.empty())
    return bad_argument("an attribute domain has neither coordinates nor a domain in it");
  if (const Status status = check_has_attributes(own); !status) return status;
  for (std::size_t a = 0; a < own.attributes.size(); ++a)
    if (const Status status = check_own_attribute(model, own, a); !status) return status;
  Status status = validate_spline(own);
  if (status) return status;
  Error error = status.error();
  error.message = "attribute domain: " + error.message;
  return error;
}

}  // namespace

Status validate(const DmsModel& model) {
  if (model.num_components() == 0 || (model.num_coordinates != 3 && model.num_coordinates != 0))
    return bad_argument("a value begins with three coordinates");
  if (model.attribute_domain.size() > (model.num_coordinates == 3 ? 1u : 0u))
    return bad_argument("a model has at most one attribute domain");
  if (Status status = validate_spline(model); !status) return status;
  for (const DmsModel& own : model.attribute_domain)
    if (Status status = validate_own(model, own); !status) return status;
  return ok_status();
}

}  // namespace veritope
