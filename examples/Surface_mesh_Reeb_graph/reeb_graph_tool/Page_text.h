#ifndef REEB_GRAPH_TOOL_PAGE_TEXT_H
#define REEB_GRAPH_TOOL_PAGE_TEXT_H

#include <string_view>
#include <vector>

// The page without data, in pieces; html_page/build.mjs writes the source file.
struct Page_text
{
  std::vector<std::string_view> before_data, after_data; // empty if the build has no page
};

const Page_text& page_text();

#endif // REEB_GRAPH_TOOL_PAGE_TEXT_H
