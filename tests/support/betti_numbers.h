// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/betti_numbers.h: homology of unions of octree cells by GUDHI's cubical complexes over the voxels of the
// finest level. VT_HAVE_GUDHI is defined iff libgudhi-dev is installed.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tests/support/octree_shapes.h"

#if __has_include(<gudhi/Bitmap_cubical_complex.h>)
#include <gudhi/Bitmap_cubical_complex.h>
#include <gudhi/Persistent_cohomology.h>
#define VT_HAVE_GUDHI

namespace veritope {

using Betti = std::array<int, 3>;

inline Betti betti_numbers(const octree_shapes::Cells& cells) {
  using Complex = Gudhi::cubical_complex::Bitmap_cubical_complex<
      Gudhi::cubical_complex::Bitmap_cubical_complex_base<double>>;
  using Cohomology =
      Gudhi::persistent_cohomology::Persistent_cohomology<Complex,
                                                          Gudhi::persistent_cohomology::Field_Zp>;
  unsigned level = 0;
  for (const OctreeCell& c : cells) level = std::max(level, c.level);
  using Triple = std::array<unsigned, 3>;
  const auto corner = [&](const OctreeCell& c) {
    return Triple{c.i << (level - c.level), c.j << (level - c.level), c.k << (level - c.level)};
  };
  Triple low{~0u, ~0u, ~0u}, high{};
  for (const OctreeCell& c : cells)
    for (unsigned a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], corner(c)[a]);
      high[a] = std::max(high[a], corner(c)[a] + (1u << (level - c.level)));
    }
  const Triple n{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  // Voxels outside enter at 1: at 0 the complex is |K|, closed.
  std::vector<double> voxels(std::size_t{n[0]} * n[1] * n[2], 1.0);
  for (const OctreeCell& c : cells) {
    const unsigned size = 1u << (level - c.level);
    for (unsigned q = 0; q < size * size * size; ++q) {
      const unsigned x = corner(c)[0] - low[0] + q % size,
                     y = corner(c)[1] - low[1] + q / size % size,
                     z = corner(c)[2] - low[2] + q / size / size;
      voxels[(std::size_t{z} * n[1] + y) * n[0] + x] = 0.0;
    }
  }
  Complex complex({n[0], n[1], n[2]}, voxels);
  Cohomology cohomology(complex, true);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0.0);
  Betti out{};
  for (int d = 0; d < 3; ++d)
    out[static_cast<std::size_t>(d)] = cohomology.persistent_betti_number(d, 0.0, 0.0);
  return out;
}

}  // namespace veritope

#endif
