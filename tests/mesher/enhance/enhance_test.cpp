#include "mesher/enhance/enhance.hpp"

#include <algorithm>
#include <cstring>
#include <random>

#include <doctest/doctest.h>

#include "mesher/enhance/paper_smooth.hpp"
#include "mesher/enhance/repair.hpp"
#include "mesher/enhance/smooth.hpp"
#include "mesher/enhance/vertex_energy.hpp"
#include "mesher/geometry/error.hpp"
#include "tests/support/work_meshes.hpp"

using namespace anisofront;
using namespace anisofront::testing;

namespace {

struct Filled {
  WorkCase work;
  Patch patch;
  Filled(unsigned seed, double stretch, const Domain& domain = square_domain(1))
      : work(make(seed, stretch, domain)), patch(make_patch(*work.background, work.mesh(), {})) {}

  static WorkCase make(unsigned seed, double stretch, const Domain& domain) {
    std::mt19937_64 random(seed);
    WorkCase work(domain, RandomMetric{&random, 0.12, stretch}, {0, 0}, {1, 1});
    work.advance();
    return work;
  }
};

Domain square_with_slit() {
  Domain domain = square_domain(1);
  for (const auto& [a, b] :
       {std::pair{Point{0.3, 0.5}, Point{0.7, 0.5}}, std::pair{Point{0.5, 0.5}, Point{0.45, 0.8}}})
    domain.regions[0].embedded_curves.push_back(
        add_curve(domain, "slit" + std::to_string(domain.curves.size()), 9, make_line(a, b)));
  return domain;
}

/// Energy of the paper's objectives over the whole mesh: sum over triangles of alpha^-3 - 1 and
/// over edges of (l^2 + l^-2 - 2)^2, l^2 the geometric mean of both ends.
double total_energy(const Patch& patch) {
  double sum = 0;
  for (Index t = 0; t < static_cast<Index>(patch.mesh.triangles.size()); ++t) {
    const WorkTriangle& triangle = patch.mesh.triangles[t];
    if (triangle.dead()) continue;
    sum += std::pow(patch.alpha_of(t), -3) - 1;
    for (int k = 0; k < 3; ++k) {
      if (triangle.neighbours[k] > t) continue;
      const WorkVertex& a = patch.vertex(triangle.vertices[kNext[k]]);
      const WorkVertex& b = patch.vertex(triangle.vertices[kPrevious[k]]);
      const double l2 = length(a.r, b.p - a.p) * length(b.r, b.p - a.p);
      sum += 4.33 * std::pow(l2 + 1 / l2 - 2, 2);
    }
  }
  return sum;
}

double log_product(const Patch& patch) {
  double sum = 0;
  for (const WorkTriangle& t : patch.mesh.triangles)
    sum += std::log(least_alpha(patch.vertex(t.vertices[0]), patch.vertex(t.vertices[1]),
                                patch.vertex(t.vertices[2])));
  return sum;
}

struct Snapshot {
  std::vector<WorkVertex> vertices;
  std::vector<WorkTriangle> triangles;
  std::vector<Index> triangle_of;
  explicit Snapshot(const Patch& patch)
      : vertices(patch.mesh.vertices),
        triangles(patch.mesh.triangles),
        triangle_of(patch.triangle_of) {}
};

template <class T>
bool same_bytes(const std::vector<T>& x, const std::vector<T>& y) {
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0;
}

void check_fixed_vertices_stay(const Snapshot& before, const Patch& patch) {
  for (std::size_t v = 0; v < before.vertices.size(); ++v) {
    if (!patch.fixed[v]) continue;
    CHECK(patch.mesh.vertices[v].p == before.vertices[v].p);
    CHECK(patch.triangle_of[v] != kNoIndex);
  }
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the energy of a unit hexagon is zero at its centre and grows away from it") {
    WorkMesh mesh;
    mesh.vertices.push_back({{0, 0}, {1, 0, 1}, 0});
    for (Index i = 0; i < 6; ++i) {
      const double phi = kPi / 3 * i;
      mesh.vertices.push_back({{std::cos(phi), std::sin(phi)}, {1, 0, 1}, 0});
      mesh.segments.push_back({i + 1, (i + 1) % 6 + 1, 0, 0, 1, 0, kNoIndex});
      mesh.triangles.push_back({{0, i + 1, (i + 1) % 6 + 1}, {~i, (i + 1) % 6, (i + 5) % 6}});
    }
    const Mesh grid = crossed_rectangle(2, 2, {-1, -1}, {1, 1});
    const BackgroundMesh background(grid, MetricField(grid.points.size()));
    const Patch patch = make_patch(background, mesh, {});
    Ring ring;
    REQUIRE(closed_ring(patch, 0, ring));
    VertexEnergy energy;
    energy.load(patch, ring);
    CHECK(energy.size() == 6);
    const auto at = [&](Point p) { return energy({p, {1, 0, 1}, 0}, 1e31); };
    CHECK(at({0, 0}) == doctest::Approx(0).epsilon(1e-12));
    CHECK(norm(energy.length_proposal({{0, 0}, {1, 0, 1}, 0})) < 1e-12);
    CHECK(norm(energy.quality_proposal({{0, 0}, {1, 0, 1}, 0})) < 1e-12);
    CHECK(at({0.1, 0}) > at({0.05, 0}));
    CHECK(at({0.05, 0}) > 0);
    CHECK(at({2, 0}) >= 1e30);
    CHECK(energy.is_valid({0.5, 0}));
    CHECK_FALSE(energy.is_valid({std::cos(kPi / 6), 0.5}));
    CHECK_FALSE(energy.is_valid({2, 0}));
    // Off the centre both proposals point back to it.
    const WorkVertex off{{0.2, 0}, {1, 0, 1}, 0};
    energy(off, 1e31);
    CHECK(energy.length_proposal(off).x < -0.05);
    CHECK(energy.quality_proposal(off).x < -0.05);
  }

