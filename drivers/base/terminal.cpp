#include "drivers/base/terminal.hpp"

#include <cstdlib>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace anisofront {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

}  // namespace

Terminal terminal_of(int descriptor) {
  Terminal terminal;
  terminal.can_redraw = isatty(descriptor) != 0 && environment("TERM") != "dumb";
  // https://no-color.org: set and not empty
  terminal.has_colour = terminal.can_redraw && environment("NO_COLOR").empty();
  return terminal;
}

int terminal_columns(int descriptor, int otherwise) {
  winsize size{};
  const bool is_known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : otherwise;
}

}  // namespace anisofront
