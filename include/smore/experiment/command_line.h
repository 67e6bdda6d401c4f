// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace smore {

/// The value of an option: a number from `least` to `most`. What `target` holds is the default
/// where it lies in this range; else there is none.
template <typename Number>
class NumberOption : public boost::program_options::typed_value<Number> {
 public:
  NumberOption(Number* target, Number least, Number most);
  void xparse(boost::any& value, const std::vector<std::string>& tokens) const override;

 private:
  Number least_, most_;
};

/// The value of an option: one of `choices`. What `target` holds is the default where it is one of
/// them; else there is none.
class ChoiceOption : public boost::program_options::typed_value<std::string> {
 public:
  ChoiceOption(std::string* target, std::vector<std::string> choices);
  void xparse(boost::any& value, const std::vector<std::string>& tokens) const override;

 private:
  std::vector<std::string> choices_;
};

/// Sets the variables that belong to `options` from the command line, whose names must be whole.
/// What is no option belongs to the option `positional`. Returns the text to print if --help is
/// given, and sets nothing then. InputError with the option and what it takes where the command
/// line is wrong.
std::optional<std::string> readCommandLine(int argc, const char* const* argv,
                                           boost::program_options::options_description options,
                                           const std::string& positional = "");

}  // namespace smore
