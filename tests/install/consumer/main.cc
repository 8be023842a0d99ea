// SPDX-License-Identifier: LGPL-3.0-or-later
// A program outside the tree: tests/install/install_test.py builds it against an installed Veritope. README.md shows it.
#include <iostream>

#include <veritope/io/read_model.h>
#include <veritope/predicates/orient3d.h>
#include <veritope/solids/polyhedron/validity.h>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  using namespace veritope;
  // The fourth point lies above the plane of the others by the least positive double.
  const Sign side = orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p-1074});
  std::cout << "orient3d: " << to_int(side) << "\n";

  const Result<MeshFile> file = read_mesh_file(argv[1], {});
  if (!file) {
    std::cerr << to_string(file.error()) << "\n";
    return 4;
  }
  const ValidityReport report = decide_validity(file->mesh, {});
  std::cout << (report.is_valid ? "valid" : "invalid") << ", " << report.counts.faces << " faces\n";
  return report.is_valid ? 0 : 1;
}
