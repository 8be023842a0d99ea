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

void count(PointWord word, report::ClassifyReport& report) {
  ++report.points;
  switch (word) {
    case PointWord::kIn: ++report.in; break;
    case PointWord::kOn: ++report.on; break;
    case PointWord::kOut: ++report.out; break;
    case PointWord::kUndecided:
      report.undecided.push_back({report.points,
                                  "boundaries meet there that are not flat, or at a place that is "
                                  "not known as exact numbers"});
  }
}

}  // namespace

Status classify_points(const ExpressionClassifier& classifier, PointSource& source, unsigned jobs,
                       const WriteAnswers& write, report::ClassifyReport& report,
                       ExpressionCertificate* certificate) {
  Sha256 hash;
  PointBatch batch;
  std::vector<PointWord> words;
  std::string lines;
  for (;;) {
    if (const Status status = source.next(batch); !status) return status;
    if (batch.size() == 0) break;
    words.resize(batch.size());
    classifier.classify(batch.points, words, jobs);
    parallel_for(batch.exact.size(), 16, jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t k = begin; k < end; ++k)
                     words[batch.exact[k].first] = classifier.classify(batch.exact[k].second);
                 });
    lines.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      lines.append(batch.text(i)).append(answer_of(words[i]));
      count(words[i], report);
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
