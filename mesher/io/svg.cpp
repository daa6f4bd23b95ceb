#include "mesher/io/svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesher/geometry/error.hpp"
#include "mesher/io/atomic_file.hpp"
#include "mesher/io/mesh_arrays.hpp"
#include "mesher/io/xml.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {

namespace {

constexpr std::array<std::string_view, 8> kTints{"#e6f0fa", "#fdeedb", "#e6f4e1", "#f9e4ec",
                                                 "#eee8f8", "#fbf6d5", "#dff3f1", "#f1ece4"};
constexpr std::string_view kEdgeColour = "#8a94a3";
constexpr std::string_view kCurveColour = "#1c2b45";
constexpr std::string_view kDotColour = "#c8402f";

/// From the plane to the drawing: y down, margins all round.
struct Frame {
  Point low{}, high{};
  double margin = 0;
  double scale = 1;
  double width = 0, height = 0;

  Point operator()(Point p) const {
    return {margin + scale * (p.x - low.x), margin + scale * (high.y - p.y)};
  }
};

Frame make_frame(const Mesh& mesh, double width) {
  constexpr double kMargin = 0.02;  // of the width
  Frame frame;
  if (!mesh.points.empty()) frame.low = frame.high = mesh.points.front();
  for (const Point p : mesh.points) {
    frame.low = {std::min(frame.low.x, p.x), std::min(frame.low.y, p.y)};
    frame.high = {std::max(frame.high.x, p.x), std::max(frame.high.y, p.y)};
  }
  const Vector extent = frame.high - frame.low;
  frame.margin = kMargin * width;
  frame.width = width;
  if (extent.x > 0) {
    frame.scale = (width - 2 * frame.margin) / extent.x;
  } else if (extent.y > 0) {
    frame.scale = (width - 2 * frame.margin) / extent.y;
  }
  frame.height = 2 * frame.margin + frame.scale * extent.y;
  return frame;
}

struct LineWidths {
  double edge;
  double curve;
  double dot;
};

/// Thin enough that the element of mean size stays light.
LineWidths line_widths(const Mesh& mesh, const Frame& frame) {
  const auto elements = static_cast<double>(mesh.triangles.size() + mesh.quads.size());
  const double area = (frame.width - 2 * frame.margin) * (frame.height - 2 * frame.margin);
  const double size = std::sqrt(area / std::max(elements, 1.0));
  const double edge = std::clamp(0.045 * size, 0.06, 0.9);
  const double curve = std::clamp(2.8 * edge, 0.7, 2.2);
  return {edge, curve, std::max(1.9 * curve, 2.2)};
}

/// Pixels, to a thousandth: enough for zooming in.
void pixels(AtomicFile& out, double value) { out.real(std::round(1000 * value) / 1000); }

void attribute(AtomicFile& out, std::string_view name, double value) {
  out.text(" ");
  out.text(name);
  out.text("=\"");
  pixels(out, value);
  out.text("\"");
}

class PathWriter {
 public:
  PathWriter(AtomicFile& out, const Mesh& mesh, const Frame& frame)
      : out_(out), mesh_(mesh), frame_(frame) {}

  void move(Index v) { command('M', v); }
  void line(Index v) { command('L', v); }
  void close() { out_.byte('Z'); }

  template <class Element>
  void polygon(const Element& element) {
    move(element[0]);
    for (std::size_t k = 1; k < element.size(); ++k) line(element[k]);
    close();
    out_.byte('\n');
  }

 private:
  void command(char letter, Index v) {
    const Point p = frame_(mesh_.points[static_cast<std::size_t>(v)]);
    out_.byte(letter);
    pixels(out_, p.x);
    out_.byte(' ');
    pixels(out_, p.y);
  }

