#include <algorithm>
#include <numeric>

#include "mesher/io/element_orientation.hpp"
#include "mesher/io/gmsh_content.hpp"

namespace anisofront {

namespace {

struct ElementType {
  int type;
  std::size_t corners;
  std::size_t nodes;
};
// The numbers of the Gmsh manual, section "Node ordering".
constexpr std::array<ElementType, 8> kTypes{
    {{15, 1, 1}, {1, 2, 2}, {8, 2, 3}, {2, 3, 3}, {9, 3, 6}, {3, 4, 4}, {10, 4, 9}, {16, 4, 8}}};
constexpr std::array<int, 11> kSolids{4, 5, 6, 7, 11, 12, 13, 14, 17, 18, 19};

const ElementType& element_type(const GmshStream& in, int type, const std::string& where) {
  for (const ElementType& known : kTypes)
    if (known.type == type) return known;
  if (std::find(kSolids.begin(), kSolids.end(), type) != kSolids.end())
    in.fail(where + " is three-dimensional (type " + std::to_string(type) +
            "): expected a mesh in the plane");
  in.fail(where + " has type " + std::to_string(type) +
          ": expected points (15), lines (1, 8), triangles (2, 9) or quads (3, 10, 16); "
          "elements of third and higher order are not read");
}

std::string described(const GmshElement& element) {
  return "element " + std::to_string(element.number);
}

template <std::size_t N>
void orient(const GmshStream& in, const GmshContent& content, GmshElement& element) {
  std::array<Index, N> vertices;
  std::copy_n(element.vertices.begin(), N, vertices.begin());
  if (const char* defect = make_anticlockwise(vertices, content.points))
    in.fail(described(element) + " " + defect);
  std::copy_n(vertices.begin(), N, element.vertices.begin());
}

void check_length(const GmshStream& in, const GmshContent& content, const GmshElement& element) {
  if (content.points[element.vertices[0]] == content.points[element.vertices[1]])
    in.fail(described(element) + " has no length");
}

void add_element(const GmshStream& in, GmshContent& content, std::size_t corners,
                 GmshElement& element) {
  if (corners == 1) return content.point_elements.push_back(element);
  if (corners == 2) {
    check_length(in, content, element);
    return content.edges.push_back(element);
  }
  if (corners == 3) {
    orient<3>(in, content, element);
    return content.triangles.push_back(element);
  }
  orient<4>(in, content, element);
  content.quads.push_back(element);
}

/// Reads the node numbers with `read_number` and keeps the corners.
template <class ReadNumber>
void read_nodes(GmshStream& in, GmshContent& content, const ElementType& type, GmshElement& element,
                ReadNumber read_number) {
  for (std::size_t k = 0; k < type.nodes; ++k) {
    const Index node = find_node(in, content, read_number());
    if (k < type.corners)
      element.vertices[k] = node;
    else
      content.is_mid_node[static_cast<std::size_t>(node)] = 1;
  }
  content.second_order += type.nodes > type.corners;
}

/// Tags, nodes of an element of format 2; its number has been read.
void read_element_2(GmshStream& in, GmshContent& content, const ElementType& type,
                    std::int64_t tags, GmshElement element) {
  for (std::int64_t k = 0; k < tags; ++k) {
    const Index tag = in.integer("a tag of an element");
    if (k == 0) element.physical = unsigned_tag(tag);
    if (k == 1) element.elementary = tag;
  }
  read_nodes(in, content, type, element, [&in] { return in.integer("a node number"); });
  add_element(in, content, type.corners, element);
}

void read_ascii_elements_2(GmshStream& in, GmshContent& content, std::size_t n) {
  for (std::size_t e = 0; e < n; ++e) {
    GmshElement element{.number = in.integer("an element number")};
    const ElementType& type =
        element_type(in, in.integer("the type of an element"), described(element));
    read_element_2(in, content, type, in.integer("the number of tags"), element);
  }
}

void read_binary_elements_2(GmshStream& in, GmshContent& content, std::size_t n) {
  for (std::size_t e = 0; e < n;) {
    const ElementType& type =
        element_type(in, in.integer("the type of an element"), "a block of elements");
    const Index block = in.integer("the number of elements of a block");
    const Index tags = in.integer("the number of tags");
    if (block < 1 || static_cast<std::size_t>(block) > n - e)
      in.fail("a block of " + std::to_string(block) + " elements, expected 1 to " +
              std::to_string(n - e));
    for (Index i = 0; i < block; ++i)
      read_element_2(in, content, type, tags, {.number = in.integer("an element number")});
    e += static_cast<std::size_t>(block);
  }
}

/// Sorts by number.
void sort_elements(std::vector<GmshElement>& elements) {
  const auto by_number = [](const GmshElement& a, const GmshElement& b) {
    return a.number < b.number;
  };
  if (!std::is_sorted(elements.begin(), elements.end(), by_number))
    std::stable_sort(elements.begin(), elements.end(), by_number);
}

/// Elements with the same vertices as an earlier one. Gmsh stores those in several physical groups
/// once for each group (format 2).
std::vector<char> find_repeats(const std::vector<GmshElement>& elements) {
  std::vector<std::pair<std::array<Index, 4>, std::size_t>> keys(elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    keys[e] = {elements[e].vertices, e};
    std::sort(keys[e].first.begin(), keys[e].first.end());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<char> repeated(elements.size(), 0);
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) repeated[keys[i].second] = 1;
  return repeated;
}

void remove_repeats(std::vector<GmshElement>& elements, std::vector<std::int64_t>& removed) {
  const std::vector<char> repeated = find_repeats(elements);
  std::size_t kept = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (repeated[e])
      removed.push_back(elements[e].number);
    else
      elements[kept++] = elements[e];
  }
  elements.resize(kept);
}

void finish_elements(GmshContent& content) {
  std::vector<std::int64_t> removed;
  for (auto* elements :
       {&content.point_elements, &content.edges, &content.triangles, &content.quads}) {
    sort_elements(*elements);
    remove_repeats(*elements, removed);
  }
  if (!removed.empty())
    content.warning(std::to_string(removed.size()) +
                    " elements repeat the vertices of an earlier one and were left out; the first "
                    "of them is element " +
                    std::to_string(removed.front()));
  if (content.second_order > 0)
    content.warning(std::to_string(content.second_order) +
                    " elements of second order were reduced to their corners");
  content.left_out.insert(content.left_out.end(), removed.begin(), removed.end());
  std::sort(content.left_out.begin(), content.left_out.end());
  content.has_elements = true;
}

void require_nodes(const GmshStream& in, const GmshContent& content) {
  if (!content.has_nodes) in.fail("$Elements before $Nodes");
  if (content.has_elements) in.fail("a second section $Elements");
}

GmshEntity find_entity(const GmshEntities& entities, int dimension, Index tag) {
  const auto after = std::upper_bound(entities.begin(), entities.end(), std::pair(dimension, tag),
                                      [](const std::pair<int, Index>& key, const GmshEntity& e) {
                                        return key < std::pair(e.dimension, e.tag);
                                      });
  if (after != entities.begin() && (after - 1)->dimension == dimension && (after - 1)->tag == tag)
    return *(after - 1);
  return {.dimension = dimension, .tag = tag, .elementary = tag};
}

/// Returns the number of elements of the block.
std::size_t read_block_4(GmshStream& in, GmshContent& content, const GmshEntities& entities) {
  const Index dimension = in.integer("the dimension of an entity");
  const Index tag = in.integer("the tag of an entity");
  const ElementType& type = element_type(in, in.integer("the type of an element"),
                                         "a block of elements on entity " + std::to_string(tag));
  const std::size_t n =
      in.checked_count("the number of elements", in.size("the number of elements of a block"),
                       1 + type.nodes, 8 * (1 + type.nodes));
  const GmshEntity entity = find_entity(entities, dimension, tag);
  for (std::size_t e = 0; e < n; ++e) {
    GmshElement element{.number = in.size("an element number"),
                        .physical = entity.physical,
                        .elementary = entity.elementary};
    read_nodes(in, content, type, element, [&in] { return in.size("a node number"); });
    if (entity.is_interface)
      content.left_out.push_back(element.number);
    else
      add_element(in, content, type.corners, element);
  }
  return n;
}

}  // namespace

void read_gmsh_elements_2(GmshStream& in, GmshContent& content) {
  require_nodes(in, content);
  const std::size_t n =
      in.checked_count("the number of elements", in.text.integer("the number of elements"), 4, 8);
  if (in.binary()) {
    in.text.skip_line();
    read_binary_elements_2(in, content, n);
  } else {
    read_ascii_elements_2(in, content, n);
  }
  finish_elements(content);
}

void read_gmsh_elements_4(GmshStream& in, GmshContent& content, const GmshEntities& entities) {
  require_nodes(in, content);
  const std::int64_t blocks = in.size("the number of element blocks");
  const std::size_t total =
      in.checked_count("the number of elements", in.size("the number of elements"), 2, 16);
  in.size("the smallest element number");
  in.size("the largest element number");
  std::size_t found = 0;
  for (std::int64_t b = 0; b < blocks; ++b) found += read_block_4(in, content, entities);
  if (found != total)
    in.fail("the blocks hold " + std::to_string(found) + " elements, $Elements announced " +
            std::to_string(total));
  finish_elements(content);
}

}  // namespace anisofront
