#include "drivers/report/page.hpp"

#include <doctest/doctest.h>

#include "tests/drivers/temporary_folder.hpp"

using namespace anisofront;
using namespace anisofront::testing;

TEST_SUITE_BEGIN("unit");

TEST_CASE("text is no markup") {
  CHECK(html_text("a < b && \"c\" > d") == "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
}

TEST_CASE("nothing in the data can end its script and it reads back the same") {
  const Json data{{"study", "x = '</script><!-- <script>{{meshes}}' \\ \""}};
  const std::string page = page_html({"<t>", {}, data, {}});
  const std::string start = "<script type=\"application/json\" id=\"report-data\">";
  REQUIRE(has(page, start));
  const std::size_t begin = page.find(start) + start.size();
  const std::string text = page.substr(begin, page.find("</script>", begin) - begin);
  CHECK_FALSE(has(text, "<"));
  CHECK(Json::parse(text) == data);
  CHECK(has(page, "<title>&lt;t&gt;</title>"));
}

TEST_CASE("the page holds its meshes and the tables for readers without scripts") {
  TextTable table;
  table.header = {"variant", "a<b"};
  table.rows = {{"one", "&"}};
  const std::string page = page_html({"t", {table}, Json::object(), {{"mesh-0-1-2", "QUJD"}}});
  CHECK(has(page, "<script type=\"application/octet-stream\" id=\"mesh-0-1-2\">QUJD</script>"));
  CHECK(has(page, "<th>a&lt;b</th>"));
  CHECK(has(page, "<td>one</td><td>&amp;</td>"));
}

TEST_CASE("styles and scripts are embedded and end where they should") {
  CHECK(page_style().find("--accent") != std::string_view::npos);
  CHECK(page_script().find("function startReport()") != std::string_view::npos);
  CHECK(page_script().find("</script") == std::string_view::npos);
  CHECK(page_style().find("</style") == std::string_view::npos);
  CHECK(page_skeleton().find("{{data}}") != std::string_view::npos);
}

TEST_CASE("a page asks for nothing outside of itself") {
  const std::string page = page_html({"t", {}, Json::object(), {}});
  for (const char* outside : {"src=\"", "href=\"http", "@import", "url(http", "fetch("})
    CHECK_MESSAGE(!has(page, outside), outside);
}
