// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/evidence_journal.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace smore {
namespace {

namespace fs = std::filesystem;

const char* const kExtension = ".evidence";

// The number of a journal's file; 0 for any other.
int numberOf(const fs::path& file) {
  if (file.extension() != kExtension) return 0;
  const std::string stem = file.stem().string();
  int number = 0;
  const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  return error == std::errc() && end == stem.data() + stem.size() ? number : 0;
}

int newestNumber(const std::string& directory) {
  int newest = 0;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(directory, missing)) {
    newest = std::max(newest, numberOf(entry.path()));
  }
  return newest;
}

std::string fileName(const std::string& directory, int number) {
  return (fs::path(directory) / (std::to_string(number) + kExtension)).string();
}

void takeName(const std::string& file, const std::string& name) {
  std::error_code problem;
  fs::rename(file, name, problem);
  if (problem) throw std::runtime_error(name + ": cannot be written: " + problem.message());
}

}  // namespace

/// A file with a name that it took once these observations were in it.
struct OpenEvidence {
  OpenEvidence(const std::string& name, const EvidenceSource& source,
               const std::vector<ContactObservation>& observations)
      : writer(name + ".part"), recorder(&writer, source) {
    for (const ContactObservation& observation : observations) recorder.observe(observation);
    takeName(name + ".part", name);
  }

  JsonLinesWriter writer;
  EvidenceRecorder recorder;
};

EvidenceJournal::~EvidenceJournal() = default;

EvidenceJournal::EvidenceJournal(const std::string& directory, EvidenceSource source)
    : directory_(directory), source_(std::move(source)) {
  std::error_code problem;
  fs::create_directories(directory, problem);
  if (problem) {
    throw std::runtime_error("journal: the directory '" + directory +
                             "' cannot be made: " + problem.message());
  }
}

void EvidenceJournal::begin(const Priors& priors,
                            const std::vector<ContactObservation>& observations) {
  source_.priors = priors;
  const std::string name = fileName(directory_, newestNumber(directory_) + 1);
  file_ = std::make_unique<OpenEvidence>(name, source_, observations);
}

void EvidenceJournal::observe(const ContactObservation& observation) {
  file_->recorder.observe(observation);
}

std::optional<std::string> EvidenceJournal::newest(const std::string& directory) {
  const int number = newestNumber(directory);
  if (number == 0) return std::nullopt;
  return fileName(directory, number);
}

void writeEvidence(const std::string& file, const EvidenceSource& source,
                   const std::vector<ContactObservation>& observations) {
  try {
    const OpenEvidence written(file, source, observations);
  } catch (...) {
    std::error_code ignored;
    fs::remove(file + ".part", ignored);
    throw;
  }
}

}  // namespace smore
