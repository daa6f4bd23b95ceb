#include "drivers/report/page.hpp"

#include <array>
#include <utility>

namespace anisofront {
namespace {

std::string table_row(const std::vector<std::string>& cells, const std::string& tag) {
  std::string html = "<tr>";
  for (const std::string& cell : cells)
    html.append("<").append(tag).append(">").append(html_text(cell)).append("</" + tag + ">");
  return html + "</tr>\n";
}

std::string html_tables(const std::vector<TextTable>& tables) {
  std::string html;
  for (const TextTable& table : tables) {
    html += "<table>\n" + table_row(table.header, "th");
    for (const std::vector<std::string>& row : table.rows) html += table_row(row, "td");
    html += "</table>\n";
  }
  return html;
}

/// JSON in which nothing can end the script element that holds it.
std::string script_json(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::string html_meshes(const std::vector<PageMesh>& meshes) {
  std::string html;
  for (const PageMesh& mesh : meshes)
    html.append("<script type=\"application/octet-stream\" id=\"")
        .append(mesh.id)
        .append("\">")
        .append(mesh.text)
        .append("</script>\n");
  return html;
}

using Part = std::pair<std::string_view, std::string>;

/// The skeleton with every {{name}} replaced by the part of that name. Parts are not looked into.
template <class Parts>
std::string filled(std::string_view skeleton, const Parts& parts) {
  std::string html;
  while (true) {
    const std::size_t begin = skeleton.find("{{");
    html += skeleton.substr(0, begin);
    if (begin == std::string_view::npos) return html;
    const std::size_t end = skeleton.find("}}", begin);
    const std::string_view name = skeleton.substr(begin + 2, end - begin - 2);
    for (const Part& part : parts)
      if (part.first == name) html += part.second;
    skeleton.remove_prefix(end + 2);
  }
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string page_html(const PageContent& content) {
  const std::array<Part, 6> parts{{{"title", html_text(content.title)},
                                   {"style", std::string(page_style())},
                                   {"script", std::string(page_script())},
                                   {"tables", html_tables(content.tables)},
                                   {"data", script_json(content.data)},
                                   {"meshes", html_meshes(content.meshes)}}};
  return filled(page_skeleton(), parts);
}

}  // namespace anisofront
