#pragma once

namespace anisofront {

/// What stands behind a file descriptor such as STDERR_FILENO.
struct Terminal {
  bool can_redraw = false;  ///< a terminal on which a line can be drawn again (not TERM=dumb)
  bool has_colour = false;  ///< and colours are welcome (NO_COLOR)
};
Terminal terminal_of(int descriptor);

/// Columns of the terminal now, which changes when its window does; `otherwise` for what is none.
int terminal_columns(int descriptor, int otherwise);

}  // namespace anisofront
