// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/dms_inverse.h: the point of the domain that a simplex-spline solid maps to a point of space, in
// binary64: for pictures.  Design: docs/design/0106-pictures-in-the-solid.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_model.h"

namespace veritope {

struct DmsInverseOptions {
  std::optional<std::size_t> component;  ///< whose values are wanted, too
  unsigned jobs = 1;                     ///< 0: as many as the machine runs
  std::size_t max_cells = 4096;          ///< of a tetrahedron: polynomial_parts
  std::size_t max_leaves = std::size_t{1} << 21;
};

/// The convex cells on which the map is one polynomial (solids/dms/dms_parts.h), in boxes that are halved until the map
/// differs little from an affine one: in each box the derivative, times the inverse of that in the middle, is within
/// 1/2 of the identity (Frobenius norm). So a simple iteration finds the one preimage in a box if there is one, and
/// then the planes of the cell decide. Boxes around images find the leaves.
/// Several threads may ask at once; answers depend on the point alone.
class DmsInverse {
 public:
  /// REQUIRES a model with coordinates and without defects (solids/dms/dms_defects.h). Where the map is not one to one,
  /// as only `certify` proves, a point has several preimages, and one of them is found. Boxes that 24 halvings along
  /// each axis leave uneven are left out: there the derivative is nearly singular.
  /// @error kOverLimit, kNotFinite, with the tetrahedron as the entity
  /// @cost  the polynomial of each convex cell (solids/dms/dms_polynomials.h)
  static Result<DmsInverse> make(const DmsModel& model, const DmsInverseOptions& options);

  struct Place {
    std::uint32_t leaf = 0;
    Point3d at{};  ///< in the leaf's coordinates, from -1 to 1
  };
  /// Nothing if x is not in the solid. What is beside it by less than 2^-30 of a cell may count as inside.
  /// @cost a few evaluations of the polynomials of one or two leaves
  std::optional<Place> find(const Point3d& x) const;

  /// The point of the domain, up to rounding errors; or the one that is nearer by a share to a point inside of its
  /// cell.
  Point3d domain_point(const Place& place, double inward = 0) const;
  bool has_component() const { return components_ == 4; }
  /// REQUIRES a component among the options.
  double value(const Place& place) const;
  /// Around the leaves' images.
  const Box3d& box() const { return box_; }
  std::size_t num_leaves() const { return leaves_.size(); }

 private:
  friend class DmsInverseMaker;
  // A closed half-space: normal . (u - origin of the cell) + height >= 0. The normal has length 1.
  struct HalfSpace {
    Point3d normal;
    double height;
  };
  struct Cell {
    Point3d origin;
    Point3d inside;                  // beside the origin: the mean of the corners
    std::size_t first = 0, end = 0;  // of half_spaces_
    double slack = 0;                // by which these are wider
  };
  // u = origin + middle + radius at.
  struct Leaf {
    std::uint32_t cell = 0;
    Point3d middle;
    double radius = 1;
    Point3d reach;                  // |at| in the box is at most this
    std::array<Point3d, 3> linear;  // rows: the inverse of the derivative in the middle
    Point3d
        off;  // by which `linear` times the image's distance from the middle's may differ from at
    double noise = 0;  // of `at`, from rounding errors
  };
  struct Evaluated {
    Point3d value;
    std::array<Point3d, 3> along;  // derivatives along the axes
  };

  DmsInverse(int degree, std::size_t num_components);
  const double* net(std::size_t leaf) const { return nets_.data() + leaf * stride_; }
  Evaluated evaluate(const double* net, const Point3d& at) const;
  bool is_in_cell(const Leaf& leaf, const Point3d& at) const;
  std::optional<Point3d> find_in(std::size_t leaf, const Point3d& x) const;

  int degree_;
  double scale_ = 1;  // a power of two: images have coordinates of at most about 1
  std::size_t count_, components_, stride_;
  std::vector<std::array<int, 3>> exponents_;  // of the monomials
  std::vector<HalfSpace> half_spaces_;
  std::vector<Cell> cells_;
  std::vector<Leaf> leaves_;
  std::vector<double> nets_;  // [leaf][component][monomial]
  BoxHierarchy boxes_;
  Box3d box_ = empty_box();
};

}  // namespace veritope
