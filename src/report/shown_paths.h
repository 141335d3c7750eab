// Texts without the folders of the machine that they were written on.
#pragma once

#include <string>

namespace phs::report {

/// Every absolute path in a text shortened: from models/ or bogie_xml/ on where it lies in such a
/// data folder, else its file name. Relative paths, which mean the same everywhere, stay. What
/// stands before a path is the text's begin, a blank, a quotation mark or one of = ( [ : , a path
/// ends before a blank, a quotation mark or one of : ; , ) ].
std::string WithoutFolders(const std::string& text);

}  // namespace phs::report
