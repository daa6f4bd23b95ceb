#include "drivers/report/html.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"

namespace anisofront {
namespace {

const char* const kStyle =
    "body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1240px;padding:0 1rem;"
    "color:#222;background:#fff}"
    "h1{font-size:1.6rem}h2{font-size:1.2rem;margin-top:2.2rem;border-bottom:1px solid #ccc}"
    "table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}"
    "th,td{padding:.2rem .6rem;text-align:right}th{border-bottom:2px solid #555}"
    "th:nth-child(-n+2),td:nth-child(-n+2){text-align:left}"
    "tr.reference td{color:#777;font-style:italic;border-bottom:1px solid #ddd}"
    "code{background:#f2f2f2;padding:0 .3rem;border-radius:3px;white-space:nowrap}"
    "figure{margin:0}figure img{max-width:100%;max-height:640px}"
    "figcaption{color:#555;font-size:.9rem}.warnings{color:#a40}"
    ".pair{display:grid;grid-template-columns:1fr 1fr;gap:1.5rem;align-items:center}"
    "@media(max-width:800px){.pair{grid-template-columns:1fr}}";

std::string row(const std::vector<std::string>& cells, const char* tag, const char* attributes) {
  std::string html = fmt::format("<tr{}>", attributes);
  for (const std::string& cell : cells) html += fmt::format("<{0}>{1}</{0}>", tag, html_text(cell));
  return html + "</tr>\n";
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

std::string html_table(const TextTable& table) {
  std::string html = "<table>\n" + row(table.header, "th", "");
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    html += row(table.rows[i], "td", table.is_reference[i] ? " class=\"reference\"" : "");
  return html + "</table>\n";
}

std::string html_figure(const std::filesystem::path& svg, const std::string& caption) {
  constexpr std::size_t kLargestInline = 8u << 20;
  const std::string name = svg.filename().string();
  if (std::filesystem::file_size(svg) > kLargestInline)
    return fmt::format(
        "<figure><a href=\"figures/{0}\">{0}</a><figcaption>{1}</figcaption></figure>\n",
        html_text(name), html_text(caption));
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/svg+xml;base64,{1}\"><figcaption>{0}</figcaption>"
      "</figure>\n",
      html_text(caption), base64(read_text_file(svg)));
}

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      html_text(title), kStyle, body);
}

}  // namespace anisofront
