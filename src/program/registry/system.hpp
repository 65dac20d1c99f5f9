// The registry of systems: the one place where a system adds itself, with its parameters, methods,
// quantities, statements and pictures.
//
// A later system writes one file systems/NAME.cpp with a function NAME_system() that returns its `System`,
// and one line in system.cpp.
#pragma once

#include <optional>

#include "actio/parallel/parts_on_ranks.hpp"
#include "program/document/key.hpp"
#include "program/document/schedule.hpp"
#include "program/registry/simulation.hpp"

namespace actio::scene {

/// A method that a system can be stepped by.
struct Method {
  std::string name;                 ///< as scenes write it
  std::vector<std::string> orders;  ///< as the scene writes them: "2", "exact"
  std::string meaning;              ///< one sentence
  std::string statement;            ///< of the thesis, or of the literature
};

/// What a scene asks of a system.
struct Request {
  SceneFile file;                       ///< whose sections the system reads
  Schedule const& schedule;             ///< when there are rows
  std::vector<std::string> quantities;  ///< names of those that the rows hold
  /// whether an estimate of the error is wanted; none: where it costs less than a third of the run
  std::optional<bool> error_estimate;
  /// what is wanted of snapshots; none: there are none to be written
  std::optional<SnapshotRequest> snapshots = {};
};

struct BodyShape;
struct OrbitingBody;
struct Overview;
struct Scene;

/// A picture of a run that one system alone draws.
struct Picture {
  std::string name;      ///< of its file, plots/NAME.svg
  std::string quantity;  ///< it is drawn where this one was asked for
  /// The picture, as SVG.
  std::string (*draw)(Scene const& scene, Overview const& overview);
};

/// Maps of the snapshots of a run, which its system draws.
struct SnapshotMaps {
  std::string name;  ///< of the picture of some of them, plots/NAME.svg
  /// Some of them, from the first to the last that is there, as a picture of that width; empty where the run
  /// has none.
  std::string (*picture)(Scene const& scene, std::string const& folder, double width);
  /// All of them, or a hundred, as the page of the run has them, in JSON; `null` where there are fewer than
  /// two.
  std::string (*json)(Scene const& scene, std::string const& folder);
};

/// A kind of system.
struct System {
  std::string name;       ///< as scenes write it
  std::string title;      ///< for people
  std::string meaning;    ///< a sentence or two
  std::string statement;  ///< of the thesis
  std::vector<Parameter>
      parameters;  ///< of [system] and [initial]; one of [method] takes the place of that of every system
  std::vector<Method> methods;       ///< the default first
  std::vector<Quantity> quantities;  ///< each after what it needs
  /// Reads [system], [initial] and [method], writes their defaults back, and sets up what was asked for.
  /// @throws SceneError     where a value is missing or wrong
  /// @throws NumericsError  where the step is too long for the method
  Simulation (*prepare)(Request const& request);
  std::string example = "";  ///< a small scene to paste, which runs as it is
  /// What the body that turns in a scene looks like; null where none does.
  BodyShape (*shape)(SceneFile const& file) = nullptr;
  std::vector<Picture> pictures = {};  ///< beside those that every system has: curves, drifts and the page
  /// The quantities that a scene of it adds by itself, for instance the vectors that it names; null where
  /// none does so.
  std::vector<Quantity> (*own_quantities)(SceneFile const& file) = nullptr;
  std::optional<SnapshotKind> snapshots = {};  ///< what its snapshots can hold; none: it has no snapshots
  std::optional<SnapshotMaps> maps = {};       ///< how they are drawn as maps; none: they are not
  /// The method that a scene with run.accuracy takes where it leaves method and order out; null: the first.
  std::string (*method_for_accuracy)(SceneFile const& file) = nullptr;
  /// The two bodies that move about each other in a scene, in the order of their attitudes; null where none
  /// do.
  std::vector<OrbitingBody> (*bodies)(SceneFile const& file) = nullptr;
  /// What another rank has of the motion of a scene, where rank 0 tells such a number with it; null where
  /// ranks do not share it.
  std::unique_ptr<RankPart> (*part)(SceneFile const& file, double number) = nullptr;
};

/// All systems, in the order in which they are told.
std::vector<System> const& systems();
/// The one of that name; null where there is none.
System const* find_system(std::string const& name);
/// What this rank, which is not the first, has of the motion of a scene.
/// @param scene   as a text
/// @param number  that rank 0 tells with it
std::unique_ptr<RankPart> part_of_motion(std::string const& scene, double number);

/// The names of systems, of methods, of quantities, ...
template <class List>
std::vector<std::string> names_of(List const& list) {
  std::vector<std::string> out;
  for (auto const& one : list) out.emplace_back(one.name);
  return out;
}

}  // namespace actio::scene
