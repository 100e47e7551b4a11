# The page of a result (page/): TypeScript and style sheets, bundled by esbuild and embedded as text.
find_program(C1MESH_ESBUILD esbuild REQUIRED)
set(C1MESH_PAGE_FOLDER "${PROJECT_SOURCE_DIR}/page")
set(c1mesh_bundle --bundle --minify --charset=ascii --legal-comments=none --log-level=warning)

# c1mesh_page(OUT_VARIABLE): makes page_text.cpp (src/write/page_text.h); its name goes to OUT_VARIABLE.
function(c1mesh_page out)
  set(made "${CMAKE_CURRENT_BINARY_DIR}/page")
  file(MAKE_DIRECTORY ${made})
  file(GLOB scripts CONFIGURE_DEPENDS "${C1MESH_PAGE_FOLDER}/src/*.ts")
  add_custom_command(OUTPUT ${made}/page_text.cpp
    COMMAND ${C1MESH_ESBUILD} src/main.ts ${c1mesh_bundle} --format=iife --target=es2020
            --outfile=${made}/script.js
    COMMAND ${C1MESH_ESBUILD} src/style.css src/dark.css ${c1mesh_bundle} --outdir=${made}
    COMMAND ${CMAKE_COMMAND} "-DTEMPLATE=${C1MESH_PAGE_FOLDER}/page.html" "-DMADE=${made}"
            -P "${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake"
    DEPENDS ${scripts} ${C1MESH_PAGE_FOLDER}/src/style.css ${C1MESH_PAGE_FOLDER}/src/dark.css
            ${C1MESH_PAGE_FOLDER}/page.html ${C1MESH_PAGE_FOLDER}/tsconfig.json
            ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake
    WORKING_DIRECTORY ${C1MESH_PAGE_FOLDER}
    COMMENT "Bundling the page" VERBATIM)
  set(${out} ${made}/page_text.cpp PARENT_SCOPE)
endfunction()
