// SPDX-License-Identifier: BSD-3-Clause
#include "smore/common/json_lines.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "smore/common/result.h"

namespace smore {

JsonLinesWriter::JsonLinesWriter(const std::string& file) : file_(file), stream_(file) {
  if (!stream_) throw std::runtime_error(file + ": cannot be written; check the directory");
}

void JsonLinesWriter::append(const Json& record) {
  stream_ << lineOf(record) << std::flush;
  if (!stream_) throw std::runtime_error(file_ + ": cannot be written; check the disk");
}

std::string JsonLinesWriter::lineOf(const Json& record) {
  constexpr int kOneLine = -1;
  return record.dump(kOneLine, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string textOf(const Json& record) {
  constexpr int kIndent = 2;
  return record.dump(kIndent, ' ', false, Json::error_handler_t::replace);
}

bool readJsonLines(const std::string& file,
                   const std::function<void(int line, const Json& record)>& take) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": cannot be read; check the path");
  return readJsonLines(&stream, file, take);
}

bool readJsonLines(std::istream* stream, const std::string& name,
                   const std::function<void(int line, const Json& record)>& take) {
  std::string text;
  int line = 0;
  while (std::getline(*stream, text)) {
    if (stream->eof()) return false;  // a line whose end is missing
    ++line;
    constexpr bool kThrow = false;
    const Json record = Json::parse(text, nullptr, kThrow);
    if (!record.is_object()) {
      throw InputError(name + ": line " + std::to_string(line) +
                       ": not a record (a JSON object); the file is damaged or of another kind");
    }
    take(line, record);
  }
  if (stream->bad() || (line == 0 && !stream->eof())) {
    throw InputError(name + ": cannot be read; check the path");
  }
  return true;
}

}  // namespace smore
