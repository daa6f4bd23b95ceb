#include "drivers/study/study_output.hpp"

#include <algorithm>
#include <cctype>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/study/element_names.hpp"

namespace anisofront {
namespace {

constexpr Index kMaxLinePoints = 1'000'000;
constexpr double kMaxGrading = 20;
constexpr int kMaxThreads = 256;

constexpr std::array<Named<LinearMethod>, 5> kMethodNames{{{"automatic", LinearMethod::automatic},
                                                           {"simplicial", LinearMethod::simplicial},
                                                           {"supernodal", LinearMethod::supernodal},
                                                           {"multigrid", LinearMethod::multigrid},
                                                           {"general", LinearMethod::general}}};

std::vector<std::string> read_formats(TomlTable& table) {
  if (!table.has("formats")) return OutputRequests{}.formats;
  const std::vector<std::string> formats = table.texts("formats");
  const std::vector<std::string> known{"msh", "vtu", "svg", "mesh"};
  for (const std::string& format : formats)
    if (std::find(known.begin(), known.end(), format) == known.end())
      table.fail("formats",
                 fmt::format("unknown format \"{}\"; known: msh, vtu, svg, mesh", format));
  return formats;
}

/// A name that no earlier request of the list has.
template <class Request>
void require_new_name(TomlTable& entry, const std::string& name,
                      const std::vector<Request>& earlier) {
  for (const Request& request : earlier)
    if (request.name == name) entry.fail("name", fmt::format("\"{}\" stands there twice", name));
}

std::vector<ValueRequest> read_values(TomlTable& table) {
  std::vector<ValueRequest> values;
  for (TomlTable& entry : table.tables("values")) {
    const std::string name = entry.required(entry.text("name"), "name");
    require_new_name(entry, name, values);
    values.push_back({name, entry.required(entry.point("at"), "at"), entry.place()});
    entry.finish();
  }
  return values;
}

bool is_file_name(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
         });
}

/// reference = "FILE", or = { QUANTITY = "expression", ... }.
std::optional<LineReference> read_reference(TomlTable& entry) {
  constexpr const char* kKey = "reference";
  if (!entry.has(kKey)) return {};
  LineReference reference;
  reference.place = entry.place(kKey);
  if (!entry.is_table(kKey)) {
    reference.file = *entry.text(kKey);
    if (reference.file.empty())
      entry.fail(kKey, "expected the name of a file, or { QUANTITY = \"expression\" }");
    return reference;
  }
  TomlTable expressions = *entry.table(kKey);
  for (const std::string& name : expressions.keys())
    reference.quantities.push_back({name, *expressions.expression(name)});
  if (reference.quantities.empty())
    entry.fail(kKey, "is empty; expected { QUANTITY = \"expression\" }");
  return reference;
}

LineEnd line_end(const std::string& name) {
  if (name == "both") return LineEnd::both;
  return name == "end" ? LineEnd::end : LineEnd::start;
}

void read_spacing(TomlTable& entry, LineRequest& line) {
  line.points = entry.integer("points").value_or(line.points);
  line.grading = entry.number("grading").value_or(line.grading);
  if (line.points < 2 || line.points > kMaxLinePoints)
    entry.fail("points", fmt::format("expected 2 to {}, found {}", kMaxLinePoints, line.points));
  if (line.grading < 1 || line.grading > kMaxGrading)
    entry.fail("grading",
               fmt::format("expected 1 (equal steps) to {}, found {}", kMaxGrading, line.grading));
  if (entry.has("towards") && line.grading == 1)
    entry.fail("towards", "says where points stand close together; write grading = 2 or more too");
  line.towards = line_end(entry.choice("towards", {"start", "end", "both"}, "start"));
}

LineRequest read_line(TomlTable& entry) {
  LineRequest line;
  line.place = entry.place();
  line.curve = entry.text("curve").value_or("");
  line.name = entry.required(entry.text("name"), "name");
  const auto from = entry.point("from"), to = entry.point("to");
  read_spacing(entry, line);
  line.reference = read_reference(entry);
  entry.finish();
  if (!is_file_name(line.name))
    entry.fail("name", "becomes the name of a file; write letters, digits, dots, - and _ only");
  if (line.curve.empty() ? !(from && to) : (from || to))
    entry.fail({}, "expected either curve = \"NAME\" or from = [x, y] and to = [x, y]");
  if (from && *from == *to) entry.fail("to", "is the same point as from");
  line.from = from.value_or(Point{});
  line.to = to.value_or(Point{});
  return line;
}

}  // namespace

OutputRequests parse_output(TomlTable table) {
  OutputRequests output;
  output.formats = read_formats(table);
  output.values = read_values(table);
  for (TomlTable& entry : table.tables("lines")) {
    const LineRequest line = read_line(entry);
    require_new_name(entry, line.name, output.lines);
    output.lines.push_back(line);
  }
  table.finish();
  return output;
}

void change_reference_files(toml::table& study,
                            const std::function<std::string(const std::string&)>& change) {
  toml::array* lines = study["output"]["lines"].as_array();
  if (lines == nullptr) return;
  for (toml::node& line : *lines)
    if (toml::table* entry = line.as_table())
      if (const auto name = (*entry)["reference"].value<std::string>())
        entry->insert_or_assign("reference", change(*name));
}

std::filesystem::path beside_study(const std::filesystem::path& study,
                                   const std::filesystem::path& name) {
  return (study.parent_path() / name).lexically_normal();
}

SolverSettings parse_solver(TomlTable table) {
  SolverSettings solver;
  solver.place = table.place("method");
  solver.method =
      value_named(kMethodNames, table.choice("method", names_of(kMethodNames), "automatic"));
  const Index threads = table.integer("threads").value_or(0);
  if (threads > kMaxThreads)
    table.fail("threads", fmt::format("found {}, expected at most {}", threads, kMaxThreads));
  solver.threads = static_cast<int>(threads);
  solver.memory = table.positive("memory").value_or(0);
  table.finish();
  return solver;
}

}  // namespace anisofront
