// Random operations on meshes of every kind: the laws that each of them keeps.
#include <doctest/doctest.h>

#include "tests/mesher/quads/quad_fixtures.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

/// Sum of (valence - ideal)^2.
int valence_defect(const QuadWork& work) {
  int sum = 0;
  for (std::size_t v = 0; v < work.ideal.size(); ++v)
    if (work.mesh.leaving[v] != kNoIndex) {
      const int defect = work.mesh.valence[v] - work.ideal[v];
      sum += defect * defect;
    }
  return sum;
}

/// What an operation that was done has broken, or an empty text. Its transaction is still open.
std::string broken_by_operation(QuadWork& work, const QuadWork& before) {
  std::string defect = broken_invariant(work.mesh);
  if (!defect.empty()) return defect;
  if (rim_of(work.mesh) != rim_of(before.mesh)) return "the rim has changed";
  if (euler_number(work.mesh) != euler_number(before.mesh)) return "the Euler number has changed";
  if (std::fabs(signed_area(work.mesh) - signed_area(before.mesh)) > 1e-9) return "area";
  for (std::size_t v = 0; v < before.mesh.vertices.size(); ++v)
    if (before.mesh.leaving[v] != kNoIndex && before.mesh.kind[v] != QuadVertexKind::free &&
        (work.mesh.leaving[v] == kNoIndex ||
         !same_vertex(work.mesh.vertices[v], before.mesh.vertices[v])))
      return "vertex " + std::to_string(v) + " that must stay has gone or moved";
  if (work.valence_growth() != valence_defect(work) - valence_defect(before))
    return "growth of the valences";
  int not_convex = 0;
  const double change = work.energy_change(not_convex);
  const double energy = total_energy(work), energy_before = total_energy(before);
  // Edges of nearly no length weigh any amount: relative to the sums.
  if (!(std::fabs(change - (energy - energy_before)) <=
        1e-9 * (1 + std::fabs(energy) + std::fabs(energy_before))))
    return "energy change";
  return {};
}

/// After a commit every energy is that of its quadrilateral, every metric that of its place.
std::string stale(const QuadWork& work) {
  for (std::size_t v = 0; v < work.mesh.vertices.size(); ++v) {
    if (work.mesh.leaving[v] == kNoIndex) continue;
    const WorkVertex& vertex = work.mesh.vertices[v];
    Index hint = vertex.hint;
    const MetricFactor r = work.background.factor_at(vertex.p, hint);
    if (std::fabs(r.a - vertex.r.a) + std::fabs(r.b - vertex.r.b) + std::fabs(r.c - vertex.r.c) >
        1e-9 * (r.a + r.c))
      return "metric of vertex " + std::to_string(v);
  }
  for (Index q = 0; q < work.mesh.quad_count(); ++q)
    if (!work.mesh.is_dead(q) && work.energy[q] != work.energy_of(q).value)
      return "energy of quadrilateral " + std::to_string(q);
  return {};
}

struct Tally {
  std::array<int, kOperationKinds> done{}, refused{};
};

/// Random operations, committed or undone at random but for a mesh that would become too small; the
/// first defect, or an empty text.
std::string first_defect(QuadWork& work, std::mt19937_64& random, int count, Tally& tally) {
  const Index least = live_quads(work.mesh) * 2 / 3;
  for (int i = 0; i < count; ++i) {
    const QuadWork before = work;
    const int kind = static_cast<int>(random() % kOperationKinds);
    const std::string at = "operation " + std::to_string(i) + " of kind " + std::to_string(kind);
    std::string defect;
    if (!apply_random(work, random, kind)) {
      ++tally.refused[kind];
      defect = difference(work, before);
    } else {
      ++tally.done[kind];
      defect = broken_by_operation(work, before);
      if (defect.empty() && (random() % 2 || live_quads(work.mesh) < least)) {
        work.undo();
        defect = difference(work, before);
      } else if (defect.empty()) {
        work.commit();
        defect = stale(work);
      }
    }
    if (!defect.empty()) return at + ": " + defect;
  }
  return {};
}

}  // namespace

TEST_SUITE("property") {
  TEST_CASE("random operations keep the mesh whole and can be undone to the bit") {
    Tally tally;
    for (NamedMesh& named : property_meshes())
      for (const unsigned seed : {1u, 2u, 3u, 4u}) {
        CAPTURE(named.name);
        CAPTURE(seed);
        std::mt19937_64 random(seed);
        const BackgroundMesh background =
            background_of(smooth_random_metric(random, 1, 5, 6), {-1, -1}, {7, 7});
        MixedMesh mesh = named.mesh;
        perturb(mesh, random, 0.3);
        QuadWork work = work_on(background, mesh);
        REQUIRE(broken_invariant(work.mesh) == "");
        CHECK(first_defect(work, random, 1500, tally) == "");
      }
    for (int kind = 0; kind < kOperationKinds; ++kind) {  // else the test has seen nothing
      CAPTURE(kind);
      CHECK(tally.done[kind] > 400);
      CHECK(tally.refused[kind] > 400);
    }
  }
}
