#pragma once

#include "mesher/background/background_mesh.hpp"
#include "mesher/front/work_mesh.hpp"

namespace anisofront {

/// A trial apex with the metric there.
struct TrialPoint {
  Point p;
  MetricFactor r;
  Index hint = 0;
};

/// C1 (Eqn 23b): AB turned by 60 degrees about A in the metric of A, with unit length there.
Point offset_from_a(const Metric& at_a, Point a, Point b);
/// C2 (Eqn A14): BA turned by -60 degrees about B in the metric of B, with unit length there.
Point offset_from_b(const Metric& at_b, Point a, Point b);
/// C3 (Eqn A15): DB turned by 90 degrees about D in the metric of D, with length sqrt(3)/2 there.
Point offset_from_midpoint(const Metric& at_d, Point d, Point b);

/// Apex of the triangle over AB with unit sides in one constant metric (height bounded below for
/// long bases), and nothing looked up: the first guess of the fast path.
Point constant_metric_apex(const MetricFactor& r, Point a, Point b);

/// Moves the trial point by Newton's method until l(AC) = l(BC) = 1 (Eqn 22) with log-mean lengths;
/// at most `steps` look-ups beyond the first. Stays left of AB.
void correct_by_newton(const BackgroundMesh& background, const WorkVertex& a, const WorkVertex& b,
                       int steps, TrialPoint& trial);

/// mu~ (Eqn 17) of the triangle ABC for the fast path: alpha in the mean metric times a rational
/// stand-in for e^(-delta); negative when the triangle is clockwise.
double fast_mu(const WorkVertex& a, const WorkVertex& b, Point c, const MetricFactor& at_c);

}  // namespace anisofront
