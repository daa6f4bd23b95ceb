#include "mesher/front/curve_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "mesher/geometry/error.hpp"
#include "mesher/metric/metric_length.hpp"

namespace anisofront {
namespace {

/// A sampled point of a curve.
struct Sample {
  double t;
  Point p;
  MetricFactor r;
};

double step_length(const Sample& a, const Sample& b) {
  const Vector u = b.p - a.p;
  return log_mean_length(squared_length(a.r, u), squared_length(b.r, u));
}

double longest_step(const Sample& a, const Sample& b) {
  const Vector u = b.p - a.p;
  return std::sqrt(std::max(squared_length(a.r, u), squared_length(b.r, u)));
}

class Sampler {
 public:
  Sampler(const BackgroundMesh& background, const NurbsCurve& curve, double tolerance,
          double max_length, Index& hint)
      : background_(background),
        curve_(curve),
        tolerance_(tolerance),
        max_length_(max_length),
        hint_(hint) {}

  Sample at(double t) {
    const Point p = evaluate(curve_, t);
    return {t, p, background_.factor_at(p, hint_)};
  }

  void append(const Sample& s) {
    if (profile.parameter.empty()) {
      profile.parameter.push_back(s.t);
      profile.length.push_back(0);
    } else {
      profile.parameter.push_back(s.t);
      profile.length.push_back(profile.length.back() + step_length(last_, s));
      if (profile.length.back() > max_length_)
        throw BudgetError("a boundary curve alone would need more than " +
                          std::to_string(static_cast<std::int64_t>(max_length_)) + " edges near (" +
                          std::to_string(s.p.x) + ", " + std::to_string(s.p.y) +
                          "); ask for larger sizes or allow more nodes");
    }
    last_ = s;
  }

  /// Appends everything after a, up to and including b. Mid-point metrics are looked at too, since
  /// a layer can be crossed within one step.
  void refine(const Sample& a, const Sample& b, int least_depth, int depth) {
    constexpr int kMaxDepth = 40;
    if (depth >= kMaxDepth) return append(b);
    const Sample middle = at(0.5 * (a.t + b.t));
    if (depth >= least_depth && longest_step(a, middle) < tolerance_ &&
        longest_step(middle, b) < tolerance_) {
      append(middle);
      return append(b);
    }
    refine(a, middle, least_depth, depth + 1);
    refine(middle, b, least_depth, depth + 1);
  }

  CurveProfile profile;

 private:
  const BackgroundMesh& background_;
  const NurbsCurve& curve_;
  double tolerance_, max_length_;
  Index& hint_;
  Sample last_{};
};

}  // namespace

Index segment_count(double length) {
  const double m = std::floor(length);
  const double count = m * (m + 1) > length * length ? m : m + 1;
  return std::max(static_cast<Index>(count), Index{1});
}

CurveProfile sample_curve(const BackgroundMesh& background, const NurbsCurve& curve, double t0,
                          double t1, double tolerance, double max_length, Index& hint) {
  constexpr std::size_t kManySpans = 16;
  std::vector<double> breaks{t0};
  for (const double t : distinct_knots(curve))
    if (t > t0 && t < t1) breaks.push_back(t);
  breaks.push_back(t1);
  Sampler sampler(background, curve, tolerance, max_length, hint);
  Sample from = sampler.at(t0);
  sampler.append(from);
  const int least_depth = breaks.size() > kManySpans ? 0 : 2;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const Sample to = sampler.at(breaks[i]);
    sampler.refine(from, to, least_depth, 0);
    from = to;
  }
  return std::move(sampler.profile);
}

CurveProfile measure_old_segments(const BackgroundMesh& background, const Mesh& old_mesh,
                                  const std::vector<CurveEdge>& edges, Index& hint) {
  constexpr double kAppendixB = 0.25;
  const double tolerance = kAppendixB / std::max(background.size_factor(), 1.);
  const MetricFunction metric = [&](Point p) { return metric_of(background.factor_at(p, hint)); };
  CurveProfile profile{{edges.front().parameters[0]}, {0}};
  for (const CurveEdge& edge : edges) {
    const SegmentProfile sub = segment_profile(metric, old_mesh.points[edge.vertices[0]],
                                               old_mesh.points[edge.vertices[1]], tolerance);
    const double start = profile.length.back();
    for (std::size_t i = 1; i < sub.t.size(); ++i) {
      profile.parameter.push_back(std::lerp(edge.parameters[0], edge.parameters[1], sub.t[i]));
      profile.length.push_back(start + sub.length[i]);
    }
  }
  return profile;
}

