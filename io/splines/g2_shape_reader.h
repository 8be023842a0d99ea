// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/g2_shape_reader.h: the curves and surfaces of GoTools' .g2, from after the header of their object.
#pragma once
#include "io/splines/spline_text_reader.h"

namespace veritope {

/// GoTools' ClassType.
enum G2Class : std::int64_t {
  kSplineCurve = 100,
  kCurveOnSurface = 110,
  kLine = 120,
  kCircle = 130,
  kEllipse = 140,
  kBoundedCurve = 150,
  kHyperbola = 160,
  kParabola = 170,
  kSplineSurface = 200,
  kBoundedSurface = 210,
  kPlane = 250,
  kCylinder = 260,
  kLinearExtrusion = 261,
  kSphere = 270,
  kCone = 280,
  kTorus = 290,
  kRevolution = 291,
  kDisc = 292,
  kPointCloud = 400,
  kLineCloud = 410,
  kSplineVolume = 700,
};

/// "line", "torus", ...: the name of a shape that may be left out.
const char* g2_class_name(std::int64_t type);

/// A curve or a surface, or the reason why it is left out.
template <typename Spline>
struct G2Shape {
  std::optional<Spline> spline;
  std::string reason;
};

class G2ShapeReader : public SplineTextReader {
 public:
  using SplineTextReader::SplineTextReader;

 protected:
  template <std::size_t N>
  bool read_spline(std::optional<BSpline<Rational, N>>& spline);
  /// Reads a curve of one of the classes; a shape with a reason has no spline.
  bool read_curve(std::int64_t type, G2Shape<ExactCurve>& shape);
  bool read_surface(std::int64_t type, G2Shape<ExactSurface>& shape);

 private:
  using Numbers = std::vector<Rational>;

  bool read_flag(const char* what, bool& flag, bool& has_domain);
  bool read_numbers(std::uint64_t count, Numbers& into);
  bool read_dimension(std::uint64_t& dimension);
  bool read_line(G2Shape<ExactCurve>& shape);
  bool read_plane(G2Shape<ExactSurface>& shape);
  bool read_extrusion(G2Shape<ExactSurface>& shape);
  bool read_elementary(std::uint64_t scalars_first, std::uint64_t vectors, bool is_bounded_flag,
                       std::uint64_t scalars_last);
};

}  // namespace veritope