  AtomicFile& out_;
  const Mesh& mesh_;
  const Frame& frame_;
};

/// Ends a path, with the name of its group as the tool tip.
void end_path(AtomicFile& out, const Mesh& mesh, int dimension, Index tag) {
  const std::string name = group_name(mesh, dimension, tag);
  out.text(name.empty() ? "\"/>\n" : "\"><title>" + xml_escaped(name) + "</title></path>\n");
}

struct RegionElements {
  std::vector<std::size_t> triangles;
  std::vector<std::size_t> quads;
};

/// One path per region: a renderer then leaves no seams between its elements.
void write_regions(AtomicFile& out, const Mesh& mesh, PathWriter& path) {
  std::map<Index, RegionElements> regions;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    regions[mesh.triangle_regions[t]].triangles.push_back(t);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    regions[mesh.quad_regions[q]].quads.push_back(q);
  std::size_t colour = 0;
  for (const auto& [region, elements] : regions) {
    out.text("<path fill=\"" + std::string(kTints[colour++ % kTints.size()]) + "\" d=\"");
    for (const std::size_t t : elements.triangles) path.polygon(mesh.triangles[t]);
    for (const std::size_t q : elements.quads) path.polygon(mesh.quads[q]);
    end_path(out, mesh, 2, region);
  }
}

void begin_lines(AtomicFile& out, std::string_view colour, double width) {
  out.text("<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke=\"");
  out.text(colour);
  out.text("\"");
  attribute(out, "stroke-width", width);
  out.text(">\n");
}

void write_edges(AtomicFile& out, const Mesh& mesh, PathWriter& path, double width) {
  begin_lines(out, kEdgeColour, width);
  out.text("<path d=\"");
  for (const auto& [a, b] : mesh_edges(mesh)) {
    path.move(a);
    path.line(b);
    out.byte('\n');
  }
  out.text("\"/>\n</g>\n");
}

/// Edges that continue the one before are joined to it.
void write_curves(AtomicFile& out, const Mesh& mesh, PathWriter& path, double width) {
  std::map<Index, std::vector<std::size_t>> tags;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) tags[mesh.edges[e].tag].push_back(e);
  begin_lines(out, kCurveColour, width);
  for (const auto& [tag, edges] : tags) {
    out.text("<path d=\"");
    Index last = kNoIndex;
    for (const std::size_t e : edges) {
      const auto [a, b] = mesh.edges[e].vertices;
      if (a != last) path.move(a);
      path.line(b);
      out.byte('\n');
      last = b;
    }
    end_path(out, mesh, 1, tag);
  }
  out.text("</g>\n");
}

void write_dots(AtomicFile& out, const Mesh& mesh, const Frame& frame, const LineWidths& widths) {
  if (mesh.required_vertices.empty()) return;
  out.text("<g fill=\"" + std::string(kDotColour) + "\" stroke=\"#ffffff\"");
  attribute(out, "stroke-width", widths.curve / 2);
  out.text(">\n");
  for (const Index v : mesh.required_vertices) {
    const Point p = frame(mesh.points[static_cast<std::size_t>(v)]);
    out.text("<circle");
    attribute(out, "cx", p.x);
    attribute(out, "cy", p.y);
    attribute(out, "r", widths.dot);
    out.text("/>\n");
  }
  out.text("</g>\n");
}

void begin_drawing(AtomicFile& out, const Frame& frame) {
  out.text("<svg xmlns=\"http://www.w3.org/2000/svg\"");
  attribute(out, "width", frame.width);
  attribute(out, "height", frame.height);
  out.text(" viewBox=\"0 0 ");
  pixels(out, frame.width);
  out.byte(' ');
  pixels(out, frame.height);
  out.text("\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
}

}  // namespace

void write_svg(const std::filesystem::path& path, const Mesh& mesh, const SvgOptions& options) {
  require_writable(mesh, path.string());
  const Frame frame = make_frame(mesh, options.width);
  if (!(frame.scale > 0) || !std::isfinite(frame.scale) || !std::isfinite(frame.height))
    throw InputError("cannot draw " + path.string() +
                     ": the bounding box of the mesh is not finite or too flat");
  const LineWidths widths = line_widths(mesh, frame);
  AtomicFile out(path);
  PathWriter writer(out, mesh, frame);
  begin_drawing(out, frame);
  write_regions(out, mesh, writer);
  write_edges(out, mesh, writer, widths.edge);
  write_curves(out, mesh, writer, widths.curve);
  write_dots(out, mesh, frame, widths);
  out.text("</svg>\n");
  out.commit();
}

}  // namespace anisofront
