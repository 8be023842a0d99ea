// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/jack_maker_internal.h: the patches of jacks, and of tiles that are made of their arms. Internal to
// solids/micro.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "solids/micro/jack.h"

namespace veritope::internal {

/// A point relative to the middle of the cube: fixed, and times the number of a wall.
struct JackPoint {
  TilePoint fixed, slope;
};
/// Half the edge of a cross-section: fixed + slope t.
struct JackHalfWidth {
  Rational fixed, slope;
};
/// A square across an arm.
struct JackCrossSection {
  Rational distance;  ///< from the middle of the cube
  JackHalfWidth width;
};

class JackMaker {
 public:
  /// REQUIRES that the shape outlives it.
  explicit JackMaker(const JackShape& shape);

  JackHalfWidth cap() const;
  /// The control points of an arm, from the cube to its end.
  const std::vector<JackCrossSection>& profile() const { return profile_; }

  /// The four sides of an arm, and its cap.
  void add_arm(int wall);
  /// The side of the cube in the middle, where no arm is.
  void add_closed_side(int wall);
  /// A patch with these control points, which depends on the number of the wall if a slope is not 0.
  void add(int wall, std::array<int, 2> degrees, const std::vector<JackPoint>& net);

  /// Without a range if no patch depends on a number.
  MicroTile take();

 private:
  static JackPoint corner(int wall, const JackCrossSection& at, int first, int second);
  void add_square(int wall, const JackCrossSection& at);
  void add_side(int wall, std::size_t out, int sign);

  const JackShape& shape_;
  std::vector<JackCrossSection> profile_;
  MicroTile tile_;
};

/// What is wrong with the numbers of a jack, or of a tile of this name; empty if they are right.
std::string fault_of_jack(const JackShape& shape, const std::string& name);
/// The keys after the name: ",node=1/5,cap=1/8,degree=3".
std::string keys_of_jack(const JackShape& shape);

}  // namespace veritope::internal
