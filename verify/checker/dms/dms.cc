// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms.cc: the conditions of docs/certificates/dms-solid.md and dms-solid-2.md in their order.
#include "dms.h"

#include "../patches/star_box.h"
#include "dms_claim.h"

namespace {

struct DmsProof {
  DmsFile file;
  DmsBody body;
  DmsModel model;
  uint64_t file_bytes;
  Units units;

  DmsProof(const Statement& s, std::string model_text, const Body& bytes,
           DmsBody (*read_body)(const DmsFile&, const Body&))
      : file(read_dms(model_text)),
        body(read_body(file, bytes)),
        model(file),
        file_bytes(s.number.at("subject_bytes")),
        units(dms_units(file_bytes + bytes.left())) {}

  // From D1 to J3.
  DmsNumbers check_map() {
    find_dms_boundary(&model);
    check_dms_domain(model);
    require(model.faces.size() == body.faces, "B1", "the faces of the boundary are",
            model.faces.size());
    const DmsNumbers of_domain = check_dms_boundary(model, body.domain, file_bytes);
    check_dms_clouds(model, body.planes, &units);
    check_dms_jacobian(model, body, &units);
    return of_domain;
  }
  std::string compare_numbers(const Statement& s, const char* name, uint64_t number,
                              const DmsNumbers& n) const {
    uint64_t leaves = 0;
    for (const DmsTree& t : body.trees) leaves += t.leaves.size();
    return compared(s, {{"tetrahedra", file.tetrahedra.size()},
                        {"control_points", file.controls()},
                        {"leaves", leaves},
                        {name, number},
                        {"shells", n.shells},
                        {"bodies", n.bodies},
                        {"genus", n.genus}});
  }
};

}  // namespace

std::string check_dms(const Statement& s, std::string model_text, const Body& bytes) {
  DmsProof proof(s, std::move(model_text), bytes, read_dms_body);
  const DmsNumbers of_domain = proof.check_map();
  const DmsNumbers of_surface =
      check_dms_surface(proof.model, proof.body, proof.file_bytes, &proof.units);
  uint64_t patches = 0;
  for (const std::vector<DmsTile>& tiles : proof.body.tiles)
    patches += std::max<size_t>(1, tiles.size());
  const std::string text = proof.compare_numbers(s, "patches", patches, of_surface);
  require(of_domain.shells == of_surface.shells, "W3", "the shells of the domain are",
          of_domain.shells);
  require(of_domain.bodies == of_surface.bodies, "W3", "the bodies of the domain are",
          of_domain.bodies);
  require(of_domain.genus == of_surface.genus, "W3", "the genus of the domain is", of_domain.genus);
  return text;
}

std::string check_dms_2(const Statement& s, std::string model_text, const Body& bytes) {
  DmsProof proof(s, std::move(model_text), bytes, read_dms_body_2);
  const DmsNumbers of_domain = proof.check_map();
  check_dms_pairs(proof.model, proof.body, of_domain, &proof.units);
  return proof.compare_numbers(s, "faces", proof.body.faces, of_domain);
}
