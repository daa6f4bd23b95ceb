#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/io/gmsh_content.hpp"

namespace anisofront {

namespace {

/// The header of a data section and the field it announces, with NaN for every value.
struct DataSection {
  FileField field;
  std::size_t count = 0;
};

void read_string_tags(GmshStream& in, FileField& field) {
  const Index n = in.text.count("the number of string tags", 1);
  for (Index i = 0; i < n; ++i) {
    const std::string_view tag = in.text.quoted("a string tag");
    if (i == 0) field.name = tag;
  }
}

void read_real_tags(GmshStream& in, FileField& field) {
  const Index n = in.text.count("the number of real tags", 2);
  for (Index i = 0; i < n; ++i) {
    const double tag = in.text.real("a real tag");
    if (i == 0) field.time = tag;
  }
}

DataSection read_header(GmshStream& in, std::size_t entry_bytes) {
  DataSection section;
  read_string_tags(in, section.field);
  read_real_tags(in, section.field);
  const Index n = in.text.count("the number of integer tags", 2);
  std::array<Index, 3> tags{};  // step, components, entries
  if (n < 3) in.fail("expected at least 3 integer tags (step, components, number of entries)");
  for (Index i = 0; i < n; ++i) {
    const Index tag = in.text.index("an integer tag");
    if (i < 3) tags[static_cast<std::size_t>(i)] = tag;
  }
  if (tags[1] != 1 && tags[1] != 3 && tags[1] != 9)
    in.fail("a field of " + std::to_string(tags[1]) + " components, expected 1, 3 or 9");
  section.field.step = tags[0];
  section.field.components = tags[1];
  const auto components = static_cast<std::size_t>(tags[1]);
  section.count = in.checked_count("the number of entries", tags[2], 1 + components,
                                   entry_bytes + 8 * components);
  if (in.binary()) in.text.skip_line();
  return section;
}

void allocate(FileField& field, std::size_t entities) {
  field.values.assign(entities * static_cast<std::size_t>(field.components),
                      std::numeric_limits<double>::quiet_NaN());
}

double* entry(FileField& field, Index slot) {
  return field.values.data() + static_cast<std::ptrdiff_t>(slot) * field.components;
}

void read_values(GmshStream& in, const FileField& field, double* values) {
  for (int k = 0; k < field.components; ++k) values[k] = in.real("a value of a field");
}

/// Position among triangles, then quads; kNoIndex for other elements.
Index find_element(const GmshStream& in, const GmshContent& content, std::int64_t number) {
  const auto find = [number](const std::vector<GmshElement>& elements) {
    const auto at = std::lower_bound(
        elements.begin(), elements.end(), number,
        [](const GmshElement& element, std::int64_t key) { return element.number < key; });
    return at != elements.end() && at->number == number ? static_cast<Index>(at - elements.begin())
                                                        : kNoIndex;
  };
  if (const Index triangle = find(content.triangles); triangle != kNoIndex) return triangle;
  if (const Index quad = find(content.quads); quad != kNoIndex)
    return static_cast<Index>(content.triangles.size()) + quad;
  if (find(content.edges) == kNoIndex && find(content.point_elements) == kNoIndex &&
      !std::binary_search(content.left_out.begin(), content.left_out.end(), number))
    in.fail("element number " + std::to_string(number) + " does not exist");
  return kNoIndex;
}

void warn_left_out(const GmshContent& content, const FileField& field, std::size_t count) {
  if (count > 0)
    content.warning("field '" + field.name + "': " + std::to_string(count) +
                    " entries of elements other than triangles and quads were left out");
}

std::size_t element_count(const GmshContent& content) {
  return content.triangles.size() + content.quads.size();
}

void require_elements(const GmshStream& in, const GmshContent& content) {
  if (!content.has_elements) in.fail("element data before $Elements");
}

/// The mean of the values at the corners of element `slot`, of `nodes` nodes in the file.
void read_mean(GmshStream& in, const GmshContent& content, FileField& field, Index slot,
               Index nodes) {
  const Index corners = slot < static_cast<Index>(content.triangles.size()) ? 3 : 4;
  if (nodes < corners)
    in.fail("values at " + std::to_string(nodes) + " nodes of an element, expected at least " +
            std::to_string(corners));
  double* mean = entry(field, slot);
  std::fill_n(mean, field.components, 0.0);
  std::array<double, 9> values;
  for (Index node = 0; node < nodes; ++node) {
    read_values(in, field, values.data());
    for (int k = 0; node < corners && k < field.components; ++k)
      mean[k] += values[static_cast<std::size_t>(k)] / corners;
  }
}

void skip_values(GmshStream& in, const FileField& field, Index nodes) {
  std::array<double, 9> values;
  for (Index node = 0; node < nodes; ++node) read_values(in, field, values.data());
}

}  // namespace

void read_gmsh_node_data(GmshStream& in, GmshContent& content) {
  if (!content.has_nodes) in.fail("$NodeData before $Nodes");
  DataSection section = read_header(in, 4);
  allocate(section.field, content.points.size());
  for (std::size_t i = 0; i < section.count; ++i) {
    const Index node = find_node(in, content, in.integer("a node number"));
    read_values(in, section.field, entry(section.field, node));
  }
  content.vertex_fields.push_back(std::move(section.field));
}

void read_gmsh_element_data(GmshStream& in, GmshContent& content) {
  require_elements(in, content);
  DataSection section = read_header(in, 4);
  allocate(section.field, element_count(content));
  std::size_t left_out = 0;
  std::array<double, 9> unused;
  for (std::size_t i = 0; i < section.count; ++i) {
    const Index slot = find_element(in, content, in.integer("an element number"));
    read_values(in, section.field, slot == kNoIndex ? unused.data() : entry(section.field, slot));
    left_out += slot == kNoIndex;
  }
  warn_left_out(content, section.field, left_out);
  content.element_fields.push_back(std::move(section.field));
}

void read_gmsh_element_node_data(GmshStream& in, GmshContent& content) {
  require_elements(in, content);
  DataSection section = read_header(in, 8);
  allocate(section.field, element_count(content));
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < section.count; ++i) {
    const Index slot = find_element(in, content, in.integer("an element number"));
    const Index nodes = in.integer("a number of nodes");
    if (slot == kNoIndex) {
      skip_values(in, section.field, nodes);
      ++left_out;
    } else {
      read_mean(in, content, section.field, slot, nodes);
    }
  }
  warn_left_out(content, section.field, left_out);
  content.warning("field '" + section.field.name +
                  "': the values at the nodes of each element were averaged");
  content.element_fields.push_back(std::move(section.field));
}

}  // namespace anisofront
