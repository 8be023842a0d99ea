// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms.cc: the conditions of docs/certificates/dms-solid.md in their order.
#include "dms.h"

#include "../patches/star_box.h"
#include "dms_claim.h"

std::string check_dms(const Statement& s, std::string model_text, const Body& bytes) {
  const DmsFile file = read_dms(model_text);
  model_text = std::string();
  const uint64_t file_bytes = s.number.at("subject_bytes");
  const DmsBody body = read_dms_body(file, bytes);
  DmsModel model(file);
  Units units = dms_units(file_bytes + bytes.left());
  find_dms_boundary(&model);
  check_dms_domain(model);
  require(model.faces.size() == body.faces, "B1", "the faces of the boundary are",
          model.faces.size());
  const DmsNumbers of_domain = check_dms_boundary(model, body.domain, file_bytes);
  check_dms_clouds(model, body.planes, &units);
  check_dms_jacobian(model, body, &units);
  const DmsNumbers of_surface = check_dms_surface(model, body, file_bytes, &units);

  uint64_t leaves = 0, patches = 0;
  for (const DmsTree& t : body.trees) leaves += t.leaves.size();
  for (const std::vector<DmsTile>& tiles : body.tiles) patches += std::max<size_t>(1, tiles.size());
  const std::string text = compared(s, {{"tetrahedra", file.tetrahedra.size()},
                                        {"control_points", file.controls()},
                                        {"leaves", leaves},
                                        {"patches", patches},
                                        {"shells", of_surface.shells},
                                        {"bodies", of_surface.bodies},
                                        {"genus", of_surface.genus}});
  require(of_domain.shells == of_surface.shells, "W3", "the shells of the domain are",
          of_domain.shells);
  require(of_domain.bodies == of_surface.bodies, "W3", "the bodies of the domain are",
          of_domain.bodies);
  require(of_domain.genus == of_surface.genus, "W3", "the genus of the domain is", of_domain.genus);
  return text;
}
