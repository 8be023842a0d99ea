// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/chain_classification.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "robust/base/parallel.h"
#include "robust/base/stopwatch.h"
#include "solids/chain/literal_chain.h"
#include "solids/chain/normal_chain.h"

namespace veritope::cli {

namespace {

struct ChainAnswer {
  std::optional<int> f, regular;
};

ChainAnswer answer_of(const NormalChain& chain, const ExactPoint& q, const ExactPoint& origin) {
  return {chain.value(q, origin), std::nullopt};
}
ChainAnswer answer_of(const LiteralChain& chain, const ExactPoint& q, const ExactPoint& origin) {
  const LiteralValue value = chain.value(q, origin);
  return {value.f, value.regular};
}

template <typename Chain>
Status answer_all(const PatchComplex& complex, const ExactPoint& origin, PointSource& source,
                  unsigned jobs, const WriteAnswers& write, report::ClassifyReport& report) {
  Stopwatch watch;
  const Chain chain(complex);
  report.seconds_build = watch.lap();
  PointBatch batch;
  std::vector<ExactPoint> points;
  std::vector<ChainAnswer> answers;
  std::string lines;
  for (;;) {
    if (const Status status = source.next(batch); !status) return status.error();
    if (batch.size() == 0) break;
    points.assign(batch.size(), {});
    for (std::size_t i = 0; i < batch.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        points[i][k] = Rational::from_double(batch.points[i][static_cast<int>(k)]);
    for (const auto& [at, point] : batch.exact) points[at] = point;
    answers.assign(batch.size(), {});
    parallel_for(batch.size(), 16, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) answers[i] = answer_of(chain, points[i], origin);
    });
    lines.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const auto& [f, regular] = answers[i];
      lines += batch.text(i);
      lines += " - " + (f ? std::to_string(*f) : "wall");
      lines += " " + (regular ? std::to_string(*regular) : "-") + "\n";
    }
    report.points += batch.size();
    if (const Status status = write(lines); !status) return status.error();
  }
  report.seconds_classify = watch.lap();
  return ok_status();
}

}  // namespace

Status classify_by_chain(const PatchComplex& complex, ChainKind kind, const ExactPoint& origin,
                         PointSource& source, unsigned jobs, const WriteAnswers& write,
                         report::ClassifyReport& report) {
  return kind == ChainKind::kNormal
             ? answer_all<NormalChain>(complex, origin, source, jobs, write, report)
             : answer_all<LiteralChain>(complex, origin, source, jobs, write, report);
}

}  // namespace veritope::cli
