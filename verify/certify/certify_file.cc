// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certify_file.h"

#include <vector>

#include "io/base/atomic_file.h"

namespace veritope {

Result<Certified> certify_file(const std::string& path, const CertifyFileOptions& options) {
  const Result<ModelFile> file = read_model_file(path, options.reading);
  if (!file) return file.error();
  return certify(*file, options.certify);
}

Status write_certificate(const Certified& certified, const std::string& path) {
  if (certified.certificate.empty())
    return bad_argument("there is no certificate to write: the verdict is UNDECIDED");
  std::vector<WholeFile> files;
  if (certified.copy)
    files.push_back({copy_path(path, certified.copy->format), certified.copy->bytes});
  files.push_back({path,
                   {reinterpret_cast<const char*>(certified.certificate.data()),
                    certified.certificate.size()}});
  return write_files(files);
}

std::string copy_path(const std::string& certificate, const std::string& format) {
  return certificate + "." + format;
}

}  // namespace veritope
