#pragma once

#include <span>

#include "mesher/io/svg_frame.hpp"
#include "mesher/io/xml.hpp"

namespace anisofront {

/// Writes the "d" of paths through vertices of a mesh.
class SvgPath {
 public:
  SvgPath(AtomicFile& out, const Mesh& mesh, const SvgFrame& frame)
      : out_(out), mesh_(mesh), frame_(frame) {}

  void move(Index v) { command('M', v); }
  void line(Index v) { command('L', v); }
  void close() { out_.byte('Z'); }

  /// Precondition: at least one vertex.
  void polygon(std::span<const Index> vertices) {
    move(vertices.front());
    for (const Index v : vertices.subspan(1)) line(v);
    close();
    out_.byte('\n');
  }

 private:
  void command(char letter, Index v) {
    const Point p = frame_(mesh_.points[static_cast<std::size_t>(v)]);
    out_.byte(letter);
    write_pixels(out_, p.x);
    out_.byte(' ');
    write_pixels(out_, p.y);
  }

  AtomicFile& out_;
  const Mesh& mesh_;
  const SvgFrame& frame_;
};

/// Ends a path, with the name of its group as the tool tip.
inline void end_path(AtomicFile& out, const Mesh& mesh, int dimension, Index tag) {
  const std::string name = group_name(mesh, dimension, tag);
  out.text(name.empty() ? "\"/>\n" : "\"><title>" + xml_escaped(name) + "</title></path>\n");
}

}  // namespace anisofront
