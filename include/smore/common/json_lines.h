// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <functional>
#include <string>

#include "smore/common/json.h"

namespace smore {

/// Writes a file of records, one JSON object a line. Each line is handed to the operating system
/// before `append` returns: what was appended outlives the end of this process, however it ends. A
/// crash in the middle of a line leaves a last line without its end, which readers leave out.
class JsonLinesWriter {
 public:
  /// A new file, over an old one. std::runtime_error if it cannot be opened.
  explicit JsonLinesWriter(const std::string& file);

  /// Numbers are written such that they are read back bit by bit. std::runtime_error if the line
  /// cannot be written (disk full).
  void append(const Json& record);

  /// A record as `append` writes it, with the end of its line.
  static std::string lineOf(const Json& record);

 private:
  std::string file_;
  std::ofstream stream_;
};

/// Text of a record for a file of its own, indented. Bytes that are not UTF-8, as a file's name may
/// have, are replaced.
std::string textOf(const Json& record);

/// Hands each whole line of the file to `take`, with its number from 1 on, in their order. A last
/// line without its end is a record that was cut: it is left out, and the result is false; else
/// true. InputError with file and line for a file that cannot be read, and for a line that is not a
/// JSON object.
bool readJsonLines(const std::string& file,
                   const std::function<void(int line, const Json& record)>& take);

/// The same of a stream, which messages call `name`.
bool readJsonLines(std::istream* stream, const std::string& name,
                   const std::function<void(int line, const Json& record)>& take);

}  // namespace smore