std::vector<double> equal_parts(const CurveProfile& profile, Index count) {
  std::vector<double> parameters{profile.parameter.front()};
  std::size_t j = 1;
  for (Index k = 1; k < count; ++k) {
    const double wanted = profile.total() * k / count;
    while (j + 1 < profile.length.size() && profile.length[j] < wanted) ++j;
    const double step = profile.length[j] - profile.length[j - 1];
    const double t = step > 0 ? (wanted - profile.length[j - 1]) / step : 0;
    parameters.push_back(std::lerp(profile.parameter[j - 1], profile.parameter[j], t));
  }
  parameters.push_back(profile.parameter.back());
  return parameters;
}

double chord_length(const BackgroundMesh& background, Point a, Point b, Index& hint) {
  constexpr int kSteps = 4;
  const Vector u = (1. / kSteps) * (b - a);
  double before = squared_length(background.factor_at(a, hint), u);
  double sum = 0;
  for (int k = 1; k <= kSteps; ++k) {
    const double after = squared_length(background.factor_at(lerp(a, b, k / 4.), hint), u);
    sum += log_mean_length(before, after);
    before = after;
  }
  return sum;
}

namespace {

std::vector<double> chord_lengths(const BackgroundMesh& background, const NurbsCurve& curve,
                                  const std::vector<double>& ends, Index& hint) {
  std::vector<double> chords;
  Point from = evaluate(curve, ends[0]);
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const Point to = evaluate(curve, ends[k]);
    chords.push_back(chord_length(background, from, to, hint));
    from = to;
  }
  return chords;
}

/// Scales the running length within each edge so that the edge counts as much as its chord.
void weigh_by_chords(CurveProfile& profile, const std::vector<double>& ends,
                     const std::vector<double>& chords) {
  CurveProfile scaled{{profile.parameter.front()}, {0}};
  const double arc = profile.total() / static_cast<double>(chords.size());
  std::size_t i = 1;
  double from = 0;  // running length, old profile
  for (std::size_t k = 0; k < chords.size(); ++k) {
    const double factor = chords[k] / arc;
    const auto advance_to = [&](double t, double length) {
      scaled.parameter.push_back(t);
      scaled.length.push_back(scaled.length.back() + factor * std::max(length - from, 0.));
      from = length;
    };
    while (i < profile.parameter.size() && profile.parameter[i] < ends[k + 1]) {
      advance_to(profile.parameter[i], profile.length[i]);
      ++i;
    }
    advance_to(ends[k + 1], arc * static_cast<double>(k + 1));
  }
  profile = std::move(scaled);
}

/// Numbers of edges that are allowed.
struct CountRange {
  Index least, most;
};

std::vector<double> equal_chords_within(const BackgroundMesh& background, const NurbsCurve& curve,
                                        CurveProfile profile, CountRange range, Index& hint) {
  constexpr int kIterations = 12;
  constexpr double kEven = 0.02;
  const auto allowed = [&](double length) {
    return std::clamp(segment_count(length), range.least, range.most);
  };
  Index count = allowed(profile.total());
  // Chords of fewer edges are longer: `low` edges are known to be too few, `high` to be enough.
  Index low = range.least - 1, high = range.most;
  std::vector<double> ends = equal_parts(profile, count);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const std::vector<double> chords = chord_lengths(background, curve, ends, hint);
    const double total = std::accumulate(chords.begin(), chords.end(), 0.);
    const Index wanted = allowed(total);
    const auto [shortest, longest] = std::minmax_element(chords.begin(), chords.end());
    const bool even = *longest - *shortest < kEven * total / count;
    (wanted > count ? low : high) = count;
    const bool settled = wanted == count || (count == high && low == count - 1);
    if (settled && even) break;
    if (!settled) {
      const double middle = std::sqrt(static_cast<double>(count) * wanted);
      count = std::clamp(static_cast<Index>(middle + 0.5), low + 1, std::max(low + 1, high - 1));
    }
    weigh_by_chords(profile, ends, chords);
    ends = equal_parts(profile, count);
  }
  return ends;
}

}  // namespace

std::vector<double> equal_chords(const BackgroundMesh& background, const NurbsCurve& curve,
                                 CurveProfile profile, Index least_count, Index& hint) {
  const CountRange range{least_count, std::numeric_limits<Index>::max()};
  return equal_chords_within(background, curve, std::move(profile), range, hint);
}

std::vector<double> equal_chords_of_count(const BackgroundMesh& background, const NurbsCurve& curve,
                                          CurveProfile profile, Index count, Index& hint) {
  return equal_chords_within(background, curve, std::move(profile), {count, count}, hint);
}

double total_chord_length(const BackgroundMesh& background, const NurbsCurve& curve,
                          const std::vector<double>& parameters, Index& hint) {
  const std::vector<double> chords = chord_lengths(background, curve, parameters, hint);
  return std::accumulate(chords.begin(), chords.end(), 0.);
}

}  // namespace anisofront
