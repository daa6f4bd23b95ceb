#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "drivers/study/expression.hpp"

namespace anisofront {

/// A program of x and y for several threads at once. Each call borrows a compiled copy that nobody
/// else holds and puts it back; a copy more is compiled when all are lent. No lock on the way but
/// for that.
class SharedProgram {
 public:
  /// `compile` makes a copy; what it throws is thrown on (here already for the first).
  explicit SharedProgram(std::function<ExpressionProgram()> compile);
  ~SharedProgram();
  SharedProgram(const SharedProgram&) = delete;
  SharedProgram& operator=(const SharedProgram&) = delete;

  /// Value of the first expression at p.
  double evaluate(Point p);

 private:
  using Owned = std::unique_ptr<ExpressionProgram>;

  Owned take(std::size_t home);
  void put_back(Owned program, std::size_t home);
  Owned compile();

  /// Threads start to look at a place of their own; a cache line each.
  struct alignas(64) Place {
    std::atomic<ExpressionProgram*> idle{nullptr};
  };
  std::array<Place, 32> places_;
  std::function<ExpressionProgram()> compile_;
  std::mutex compiling_;
};

}  // namespace anisofront
