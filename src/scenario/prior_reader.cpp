// SPDX-License-Identifier: BSD-3-Clause
#include "prior_reader.h"

#include <filesystem>

namespace smore {
namespace {

constexpr Range kScale{-1e6, 1e6};
constexpr int kMostEntries = 32;  // of both maps together as many as the belief takes

void readFile(ParameterReader* reader, PriorSource* entry) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(entry->file, problem)) {
    reader->error("source", "no file '" + entry->file + "'; give 'truth' or a path of a file, " +
                                "relative to the scenario's");
    return;
  }
  Vec3 position = Vec3::Zero();
  Vec3 rpy = Vec3::Zero();
  if (reader->has("position")) reader->vector("position", &position, kPriorPosition);
  if (reader->has("rpy")) reader->angles("rpy", &rpy);
  entry->pose = makePose(position, rpy);
  if ((entry->format == PriorFormat::kMesh || entry->format == PriorFormat::kCloud) &&
      reader->has("scale")) {
    reader->vector("scale", &entry->scale, kScale);
  }
}

void readBox(ParameterReader* reader, PriorSource* entry) {
  const bool has_min = reader->has("min");
  const bool has_max = reader->has("max");
  if (!has_min && !has_max) return;
  Bounds box;
  reader->vector("min", &box.min, kPriorPosition);
  reader->vector("max", &box.max, kPriorPosition);
  if (!has_min || !has_max) return;
  if ((box.min.array() >= box.max.array()).any()) {
    reader->error("min", "not below max; give min first on every axis");
  }
  entry->box = box;
}

std::vector<PriorSource> readEntries(ParameterReader* reader, const std::string& key,
                                     const std::string& directory) {
  std::vector<PriorSource> entries;
  if (!reader->has(key)) return entries;
  for (ParameterReader& section : reader->list(key)) {
    std::string source;
    section.text("source", &source);
    if (source.empty()) continue;
    PriorSource entry;
    const bool of_file = source != "truth";
    if (of_file) entry.file = source.front() == '/' ? source : directory + source;
    const auto format = of_file ? priorFormatOf(entry.file) : PriorFormat::kTruth;
    if (!format) {
      section.error("source", "'" + source + "' is none of: truth, " + kPriorFiles);
      continue;
    }
    entry.format = *format;
    if (of_file) readFile(&section, &entry);
    readBox(&section, &entry);
    if (section.has("offset")) section.vector("offset", &entry.offset, kPriorPosition);
    if (section.has("confidence"))
      section.number("confidence", &entry.confidence, kPriorConfidence);
    section.finishNested();
    entries.push_back(entry);
  }
  if (entries.size() > kMostEntries) {
    reader->error(key, "more than " + std::to_string(kMostEntries) + " entries; join some files");
  }
  return entries;
}

}  // namespace

PriorSources readPriorSources(ParameterReader* reader, const std::string& directory) {
  PriorSources sources;
  if (!reader->has("prior")) return sources;
  ParameterReader section = reader->nested("prior");
  sources.object = readEntries(&section, "object", directory);
  sources.world = readEntries(&section, "world", directory);
  section.finishNested();
  return sources;
}

}  // namespace smore
