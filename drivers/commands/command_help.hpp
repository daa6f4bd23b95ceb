#pragma once

#include <string>
#include <vector>

namespace anisofront {

/// What a value on the command line may be, for people and for shells that complete it.
struct ValueHelp {
  std::string name;                   ///< "DIR", "KEY=VALUE"; empty: there is no value
  std::vector<std::string> choices;   ///< the words it must be one of
  std::vector<std::string> suffixes;  ///< of file names, ".toml"
  bool is_folder = false, is_file = false, is_command = false;
};

/// An option, a flag or a positional argument.
struct OptionHelp {
  std::vector<std::string> names;  ///< "-o", "--output"; none: positional
  ValueHelp value;
  std::string text, default_value, group;
  bool is_required = false, is_repeated = false;
};

/// A command with all that can be said about it. Help texts, man pages and the completion of shells
/// are made from this and nothing else.
struct CommandHelp {
  std::string name;  ///< in full: "anisofront metric explain"
  std::string summary, group;
  bool is_hidden = false;
  std::vector<std::string> details;   ///< paragraphs
  std::vector<std::string> examples;  ///< commands
  std::vector<OptionHelp> arguments, options;
  std::vector<CommandHelp> commands;

  /// "explain".
  std::string word() const;
  /// Groups of the options, in the order in which they first appear, that of all commands last.
  std::vector<std::string> option_groups() const;
};

/// The group of the options that every command has.
inline constexpr const char* kGeneralGroup = "General options";

struct ExitCode {
  int code;
  std::string meaning;
};
const std::vector<ExitCode>& exit_codes();

/// "anisofront run [OPTIONS] STUDY".
std::string usage_line(const CommandHelp& command);

/// The words to choose from, "best|paper", where they are few, else the name.
std::string value_name(const ValueHelp& value);

/// "-o, --output DIR".
std::string option_names(const OptionHelp& option);

/// The text with the words to choose from and the default where these say more than the names.
std::string option_text(const OptionHelp& option);

/// The whole text of --help, in lines of at most `columns`.
std::string help_text(const CommandHelp& command, int columns);

}  // namespace anisofront
