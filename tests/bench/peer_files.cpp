#include "tests/bench/peer_files.hpp"

#include <cmath>
#include <fstream>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::ofstream opened(const std::string& path) {
  std::ofstream out(path);
  out.precision(17);
  return out;
}

void finish(std::ofstream& out, const std::string& path) {
  if (!out.flush()) throw InputError(path + ": cannot be written");
}

void write_corners(std::ostream& out, const Mesh& mesh, const Triangle& t) {
  const char* before = "(";
  for (const Index v : t) {
    out << before << mesh.points[v].x << ',' << mesh.points[v].y << ",0";
    before = ",";
  }
  out << ')';
}

void write_values(std::ostream& out, const Metric& m, bool isotropic) {
  if (isotropic)
    out << 1 / std::sqrt(m.m11);
  else
    out << m.m11 << ',' << m.m12 << ",0," << m.m12 << ',' << m.m22 << ",0,0,0,1";
}

}  // namespace

void write_bamg_metric(const std::string& path, const MetricField& field) {
  std::ofstream out = opened(path);
  out << field.size() << " 3\n";
  for (const Metric& m : field) out << m.m11 << ' ' << m.m12 << ' ' << m.m22 << '\n';
  finish(out, path);
}

void write_gmsh_view(const std::string& path, const Mesh& mesh, const MetricField& field,
                     bool isotropic) {
  std::ofstream out = opened(path);
  out << "View \"metric\" {\n";
  for (const Triangle& t : mesh.triangles) {
    out << (isotropic ? "ST" : "TT");
    write_corners(out, mesh, t);
    const char* before = "{";
    for (const Index v : t) {
      out << before;
      write_values(out, field[v], isotropic);
      before = ",";
    }
    out << "};\n";
  }
  out << "};\n";
  finish(out, path);
}

void write_gmsh_square(const std::string& path, double side) {
  std::ofstream out = opened(path);
  out << "a = " << side << ";\n"
      << "Point(1) = {0, 0, 0}; Point(2) = {a, 0, 0};\n"
      << "Point(3) = {a, a, 0}; Point(4) = {0, a, 0};\n"
      << "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n"
      << "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};\n";
  finish(out, path);
}

}  // namespace anisofront
