#pragma once

#include <stdexcept>
#include <string>

namespace anisofront {

/// What went wrong, with the exit code of the program (README, "Exit codes").
enum class ErrorKind { failed = 2, usage = 3, input = 4, budget = 5, interrupted = 130 };

/// Every error that is reported to the user. The message says where (file and line, or curve name
/// and coordinates), what was found, what was expected and what to do.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// Invalid geometry, metric, mesh or file content.
struct InputError : Error {
  explicit InputError(const std::string& message) : Error(ErrorKind::input, message) {}
};

/// The input is valid but no usable result was found.
struct MeshingError : Error {
  explicit MeshingError(const std::string& message) : Error(ErrorKind::failed, message) {}
};

/// A limit on nodes, memory or time would be exceeded; the message holds the estimate.
struct BudgetError : Error {
  explicit BudgetError(const std::string& message) : Error(ErrorKind::budget, message) {}
};

/// Wrong command line or study file.
struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(ErrorKind::usage, message) {}
};

/// The user asked to stop.
struct Interrupted : Error {
  Interrupted() : Error(ErrorKind::interrupted, "interrupted") {}
};

}  // namespace anisofront
