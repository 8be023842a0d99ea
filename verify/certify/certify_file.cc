// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certify_file.h"

#include <string_view>

#include "io/base/atomic_file.h"

namespace veritope {
namespace {

Status write_whole(const std::string& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status status = file->write(bytes); !status) return status;
  return file->commit();
}

}  // namespace

Result<Certified> certify_file(const std::string& path, const CertifyFileOptions& options) {
  const Result<ModelFile> file = read_model_file(path, options.reading);
  if (!file) return file.error();
  return certify(*file, options.certify);
}

Status write_certificate(const Certified& certified, const std::string& path) {
  if (certified.certificate.empty())
    return bad_argument("there is no certificate to write: the verdict is UNDECIDED");
  if (certified.copy)
    if (Status status = write_whole(copy_path(path), certified.copy->bytes); !status)
      return status;
  return write_whole(path, {reinterpret_cast<const char*>(certified.certificate.data()),
                            certified.certificate.size()});
}

std::string copy_path(const std::string& certificate) { return certificate + ".vjson"; }

}  // namespace veritope
