#include "drivers/commands/command_tree.hpp"

#include <sstream>

#include "drivers/base/text.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// CLI11 tells the type of a value and then what is accepted:
/// "WORD:best|paper", "FILE:.msh|.mesh" (see one_of() and file_name()).
ValueHelp value_help(const CLI::Option& option) {
  ValueHelp value;
  if (option.get_items_expected_max() == 0) return value;
  const std::vector<std::string> parts = split(option.get_type_name(), ':');
  value.name = option.nonpositional() ? parts.front() : option.get_name(true);
  value.is_folder = value.name == "DIR";
  value.is_command = value.name == "COMMAND";
  if (parts.size() > 1 && parts[1].starts_with('.'))
    value.suffixes = split(parts[1], '|');
  else if (parts.size() > 1 && parts[1].find('|') != std::string::npos)
    value.choices = split(parts[1], '|');
  value.is_file = !value.suffixes.empty() || value.name == "FILE";
  return value;
}

OptionHelp option_help(const CLI::Option& option) {
  OptionHelp help;
  for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  help.value = value_help(option);
  help.text = option.get_description();
  help.default_value = option.get_default_str();
  help.group = option.get_group();
  help.is_required = option.get_required();
  help.is_repeated = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  return help;
}

void add_options(const CLI::App& app, CommandHelp& help) {
  for (const CLI::Option* option : app.get_options()) {
    OptionHelp next = option_help(*option);
    if (option == app.get_help_ptr() || option == app.get_version_ptr()) next.group = kGeneralGroup;
    (option->nonpositional() ? help.options : help.arguments).push_back(std::move(next));
  }
}

void add_footer(const std::string& footer, CommandHelp& help) {
  bool is_new = true;
  for (const std::string& line : split(footer, '\n')) {
    const bool is_heading = line == "Example:" || line == "Examples:";
    if (line.starts_with("  anisofront ")) {
      help.examples.push_back(line.substr(2));
    } else if (!line.empty() && !is_heading) {
      if (is_new) help.details.emplace_back();
      help.details.back() += (is_new ? "" : " ") + line;
    }
    is_new = line.empty() || is_heading;
  }
}

}  // namespace

CommandHelp describe(const CLI::App& app) {
  CommandHelp help;
  help.name = full_name(app);
  help.summary = app.get_description();
  help.group = app.get_group();
  help.is_hidden = help.group.empty();
  add_options(app, help);
  add_footer(app.get_footer(), help);
  for (const CLI::App* command : app.get_subcommands({}))
    help.commands.push_back(describe(*command));
  return help;
}

const CLI::App& find_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    std::vector<std::string> known;
    const CLI::App* next = nullptr;
    for (const CLI::App* candidate : command->get_subcommands({})) {
      known.push_back(candidate->get_name());
      if (candidate->get_name() == word) next = candidate;
    }
    if (next == nullptr)
      throw UsageError(full_name(*command) + " has no command \"" + word + "\"" +
                       name_proposal(word, known));
    command = next;
  }
  return *command;
}

std::vector<std::string> known_words(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : app.get_options()) {
    const OptionHelp help = option_help(*option);
    words.insert(words.end(), help.names.begin(), help.names.end());
  }
  for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  return words;
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

}  // namespace anisofront
