# Compiles the pages of docs/diagnostics into the command, for `iecfront explain`.

# The text of `page` as C++ string literals. No compiler need take one of more than 4000 bytes (the
# least that some take is 16 kB), and the delimiter cannot occur in a page by chance.
function(iecfront_string_literals page out)
    set(literals)
    string(LENGTH "${page}" size)
    set(begin 0)
    while(begin LESS size)
        string(SUBSTRING "${page}" ${begin} 4000 piece)
        string(APPEND literals "\n     R\"iecfront_page(${piece})iecfront_page\"")
        math(EXPR begin "${begin} + 4000")
    endwhile()
    set(${out} "${literals}" PARENT_SCOPE)
endfunction()

# Writes the C++ source `output` with every IEC*.md in `folder`. Done anew when a page changes, comes
# or goes.
function(iecfront_write_explain_pages folder output)
    file(GLOB pages CONFIGURE_DEPENDS ${folder}/IEC*.md)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pages})
    set(rows)
    set(count 0)
    foreach(file IN LISTS pages)
        get_filename_component(code ${file} NAME_WE)
        file(READ ${file} page)
        iecfront_string_literals("${page}" literals)
        string(APPEND rows "    {\"${code}\",${literals}},\n")
        math(EXPR count "${count} + 1")
    endforeach()
    configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/explain_pages.cpp.in ${output} @ONLY)
endfunction()
