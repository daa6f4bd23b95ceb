#include "drivers/study/shared_program.hpp"

#include <thread>

namespace anisofront {

SharedProgram::SharedProgram(std::function<ExpressionProgram()> compile)
    : compile_(std::move(compile)) {
  put_back(this->compile(), 0);
}

SharedProgram::~SharedProgram() {
  for (Place& place : places_) delete place.idle.load();
}

double SharedProgram::evaluate(Point p) {
  const std::size_t home = std::hash<std::thread::id>{}(std::this_thread::get_id());
  Owned program = take(home);
  const double value = program->evaluate({p.x, p.y}).front();
  put_back(std::move(program), home);
  return value;
}

SharedProgram::Owned SharedProgram::take(std::size_t home) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    std::atomic<ExpressionProgram*>& idle = places_[(home + i) % places_.size()].idle;
    if (idle.load(std::memory_order_relaxed) == nullptr) continue;
    if (ExpressionProgram* program = idle.exchange(nullptr)) return Owned(program);
  }
  return compile();
}

void SharedProgram::put_back(Owned program, std::size_t home) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    ExpressionProgram* none = nullptr;
    if (!places_[(home + i) % places_.size()].idle.compare_exchange_strong(none, program.get()))
      continue;
    program.release();
    return;
  }
}

SharedProgram::Owned SharedProgram::compile() {
  const std::lock_guard lock(compiling_);
  return std::make_unique<ExpressionProgram>(compile_());
}

}  // namespace anisofront
