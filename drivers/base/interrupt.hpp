#pragma once

namespace anisofront {

/// While it lives, the first SIGINT or SIGTERM only raises a flag, so that finished work can be
/// kept; a second one ends the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Whether the user has asked to stop since the guard was made.
  static bool requested();
};

}  // namespace anisofront
