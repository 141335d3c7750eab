# Writes OUTPUT, a C++ source that holds the page template, the joined STYLES and the joined SCRIPTS as
# string literals (declared in page_assets.h).

function(literal variable)
  set(joined "")
  foreach(path IN LISTS ARGN)
    file(READ "${path}" text)
    string(APPEND joined "${text}\n")
  endforeach()
  string(FIND "${joined}" ")PHS~\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${ARGN}: holds the end mark of the string literal")
  endif()
  set(${variable} "R\"PHS~(${joined})PHS~\"" PARENT_SCOPE)
endfunction()

literal(template "${TEMPLATE}")
literal(style ${STYLES})
literal(script ${SCRIPTS})
literal(licence "${LICENCE}")
literal(scene "${SCENE}")
literal(scene_licence "${SCENE_LICENCE}")
string(FIND "${scene}" "</script" clash)
if(NOT clash EQUAL -1)
  message(FATAL_ERROR "${SCENE}: would end the script element that holds it")
endif()
file(WRITE "${OUTPUT}" "// Made from the files of src/report/web and the plotting library.
#include \"report/page_assets.h\"
namespace phs::report {
const char kPageTemplate[] = ${template};
const char kPageStyle[] = ${style};
const char kPageScript[] = ${script};
const char kPlotLibraryLicence[] = ${licence};
const char kSceneScript[] = ${scene};
const char kSceneLibraryLicence[] = ${scene_licence};
}  // namespace phs::report
")
