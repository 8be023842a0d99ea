// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/certify_answers.h: what tests of certify() ask of its answers.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "io/read_model.h"
#include "tests/support/checker_call.h"
#include "verify/certify/certify.h"

namespace veritope {

inline ModelFile read(const std::string& bytes, const std::string& name,
                      ModelReadOptions options = {}) {
  return read_model_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                          name, options)
      .value();
}
inline const PatchFacts& patch_facts(const Certified& c) { return std::get<PatchFacts>(c.facts); }

inline void expect_undecided(const Certified& c, const std::string& code,
                             const std::string& words) {
  EXPECT_EQ(c.verdict, Verdict::kUndecided);
  ASSERT_EQ(c.findings.size(), 1u);
  EXPECT_EQ(c.findings[0].code, code);
  EXPECT_NE(c.findings[0].message.find(words), std::string::npos) << c.findings[0].message;
  EXPECT_TRUE(c.certificate.empty() && c.claim.empty());
}

inline void expect_accepted(const std::string& file, const Certified& c) {
  const std::string answer =
      check_in_process(file, std::string(c.certificate.begin(), c.certificate.end()));
  EXPECT_EQ(answer.rfind("ACCEPT " + c.claim, 0), 0u) << answer;
}

inline std::string format_of_certificate(const Certified& c) {
  const std::string text(c.certificate.begin(), c.certificate.end());
  const std::string key = "\"subject_format\":\"";
  const std::size_t at = text.find(key) + key.size();
  return text.substr(at, text.find('"', at) - at);
}

}  // namespace veritope
