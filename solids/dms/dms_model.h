// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_model.h: a simplex-spline solid as its file has it (docs/formats/dms-files.md): a complex of
// tetrahedra, clouds of knots at its vertices, and control points. Nothing is evaluated, and nothing is proved.
// Source: [HHQ04], section 3.  Design: docs/design/0087-simplex-spline-solids.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robust/base/result.h"
#include "robust/rational.h"
#include "splines/dms_spline.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

inline constexpr std::size_t kMaxDmsAttributes = 256;
inline constexpr std::size_t kMaxDmsVertices = std::size_t{1} << 24;
inline constexpr std::size_t kMaxDmsTetrahedra = std::size_t{1} << 24;
inline constexpr std::size_t kMaxDmsBits = 2048;  ///< of a numerator or denominator

using DmsPoint = std::array<Rational, 3>;

/// The knots t_0, t_1, ... of a vertex: one (collapsed), as many as the degree, or one more.
using DmsCloud = std::vector<DmsPoint>;

/// Control points in the order of a canonical file.
struct DmsControl {
  /// Whether each tetrahedron has control points of its own. Else they belong to multisets of vertices.
  bool is_separate = false;
  /// If shared: for each control point as many vertices as the degree, ascending. The control points are in ascending
  /// order of them. If separate: empty; control point tetrahedral_index(β) of tetrahedron I is number I
  /// num_tetrahedral_indices(degree) + tetrahedral_index(β).
  std::vector<std::uint32_t> at;
  /// For each control point x, y, z, which an attribute domain lacks, and the attributes.
  std::vector<Rational> values;
  friend bool operator==(const DmsControl&, const DmsControl&) = default;
};

struct DmsModel {
  int degree = 1;
  std::vector<std::string> attributes;
  std::vector<DmsCloud> clouds;  ///< for each vertex
  std::vector<TetrahedronCorners> tetrahedra;
  DmsControl control;
  /// Numbers of a value before the attributes: x, y, z. An attribute domain has 0.
  std::size_t num_coordinates = 3;
  /// Further attributes, over a domain of their own: at most one model, with num_coordinates 0 and without a further
  /// one. What works on one spline takes the model for itself, or this one, and does not look for the other.
  std::vector<DmsModel> attribute_domain = {};

  friend bool operator==(const DmsModel&, const DmsModel&) = default;

  /// Numbers of a value: the coordinates and the attributes, without those of the attribute domain.
  std::size_t num_components() const { return num_coordinates + attributes.size(); }
  std::size_t num_control() const { return control.values.size() / num_components(); }
  /// The greatest |γ| of the sets of knots that the conditions on clouds speak of: N of docs/formats/dms-files.md.
  int condition_degree() const { return control.is_separate ? degree : degree - 1; }
  /// Knot i of a vertex: t_0 where the cloud has no knot of that number. REQUIRES 0 <= i <= degree.
  const DmsPoint& knot(std::uint32_t vertex, int i) const {
    const DmsCloud& cloud = clouds[vertex];
    return static_cast<std::size_t>(i) < cloud.size() ? cloud[static_cast<std::size_t>(i)]
                                                      : cloud[0];
  }
  std::span<const Rational> value(std::size_t control_point) const {
    return std::span(control.values).subspan(control_point * num_components(), num_components());
  }
};

/// The names of all attributes: those of the model, then those of its attribute domain.
std::vector<std::string> all_attributes(const DmsModel& model);

/// A component of the values of a model or of its attribute domain.
struct DmsComponent {
  const DmsModel* spline = nullptr;
  std::size_t component = 0;
};
/// The spline that has the attribute of this name, and its component; nothing if neither has it. The model must outlive
/// the answer.
std::optional<DmsComponent> find_attribute(const DmsModel& model, std::string_view name);

/// The control point of a multiset of vertices, which are ascending; nothing if it does not exist.
/// REQUIRES shared control points, as many vertices as the degree. @cost a binary search
std::optional<std::size_t> find_control(const DmsModel& model,
                                        std::span<const std::uint32_t> vertices);
/// The multiset of vertices of β: beta[m] times corner m, ascending.
std::vector<std::uint32_t> control_vertices(const TetrahedronCorners& tetrahedron,
                                            const TetrahedralIndex& beta);
/// The number of the control point c(I, β). REQUIRES a model that validate() accepts, |β| = degree.
std::size_t control_of(const DmsModel& model, std::uint32_t tetrahedron,
                       const TetrahedralIndex& beta);

/// Whether all that "The file" of docs/formats/dms-files.md demands holds; the places name vertices, tetrahedra and
/// control points as entities, of the attribute domain if the message says so. An attribute domain alone is accepted.
Status validate(const DmsModel& model);

/// The text of an index: "(1,0,2,0)".
std::string to_string(const TetrahedralIndex& index);

}  // namespace veritope
