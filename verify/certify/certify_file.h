// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/certify_file.h: one call from the name of a file to its verdict and its certificate; installed as
// <veritope/certify.h>.
#pragma once
#include <array>
#include <string>

#include "io/read_model.h"
#include "robust/base/result.h"
#include "verify/certify/certify.h"

namespace veritope {

struct CertifyFileOptions {
  ModelReadOptions reading;
  CertifyOptions certify;
};

/// Reads the file as read_model_file does, in any format, and calls certify, which decides whether the model bounds a
/// solid. No checker has confirmed the result: that is what `veritope-check FILE CERTIFICATE` is for.
/// @param path  a regular file, or "-" for standard input; then options.reading.format is required
/// @error  as read_model_file, with the place in the file, and as certify
Result<Certified> certify_file(const std::string& path, const CertifyFileOptions& options = {});

/// Writes the certificate to a file and, if it refers to a copy of the model, that copy beside it, as
/// copy_path(path, copy.format). Each file appears complete or not at all, and neither before the bytes of both are on
/// the disk.
/// @error  kBadArgument: there is no certificate, because the verdict is UNDECIDED; kCannotWrite
Status write_certificate(const Certified& certified, const std::string& path);

/// Where the copy of which a certificate speaks is kept: "part.cert.vjson" beside "part.cert".
std::string copy_path(const std::string& certificate, const std::string& format);

/// The formats of copies.
inline constexpr std::array<const char*, 2> kCopyFormats = {"vjson", "off"};

}  // namespace veritope
