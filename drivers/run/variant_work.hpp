#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "adapt/loop.hpp"
#include "drivers/study/study.hpp"

namespace anisofront {

/// What can be said about the work of a variant before it runs. Work is counted in the time that a
/// vertex of a large mesh of linear triangles takes (some 25 microseconds).
struct VariantPlan {
  int cycles = 0;
  double first_vertices = 0;             ///< of the initial mesh
  double vertices = 0;                   ///< of the meshes from cycle 1 on
  double growth = 1;                     ///< of the vertices in each cycle from then on
  double mesh_work = 1, solve_work = 1;  ///< per vertex
  double reference_vertices = 0;         ///< of the mesh for true errors; 0: none
  std::vector<double> done_vertices;     ///< of the cycles of an earlier run, analysed again
};
/// `done`: what an earlier run has left to go on from.
VariantPlan variant_plan(const Study& study, const LoopInput& input,
                         const std::vector<FinishedCycle>& done = {});

/// How much of the work of a variant is done, and how much is still expected.
class VariantWork {
 public:
  explicit VariantWork(VariantPlan plan);

  /// As the loop and the libraries report it to a Monitor.
  void report(std::string_view phase, double fraction);
  /// A cycle has ended with so many vertices; the next mesh will have about `next` (0: not known).
  void finish_cycle(double vertices, double next);
  /// Nothing is left to be done, for whatever reason.
  void finish();

  double done() const { return finished_ + part_; }
  double total() const { return finished_ + expected_; }
  int cycle() const { return cycle_; }  ///< at work
  /// What is at work: "cycle 2 of 5", or "true errors" after the last.
  std::string stage() const;

 private:
  double cycle_work(int cycle, double vertices) const;
  double later_work(double vertices) const;
  double within_stage(std::string_view phase, double fraction) const;

  VariantPlan plan_;
  int cycle_ = 0;
  bool is_reference_ = false;
  double resume_ = 0;    ///< work of analysing the cycles of an earlier run again
  double vertices_ = 0;  ///< of the mesh at work
  double finished_ = 0, part_ = 0, expected_ = 0;
};

}  // namespace anisofront
