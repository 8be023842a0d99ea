// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/expression_classification.h"

#include "robust/base/parallel.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

// Word, f and shell; expressions have no shells.
std::string_view answer_of(PointWord word) {
  switch (word) {
    case PointWord::kIn: return " in 1 -\n";
    case PointWord::kOn: return " on - -\n";
    case PointWord::kOut: return " out 0 -\n";
    case PointWord::kUndecided: break;
  }
  return " undecided - -\n";
}

std::string reason_text(const OpenWord& open, std::span<const std::string> names) {
  const auto name = [&](std::size_t i) { return names[open.variables[i]]; };
  switch (open.reason) {
    case OpenWord::Reason::kPlace:
      return "it is not known whether it is on the boundary of " + name(0);
    case OpenWord::Reason::kDirections:
      return "the boundary of " + name(0) +
             " has an apex there, an edge of angle 0, or tangents that are irrational";
    case OpenWord::Reason::kContact: break;
  }
  std::string out;
  for (std::size_t i = 0; i < open.variables.size(); ++i) {
    if (i > 0) out += i + 1 < open.variables.size() ? ", " : " and ";
    out += "face " + std::to_string(open.faces[i]) + " of " + name(i);
  }
  return out + " touch there";
}

void count(PointWord word, const OpenWord& why, std::span<const std::string> names,
           report::ClassifyReport& report) {
  ++report.points;
  switch (word) {
    case PointWord::kIn: ++report.in; break;
    case PointWord::kOn: ++report.on; break;
    case PointWord::kOut: ++report.out; break;
    case PointWord::kUndecided: report.add_undecided(reason_text(why, names));
  }
}

}  // namespace

Status classify_points(const ExpressionClassifier& classifier, std::span<const std::string> names,
                       PointSource& source, unsigned jobs, const WriteAnswers& write,
                       report::ClassifyReport& report, ExpressionCertificate* certificate) {
  Sha256 hash;
  PointBatch batch;
  std::vector<PointWord> words;
  std::vector<OpenWord> why;
  std::string lines;
  for (;;) {
    if (const Status status = source.next(batch); !status) return status;
    if (batch.size() == 0) break;
    words.resize(batch.size());
    why.resize(batch.size());
    classifier.classify(batch.points, words, jobs, why);
    parallel_for(batch.exact.size(), 16, jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t k = begin; k < end; ++k)
                     words[batch.exact[k].first] =
                         classifier.classify(batch.exact[k].second, &why[batch.exact[k].first]);
                 });
    lines.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      lines.append(batch.text(i)).append(answer_of(words[i]));
      count(words[i], why[i], names, report);
    }
    if (const Status status = write(lines); !status) return status;
    if (certificate == nullptr) continue;
    certificate->certifier.add(batch.points, batch.exact, words);
    hash.update({reinterpret_cast<const unsigned char*>(lines.data()), lines.size()});
    certificate->answers.bytes += lines.size();
  }
  if (certificate != nullptr) certificate->answers.sha256 = to_hex(hash.finish());
  return ok_status();
}

}  // namespace veritope::cli
