// Interface of completions: zsh manual, zshcompsys(1), "_arguments" and "_describe".
#include <algorithm>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/commands/completion.hpp"

namespace anisofront {
namespace {

/// "anisofront metric explain" -> "_anisofront_metric_explain".
std::string function_name(const CommandHelp& command) {
  std::string name = "_" + command.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// Text within single quotes, with a backslash before what _arguments takes for its own.
std::string escaped(const std::string& text, const std::string& special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) result += '\\';
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result;
}

std::string action(const ValueHelp& value) {
  if (!value.choices.empty()) return "(" + joined(value.choices, " ") + ")";
  if (value.is_folder) return "_files -/";
  // (-.): regular files, also behind links. Alone, (.toml) would be taken for such a qualifier.
  if (!value.suffixes.empty()) return "_files -g \"*(" + joined(value.suffixes, "|") + ")(-.)\"";
  if (value.is_command) return "_anisofront_commands";
  return value.is_file ? "_files" : " ";
}

/// ":DIR:_files -/".
std::string value_spec(const ValueHelp& value) {
  return ":" + escaped(value.name, ":") + ":" + action(value);
}

/// One word of _arguments per name; a name excludes the others and itself.
std::string option_specs(const OptionHelp& option) {
  std::string specs;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    std::string spec = fmt::format("({}){}", joined(option.names, " "), name);
    if (option.value.name == "KEY=VALUE") spec = "*" + name;  // as often as one likes
    if (!option.value.name.empty()) spec += is_long ? "=" : "+";
    spec += "[" + escaped(option.text, "[]:\\") + "]";
    if (!option.value.name.empty()) spec += value_spec(option.value);
    specs += "    '" + spec + "' \\\n";
  }
  return specs;
}

std::string function(const CommandHelp& command) {
  std::string text = function_name(command) + "() {\n";
  const bool has_commands = !command.commands.empty();
  if (has_commands) text += "  local state line\n";
  text += fmt::format("  _arguments -s -S{} \\\n", has_commands ? " -C" : "");
  for (const OptionHelp& option : command.options) text += option_specs(option);
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const OptionHelp& argument = command.arguments[i];
    const std::string position = argument.is_repeated ? "*" : std::to_string(i + 1);
    text += "    '" + position + value_spec(argument.value) + "' \\\n";
  }
  if (!has_commands) return text + "    && return\n}\n\n";
  text += fmt::format("    '1:command:{}_commands' '*::arguments:->arguments' && return\n",
                      function_name(command));
  text += "  [[ $state == arguments ]] || return\n  case $line[1] in\n";
  for (const CommandHelp& sub : command.commands)
    text += fmt::format("    {}) {} ;;\n", sub.word(), function_name(sub));
  text += fmt::format("  esac\n}}\n\n{}_commands() {{\n  local -a commands=(\n",
                      function_name(command));
  for (const CommandHelp& sub : command.commands)
    if (!sub.is_hidden)
      text += fmt::format("    '{}:{}'\n", sub.word(), escaped(sub.summary, ":\\"));
  return text + "  )\n  _describe command commands\n}\n\n";
}

std::string functions(const CommandHelp& command) {
  std::string text = function(command);
  for (const CommandHelp& sub : command.commands) text += functions(sub);
  return text;
}

}  // namespace

std::string zsh_completion(const CommandHelp& program) {
  return "#compdef anisofront\n# Completion for zsh, made by `anisofront completion zsh`.\n\n" +
         functions(program) +
         "# Autoloaded from the fpath, or read by `source`.\n"
         "if [[ $funcstack[1] == _anisofront ]]; then\n  _anisofront \"$@\"\n"
         "else\n  compdef _anisofront anisofront\nfi\n";
}

}  // namespace anisofront
