// MJCF as a document in memory: includes expanded, elements copied with prefixed names.
#pragma once

#include <tinyxml2.h>

#include <memory>
#include <string>

#include "base/result.h"
#include "vehicle/engine.h"

namespace phs::vehicle {

using XmlPtr = std::unique_ptr<tinyxml2::XMLDocument>;

/// Reads an MJCF file and puts the content of every <include> in its place (as MuJoCo does).
Result<XmlPtr> ReadMjcf(const std::string& path);

/// Deep copy of `element` into `target`'s document with `prefix` before every name and reference.
tinyxml2::XMLElement* CopyWithPrefix(const tinyxml2::XMLElement& element, const std::string& prefix,
                                     tinyxml2::XMLNode* target);

/// The body of a name, or null.
tinyxml2::XMLElement* FindBody(tinyxml2::XMLElement* root, const std::string& name);

/// Compiles the document; `origin` names it in messages.
Result<ModelPtr> CompileMjcf(const tinyxml2::XMLDocument& document, const std::string& origin);

}  // namespace phs::vehicle
