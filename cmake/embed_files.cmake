# Run by shatterpave_embed: writes OUTPUT, a C++ source holding the text of each of FILES.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  # A string literal is limited to 64 KiB by the standard; raw literals in sequence are joined by the compiler. The suffix sv on
  # the last one makes it a view without counting its characters, for which a compiler takes only so many steps.
  string(LENGTH "${text}" length)
  set(literals "")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 part)
    string(APPEND literals "R\"embedded(${part})embedded\"\n")
    math(EXPR at "${at} + 8000")
  endwhile()
  string(APPEND entries "    EmbeddedFile{\"${name}\",\n${literals}\"\"sv},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"core/embedded.h\"\n\n#include <array>\n\nnamespace shatterpave {\n
using namespace std::string_view_literals;

static constexpr std::array files = {\n${entries}};

std::span<const EmbeddedFile> embedded_files() { return files; }

}  // namespace shatterpave\n")
