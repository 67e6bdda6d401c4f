// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/command_line.h"

#include <algorithm>
#include <boost/lexical_cast.hpp>
#include <cstdint>
#include <filesystem>
#include <sstream>

#include "smore/common/result.h"

namespace smore {
namespace {

namespace po = boost::program_options;

template <typename Number>
std::string textOf(Number number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string listOf(const std::vector<std::string>& choices) {
  std::string list;
  for (const std::string& choice : choices) list += (list.empty() ? "" : "|") + choice;
  return list;
}

// Boost puts the option's name in.
[[noreturn]] void refuse(const std::vector<std::string>& tokens, const std::string& expected) {
  throw po::error_with_option_name("%canonical_option%: '" + tokens.front() + "' is not " +
                                   expected);
}

std::string helpOf(const std::string& program, const po::options_description& options,
                   const std::string& positional) {
  std::ostringstream text;
  text << "Usage: " << program << " [OPTION ...]"
       << (positional.empty() ? "" : " " + positional + " ...") << "\n\n"
       << options;
  return text.str();
}

// Boost leaves out what is no option where none takes it.
void refuseStrayTexts(const po::parsed_options& parsed) {
  for (const po::option& option : parsed.options) {
    if (option.string_key.empty()) {
      throw po::error("'" + option.value.front() + "' was not expected");
    }
  }
}

// A shell's variable that was never set would else do as if the option were not there.
void refuseEmptyTexts(const po::parsed_options& parsed) {
  for (const po::option& option : parsed.options) {
    if (!option.value.empty() && option.value.front().empty()) {
      throw po::error("--" + option.string_key + ": is empty");
    }
  }
}

}  // namespace

template <typename Number>
NumberOption<Number>::NumberOption(Number* target, Number least, Number most)
    : po::typed_value<Number>(target), least_(least), most_(most) {
  this->value_name(textOf(least) + ".." + textOf(most));
  if (*target >= least && *target <= most) this->default_value(*target, textOf(*target));
}

template <typename Number>
void NumberOption<Number>::xparse(boost::any& value, const std::vector<std::string>& tokens) const {
  // To Boost, "-1" is the largest of the numbers without a sign.
  const bool wraps = std::is_unsigned_v<Number> && tokens.front().compare(0, 1, "-") == 0;
  Number number{};
  if (wraps || !boost::conversion::try_lexical_convert(tokens.front(), number) ||
      !(number >= least_ && number <= most_)) {
    refuse(tokens, "a number from " + textOf(least_) + " to " + textOf(most_));
  }
  value = number;
}

template class NumberOption<int>;
template class NumberOption<double>;
template class NumberOption<std::uint64_t>;

ChoiceOption::ChoiceOption(std::string* target, std::vector<std::string> choices)
    : po::typed_value<std::string>(target), choices_(std::move(choices)) {
  value_name(listOf(choices_));
  const bool known = std::find(choices_.begin(), choices_.end(), *target) != choices_.end();
  if (known) default_value(*target);
}

void ChoiceOption::xparse(boost::any& value, const std::vector<std::string>& tokens) const {
  if (std::find(choices_.begin(), choices_.end(), tokens.front()) == choices_.end()) {
    refuse(tokens, "one of " + listOf(choices_));
  }
  value = tokens.front();
}

std::optional<std::string> readCommandLine(int argc, const char* const* argv,
                                           po::options_description options,
                                           const std::string& positional) {
  options.add_options()("help,h", "print this text");
  po::positional_options_description positions;
  if (!positional.empty()) positions.add(positional.c_str(), -1);
  constexpr int kWholeNames =
      po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  try {
    po::command_line_parser parser(argc, argv);
    parser.options(options).style(kWholeNames);
    if (!positional.empty()) parser.positional(positions);
    const po::parsed_options parsed = parser.run();
    refuseStrayTexts(parsed);
    po::variables_map given;
    po::store(parsed, given);
    refuseEmptyTexts(parsed);
    if (given.count("help") != 0) {
      return helpOf(std::filesystem::path(argv[0]).filename().string(), options, positional);
    }
    po::notify(given);
  } catch (const po::required_option& missing) {
    throw InputError(missing.get_option_name() + " is required; --help lists the options");
  } catch (const po::error& error) {
    throw InputError(std::string(error.what()) + "; --help lists the options");
  }
  return std::nullopt;
}

}  // namespace smore
