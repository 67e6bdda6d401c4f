// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/evidence.h"

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "evidence_records.h"
#include "prior_record.h"
#include "smore/common/json_lines.h"
#include "smore/common/result.h"
#include "task_record.h"

namespace smore {
namespace {

// Takes one record after the other: header, task and method first, then what happened.
class EvidenceReader {
 public:
  EvidenceReader(std::string file, const std::optional<MethodParameters>& parameters)
      : parameters_(parameters) {
    evidence_.file = std::move(file);
  }

  Evidence read() { return whole(readJsonLines(evidence_.file, taker())); }
  Evidence read(std::istream* stream) {
    return whole(readJsonLines(stream, evidence_.file, taker()));
  }

 private:
  static constexpr int kFirstRecords = 3;

  std::function<void(int, const Json&)> taker() {
    return [this](int line, const Json& record) { take(line, record); };
  }

  Evidence whole(bool to_the_end) {
    evidence_.whole = to_the_end;
    if (records_ < kFirstRecords) {
      throw InputError(evidence_.file +
                       ": the file ends before its header, task and method are whole; nothing can "
                       "be made of it");
    }
    return std::move(evidence_);
  }

  void take(int line, const Json& record) {
    const JsonFields fields(record, evidence_.file + ": line " + std::to_string(line));
    switch (records_++) {
      case 0:
        return takeHeader(fields);
      case 1:
        expect("task", fields);
        evidence_.source.task = readTask(fields);
        return checkPlace(fields, "start", evidence_.source.task.start);
      case 2:
        expect("method", fields);
        return takeMethod(fields);
      default:
        return takeEvent(fields);
    }
  }

  void takeHeader(const JsonFields& header) {
    if (header.raw("format") != kEvidenceFormat) {
      throw InputError(evidence_.file + ": not a file of evidence; give one that was written by " +
                       "smore_experiment --record");
    }
    const int version = header.integer("version", 1, std::numeric_limits<int>::max());
    evidence_.program = header.text("program");
    if (version > kEvidenceVersion) {
      throw InputError(evidence_.file + ": format version " + std::to_string(version) +
                       ", written by " + evidence_.program + "; this program reads up to version " +
                       std::to_string(kEvidenceVersion) + ": use a newer one");
    }
  }

  static void expect(const std::string& kind, const JsonFields& record) {
    if (record.raw("record") != kind) {
      record.fail("record", "expected '" + kind + "'; the file is damaged");
    }
  }

  void takeMethod(const JsonFields& record) {
    EvidenceSource& source = evidence_.source;
    source.method = static_cast<MethodKind>(record.choice("method", methodNames()));
    source.seed = record.count("seed");
    if (parameters_) {
      source.parameters = *parameters_;
    } else if (source.method == MethodKind::kSmore || record.has("parameters")) {
      // Files of the method paper from before it had parameters lack them.
      (void)record.object("parameters");
      source.parameters = readMethodParameters(YAML::Load(record.raw("parameters").dump()),
                                               evidence_.file + ": parameters");
    }
  }

  void takeEvent(const JsonFields& record) {
    const std::string kind = record.text("record");
    if (kind == "observation") {
      evidence_.observations.push_back(readObservation(record));
      checkPlace(record, "pose", evidence_.observations.back().T_world_object);
    } else if (kind == "motion") {
      evidence_.motions.push_back(readMotion(record));
      evidence_.motions.back().observations_before = evidence_.observations.size();
    } else if (kind == "motion_end") {
      if (evidence_.motions.empty()) record.fail("record", "no motion began before");
      readMotionEnd(record, &evidence_.motions.back());
    } else if (kind == "outcome") {
      evidence_.outcome = readOutcome(record);
    } else if (kind == "prior") {
      evidence_.source.priors.of(readPriorSide(record)).push_back(readPrior(record));
    } else if (kind != "truth") {  // which is for scores alone
      record.fail("record", "unknown kind '" + kind + "'; the file is damaged");
    }
  }

  // What the mapping takes, and so writes, is read again.
  static void checkPlace(const JsonFields& record, const std::string& key, const Pose& pose) {
    if (pose.translation().cwiseAbs().maxCoeff() > kFarthestPlace) {
      record.fail(key, "far outside, more than 10 km from the origin; the record is damaged");
    }
  }

  std::optional<MethodParameters> parameters_;
  Evidence evidence_;
  int records_ = 0;
};

}  // namespace

Evidence readEvidence(const std::string& file, const std::optional<MethodParameters>& parameters) {
  return EvidenceReader(file, parameters).read();
}

std::string toRecords(const EvidenceSource& source) {
  std::string text;
  for (const Json& record : sourceRecords(source)) text += JsonLinesWriter::lineOf(record);
  return text;
}

EvidenceSource readEvidenceSource(const std::string& records, const std::string& name,
                                  const std::optional<MethodParameters>& parameters) {
  std::istringstream stream(records);
  return EvidenceReader(name, parameters).read(&stream).source;
}

void replay(const Evidence& evidence, Method* method) {
  try {
    for (const ContactObservation& observation : evidence.observations) {
      method->observe(observation);
    }
    (void)method->maps->world();  // made when they are asked for
    (void)method->maps->object();
  } catch (const std::out_of_range& error) {
    throw InputError(evidence.file + ": an observation lies outside of the maps (" + error.what() +
                     "); use larger voxels");
  }
}

}  // namespace smore
