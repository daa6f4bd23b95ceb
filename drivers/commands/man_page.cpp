// Macros: groff_man(7); language: groff(7).
#include "drivers/commands/man_page.hpp"

#include <algorithm>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

/// As it is, but for what roff would take for its own or show as something that cannot be typed.
std::string roff_character(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '`':
      return "\\(ga";
    case '\'':
      return "\\(aq";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return std::string(1, c);
  }
}

/// Text as roff shows it unchanged. A line must not begin with a dot.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) result += roff_character(c);
  return result.starts_with('.') ? "\\&" + result : result;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string section(const std::string& title) { return ".SH " + title + "\n"; }

/// A tagged paragraph.
std::string tagged(const std::string& tag, const std::string& text) {
  return ".TP\n" + tag + "\n" + roff(text) + "\n";
}

std::string option_tag(const OptionHelp& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back(bold(name) +
                    (option.value.name.empty() ? "" : " " + italic(value_name(option.value))));
  return option.names.empty() ? italic(value_name(option.value)) : joined(names);
}

std::string synopsis(const CommandHelp& command) {
  const std::string line = usage_line(command);
  return section("SYNOPSIS") + bold(command.name) + roff(line.substr(command.name.size())) + "\n";
}

std::string description(const CommandHelp& command) {
  std::string text = section("DESCRIPTION") + roff(command.summary) + ".\n";
  for (const std::string& paragraph : command.details) text += ".PP\n" + roff(paragraph) + "\n";
  return text;
}

std::string commands(const CommandHelp& command) {
  if (command.commands.empty()) return {};
  std::string text = section("COMMANDS");
  for (const CommandHelp& sub : command.commands)
    if (!sub.is_hidden) text += tagged(bold(sub.word()), sub.summary);
  return text;
}

std::string options(const CommandHelp& command) {
  std::string text;
  if (!command.arguments.empty()) text += section("ARGUMENTS");
  for (const OptionHelp& argument : command.arguments)
    text += tagged(option_tag(argument), option_text(argument));
  text += section("OPTIONS");
  const std::vector<std::string> groups = command.option_groups();
  for (const std::string& group : groups) {
    if (groups.size() > 1) text += ".SS " + roff(group) + "\n";
    for (const OptionHelp& option : command.options)
      if (option.group == group) text += tagged(option_tag(option), option_text(option));
  }
  return text;
}

std::string examples(const CommandHelp& command) {
  if (command.examples.empty()) return {};
  std::string text = section("EXAMPLES") + ".nf\n";
  for (const std::string& example : command.examples) text += roff(example) + "\n";
  return text + ".fi\n";
}

std::string exit_status() {
  std::string text = section("\"EXIT STATUS\"");
  for (const ExitCode& code : exit_codes())
    text += tagged(bold(std::to_string(code.code)), code.meaning);
  return text;
}

std::string environment() {
  return section("ENVIRONMENT") +
         tagged(bold("NO_COLOR"), "Set and not empty: no colours (https://no-color.org).") +
         tagged(bold("TERM"), "dumb: neither colours nor a progress bar.");
}

std::string see_also(const std::vector<std::string>& others) {
  if (others.empty()) return {};
  std::vector<std::string> pages;
  for (const std::string& name : others) pages.push_back(bold(name) + "(1)");
  return section("\"SEE ALSO\"") + joined(pages, ",\n") + "\n";
}

void collect(const CommandHelp& command, std::vector<const CommandHelp*>& all) {
  if (command.is_hidden) return;
  all.push_back(&command);
  for (const CommandHelp& sub : command.commands) collect(sub, all);
}

}  // namespace

std::string man_page_name(const CommandHelp& command) {
  std::string name = command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string man_page(const CommandHelp& command, const std::vector<std::string>& others) {
  std::string title = man_page_name(command);
  std::transform(title.begin(), title.end(), title.begin(), [](char c) {
    return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return fmt::format(".TH {} 1 \"\" \"anisofront {}\" \"User Commands\"\n.nh\n.ad l\n", roff(title),
                     ANISOFRONT_VERSION) +
         section("NAME") + roff(man_page_name(command)) + " \\- " + roff(command.summary) + "\n" +
         synopsis(command) + description(command) + commands(command) + options(command) +
         examples(command) + exit_status() + environment() + see_also(others);
}

std::vector<ManPage> man_pages(const CommandHelp& program) {
  std::vector<const CommandHelp*> all;
  collect(program, all);
  std::vector<ManPage> pages;
  for (const CommandHelp* command : all) {
    std::vector<std::string> others;
    for (const CommandHelp* other : all)
      if (other != command) others.push_back(man_page_name(*other));
    pages.push_back({man_page_name(*command) + ".1", man_page(*command, others)});
  }
  return pages;
}

}  // namespace anisofront
