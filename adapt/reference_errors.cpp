#include "adapt/reference_errors.hpp"

#include <cmath>

#include "adapt/reference.hpp"

namespace anisofront {
namespace {

double vertices_of(const ReferenceSettings& reference, int order, const Mesh& last) {
  if (reference.vertices > 0) return reference.vertices;
  return (order == 1 ? 16. : 8.) * static_cast<double>(last.points.size());
}

Mesh reference_mesh(const Model& model, const Domain& domain, AdaptSettings settings,
                    GenerateOptions generate, double vertices, const Mesh& last,
                    const Monitor& monitor) {
  settings.target = {.vertices = vertices, .error = {}};
  settings.density.mode = AdaptMode::anisotropic;
  settings.use_goal = false;
  settings.layer_metric = false;
  settings.elements = generate.elements = Elements::triangle;
  const Analysis analysis = analyse_model(model, domain, settings)(last, 1);
  return anisofront::generate(domain, last, analysis.metric, generate, monitor).mesh;
}

}  // namespace

MeasureErrors errors_against_reference(Model model, Domain domain, AdaptSettings settings,
                                       GenerateOptions generate, ReferenceSettings reference,
                                       Monitor monitor) {
  return [=](std::span<const Mesh> meshes) {
    const Mesh& last = meshes.back();
    const int order = model(curved_fe_mesh(last, domain), monitor).order;
    const Mesh mesh = reference_mesh(model, domain, settings, generate,
                                     vertices_of(reference, order, last), last, monitor);
    const FeMesh fine = curved_fe_mesh(mesh, domain);
    const SolvedModel solved = model(fine, monitor);
    const double energy = std::hypot(energy_of(solved.flux), std::sqrt(solved.extra_energy));
    std::vector<double> errors;
    for (const Mesh& m : meshes) {
      const FeMesh coarse = curved_fe_mesh(m, domain);
      const SolvedModel on_coarse = model(coarse, monitor);
      errors.push_back(energy_of_difference(solved.flux, coarse, on_coarse.flux_at) / energy);
    }
    return errors;
  };
}

}  // namespace anisofront
