// Order and step by the error that a run may have: [run] accuracy.
//
// Pilots are motions of the scene over its whole time, with the steps of the estimate of its error
// (error_estimate.hpp), but longer ones than the run will have. The first are the longest whose error can be
// told. By the order p of the method, the error being that of a pilot times the power p of the ratio of the
// steps, the length follows with which it is a third of the accuracy: an estimate is within a factor of three
// of the error. A further pilot, with steps of at most four times that length, sees whether the order holds
// up to there. Of a method with two orders, "8,4", p is that of short steps, which overrates the error of
// those.
//
// Where the scene leaves the order open, the one is taken that needs the least work: steps times the work of
// one, which the system counts. No clock has a part, so that the choice is the same on every machine.
//
// Where the accuracy asks for steps that are much shorter than those whose error can be told, the last pilot,
// its companion and its control cost a third of the run, and those before it less.
#pragma once

#include "program/registry/pilot.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// [run], of systems whose error can be estimated.
struct AccuracyKeys : KeyTable {
  /// A number in (0, 0.1]: beyond a tenth no estimate tells an error.
  static Pattern<double> small_positive();

  Key<double> accuracy = key(
      "accuracy", small_positive(), LeftOut{"or method.step"},
      "The largest error that attitude or configuration, momentum, relative position and carried vectors "
      "may have until the end, in radians or relative to the largest modulus: step, and order where it is "
      "left out, are chosen by it, told, and written into the copy of the scene.",
      "1e-9");
  Key<double> chosen_for =
      key("chosen_for", small_positive(), LeftOut{"written into the copy of a scene with run.accuracy"},
          "The accuracy that order and step of the copy of a scene were chosen for, so that they are not "
          "chosen again.",
          "1e-9");
};
inline AccuracyKeys const accuracy_keys{{"run"}};  ///< its keys

/// The order of a method.
struct WrittenOrder {
  std::string written;  ///< as scenes write it: 4, or "8,4" where the order of short steps is the last one
  int power;            ///< of the step in the error, where steps are short

  /// @param text  a whole number, or several with commas
  explicit WrittenOrder(std::string text);
  /// That of [method].
  static WrittenOrder of(SceneTable const& method);
  /// Writes it into [method].
  void write(SceneTable& method) const;
};

/// What was chosen.
struct ChosenSteps {
  double accuracy;     ///< asked for
  std::string method;  ///< by its name
  std::optional<Pilot>
      pilot;  ///< the last one; none where the method needs none, or the copy of a scene told
  std::optional<WrittenOrder> order{};  ///< of the method; none: it has no error

  /// `accuracy 1e-09: galerkin of order 6 with steps of 0.0125, estimated error 4.0e-10 of the momentum at
  /// t = 10`
  std::string in_words(Simulation const& simulation) const;
};

/// Chooses order and step of a scene with `accuracy`, and writes them into it.
/// @return  none where the scene has no `accuracy`, or no pilots are made
/// @throws SceneError  where there is a step as well; where no step meets the accuracy, with the time until
///                     which one would
/// @throws Stopped
std::optional<ChosenSteps> choose_steps(System const& system, Request const& request, Pilots const& pilots);

}  // namespace actio::scene
