// Interface of completions: GNU Bash manual, section 8.6, "Programmable Completion".
#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/commands/completion.hpp"

namespace anisofront {
namespace {

/// Commands are told by their words after the program: "", "run", "metric explain".
std::string key(const CommandHelp& command) {
  const std::size_t space = command.name.find(' ');
  return space == std::string::npos ? "" : command.name.substr(space + 1);
}

/// `case` patterns: "run:-o|run:--output".
std::string pattern(const CommandHelp& command, const std::vector<std::string>& words) {
  std::vector<std::string> patterns;
  for (const std::string& word : words)
    patterns.push_back(fmt::format("\"{}:{}\"", key(command), word));
  return joined(patterns, "|");
}

/// The words of the commands below this one.
std::string command_words(const CommandHelp& command) {
  std::vector<std::string> words;
  for (const CommandHelp& sub : command.commands)
    if (!sub.is_hidden) words.push_back(sub.word());
  return joined(words, " ");
}

std::string action(const ValueHelp& value) {
  if (!value.choices.empty()) return "_anisofront_words " + joined(value.choices, " ");
  if (value.is_folder) return "_anisofront_files /";
  if (value.is_file) return "_anisofront_files " + joined(value.suffixes, " ");
  return ":";
}

std::string line(const std::string& patterns, const std::string& action) {
  return fmt::format("    {}) {} ;;\n", patterns, action);
}

/// Calls `visit` for the command and all below it.
template <class Visit>
void for_each_command(const CommandHelp& command, const Visit& visit) {
  visit(command);
  for (const CommandHelp& sub : command.commands) for_each_command(sub, visit);
}

/// How the words typed so far change `command`, `value` and `position`.
std::string word_cases(const CommandHelp& program) {
  std::string text;
  for_each_command(program, [&](const CommandHelp& command) {
    for (const CommandHelp& sub : command.commands)
      text += "  " + line(pattern(command, {sub.word()}), fmt::format("command=\"{}\"", key(sub)));
    for (const OptionHelp& option : command.options)
      if (!option.value.name.empty())
        text += "  " + line(pattern(command, option.names), "value=1");
  });
  return text;
}

std::string value_cases(const CommandHelp& program) {
  std::string text;
  for_each_command(program, [&](const CommandHelp& command) {
    for (const OptionHelp& option : command.options)
      if (!option.value.name.empty())
        text += line(pattern(command, option.names), action(option.value) + "; return");
  });
  return text;
}

std::string option_cases(const CommandHelp& program) {
  std::string text;
  for_each_command(program, [&](const CommandHelp& command) {
    std::vector<std::string> names;
    for (const OptionHelp& option : command.options)
      names.insert(names.end(), option.names.begin(), option.names.end());
    text += line(fmt::format("\"{}:\"-*", key(command)), "_anisofront_words " + joined(names, " "));
  });
  return text;
}

std::string position_cases(const CommandHelp& program) {
  std::string text;
  for_each_command(program, [&](const CommandHelp& command) {
    if (!command.commands.empty())
      text += line(pattern(command, {"0"}), "_anisofront_words " + command_words(command));
    for (std::size_t i = 0; i < command.arguments.size(); ++i) {
      const OptionHelp& argument = command.arguments[i];
      const std::string position =
          fmt::format("\"{}:\"{}", key(command), argument.is_repeated ? "*" : std::to_string(i));
      text +=
          line(position, argument.value.is_command ? "_anisofront_words " + command_words(program)
                                                   : action(argument.value));
    }
  });
  return text;
}

constexpr const char* kHead =
    R"(# bash completion for anisofront, made by `anisofront completion bash`.

_anisofront_words() {
  mapfile -t COMPREPLY < <(compgen -W "$*" -- "$current")
}

# Folders, and files with these suffixes; without any, all files; "/": folders only.
_anisofront_files() {
  local suffix
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(
    if [[ $# == 0 ]]; then compgen -f -- "$current"; else compgen -d -- "$current"; fi
    for suffix; do
      [[ $suffix == / ]] || compgen -f -X "!*$suffix" -- "$current"
    done | sort -u
  )
}

_anisofront() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local command="" value="" position=0 word
  COMPREPLY=()
  # --option=word comes as three words.
  if [[ $current == "=" ]]; then
    current=""
  elif [[ $previous == "=" ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for word in "${COMP_WORDS[@]:1:COMP_CWORD - 1}"; do
    if [[ $value ]]; then
      [[ $word == "=" ]] || value=""
      continue
    fi
    case "$command:$word" in
)";

}  // namespace

std::string bash_completion(const CommandHelp& program) {
  return kHead + word_cases(program) +
         "      *:-*|*:=) ;;\n"
         "      *) position=$((position + 1)) ;;\n"
         "    esac\n  done\n"
         "  case \"$command:$previous\" in\n" +
         value_cases(program) + "  esac\n  case \"$command:$current\" in\n" +
         option_cases(program) + "    *)\n      case \"$command:$position\" in\n" +
         position_cases(program) +
         "      esac ;;\n  esac\n}\n\ncomplete -F _anisofront anisofront\n";
}

}  // namespace anisofront
