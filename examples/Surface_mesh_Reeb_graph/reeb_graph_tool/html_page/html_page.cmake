# Sets html_page_source to the source file that has the text of the HTML page, and has_html_page to
# whether there is a page. npm fetches three.js and esbuild, once for a build folder; where that fails,
# the tool is built without the page.

set(html_page_dir ${CMAKE_CURRENT_LIST_DIR})
set(html_page_build_dir ${CMAKE_CURRENT_BINARY_DIR}/html_page)
set(html_page_source ${CMAKE_CURRENT_SOURCE_DIR}/reeb_graph_tool/no_page_text.cpp)
set(has_html_page FALSE)

option(SURFACE_MESH_REEB_GRAPH_BUILD_HTML_PAGE
  "Build the HTML page of the tool reeb_graph, if npm is found" ON)
find_program(NPM_EXECUTABLE npm)
find_program(NODE_EXECUTABLE NAMES node nodejs)
mark_as_advanced(NPM_EXECUTABLE NODE_EXECUTABLE)

if(SURFACE_MESH_REEB_GRAPH_BUILD_HTML_PAGE AND NPM_EXECUTABLE AND NODE_EXECUTABLE)
  # npm writes this file when it is done.
  set(html_page_stamp ${html_page_build_dir}/node_modules/.package-lock.json)
  if(NOT EXISTS ${html_page_stamp} OR
      ${html_page_dir}/package-lock.json IS_NEWER_THAN ${html_page_stamp})
    file(COPY ${html_page_dir}/package.json ${html_page_dir}/package-lock.json
      DESTINATION ${html_page_build_dir})
    execute_process(
      COMMAND ${NPM_EXECUTABLE} ci --ignore-scripts --no-audit --no-fund
      WORKING_DIRECTORY ${html_page_build_dir}
      TIMEOUT 120
      RESULT_VARIABLE npm_result
      OUTPUT_VARIABLE npm_output
      ERROR_VARIABLE npm_output)
    if(NOT npm_result EQUAL 0)
      file(REMOVE ${html_page_stamp})
      message(NOTICE "NOTICE: npm could not fetch what the HTML page is made of:\n${npm_output}")
    endif()
  endif()
  if(EXISTS ${html_page_stamp})
    set(html_page_source ${html_page_build_dir}/page_text.cpp)
    set(has_html_page TRUE)
    file(GLOB html_page_files CONFIGURE_DEPENDS
      ${html_page_dir}/*.js ${html_page_dir}/*.mjs ${html_page_dir}/page.*)
    add_custom_command(
      OUTPUT ${html_page_source}
      COMMAND ${NODE_EXECUTABLE} ${html_page_dir}/build.mjs
              ${html_page_build_dir}/node_modules ${html_page_source}
      DEPENDS ${html_page_files} ${html_page_stamp}
      VERBATIM)
  endif()
endif()
if(SURFACE_MESH_REEB_GRAPH_BUILD_HTML_PAGE AND NOT has_html_page)
  message(NOTICE
    "NOTICE: the HTML page of the tool reeb_graph requires npm, and will not be built.")
endif()
