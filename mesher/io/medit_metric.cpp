#include "mesher/io/mapped_file.hpp"
#include "mesher/io/medit.hpp"
#include "mesher/io/metric_entry.hpp"
#include "mesher/io/text_cursor.hpp"

namespace anisofront {

namespace {

enum class SolutionType { scalar = 1, vector = 2, tensor = 3 };

[[noreturn]] void fail_vertex(TextCursor& text, std::size_t offset, Index vertex,
                              const std::string& message) {
  text.fail_at(offset, "vertex " + std::to_string(vertex + 1) + ": " + message);
}

double read_entry(TextCursor& text, Index vertex) {
  if (text.at_end())
    fail_vertex(text, text.offset(), vertex, "its metric is missing, the file ends here");
  return text.real("a number of the metric");
}

Metric read_size(TextCursor& text, Index vertex) {
  text.at_end();
  const std::size_t start = text.offset();
  const double h = read_entry(text, vertex);
  if (const char* defect = size_defect(h))
    fail_vertex(text, start, vertex, "the size " + std::to_string(h) + " " + defect);
  return metric_of_size(h);
}

Metric read_tensor(TextCursor& text, Index vertex) {
  text.at_end();
  const std::size_t start = text.offset();
  Metric m;
  for (double* entry : {&m.m11, &m.m12, &m.m22}) *entry = read_entry(text, vertex);
  if (const char* defect = metric_defect(m))
    fail_vertex(text, start, vertex,
                "the metric (m11 m12 m22) = (" + std::to_string(m.m11) + " " +
                    std::to_string(m.m12) + " " + std::to_string(m.m22) + ") " + defect);
  return m;
}

int read_header(TextCursor& text) {
  text.expect("MeshVersionFormatted");
  text.integer("a format version");
  text.expect("Dimension");
  const Index dimension = text.index("2, the dimension");
  if (dimension != 2 && dimension != 3) text.fail("expected Dimension 2");
  return dimension;
}

SolutionType read_type(TextCursor& text, int dimension) {
  if (text.integer("the number of fields") != 1)
    text.fail("expected one field: a scalar (1) or a symmetric tensor (3)");
  const Index type = text.index("the type of the field, 1 or 3");
  if (type == static_cast<int>(SolutionType::scalar)) return SolutionType::scalar;
  if (type != static_cast<int>(SolutionType::tensor))
    text.fail("a metric is a scalar (type 1) or a symmetric tensor (type 3), found type " +
              std::to_string(type));
  if (dimension == 3) text.fail("expected Dimension 2 for a tensor: m11 m12 m22");
  return SolutionType::tensor;
}

void find_solution(TextCursor& text) {
  while (text.word("the section SolAtVertices") != "SolAtVertices") {
  }
}

}  // namespace

MetricField parse_medit_metric(std::string_view bytes, const std::string& name,
                               Index vertex_count) {
  TextCursor text(bytes, name);
  const int dimension = read_header(text);
  find_solution(text);
  const std::int64_t n = text.integer("the number of vertices");
  if (n != vertex_count)
    text.fail("metrics of " + std::to_string(n) + " vertices, but the mesh has " +
              std::to_string(vertex_count));
  const SolutionType type = read_type(text, dimension);
  const bool is_tensor = type == SolutionType::tensor;
  MetricField field(static_cast<std::size_t>(vertex_count));
  for (Index v = 0; v < vertex_count; ++v)
    field[static_cast<std::size_t>(v)] = is_tensor ? read_tensor(text, v) : read_size(text, v);
  return field;
}

MetricField read_medit_metric(const std::filesystem::path& path, Index vertex_count) {
  const MappedFile file(path);
  return parse_medit_metric(file.bytes(), path.string(), vertex_count);
}

}  // namespace anisofront