  TEST_CASE("smoothing lowers the energy and keeps the mesh valid") {
    for (unsigned seed = 0; seed < 4; ++seed) {
      Filled filled(seed, 30);
      const Snapshot before(filled.patch);
      const double old_energy = total_energy(filled.patch);
      smooth_active(filled.patch, {});
      CHECK(filled.patch.statistics.moves > 10);
      CHECK(total_energy(filled.patch) < old_energy);
      CHECK(broken_invariant(filled.patch) == "");
      check_fixed_vertices_stay(before, filled.patch);
      filled.patch.update_all_alphas();
      const double energy = total_energy(filled.patch);
      smooth_targeted(filled.patch, 0.9, 1.3);
      CHECK(total_energy(filled.patch) < energy);
      CHECK(broken_invariant(filled.patch) == "");
      CHECK(area_of(filled.patch.mesh) == doctest::Approx(1).epsilon(1e-12));
    }
  }

  TEST_CASE("vertices that are not active are left alone") {
    Filled filled(1, 30);
    std::fill(filled.patch.active.begin(), filled.patch.active.end(), 0);
    const Snapshot before(filled.patch);
    smooth_active(filled.patch, {});
    CHECK(same_bytes(before.vertices, filled.patch.mesh.vertices));
  }

  TEST_CASE("the paper's smoothing raises the product of the alphas and keeps the mesh valid") {
    for (unsigned seed = 0; seed < 4; ++seed) {
      Filled filled(seed, 30);
      const Snapshot before(filled.patch);
      const double start = log_product(filled.patch);
      paper_length_smoothing(filled.patch);
      const double middle = log_product(filled.patch);
      CHECK(middle > start);
      paper_quality_smoothing(filled.patch);
      CHECK(log_product(filled.patch) > middle);
      CHECK(broken_invariant(filled.patch) == "");
      check_fixed_vertices_stay(before, filled.patch);
    }
  }

