// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/program_main.h"

#include <iostream>

#include "smore/common/result.h"
#include "smore/experiment/command_line.h"

namespace smore {

int runProgram(int argc, const char* const* argv,
               const boost::program_options::options_description& options,
               const std::function<int()>& run, const std::string& positional) {
  try {
    if (const auto help = readCommandLine(argc, argv, options, positional)) {
      std::cout << *help;
      return 0;
    }
    return run();
  } catch (const InputError& error) {
    std::cerr << error.what() << std::endl;
    return kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "internal error: " << error.what() << std::endl;
    return kInternalError;
  }
}

}  // namespace smore
