# cmake -DIN=NAME.gp -DOUT=NAME.gp.hpp -DROOM=… -P embed_script.cmake
# Turns a gnuplot script, or another text, into a header that holds its text: hexagait::scripts::ROOM::NAME.
get_filename_component(file ${IN} NAME)
get_filename_component(name ${IN} NAME_WE)
file(READ ${IN} text)
file(WRITE ${OUT} "// Made of ${file} by the build.
#pragma once

#include <string_view>

namespace hexagait::scripts::${ROOM} {
inline constexpr std::string_view ${name} = R\"script(${text})script\";
}  // namespace hexagait::scripts::${ROOM}
")
