// The keys that every scene has, whatever its system. Those of [run] are those of its schedule.
#pragma once

#include "program/registry/system.hpp"

namespace actio::scene {

/// `exact` as "exact", 2 as 2.
std::string order_as_written(std::string const& order);
/// `"exact" for moser_veselov, 2 for natural_chart`: the first order of each method; or, with all of them,
/// `moser_veselov takes "exact", 2, 4; natural_chart takes 2, 4`.
std::string orders_of(std::vector<Method> const& methods, bool all);
/// Every order of some method, once.
std::vector<std::string> all_orders_of(std::vector<Method> const& methods);

/// [scene], but for the units.
struct SceneKeys : KeyTable {
  Key<std::string> title = key(
      "title", text, LeftOut{"the name of the file without its ending"},
      "What the run is called in summary.json, series.h5, the pictures and the viewer.", "\"A body let go\"");
  Key<long> seed =
      key("seed", whole<long>("a whole number, 0 or more", 0), 1,
          "Where random numbers begin: with another one a random start is another one (initial.random and "
          "initial.ring of vorticity_sphere). Where nothing is random it changes no number of a run; it is "
          "checked, and written into the copy of the scene.",
          "1");
};
inline SceneKeys const scene_keys{{"scene"}};  ///< its keys

/// [scene.units]
struct UnitKeys : KeyTable {
  Key<std::string> mass =
      key("mass", text, LeftOut{"none"},
          "The unit of mass; with that of length it gives that of moments of inertia, and "
          "with that of time those of momentum and energy.",
          "\"kg\"");
  Key<std::string> length = key("length", text, LeftOut{"none"}, "The unit of length.", "\"m\"");
  Key<std::string> time = key("time", text, LeftOut{"none"}, "The unit of time.", "\"s\"");
};
/// Its keys.
inline UnitKeys const unit_keys{
    {"scene.units", LeftOut{"those of the body of the library, otherwise none"},
     "The names of the units in which the numbers of the scene are, for the axes of pictures, the viewer and "
     "series.h5; no number is changed. A body of the library has units of its own.",
     R"({ mass = "kg", length = "m", time = "s" })", "a table with mass, length and time"}};

/// `kind` of [system].
struct KindKeys : KeyTable {
  std::string const& example;  ///< the name of a system
  Key<std::string> kind =
      key("kind", one_of("system", names_of(systems()), "actio list systems"), needed,
          "The kind of system that is simulated (actio list systems).", as_written(example));
};

/// [method], of a system with these methods.
struct MethodKeys : KeyTable {
  std::vector<Method> const& methods;  ///< the default first
  Key<std::string> name =
      key("name", one_of("method", names_of(methods), "actio list methods"), methods.front().name,
          "The method that the system is stepped by (actio list methods).", as_written(methods.front().name));
  AnyKey order = key("order", "a whole number, or a text", LeftOut{orders_of(methods, false)},
                     "The order of the method: " + orders_of(methods, true) + ".",
                     order_as_written(methods.front().orders.front()), "", all_orders_of(methods));
};

/// The step of [method], of systems that choose it in some way.
struct StepKeys : KeyTable {
  Key<double> step;  ///< its length
  /// @param otherwise  what is chosen where it is left out
  StepKeys(std::string const& otherwise, std::string const& meaning, std::string const& example)
      : KeyTable("method"), step(key("step", positive.in("time"), LeftOut{otherwise}, meaning, example)) {}
};
/// That of most bodies.
inline StepKeys const step_keys{
    "the longest that divides the times of the rows and turns the body by at most 0.05 radians; where that "
    "makes more than four times as many steps as needed, one that divides run.every, or run.until",
    "The time that a step takes. Rows are at multiples of it, or anywhere with run.between_steps; an exact "
    "method does not use it.",
    "0.001"};

/// [output] of a system.
struct OutputKeys : KeyTable {
  System const& system;  ///< whose keys they are
  Words known;           ///< quantities
  Key<Words> quantities = key(
      "quantities", some_of("quantity", known, "actio list quantities"), needed,
      "What the rows hold, in this order after the time; nothing else is computed (actio list quantities).",
      as_written(Words{known.back()}));
  Key<Words> formats =
      key("formats", some_of("format", formats_of(system)), Words{"csv"},
          "What there is for other programs besides the table series.csv, a text with 17 significant "
          "digits, which every run writes: hdf5 is series.h5, a data set for each quantity with its unit, "
          "meaning and formula. Such files are made of the plain ones, whole, when a run ends, once a minute "
          "while it goes on, and by actio export." +
              meaning_of_formats(system),
          "[\"csv\", \"hdf5\"]");
  Key<bool> plots = key("plots", truth, false,
                        "Whether pictures are drawn when the run is done, and a page that plays the motion: "
                        "plots/*.svg and plots/index.html.",
                        "true");
  Key<bool> error_estimate =
      key("error_estimate", truth, LeftOut{"true where it costs no more than half of the run"},
          "Whether the error of attitude or configuration, momentum and carried vectors is estimated, for a "
          "method that is not exact, from two further motions with longer steps.",
          "true");

 private:
  static Words formats_of(System const& system);
  static std::string meaning_of_formats(System const& system);
};

/// [output] of snapshots, but for their times.
struct SnapshotKeys : KeyTable {
  SnapshotKind const& kind;  ///< of the system
  Key<Words> snapshots =
      key("snapshots", columns_of(kind), LeftOut{"no snapshots"},
          "What the files snapshots/000000.csv, 000001.csv, ... hold besides " + kind.always +
              ", which is what [] asks for; snapshots/times.csv has their times. " +
              meaning_of_columns(kind) + ".",
          as_written(Words{kind.columns.front().name}));

 private:
  static Pattern<Words> columns_of(SnapshotKind const& kind);
  static std::string meaning_of_columns(SnapshotKind const& kind);
};

/// The records of those of [scene], [system], [method], [run] and [output]; what a system has of its own is
/// not among them.
std::vector<Parameter> common_keys(System const& system);

}  // namespace actio::scene
