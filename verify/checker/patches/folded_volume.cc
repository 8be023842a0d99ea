// SPDX-License-Identifier: Apache-2.0 OR MIT
// folded_volume.cc: docs/certificates/volume-folded.md.
#include "patch_claims.h"
#include "volume_point.h"

std::string check_volume_folded(const Statement& s, std::string model, const Body& bytes) {
  const std::vector<Entity> volumes = read_volumes(model, s.text.at("subject_format"));
  Bytes r(bytes);
  require(r.body.begins_with(s.claim->magic), "B1", "another magic number");
  require(r.body.natural(4) == volumes.size(), "B1", "the file's entities are", volumes.size());
  const uint64_t v = r.varint();
  require(v < volumes.size(), "B1", "there is no entity", v);
  const Entity& e = volumes[size_t(v)];
  VolumePoint a = read_point(e, &r), b = read_point(e, &r);
  r.end();

  for (int64_t p : e.degrees) require(p <= kMostDegree, "B2", "a degree is over 15");
  const Points of_a = box_of(e, &a), of_b = box_of(e, &b);
  require(s.number.at("volumes") == volumes.size(), "B3", "the number of volumes is",
          volumes.size());
  require(s.number.at("entity") == v, "B3", "the volume of the body is", v);
  require(sign_of_jacobian(values_at(of_a, a)) > 0, "J1",
          "the Jacobian determinant is not positive at A");
  require(sign_of_jacobian(values_at(of_b, b)) < 0, "J2",
          "the Jacobian determinant is not negative at B");
  return "volume " + std::to_string(v) + " of " + std::to_string(volumes.size()) + " folds";
}
