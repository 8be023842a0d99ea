// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/base/finding.h"

namespace veritope {

Finding finding_of(const Error& error) {
  Finding out;
  out.code = code_name(error.code);
  out.place.source = error.place;
  out.message = error.message;
  return out;
}

std::string text_of(const Finding& finding) {
  Error error;
  error.place = finding.place.source;
  error.place.file.clear();
  error.message = finding.message;
  return to_string(error);
}

}  // namespace veritope
