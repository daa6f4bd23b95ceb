#include <functional>

#include "mesher/geometry/error.hpp"
#include "solver/scalar/exact_solutions.hpp"

namespace anisofront {
namespace {

/// What a solution needs beyond diffusion > 0 and reaction >= 0.
enum class Need { nothing, reaction, flow, line, circle };

struct Entry {
  const char* name;
  Need need;
  std::function<ExactSolution(const ExactParameters&)> make;
};

const std::vector<Entry>& entries() {
  using P = ExactParameters;
  static const std::vector<Entry> table{
      {"product-layer", Need::reaction,
       [](const P& p) { return product_layer(p.diffusion, p.reaction); }},
      {"sine-product", Need::nothing,
       [](const P& p) { return sine_product(p.diffusion, p.reaction); }},
      {"corner-singularity", Need::nothing,
       [](const P& p) { return corner_singularity(p.diffusion, p.reaction); }},
      {"exponential-layer", Need::flow,
       [](const P& p) { return exponential_layer(p.diffusion, p.reaction, p.velocity.x); }},
      {"parabolic-layers", Need::flow,
       [](const P& p) { return parabolic_layers(p.diffusion, p.reaction, p.velocity.x); }},
      {"line-front", Need::line,
       [](const P& p) { return internal_front(p.diffusion, p.reaction, p.front); }},
      {"circle-front", Need::circle,
       [](const P& p) { return internal_front(p.diffusion, p.reaction, p.front); }},
  };
  return table;
}

const Entry& entry_of(std::string_view name) {
  std::string known;
  for (const Entry& entry : entries()) {
    if (entry.name == name) return entry;
    known += std::string(known.empty() ? "" : ", ") + "\"" + entry.name + "\"";
  }
  throw UsageError("unknown exact solution \"" + std::string(name) + "\", expected one of " +
                   known);
}

void require(bool condition, const Entry& entry, const char* what) {
  if (!condition)
    throw UsageError("exact solution \"" + std::string(entry.name) + "\" needs " + what);
}

void check_parameters(const Entry& entry, const ExactParameters& p) {
  require(p.diffusion > 0 && p.reaction >= 0, entry, "diffusion > 0 and reaction >= 0");
  require(entry.need != Need::reaction || p.reaction > 0, entry, "reaction > 0");
  require(entry.need != Need::flow || (p.velocity.x > 0 && p.velocity.y == 0), entry,
          "a velocity (speed, 0) with speed > 0");
  const bool is_front = entry.need == Need::line || entry.need == Need::circle;
  require(!is_front || p.front.width > 0, entry, "a width > 0");
  require(entry.need != Need::line || p.front.radius == 0, entry, "a line: radius 0");
  require(entry.need != Need::circle || p.front.radius > 0, entry, "a radius > 0");
}

/// The same u with b . grad u added to f.
void add_convection(Vector velocity, ExactSolution& exact) {
  exact.source = [source = exact.source, gradient = exact.gradient, velocity](Point p) {
    return source(p) + dot(velocity, gradient(p));
  };
}

}  // namespace

std::vector<std::string> exact_solution_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) names.emplace_back(entry.name);
  return names;
}

ExactSolution exact_solution(std::string_view name, const ExactParameters& parameters) {
  const Entry& entry = entry_of(name);
  check_parameters(entry, parameters);
  ExactSolution exact = entry.make(parameters);
  if (entry.need != Need::flow && !(parameters.velocity == Vector{}))
    add_convection(parameters.velocity, exact);
  return exact;
}

ExactSolution exact_solution(std::string_view name, double diffusion, double reaction) {
  return exact_solution(name, ExactParameters{diffusion, reaction, {}, {}});
}

}  // namespace anisofront
