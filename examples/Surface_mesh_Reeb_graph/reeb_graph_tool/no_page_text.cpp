#include "Page_text.h"

// Where npm was not found.
const Page_text& page_text()
{
  static const Page_text text;
  return text;
}
