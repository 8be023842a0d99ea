// SPDX-License-Identifier: LGPL-3.0-or-later
// A program outside the tree: from a model file to its verdict and a certificate. tests/install/install_test.py builds and runs it.
#include <iostream>

#include <veritope/certify.h>

int main(int argc, char** argv) {
  if (argc != 3) return 2;  // MODEL CERTIFICATE
  const auto answer = veritope::certify_file(argv[1]);
  if (!answer) return std::cerr << veritope::to_string(answer.error()) << "\n", 4;
  std::cout << veritope::verdict_name(answer->verdict) << " " << answer->claim << "\n";
  for (const veritope::Finding& f : answer->findings) std::cout << f.code << ": " << f.message << "\n";
  if (answer->certificate.empty()) return 3;
  return veritope::write_certificate(*answer, argv[2]) ? 0 : 4;
}
