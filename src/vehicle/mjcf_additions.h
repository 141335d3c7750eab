// What the plugin needs of a bogie's file and the file lacks, put into the document in memory.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace phs::vehicle {

/// Text of an attribute, "" without it.
std::string AttributeOf(const tinyxml2::XMLElement& element, const char* name);

/// Calls `visit` for every element `tag` in every top-level `section`.
template <typename Visit>
void ForEach(tinyxml2::XMLElement* root, const char* section, const char* tag, Visit visit) {
  for (tinyxml2::XMLElement* s = root->FirstChildElement(section); s != nullptr;
       s = s->NextSiblingElement(section)) {
    for (tinyxml2::XMLElement* e = s->FirstChildElement(tag); e != nullptr;
         e = e->NextSiblingElement(tag)) {
      visit(e);
    }
  }
}

/// userdata large enough for the plugin whatever its layout (it says itself what it needs): for all
/// joints and so many cylinders and states. True if the file's own was too small.
bool EnlargeUserData(int cylinders_and_states, tinyxml2::XMLElement* root);

/// The key that the plugin fills with the settled start. True if it was missing.
bool AddStartKey(tinyxml2::XMLElement* root);

/// Tracks, profiles and PHS models that lie beside the bogie's file, by their whole path. True if
/// any was found there.
bool FindBeside(const std::string& bogie_path, tinyxml2::XMLElement* root);

/// Meshes and textures of a model that is compiled from memory: still looked for beside its file.
void KeepAssetFolders(const std::string& bogie_path, tinyxml2::XMLElement* root);

/// True if the file names a step: <option timestep>.
bool SaysStep(const tinyxml2::XMLElement* root);

}  // namespace phs::vehicle
