// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/face_orientation.h"

#include <algorithm>

#include "robust/base/check.h"

namespace veritope {
namespace {

using Face = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNoShell = 0xffffffffu;

bool has_vertex(const Face& f, std::uint32_t v) {
  return std::find(f.begin(), f.end(), v) != f.end();
}

// Whether the face runs from u to w. REQUIRES that it has both.
bool runs_along(const Face& f, std::uint32_t u, std::uint32_t w) {
  const std::size_t at = static_cast<std::size_t>(std::find(f.begin(), f.end(), u) - f.begin());
  return f[(at + 1) % 3] == w;
}

class Spread {
 public:
  Spread(std::span<const Face> faces, const Incidence& incidence)
      : faces_(faces), incidence_(incidence) {
    out_.is_reversed.resize(faces.size());
    out_.shell_of_face.assign(faces.size(), kNoShell);
  }

  std::optional<FaceOrientation> run() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (out_.shell_of_face[f] != kNoShell) continue;
      reach(f, false, static_cast<std::uint32_t>(out_.num_shells++));
      while (!waiting_.empty()) {
        const std::uint32_t next = waiting_.back();
        waiting_.pop_back();
        if (!spread_from(next)) return std::nullopt;
      }
    }
    return std::move(out_);
  }

 private:
  void reach(std::uint32_t face, bool is_reversed, std::uint32_t shell) {
    out_.is_reversed[face] = is_reversed;
    out_.shell_of_face[face] = shell;
    waiting_.push_back(face);
  }

  // False if a neighbour would have to be reversed and kept.
  bool spread_from(std::uint32_t face) {
    const Face& f = faces_[face];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = f[i], w = f[(i + 1) % 3];
      const std::uint32_t other = across(face, u, w);
      const bool is_reversed = out_.is_reversed[face] != runs_along(faces_[other], u, w);
      if (out_.shell_of_face[other] == kNoShell)
        reach(other, is_reversed, out_.shell_of_face[face]);
      else if (out_.is_reversed[other] != is_reversed)
        return false;
    }
    return true;
  }

  // The other face at the edge {u, w} of `face`.
  std::uint32_t across(std::uint32_t face, std::uint32_t u, std::uint32_t w) const {
    if (incidence_.corners(w).size() < incidence_.corners(u).size()) std::swap(u, w);
    for (const std::uint32_t corner : incidence_.corners(u)) {
      const std::uint32_t other = corner_face(corner);
      if (other != face && has_vertex(faces_[other], w)) return other;
    }
    VT_CHECK(false, "an edge has one face");
    return face;
  }

  std::span<const Face> faces_;
  const Incidence& incidence_;
  FaceOrientation out_;
  std::vector<std::uint32_t> waiting_;  // faces whose neighbours were not reached from them
};

}  // namespace

std::optional<FaceOrientation> agreeing_orientation(
    std::span<const std::array<std::uint32_t, 3>> faces, const Incidence& incidence) {
  return Spread(faces, incidence).run();
}

}  // namespace veritope
