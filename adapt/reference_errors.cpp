#include "adapt/reference_errors.hpp"

#include <cmath>
#include <deque>

#include "adapt/reference.hpp"

namespace anisofront {
namespace {

/// The solution on one mesh, which it refers to: neither is moved.
struct SolvedMesh {
  FeMesh mesh;
  SolvedModel solved;
};

double vertices_of(const ReferenceSettings& reference, const SolvedMesh& last) {
  if (reference.vertices > 0) return reference.vertices;
  return (last.solved.order == 1 ? 16. : 8.) * static_cast<double>(last.mesh.mesh.points.size());
}

Mesh reference_mesh(const SolvedMesh& last, const Domain& domain, AdaptSettings settings,
                    GenerateOptions generate, double vertices, const Monitor& monitor) {
  settings.target = {.vertices = vertices, .error = {}};
  settings.density.mode = AdaptMode::anisotropic;
  settings.use_goal = false;
  settings.layer_metric = false;
  settings.elements = generate.elements = Elements::triangle;
  const Analysis analysis = analyse_solved(last.mesh, last.solved, settings, 1);
  return anisofront::generate(domain, last.mesh.mesh, analysis.metric, generate, monitor).mesh;
}

}  // namespace

MeasureErrors errors_against_reference(Model model, Domain domain, AdaptSettings settings,
                                       GenerateOptions generate, ReferenceSettings reference,
                                       Monitor monitor) {
  return [=](std::span<const Mesh> meshes) {
    std::deque<SolvedMesh> coarse;
    for (const Mesh& mesh : meshes) {
      coarse.push_back({curved_fe_mesh(mesh, domain), {}});
      coarse.back().solved = model(coarse.back().mesh, monitor);
    }
    const SolvedMesh& last = coarse.back();
    const Mesh fine_mesh =
        reference_mesh(last, domain, settings, generate, vertices_of(reference, last), monitor);
    const FeMesh fine = curved_fe_mesh(fine_mesh, domain);
    const SolvedModel solved = model(fine, monitor);
    const double energy = std::hypot(energy_of(solved.flux), std::sqrt(solved.extra_energy));
    std::vector<double> errors;
    for (const SolvedMesh& m : coarse)
      errors.push_back(energy_of_difference(solved.flux, m.mesh, m.solved.flux_at) / energy);
    return errors;
  };
}

}  // namespace anisofront
