#include <algorithm>
#include <cmath>

#include "mesher/io/gmsh_content.hpp"

namespace anisofront {

namespace {

struct Node {
  std::int64_t number;
  std::size_t offset;  ///< in the file, for messages
  Point point;
  double z;
};

void read_coordinates(GmshStream& in, Node& node) {
  node.point.x = in.real("coordinate x");
  node.point.y = in.real("coordinate y");
  node.z = in.real("coordinate z");
  if (!std::isfinite(node.point.x) || !std::isfinite(node.point.y) || !std::isfinite(node.z))
    in.fail_at(node.offset,
               "node " + std::to_string(node.number) + " has a coordinate that is not finite");
}

void sort_by_number(const GmshStream& in, std::vector<Node>& nodes) {
  const auto by_number = [](const Node& a, const Node& b) { return a.number < b.number; };
  if (!std::is_sorted(nodes.begin(), nodes.end(), by_number))
    std::stable_sort(nodes.begin(), nodes.end(), by_number);
  const auto same = [](const Node& a, const Node& b) { return a.number == b.number; };
  const auto twice = std::adjacent_find(nodes.begin(), nodes.end(), same);
  if (twice != nodes.end())
    in.fail_at((twice + 1)->offset,
               "node number " + std::to_string(twice->number) + " occurs twice");
}

/// The plane z = const may be missed by rounding errors of the program that made the mesh.
void check_plane(const GmshStream& in, const std::vector<Node>& nodes) {
  constexpr double kTolerance = 1e-10;
  if (nodes.empty()) return;
  const auto [left, right] =
      std::minmax_element(nodes.begin(), nodes.end(),
                          [](const Node& a, const Node& b) { return a.point.x < b.point.x; });
  const auto [low, high] =
      std::minmax_element(nodes.begin(), nodes.end(),
                          [](const Node& a, const Node& b) { return a.point.y < b.point.y; });
  const double extent = std::max(right->point.x - left->point.x, high->point.y - low->point.y);
  for (const Node& node : nodes)
    if (std::fabs(node.z - nodes.front().z) > kTolerance * extent)
      in.fail_at(node.offset, "node " + std::to_string(node.number) +
                                  " has z = " + std::to_string(node.z) +
                                  ", another has z = " + std::to_string(nodes.front().z) +
                                  ": expected a mesh in one plane z = const");
}

void store(const GmshStream& in, GmshContent& content, std::vector<Node>& nodes) {
  check_plane(in, nodes);
  sort_by_number(in, nodes);
  content.node_numbers.reserve(nodes.size());
  content.points.reserve(nodes.size());
  for (const Node& node : nodes) {
    content.node_numbers.push_back(node.number);
    content.points.push_back(node.point);
  }
  content.is_mid_node.assign(nodes.size(), 0);
  content.has_nodes = true;
}

void require_first(const GmshStream& in, const GmshContent& content) {
  if (content.has_nodes) in.fail("a second section $Nodes");
}

/// A block lists all its numbers, then all its coordinates.
void read_block(GmshStream& in, std::vector<Node>& nodes) {
  const Index dimension = in.integer("the dimension of an entity");
  if (dimension < 0 || dimension > 3)
    in.fail("expected the dimension of an entity, 0 to 3, found " + std::to_string(dimension));
  in.integer("the tag of an entity");
  const bool parametric = in.integer("the mark of parametric coordinates, 0 or 1") != 0;
  const std::size_t n =
      in.checked_count("the number of nodes", in.size("the number of nodes of a block"), 4, 32);
  const std::size_t first = nodes.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t offset = in.next_offset();
    nodes.push_back({in.size("a node number"), offset, {}, 0});
  }
  for (std::size_t i = first; i < nodes.size(); ++i) {
    nodes[i].offset = in.next_offset();
    read_coordinates(in, nodes[i]);
    for (Index k = 0; parametric && k < dimension; ++k) in.real("a parametric coordinate");
  }
}

}  // namespace

Index find_node(const GmshStream& in, const GmshContent& content, std::int64_t number) {
  const std::vector<std::int64_t>& numbers = content.node_numbers;
  if (!numbers.empty() && number >= numbers.front() && number <= numbers.back()) {
    // Numbers without gaps, the usual case, need no search.
    const auto slot =
        static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(numbers.front());
    if (slot < numbers.size() && numbers[slot] == number) return static_cast<Index>(slot);
    const auto found = std::lower_bound(numbers.begin(), numbers.end(), number);
    if (*found == number) return static_cast<Index>(found - numbers.begin());
  }
  in.fail("node number " + std::to_string(number) + " does not exist");
}

void read_gmsh_nodes_2(GmshStream& in, GmshContent& content) {
  require_first(in, content);
  const std::size_t n =
      in.checked_count("the number of nodes", in.text.integer("the number of nodes"), 4, 28);
  if (in.binary()) in.text.skip_line();
  std::vector<Node> nodes(n);
  for (Node& node : nodes) {
    node.offset = in.next_offset();
    node.number = in.integer("a node number");
    read_coordinates(in, node);
  }
  store(in, content, nodes);
}

void read_gmsh_nodes_4(GmshStream& in, GmshContent& content) {
  require_first(in, content);
  const std::int64_t blocks = in.size("the number of node blocks");
  const std::int64_t total = in.size("the number of nodes");
  in.checked_count("the number of nodes", total, 4, 32);
  in.size("the smallest node number");
  in.size("the largest node number");
  std::vector<Node> nodes;
  nodes.reserve(static_cast<std::size_t>(total));
  for (std::int64_t b = 0; b < blocks; ++b) read_block(in, nodes);
  if (static_cast<std::int64_t>(nodes.size()) != total)
    in.fail("the blocks hold " + std::to_string(nodes.size()) + " nodes, $Nodes announced " +
            std::to_string(total));
  store(in, content, nodes);
}

}  // namespace anisofront
