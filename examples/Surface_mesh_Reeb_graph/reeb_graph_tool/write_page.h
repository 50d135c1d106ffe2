#ifndef REEB_GRAPH_TOOL_WRITE_PAGE_H
#define REEB_GRAPH_TOOL_WRITE_PAGE_H

#include "Page.h"

#include <iosfwd>

// Whether this build of the tool has the page: it is made with npm when the tool is built.
bool has_page();

// What somebody can do to get it.
extern const char* const how_to_get_page;

// Writes a page with its data as one file.
void write_page(std::ostream& out, const Page& page);

#endif // REEB_GRAPH_TOOL_WRITE_PAGE_H
