// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>

namespace smore {

constexpr int kInternalError = 1;  ///< exit code; also of an output that cannot be written
constexpr int kBadInput = 2;       ///< exit code

/// What each program's main returns: the exit code of `run`, once readCommandLine has set its
/// variables; 0 after --help. Errors become a line on standard error, with kBadInput for an
/// InputError and kInternalError for any other.
int runProgram(int argc, const char* const* argv,
               const boost::program_options::options_description& options,
               const std::function<int()>& run, const std::string& positional = "");

}  // namespace smore
