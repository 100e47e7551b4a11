# cmake -DTEMPLATE=page.html -DMADE=FOLDER -P embed_page.cmake: FOLDER/script.js, style.css and
# dark.css with the template as strings in FOLDER/page_text.cpp.
set(text "// Made from page/ by cmake/embed_page.cmake.\n#include \"write/page_text.h\"\n\nnamespace c1mesh::page {\n\n")
foreach(pair "kTemplate=${TEMPLATE}" "kScript=${MADE}/script.js" "kStyle=${MADE}/style.css"
        "kDark=${MADE}/dark.css")
  string(REGEX MATCH "^([^=]+)=(.*)$" _ "${pair}")
  set(name "${CMAKE_MATCH_1}")
  file(READ "${CMAKE_MATCH_2}" content)
  string(FIND "${content}" ")c1page\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${CMAKE_MATCH_2} holds what ends its string")
  endif()
  string(APPEND text "const std::string_view ${name} = R\"c1page(${content})c1page\";\n\n")
endforeach()
string(APPEND text "}  // namespace c1mesh::page\n")
file(WRITE "${MADE}/page_text.cpp" "${text}")
