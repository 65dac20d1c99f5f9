// The materials that media of a scene are made of, by their names.
#pragma once

#include <string>
#include <vector>

namespace actio::scene {

/// A number that a material of the library has.
struct MaterialConstant {
  std::string name;     ///< as scenes write it
  std::string meaning;  ///< in a few words
  double above;         ///< it is greater than this
  std::string example;  ///< as a scene writes it
  std::string unit;     ///< "energy/volume"; "1" of what has none
};

/// What lists tell of a material of the library.
struct NamedMaterial {
  std::string name;                         ///< as scenes write it
  std::string meaning;                      ///< one sentence
  std::string formula;                      ///< TeX
  bool fluid;                               ///< it is one of fluids, if not of elastic bodies
  std::vector<MaterialConstant> constants;  ///< all are needed
};

/// All of them, those of fluids first.
std::vector<NamedMaterial> const& library_materials();
/// The one of that name; null where there is none.
NamedMaterial const* find_material(std::string const& name);

}  // namespace actio::scene
