// SPDX-License-Identifier: LGPL-3.0-or-later
// write_model NAME FILE...: writes a model of bench/models.h to files; their extensions determine the formats (PLY
// binary, doubles).
#include <cstdio>

#include "bench/models.h"
#include "io/formats.h"
#include "io/mesh/write_mesh.h"

int main(int argc, char** argv) {
  using namespace veritope;
  if (argc < 3) {
    std::fprintf(stderr, "usage: write_model NAME FILE...\n");
    return 2;
  }
  const TriangleMesh mesh = bench::named_model(argv[1]);
  for (int i = 2; i < argc; ++i) {
    const ModelFormat* const row = format_from_path(argv[i], ModelKind::kMesh);
    if (row == nullptr) {
      std::fprintf(stderr, "%s: no known extension\n", argv[i]);
      return 2;
    }
    const Status status =
        write_mesh_file(argv[i], mesh, default_write_options(std::get<MeshFormat>(row->id)));
    if (!status) {
      std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
      return 4;
    }
  }
  return 0;
}
