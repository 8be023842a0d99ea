// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/checker_call.h: the C++ checker as a function: what its main does with two files.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

#include "verify/checker/checker.h"

namespace veritope {

/// "ACCEPT ...", "REJECT <condition>: ...", "REFUSE ..." (exit 4) or "BUG ..." (exit 5).
inline std::string check_in_process(const std::string& model_file, const std::string& certificate) {
  try {
    ::Body body = {nullptr, nullptr};
    const ::Statement s = ::read_statement(certificate, model_file, &body);
    const std::string &claim = s.text.at("claim"), &format = s.text.at("subject_format");
    const ::Model model = ::read_model(model_file, format, s.flag.at("as_indexed"));
    const auto check = claim == "mesh-valid-1" ? ::check_mesh_valid : ::check_mesh_invalid;
    return "ACCEPT " + claim + ": " + check(s, model, body);
  } catch (const ::Rejected& r) {
    return "REJECT " + r.id + ": " + r.why;
  } catch (const ::Refused& r) {
    return "REFUSE " + r.why;
  } catch (const std::exception& e) {
    return std::string("BUG ") + e.what();
  }
}

}  // namespace veritope
