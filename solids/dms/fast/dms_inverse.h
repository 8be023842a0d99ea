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
  std::optional<std::size_t> component;          ///< whose values are wanted, too
  unsigned jobs = 1;                             ///< 0: as many as the machine runs
  std::size_t max_cells = 4096;                  ///< of a tetrahedron: polynomial_parts
  std::size_t max_parts = std::size_t{1} << 21;  ///< or fewer, so that they fit into a gigabyte
};

/// The tetrahedra on which the map is one polynomial (solids/dms/dms_parts.h), halved until the map differs little from
/// an affine one: in each, the Bernstein coefficients of the derivative, times the inverse of that in the middle, are
/// within 1/2 of the identity (Frobenius norm). So a simple iteration finds the one preimage in a part if there is one.
/// Boxes around images find the parts.
/// Several threads may ask at once; answers depend on the point alone.
class DmsInverse {
 public:
  /// REQUIRES a model with coordinates and without defects (solids/dms/dms_defects.h). Where the map is not one to one,
  /// as only `certify` proves, a point has several preimages, and one of them is found. Parts that 72 halvings leave
  /// uneven, and those with heights below 2^-48 of their size (2^-20 where the map is so steep that binary64 does not
  /// suffice), are left out; likewise those with images thinner than 2^-22 of the solid.
  /// @error kOverLimit, kNotFinite, with the tetrahedron as the entity
  /// @cost  the polynomial of each convex cell (solids/dms/dms_polynomials.h)
  static Result<DmsInverse> make(const DmsModel& model, const DmsInverseOptions& options);

  struct Place {
    std::uint32_t leaf = 0;
    Point3d at{};  ///< in the part's coordinates
  };
  /// Nothing if x is not in the solid. What is beside it by less than 2^-30 of a part may count as inside.
  /// @cost a few evaluations of the polynomials of one or two parts
  std::optional<Place> find(const Point3d& x) const;

  /// The point of the domain, up to rounding errors; or the one that is nearer by a share to the middle of its part.
  Point3d domain_point(const Place& place, double inward = 0) const;
  bool has_component() const { return components_ == 4; }
  /// REQUIRES a component among the options.
  double value(const Place& place) const;
  /// Around the images of the parts.
  const Box3d& box() const { return box_; }
  std::size_t num_parts() const { return leaves_.size(); }

 private:
  friend class DmsInverseMaker;
  // u = middle + radius at.
  struct Leaf {
    Point3d middle;
    double radius = 1;
    std::array<Point3d, 4> corners;  // in these coordinates
    std::array<Point3d, 4> normals;  // inward, of length 1; face m is opposite to corner m
    std::array<double, 4> heights;   // normal . at + height >= 0 in the part
    std::array<Point3d, 3> linear;   // rows: the inverse of the derivative in the middle
    double off =
        0;  // `linear` times the image's distance from the middle's is at most so far from `at`
    double noise = 0;  // of `at`, from rounding errors
  };
  struct Evaluated {
    Point3d value;
    std::array<Point3d, 3> along;  // derivatives along the axes
  };

  DmsInverse(int degree, std::size_t num_components);
  const double* net(std::size_t leaf) const { return nets_.data() + leaf * stride_; }
  Evaluated evaluate(const double* net, const Point3d& at) const;
  std::optional<Point3d> find_in(std::size_t leaf, const Point3d& x) const;

  int degree_;
  Point3d offset_{};  // the middle of the solid, nearly; images are beside it, times the scale
  double scale_ = 1;  // a power of two: images have coordinates of at most about 1
  std::size_t count_, components_, stride_;
  std::vector<std::array<int, 3>> exponents_;  // of the monomials
  std::vector<Leaf> leaves_;
  std::vector<double> nets_;  // [leaf][component][monomial]
  BoxHierarchy boxes_;
  Box3d box_ = empty_box();
};

}  // namespace veritope
