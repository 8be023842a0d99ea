// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_validity.h: what docs/formats/dms-files.md demands of the parts of a file, one by one, so that a
// reader knows the line of what it refuses. All together: validate() of dms_model.h.
// @error of all functions: kBadArgument, kOverLimit, kIndexOutOfRange; the message names the part and the value
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solids/dms/dms_model.h"

namespace veritope {

Status check_dms_degree(std::uint64_t degree);
/// The name, and that no attribute before it has it. REQUIRES number < model.attributes.size().
Status check_dms_attribute(const DmsModel& model, std::size_t number);
/// What attributes of an attribute domain have to obey besides: the name is that of no attribute of the model, and
/// there are at most kMaxDmsAttributes in all. REQUIRES number < own.attributes.size().
Status check_own_attribute(const DmsModel& model, const DmsModel& own, std::size_t number);
/// Whether an attribute domain has an attribute.
Status check_has_attributes(const DmsModel& own);
/// Numerator and denominator are below 2^kMaxDmsBits.
Status check_dms_number(const Rational& number);
/// How many knots a vertex has, which `vertex` names at the begin of a sentence. REQUIRES check_dms_degree.
Status check_dms_cloud_size(const std::string& vertex, int degree, std::size_t size);
Status check_dms_cloud(const DmsModel& model, std::size_t vertex);
/// Four different vertices. REQUIRES number < model.tetrahedra.size().
Status check_dms_tetrahedron(const DmsModel& model, std::size_t number);

/// Control points in any order, as they were read.
struct DmsEntries {
  bool are_separate = false;
  /// If shared: degree vertices for each entry. If separate: a tetrahedron and i, j, k, l.
  std::vector<std::uint32_t> keys;
  std::vector<Rational> values;  ///< num_components() for each entry

  std::size_t key_size(int degree) const {
    return are_separate ? 5 : static_cast<std::size_t>(degree);
  }
};

/// Whether the key of an entry can be one: its vertices exist and do not decrease, or its tetrahedron exists and its
/// numbers add up to the degree. REQUIRES check_dms_tetrahedron of all.
Status check_dms_key(const DmsModel& model, const DmsEntries& entries, std::size_t entry);
/// Whether the sizes of all clouds go with separate control points. REQUIRES check_dms_cloud of all; the place has the
/// vertex.
Status check_separate_clouds(const DmsModel& model);
/// Sorts the entries and makes them the model's control points. Refuses an entry of no tetrahedron, two with one key,
/// and a missing one; the error's place.entity is the entry, the later of two, and nothing for a missing one.
/// REQUIRES check_dms_key of all entries, model.control empty.
/// @cost sorts of the entries and of the faces and edges of the tetrahedra
Status set_dms_control(DmsModel& model, DmsEntries entries);

}  // namespace veritope