  TEST_CASE("bad edges are found whichever triangle holds them") {
    Filled filled(2, 30);
    const WorkMesh& mesh = filled.patch.mesh;
    int bad = 0, marked = 0;
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
      marked += has_bad_edge(filled.patch, t, 1.2) ? 1 : 0;
      for (int k = 0; k < 3; ++k) {
        if (mesh.triangles[t].neighbours[k] > t) continue;
        const auto& v = mesh.triangles[t].vertices;
        const double l = edge_length(mesh.vertices[v[kNext[k]]], mesh.vertices[v[kPrevious[k]]]);
        bad += l > 1.2 || l < 1 / 1.2 ? 1 : 0;
      }
    }
    CHECK(bad >= marked);
    CHECK(bad <= 3 * marked);
    CHECK(marked > 0);
  }

  TEST_CASE("repair keeps every invariant around slits too and lowers the energy") {
    for (unsigned seed = 0; seed < 8; ++seed) {
      Filled filled(seed, seed % 2 == 0 ? 30 : 1000,
                    seed % 4 < 2 ? square_domain(1) : square_with_slit());
      const Snapshot before(filled.patch);
      const double energy = total_energy(filled.patch);
      const int repaired = repair_worst(filled.patch, 0.9, 1.3);
      CHECK(repaired > 0);
      CHECK(broken_invariant(filled.patch) == "");
      CHECK(area_of(filled.patch.mesh) == doctest::Approx(1).epsilon(1e-12));
      CHECK(total_energy(filled.patch) < energy);
      check_fixed_vertices_stay(before, filled.patch);
    }
  }

  TEST_CASE("trials of repair that gain nothing leave no trace") {
    Filled filled(1, 30);
    // Repair until it finds nothing more: the last call tries everything and keeps nothing.
    int rounds = 0;
    while (repair_worst(filled.patch, 0.9, 1.4) > 0 && ++rounds < 200) {
    }
    REQUIRE(rounds < 200);
    const Snapshot before(filled.patch);
    const std::int64_t moves = filled.patch.statistics.moves;
    CHECK(repair_worst(filled.patch, 0.99, 1.05) >= 0);
    while (repair_worst(filled.patch, 0.9, 1.4) > 0) {
    }
    const Snapshot settled(filled.patch);
    REQUIRE(repair_worst(filled.patch, 0.9, 1.4) == 0);
    CHECK(same_bytes(settled.vertices, filled.patch.mesh.vertices));
    CHECK(same_bytes(settled.triangles, filled.patch.mesh.triangles));
    CHECK(settled.triangle_of == filled.patch.triangle_of);
    CHECK(filled.patch.statistics.moves >= moves);
  }

  TEST_CASE("both chains keep segments and fixed vertices and improve the mesh") {
    for (const bool paper : {false, true})
      for (unsigned seed = 0; seed < 4; ++seed) {
        Filled filled(seed, 30, seed % 2 == 0 ? square_domain(1) : square_with_slit());
        const Snapshot before(filled.patch);
        const auto segments = filled.patch.mesh.segments;
        const double old = log_product(filled.patch) / live_triangles(filled.patch.mesh);
        EnhanceOptions options;
        options.paper = paper;
        enhance(filled.patch, options);
        CHECK(broken_invariant(filled.patch) == "");
        CHECK(area_of(filled.patch.mesh) == doctest::Approx(1).epsilon(1e-12));
        check_fixed_vertices_stay(before, filled.patch);
        CHECK(same_bytes(segments, filled.patch.mesh.segments));
        double sum = 0;
        for (const WorkTriangle& t : filled.patch.mesh.triangles)
          if (!t.dead())
            sum += std::log(least_alpha(filled.patch.vertex(t.vertices[0]),
                                        filled.patch.vertex(t.vertices[1]),
                                        filled.patch.vertex(t.vertices[2])));
        CHECK(sum / live_triangles(filled.patch.mesh) > old);
      }
  }

  TEST_CASE("enhancement can be cancelled") {
    Filled filled(1, 30);
    Monitor monitor;
    monitor.progress = [](std::string_view phase, double) { return phase != "enhance"; };
    CHECK_THROWS_AS(enhance(filled.patch, {}, monitor), Interrupted);
    CHECK(broken_invariant(filled.patch) == "");
  }
}
