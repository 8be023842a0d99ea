// SPDX-License-Identifier: LGPL-3.0-or-later
// Which faces are equal, and which of them are glued.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "solids/vmodel/v_face_parts_internal.h"
#include "solids/vmodel/v_model_maker_internal.h"

namespace veritope {
namespace {

using HashedFaces = std::vector<std::pair<std::uint64_t, VFaceNumber>>;

// Visits two or more faces with one key, ascending; the groups by their first faces: cells that are close in memory.
template <typename Visit>
void for_each_group(const HashedFaces& keys, Visit visit) {
  std::vector<std::pair<VFaceNumber, std::size_t>> begins;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    if (keys[i + 1].first == keys[i].first && (i == 0 || keys[i - 1].first != keys[i].first))
      begins.emplace_back(keys[i].second, i);
  std::sort(begins.begin(), begins.end());
  for (const auto& place : begins) {
    std::vector<VFaceNumber> group;
    for (std::size_t i = place.second; i < keys.size() && keys[i].first == keys[place.second].first;
         ++i)
      group.push_back(keys[i].second);
    visit(std::move(group));
  }
}

}  // namespace

void VModelMaker::glue() {
  const auto hashed = [&](const std::vector<VFaceNumber>& faces, auto hash) {
    HashedFaces keys;
    keys.reserve(faces.size());
    for (const VFaceNumber f : faces) keys.emplace_back(hash(view(f)), f);
    std::sort(keys.begin(), keys.end());
    return keys;
  };
  const HashedFaces keys = hashed(all_open_faces(), internal::corner_hash);
  for_each_group(keys, [&](std::vector<VFaceNumber> group) {
    if (group.size() == 2) return match(group);
    for_each_group(hashed(group, internal::inner_hash),
                   [&](const std::vector<VFaceNumber>& same) { match(same); });
  });
  std::sort(m_.copies_.begin(), m_.copies_.end());
  std::sort(m_.crowds_.begin(), m_.crowds_.end());
}

std::vector<VFaceNumber> VModelMaker::all_open_faces() const {
  std::vector<VFaceNumber> out;
  for (VFaceNumber f = 0; f < m_.num_faces(); ++f)
    if (!m_.faces_[f].is_collapsed()) out.push_back(f);
  return out;
}
unsigned VModelMaker::right_symmetries(VFaceNumber f, VFaceNumber g) const {
  const auto hand = [&](VFaceNumber face) {
    return internal::hand_of_face(face, m_.is_reversed_[face / 6]);
  };
  return internal::gluing_symmetries(hand(f), hand(g));
}

// Sorts the faces of a group into classes of equal ones, and glues those of two.
void VModelMaker::match(const std::vector<VFaceNumber>& group) {
  std::vector<std::vector<VFaceNumber>> classes;
  if (group.size() == 2) return match_pair(group[0], group[1]);
  for (const VFaceNumber f : group) {
    const auto of = std::find_if(classes.begin(), classes.end(), [&](const auto& known) {
      return internal::equal_symmetries(view(known.front()), view(f), 0xff) != 0;
    });
    if (of == classes.end()) {
      classes.push_back({f});
    } else {
      of->push_back(f);
    }
  }
  for (auto& equal : classes) {
    if (equal.size() == 2) match_pair(equal[0], equal[1]);
    if (equal.size() > 2) m_.crowds_.push_back(std::move(equal));
  }
}
void VModelMaker::match_pair(VFaceNumber f, VFaceNumber g) {
  const unsigned right = right_symmetries(f, g);
  for (unsigned s = 0; s < 8; ++s) {
    if ((right >> s & 1) == 0 || internal::equal_symmetries(view(f), view(g), 1u << s) == 0)
      continue;
    m_.faces_[f].mate = g;
    m_.faces_[f].symmetry = static_cast<std::uint8_t>(s);
    m_.faces_[g].mate = f;
    m_.faces_[g].symmetry = static_cast<std::uint8_t>(v_symmetry_inverse(s));
    return;
  }
  if (internal::equal_symmetries(view(f), view(g), 0xff & ~right) != 0)
    m_.copies_.push_back({f, g});
}

}  // namespace veritope
