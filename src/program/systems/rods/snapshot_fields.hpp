// What snapshots of a rod hold of its sections and of its elements.
#pragma once

#include <string>
#include <vector>

namespace actio::scene {

/// Numbers of sections or elements that go together.
struct RodField {
  char const* name;                     ///< as scenes and files have it
  char const* meaning;                  ///< in a few words
  char const* unit;                     ///< as \ref Units reads it
  std::vector<std::string> components;  ///< of its columns: the name and one of these; or these alone
  bool named = true;                    ///< whether its columns begin with its name

  std::vector<std::string> columns() const;  ///< of a table
};

/// Of every section.
std::vector<RodField> const& fields_of_sections();
/// Of the elements, where asked for.
std::vector<RodField> const& fields_of_elements();
/// Those of elements that a scene asks for, in its order.
std::vector<RodField> rod_fields(std::vector<std::string> const& names);

}  // namespace actio::scene
