// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/pulled_patches.h: a small patch model, changed as bytes say. Four bytes a change: what, where, how much; points
// in equal places move together, unless the change is a tear.
#pragma once
#include <cstdint>
#include <vector>

#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"

namespace veritope::fuzz {

using Patches = patch_shapes::Patches;

inline Patches shape(std::uint8_t which) {
  const Rational half = Rational(1) / Rational(2);
  const Patches box = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  switch (which % 8) {
    case 0: return box;
    case 1: return elevated(box, 1);
    case 2: return patch_shapes::octant_sphere();
    case 3: return patch_shapes::sphere();
    case 4: return patch_shapes::joined({box, patch_shapes::placed(box, half, {2, 0, 0})});
    case 5: return patch_shapes::blocks({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    case 6: return patch_shapes::wrinkled_cube();
    default: return patch_shapes::frustum(1, 0, 2);
  }
}

// The model that is changed.
class Pulled {
 public:
  explicit Pulled(Patches patches) : patches_(std::move(patches)) {}

  void change(const std::uint8_t* b) {
    const Rational by =
        Rational(static_cast<std::int8_t>(b[3])) / Rational(b[0] % 2 != 0 ? 32 : 4096);
    const std::size_t patch = b[1] % patches_.size(), point = b[2];
    const std::size_t axis = b[0] / 2 % 3;
    switch (b[0] / 8 % 16) {
      case 0: patches_[patch] = reversed(patches_[patch]); break;
      case 1: patches_[patch] = turned(patches_[patch], b[2] % patches_[patch].num_sides()); break;
      case 2:
        if (patches_.size() > 1)
          patches_.erase(patches_.begin() + static_cast<std::ptrdiff_t>(patch));
        break;
      case 3:
        if (patches_.size() < 24) patches_.push_back(patches_[patch]);
        break;
      case 4: move_one(patch, point, axis, by); break;
      default: move_all_there(patch, point, axis, by);
    }
  }
  const Patches& patches() const { return patches_; }

 private:
  using Place = std::vector<Rational>;

  static Place place(const Patch& p, std::size_t i) {
    Place out;
    for (int c = 0; c < 3; ++c)
      out.push_back(p.is_rational() ? p.component(c)[i] / p.component(3)[i] : p.component(c)[i]);
    return out;
  }
  template <typename Move>
  static Patch changed(const Patch& p, Move move) {
    const auto apply = [&](auto map) {
      move(map);
      return make_patch(std::move(map), p.origin()).value();
    };
    return p.is_triangle() ? apply(p.triangle()) : apply(p.tensor());
  }
  void move_one(std::size_t patch, std::size_t point, std::size_t axis, const Rational& by) {
    const std::size_t i = point % patches_[patch].num_control();
    patches_[patch] = changed(patches_[patch],
                              [&](auto& map) { map.component(static_cast<int>(axis))[i] += by; });
  }
  void move_all_there(std::size_t patch, std::size_t point, std::size_t axis, const Rational& by) {
    const Place at = place(patches_[patch], point % patches_[patch].num_control());
    for (Patch& p : patches_)
      for (std::size_t i = 0; i < p.num_control(); ++i) {
        if (place(p, i) != at) continue;
        const Rational weight = p.is_rational() ? p.component(3)[i] : Rational(1);
        p = changed(p, [&](auto& map) { map.component(static_cast<int>(axis))[i] += weight * by; });
      }
  }

  Patches patches_;
};

}  // namespace veritope::fuzz
