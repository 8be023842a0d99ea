// SPDX-License-Identifier: LGPL-3.0-or-later
// A program outside the tree: from a model file to its verdict and a certificate. tests/install/install_test.py builds and runs it.
#include <fstream>
#include <iostream>
#include <string>

#include "io/read_model.h"
#include "verify/certify/certify.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;  // MODEL CERTIFICATE
  const auto file = veritope::read_model_file(argv[1], {});
  if (!file) return std::cerr << veritope::to_string(file.error()) << "\n", 4;
  const auto answer = veritope::certify(*file);
  if (!answer) return std::cerr << veritope::to_string(answer.error()) << "\n", 4;
  std::cout << veritope::verdict_name(answer->verdict) << " " << answer->claim << "\n";
  for (const veritope::Finding& f : answer->findings) std::cout << f.code << ": " << f.message << "\n";
  std::ofstream(argv[2], std::ios::binary) << std::string(answer->certificate.begin(), answer->certificate.end());
}
