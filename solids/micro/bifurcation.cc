// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bifurcation.h"

#include <string>
#include <utility>
#include <vector>

#include "solids/micro/jack_maker_internal.h"

namespace veritope {
namespace {

using internal::JackMaker;
using internal::JackPoint;

constexpr int kTopWall = 5;
const Rational kHalfCube = Rational(1) / Rational(2);

// The square on top of the node is cut into a small square in its middle, four rectangles beside it, four trapezoids
// beyond these, and four quadrilaterals at its corners, on which the arms stand.
class BifurcationMaker {
 public:
  explicit BifurcationMaker(const JackShape& shape)
      : shape_(shape),
        maker_(shape),
        inner_(shape.node / Rational(8)),
        rim_(shape.node * Rational(7) / Rational(8)) {}

  MicroTile make() {
    for (int wall = 0; wall < kTopWall; ++wall) {
      if ((shape_.arms >> wall & 1) == 0)
        maker_.add_closed_side(wall);
      else
        maker_.add_arm(wall);
    }
    add_flat({on_top(-inner_, -inner_), on_top(inner_, -inner_), on_top(inner_, inner_),
              on_top(-inner_, inner_)});
    for (int quarter = 0; quarter < 4; ++quarter) {
      add_flat(turned({on_top(-inner_, -rim_), on_top(inner_, -rim_), on_top(inner_, -inner_),
                       on_top(-inner_, -inner_)},
                      quarter));
      add_flat(turned({on_top(-shape_.node, -shape_.node), on_top(shape_.node, -shape_.node),
                       on_top(inner_, -rim_), on_top(-inner_, -rim_)},
                      quarter));
      add_arm(quarter);
    }
    return maker_.take();
  }

 private:
  JackPoint on_top(const Rational& x, const Rational& y) const {
    return {{x, y, shape_.node}, {Rational(0), Rational(0), Rational(0)}};
  }
  // A corner of the cap in the quarter where x and y are negative.
  JackPoint on_wall(int x, int y) const {
    const internal::JackHalfWidth cap = maker_.cap();
    const Rational quarter = Rational(-1) / Rational(4), half_x = Rational(x) / Rational(2),
                   half_y = Rational(y) / Rational(2);
    return {{quarter + cap.fixed * half_x, quarter + cap.fixed * half_y, kHalfCube},
            {cap.slope * half_x, cap.slope * half_y, Rational(0)}};
  }
  // Turned about the w axis, from u to v, so many times.
  static std::vector<JackPoint> turned(std::vector<JackPoint> points, int quarters) {
    for (JackPoint& p : points)
      for (int i = 0; i < quarters; ++i)
        for (TilePoint* const q : {&p.fixed, &p.slope}) {
          std::swap((*q)[0], (*q)[1]);
          (*q)[0].negate();
        }
    return points;
  }
  // A bilinear patch with these corners, counterclockwise seen from outside.
  void add_flat(const std::vector<JackPoint>& c) {
    maker_.add(kTopWall, {1, 1}, {c[0], c[3], c[1], c[2]});
  }

  // The way from a corner on the node to one of the cap. With the degree 3 its last third is straight along w; in a
  // family it is straight from end to end, because a sheet along w that faces the axis is seen from no point of the
  // axis.
  std::vector<JackPoint> way(const JackPoint& from, const JackPoint& to) const {
    std::vector<JackPoint> out;
    const bool is_bent = shape_.degree == 3 && !shape_.range.has_value();
    for (int k = 0; k <= shape_.degree; ++k) {
      const Rational height = Rational(k) / Rational(shape_.degree),
                     share = is_bent && k == 2 ? Rational(1) : height;
      JackPoint& p = out.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational& t = c == 2 ? height : share;
        p.fixed[c] = from.fixed[c] + (to.fixed[c] - from.fixed[c]) * t;
        p.slope[c] = from.slope[c] + (to.slope[c] - from.slope[c]) * t;
      }
    }
    return out;
  }
  void add_arm(int quarter) {
    const std::vector<JackPoint> base =
        turned({on_top(-shape_.node, -shape_.node), on_top(-inner_, -rim_),
                on_top(-inner_, -inner_), on_top(-rim_, -inner_)},
               quarter);
    const std::vector<JackPoint> cap =
        turned({on_wall(-1, -1), on_wall(1, -1), on_wall(1, 1), on_wall(-1, 1)}, quarter);
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<JackPoint> net = way(base[i], cap[i]);
      const std::vector<JackPoint> next = way(base[(i + 1) % 4], cap[(i + 1) % 4]);
      net.insert(net.end(), next.begin(), next.end());
      maker_.add(kTopWall, {1, shape_.degree}, net);
    }
    add_flat(cap);
  }

  const JackShape& shape_;
  JackMaker maker_;
  Rational inner_, rim_;
};

}  // namespace

Result<MicroTile> bifurcation_tile(const JackShape& shape) {
  if (const std::string fault = internal::fault_of_jack(shape, "bifurcation"); !fault.empty())
    return bad_argument(fault);
  if ((shape.arms >> kTopWall & 1) != 0)
    return bad_argument("arms = " + std::to_string(shape.arms) +
                        " of a bifurcation has an arm to w1");
  MicroTile tile = BifurcationMaker(shape).make();
  tile.name = "bifurcation" + internal::keys_of_jack(shape);
  return tile;
}

}  // namespace veritope
