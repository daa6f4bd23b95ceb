#include "drivers/commands/command_help.hpp"

#include <algorithm>
#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

/// Longer lists of words are told in the text of the option.
constexpr std::size_t kLongestChoices = 24;

/// Stands for a space that does not end a line.
constexpr char kNoBreak = '\x1f';

/// The words in lines of at most `columns`; lines but the first begin with `indent` spaces, and the
/// first is taken to.
std::string wrapped(const std::string& text, int indent, int columns) {
  std::istringstream words(text);
  std::string result;
  int column = indent;
  for (std::string word; words >> word;) {
    std::replace(word.begin(), word.end(), kNoBreak, ' ');
    const int width = static_cast<int>(word.size());
    if (column > indent && column + 1 + width > columns) {
      result += fmt::format("\n{:{}}", "", indent);
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += width;
  }
  return result;
}

/// A name and its meaning; long names have a line of their own.
std::string entry(const std::string& name, const std::string& text, int indent, int columns) {
  const bool fits = static_cast<int>(name.size()) + 4 <= indent;
  const std::string head = fits ? fmt::format("  {:<{}}", name, indent - 2)
                                : fmt::format("  {}\n{:{}}", name, "", indent);
  return head + wrapped(text, indent, columns) + "\n";
}

bool is_inline(const ValueHelp& value) {
  return !value.choices.empty() && joined(value.choices, "|").size() <= kLongestChoices;
}

std::string options_text(const CommandHelp& command, int columns) {
  constexpr int kIndent = 30;
  std::string text;
  if (!command.arguments.empty()) text += "\nArguments:\n";
  for (const OptionHelp& argument : command.arguments)
    text += entry(argument.value.name, option_text(argument), kIndent, columns);
  for (const std::string& group : command.option_groups()) {
    text += "\n" + group + ":\n";
    for (const OptionHelp& option : command.options)
      if (option.group == group)
        text += entry(option_names(option), option_text(option), kIndent, columns);
  }
  return text;
}

std::string commands_text(const CommandHelp& command, int columns) {
  constexpr int kIndent = 14;
  std::vector<std::string> groups;
  for (const CommandHelp& c : command.commands)
    if (!c.is_hidden && std::find(groups.begin(), groups.end(), c.group) == groups.end())
      groups.push_back(c.group);
  std::string text;
  for (const std::string& group : groups) {
    text += "\n" + group + ":\n";
    for (const CommandHelp& c : command.commands)
      if (!c.is_hidden && c.group == group) text += entry(c.word(), c.summary, kIndent, columns);
  }
  return text;
}

std::string exit_codes_text(int columns) {
  std::vector<std::string> codes;
  for (const ExitCode& code : exit_codes())
    codes.push_back(fmt::format("{}{}{}", code.code, kNoBreak, code.meaning));
  return "\n" + wrapped("Exit codes: " + joined(codes, "; ") + ".", 0, columns) + "\n";
}

}  // namespace

std::string CommandHelp::word() const { return name.substr(name.rfind(' ') + 1); }

std::vector<std::string> CommandHelp::option_groups() const {
  std::vector<std::string> groups;
  for (const OptionHelp& option : options)
    if (option.group != kGeneralGroup &&
        std::find(groups.begin(), groups.end(), option.group) == groups.end())
      groups.push_back(option.group);
  groups.emplace_back(kGeneralGroup);
  return groups;
}

const std::vector<ExitCode>& exit_codes() {
  static const std::vector<ExitCode> kCodes{
      {0, "done"},          {1, "done, but the target was missed"},
      {2, "failed"},        {3, "command line or study file"},
      {4, "invalid input"}, {5, "budget reached (nodes, memory, time)"},
      {130, "interrupted"}};
  return kCodes;
}

std::string value_name(const ValueHelp& value) {
  return is_inline(value) ? joined(value.choices, "|") : value.name;
}

std::string usage_line(const CommandHelp& command) {
  std::string line = command.name;
  if (!command.commands.empty()) return line + " COMMAND [ARGUMENTS] [OPTIONS]";
  line += " [OPTIONS]";
  for (const OptionHelp& option : command.options)
    if (option.is_required) line += " " + option.names.front() + " " + option.value.name;
  for (const OptionHelp& argument : command.arguments) {
    const std::string name = value_name(argument.value) + (argument.is_repeated ? "..." : "");
    line += argument.is_required ? " " + name : " [" + name + "]";
  }
  return line;
}

std::string option_names(const OptionHelp& option) {
  if (option.names.empty()) return option.value.name;
  std::string names = joined(option.names);
  // Long names stand below each other.
  if (option.names.front().starts_with("--")) names = "    " + names;
  return option.value.name.empty() ? names : names + " " + value_name(option.value);
}

std::string option_text(const OptionHelp& option) {
  std::string text = option.text;
  const bool tells_choices = !option.value.choices.empty() && !is_inline(option.value);
  if (tells_choices) text += "; one of: " + joined(option.value.choices);
  if (!option.default_value.empty()) text += " (default: " + option.default_value + ")";
  return text;
}

std::string help_text(const CommandHelp& command, int columns) {
  std::string text = wrapped(command.summary, 0, columns) + "\n\n";
  text += "Usage: " + wrapped(usage_line(command), 7, columns) + "\n";
  for (const std::string& paragraph : command.details)
    text += "\n" + wrapped(paragraph, 0, columns) + "\n";
  text += commands_text(command, columns) + options_text(command, columns);
  if (!command.examples.empty())
    text += command.examples.size() == 1 ? "\nExample:\n" : "\nExamples:\n";
  for (const std::string& example : command.examples) text += "  " + example + "\n";
  return text + exit_codes_text(columns);
}

}  // namespace anisofront
