// Copyright (c) 2026 The Surface_mesh_Reeb_graph authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_REEB_GRAPH_TEST_GROUPING_LOCALE_H
#define SURFACE_MESH_REEB_GRAPH_TEST_GROUPING_LOCALE_H

#include <locale>
#include <string>

namespace Reeb_graph_test {

// While it lives, streams write 1279.5 as 1.279,5 by default. It needs no locale of the system.
class Grouping_locale
{
public:
  Grouping_locale()
    : m_global_locale(std::locale::global(std::locale(std::locale::classic(), new Punctuation)))
  {}
  ~Grouping_locale() { std::locale::global(m_global_locale); }
  Grouping_locale(const Grouping_locale&) = delete;
  Grouping_locale& operator=(const Grouping_locale&) = delete;

private:
  struct Punctuation : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  std::locale m_global_locale;
};

} // namespace Reeb_graph_test

#endif // SURFACE_MESH_REEB_GRAPH_TEST_GROUPING_LOCALE_H
