#include "mesher/io/svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesher/geometry/error.hpp"
#include "mesher/io/mesh_arrays.hpp"
#include "mesher/io/svg_fill.hpp"
#include "mesher/io/svg_key.hpp"
#include "mesher/mesh/topology.hpp"

namespace anisofront {

namespace {

constexpr std::string_view kEdgeColour = "#6b7686";
constexpr std::string_view kCurveColour = "#1c2b45";
constexpr std::string_view kDotColour = "#c8402f";
constexpr std::string_view kFramedColour = "#c8402f";

PlaneWindow bounding_window(const Mesh& mesh) {
  PlaneWindow window;
  if (!mesh.points.empty()) window.low = window.high = mesh.points.front();
  for (const Point p : mesh.points) {
    window.low = {std::min(window.low.x, p.x), std::min(window.low.y, p.y)};
    window.high = {std::max(window.high.x, p.x), std::max(window.high.y, p.y)};
  }
  return window;
}

/// To a window at most `highest` times as high as wide, with the same middle.
void widen(PlaneWindow& window, double highest) {
  const Vector extent = window.high - window.low;
  const double lacking = extent.y / highest - extent.x;
  if (!(lacking > 0)) return;
  window.low.x -= lacking / 2;
  window.high.x += lacking / 2;
}

SvgFrame make_frame(const Mesh& mesh, const SvgOptions& options) {
  constexpr double kMargin = 0.02;  // of the width
  SvgFrame frame;
  frame.shown = options.window ? *options.window : bounding_window(mesh);
  if (options.highest > 0) widen(frame.shown, options.highest);
  const Vector extent = frame.shown.high - frame.shown.low;
  frame.width = options.width;
  frame.margin = kMargin * frame.width;
  const double wider = extent.x > 0 ? extent.x : extent.y;
  if (wider > 0) frame.scale = (frame.width - 2 * frame.margin) / wider;
  frame.picture_height = 2 * frame.margin + frame.scale * extent.y;
  frame.height = frame.picture_height;
  if (options.has_scale || !options.values.empty()) frame.height += key_height(frame.width);
  return frame;
}

struct LineWidths {
  double edge;
  double curve;
  double dot;
};

/// Thin enough that the element of mean size stays light.
LineWidths line_widths(const std::vector<bool>& shown, const SvgFrame& frame) {
  const auto elements = static_cast<double>(std::count(shown.begin(), shown.end(), true));
  const double area = (frame.width - 2 * frame.margin) * (frame.picture_height - 2 * frame.margin);
  const double size = std::sqrt(area / std::max(elements, 1.0));
  const double edge = std::clamp(0.045 * size, 0.08, 1.4);
  const double curve = std::clamp(2.2 * edge, 0.9, 2.6);
  return {edge, curve, std::max(1.9 * curve, 2.2)};
}

void begin_lines(AtomicFile& out, std::string_view colour, double width) {
  out.text(
      "<g fill=\"none\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\" stroke=\"");
  out.text(colour);
  out.text("\"");
  write_attribute(out, "stroke-width", width);
  out.text(">\n");
}

/// In paths of some hundred edges, which renderers draw faster than one of all.
void write_edges(AtomicFile& out, const Mesh& mesh, SvgPath& path, const SvgFrame& frame,
                 double width) {
  constexpr int kEdgesPerPath = 300;
  begin_lines(out, kEdgeColour, width);
  int in_path = 0;
  out.text("<path d=\"");
  for (const auto& edge : mesh_edges(mesh)) {
    if (!is_shown(mesh, frame, edge)) continue;
    if (in_path++ == kEdgesPerPath) {
      out.text("\"/>\n<path d=\"");
      in_path = 1;
    }
    path.move(edge[0]);
    path.line(edge[1]);
    out.byte('\n');
  }
  out.text("\"/>\n</g>\n");
}

/// Edges that continue the one before are joined to it.
void write_curves(AtomicFile& out, const Mesh& mesh, SvgPath& path, double width) {
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

void write_dots(AtomicFile& out, const Mesh& mesh, const SvgFrame& frame,
                const LineWidths& widths) {
  if (mesh.required_vertices.empty()) return;
  out.text("<g fill=\"" + std::string(kDotColour) + "\" stroke=\"#ffffff\"");
  write_attribute(out, "stroke-width", widths.curve / 2);
  out.text(">\n");
  for (const Index v : mesh.required_vertices) {
    const Point p = frame(mesh.points[static_cast<std::size_t>(v)]);
    out.text("<circle");
    write_attribute(out, "cx", p.x);
    write_attribute(out, "cy", p.y);
    write_attribute(out, "r", widths.dot);
    out.text("/>\n");
  }
  out.text("</g>\n");
}

void write_framed(AtomicFile& out, const SvgFrame& frame, const PlaneWindow& window) {
  const Point corner = frame({window.low.x, window.high.y});
  out.text("<rect class=\"framed\" fill=\"none\" stroke=\"" + std::string(kFramedColour) + "\"");
  write_attribute(out, "stroke-width", 0.003 * frame.width);
  write_attribute(out, "x", corner.x);
  write_attribute(out, "y", corner.y);
  write_attribute(out, "width", frame.scale * (window.high.x - window.low.x));
  write_attribute(out, "height", frame.scale * (window.high.y - window.low.y));
  out.text("/>\n");
}

/// What lies outside the window is cut off, and a thin frame shows that it goes
/// on there.
void begin_window(AtomicFile& out, const SvgFrame& frame) {
  const auto rectangle = [&] {
    out.text("<rect");
    write_attribute(out, "x", frame.margin);
    write_attribute(out, "y", frame.margin);
    write_attribute(out, "width", frame.width - 2 * frame.margin);
    write_attribute(out, "height", frame.picture_height - 2 * frame.margin);
  };
  out.text("<clipPath id=\"window\">");
  rectangle();
  out.text("/></clipPath>\n");
  rectangle();
  out.text(" fill=\"none\" stroke=\"#999999\"/>\n<g clip-path=\"url(#window)\">\n");
}

void begin_drawing(AtomicFile& out, const SvgFrame& frame) {
  out.text("<svg xmlns=\"http://www.w3.org/2000/svg\"");
  write_attribute(out, "width", frame.width);
  write_attribute(out, "height", frame.height);
  out.text(" viewBox=\"0 0 ");
  write_pixels(out, frame.width);
  out.byte(' ');
  write_pixels(out, frame.height);
  out.text("\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n");
}

void write_mesh(AtomicFile& out, const Mesh& mesh, const SvgFrame& frame,
                const SvgOptions& options) {
  const std::vector<bool> shown = shown_elements(mesh, frame);
  const LineWidths widths = line_widths(shown, frame);
  const ValueRange range =
      options.values.empty() ? ValueRange{} : value_range(options.values, shown);
  SvgPath path(out, mesh, frame);
  if (options.window) begin_window(out, frame);
  if (options.values.empty())
    write_regions(out, mesh, path, shown);
  else
    write_values(out, mesh, path, shown, options.values, range);
  write_edges(out, mesh, path, frame, widths.edge);
  write_curves(out, mesh, path, widths.curve);
  write_dots(out, mesh, frame, widths);
  if (options.window) out.text("</g>\n");
  if (options.framed) write_framed(out, frame, *options.framed);
  if (range.least <= range.greatest)
    write_colour_key(out, frame, options.values_name, range.least, range.greatest);
  if (options.has_scale) write_scale_bar(out, frame);
}

void require_values(const std::filesystem::path& path, const Mesh& mesh,
                    const SvgOptions& options) {
  const std::size_t elements = mesh.triangles.size() + mesh.quads.size();
  if (!options.values.empty() && options.values.size() != elements)
    throw InputError("cannot write " + path.string() + ": " +
                     std::to_string(options.values.size()) + " values for " +
                     std::to_string(elements) + " elements");
}

}  // namespace

void write_svg(const std::filesystem::path& path, const Mesh& mesh, const SvgOptions& options) {
  require_writable(mesh, path.string());
  require_values(path, mesh, options);
  const SvgFrame frame = make_frame(mesh, options);
  if (!(frame.scale > 0) || !std::isfinite(frame.scale) || !std::isfinite(frame.height))
    throw InputError("cannot draw " + path.string() +
                     ": the bounding box of the mesh is not finite or too flat");
  AtomicFile out(path);
  begin_drawing(out, frame);
  write_mesh(out, mesh, frame, options);
  out.text("</svg>\n");
  out.commit();
}

}  // namespace anisofront
