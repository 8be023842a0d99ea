// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/classification.h"

#include <utility>
#include <vector>

#include "io/mesh/reading_rule.h"
#include "robust/base/parallel.h"
#include "robust/base/stopwatch.h"
#include "verify/certify/certify.h"
#include "verify/certify/patch_points_certifier.h"
#include "verify/certify/points_certifier.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

// "in 1 0": word, f and shell.
void append_answer(const PointAnswer& answer, bool is_winding, std::string& out) {
  if (!answer.is_decided)
    out += " undecided -";
  else if (answer.is_on())
    out += " on -";
  else
    out += (is_winding            ? " - "
            : answer.winding != 0 ? " in "
                                  : " out ") +
           std::to_string(answer.winding);
  out += answer.shell == kNowhere ? " -\n" : " " + std::to_string(answer.shell) + "\n";
}

certificate::Subject subject_of(const MeshFile& file) {
  certificate::Subject out;
  out.sha256 = file.sha256;
  out.bytes = file.report.bytes;
  out.format = mesh_format_name(file.report.format);
  out.as_indexed = file.report.as_indexed;
  out.reading_rule = kReadingRule;
  out.tool = tool_name();
  return out;
}

void add_to(PointsCertifier& certifier, const PointBatch& batch,
            std::span<const PointAnswer> answers) {
  certifier.add(batch.points, answers);
}
void add_to(PatchPointsCertifier& certifier, const PointBatch& batch,
            std::span<const PointAnswer> answers) {
  certifier.add(batch.points, batch.exact, answers);
}

// Points in, lines out. Classifier, Certifier: MeshClassifier and PointsCertifier, or PatchClassifier and
// PatchPointsCertifier.
template <typename Classifier, typename Certifier>
class Classification {
 public:
  Classification(const Classifier& classifier, const ClassifySettings& settings,
                 std::optional<Certifier> certifier, report::ClassifyReport& report)
      : classifier_(classifier),
        settings_(settings),
        certifier_(std::move(certifier)),
        report_(report) {
    const LookupSize lookup = classifier.lookup();
    report.lookup_cells = lookup.cells;
    report.lookup_bytes = lookup.bytes;
  }

  Status answer_all(PointSource& source, const WriteAnswers& write) {
    PointBatch batch;
    for (;;) {
      if (const Status status = source.next(batch); !status) return status.error();
      if (batch.size() == 0) return ok_status();
      if (const Status status = write(answer(batch)); !status) return status.error();
    }
  }

  ClassifiedPoints certificate(const certificate::Subject& subject) {
    ClassifiedPoints out;
    if (!certifier_) return out;
    certificate::AnswersSubject answers;
    answers.sha256 = to_hex(hash_.finish());
    answers.bytes = num_bytes_;
    answers.are_decimals_exact = settings_.decimals == Decimals::kExact;
    answers.is_winding = settings_.is_winding;
    Result<certificate::Bytes> made = certifier_->finish(subject, std::move(answers));
    if (made)
      out.certificate = std::move(*made);
    else
      out.refusal = made.error();
    return out;
  }

 private:
  // The lines of the answers of a batch.
  const std::string& answer(const PointBatch& batch) {
    classify(batch);
    if (certifier_) add_to(*certifier_, batch, answers_);
    lines_.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      lines_ += batch.text(i);
      append_answer(answers_[i], settings_.is_winding, lines_);
      count(answers_[i]);
    }
    if (certifier_) {
      hash_.update({reinterpret_cast<const unsigned char*>(lines_.data()), lines_.size()});
      num_bytes_ += lines_.size();
    }
    return lines_;
  }

  // Points that binary64 has are answered in runs, without the rounded ones between them.
  void classify(const PointBatch& batch) {
    answers_.resize(batch.size());
    std::size_t begin = 0;
    const auto answer_until = [&](std::size_t end) {
      if (begin < end)
        classifier_.classify(std::span(batch.points).subspan(begin, end - begin),
                             std::span(answers_).subspan(begin, end - begin), settings_.jobs);
      begin = end + 1;
    };
    for (const auto& [at, point] : batch.exact) answer_until(at);
    answer_until(batch.size());
    parallel_for(batch.exact.size(), 16, settings_.jobs,
                 [&](std::size_t, std::size_t first, std::size_t last) {
                   for (std::size_t k = first; k < last; ++k)
                     answers_[batch.exact[k].first] = classifier_.classify(batch.exact[k].second);
                 });
  }

  void count(const PointAnswer& answer) {
    ++report_.points;
    if (!answer.is_decided)
      report_.add_undecided(
          "whether the point is on the surface is open: 2560 bits and 131,072 pieces do not tell");
    else if (answer.is_on())
      ++report_.on;
    else if (!settings_.is_winding)
      ++(answer.winding != 0 ? report_.in : report_.out);
  }

  const Classifier& classifier_;
  const ClassifySettings& settings_;
  std::optional<Certifier> certifier_;
  report::ClassifyReport& report_;
  std::vector<PointAnswer> answers_;
  std::string lines_;
  Sha256 hash_;
  std::uint64_t num_bytes_ = 0;
};

}  // namespace

Result<ClassifiedPoints> classify_points(const MeshFile& file, const MeshShells* shells,
                                         PointSource& source, const ClassifySettings& settings,
                                         const WriteAnswers& write, Progress& progress,
                                         const std::string& shown_name,
                                         report::ClassifyReport& report) {
  Stopwatch watch;
  progress.phase(shown_name, "building the look-up");
  const Result<MeshClassifier> classifier = MeshClassifier::make(file.mesh, shells);
  if (!classifier) return classifier.error();
  std::optional<PointsCertifier> certifier;
  if (settings.makes_certificate) certifier.emplace(file, settings.jobs);
  report.seconds_build = watch.lap();
  Classification run(*classifier, settings, std::move(certifier), report);
  progress.phase(shown_name, "classifying");
  if (const Status status = run.answer_all(source, write); !status) return status.error();
  report.seconds_classify = watch.lap();
  return run.certificate(subject_of(file));
}

Result<ClassifiedPoints> classify_points(const FilePatches& patches,
                                         const certificate::Subject& subject, PointSource& source,
                                         const ClassifySettings& settings,
                                         const WriteAnswers& write, Progress& progress,
                                         const std::string& shown_name,
                                         report::ClassifyReport& report) {
  Stopwatch watch;
  progress.phase(shown_name, "building the look-up");
  const PatchClassifier classifier = PatchClassifier::make(*patches.complex, !settings.is_winding);
  std::optional<PatchPointsCertifier> certifier;
  if (settings.makes_certificate) certifier.emplace(patches, classifier);
  report.seconds_build = watch.lap();
  Classification run(classifier, settings, std::move(certifier), report);
  progress.phase(shown_name, "classifying");
  if (const Status status = run.answer_all(source, write); !status) return status.error();
  report.seconds_classify = watch.lap();
  return run.certificate(subject);
}

}  // namespace veritope::cli
