// What the methods of scenes have in common: a name, an order and a step, each with its default.
#pragma once

#include "actio/numbers/errors.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A method and an order, as a scene writes them: "4", "exact".
struct MethodChoice {
  std::string name,  ///< of the method
      order;         ///< a number, or "exact"

  /// The order as a number; zero for an exact method.
  int number() const { return order == "exact" ? 0 : std::stoi(order); }
};

/// `name` and `order` of [method]; written back where they are left out: the first of the methods, and the
/// order that is first among those of it.
/// @param known  of the system; the orders of each in the order of preference for a default
/// @throws SceneError  where no such method is, or not of that order, with what there is
MethodChoice read_method(SceneTable method, std::vector<Method> const& known);

/// `step` of [method]; written back where it is left out: the longest that divides the times of the rows and
/// turns the body by at most so much.
/// @param fastest  bound of the angular velocity, 1/time; zero for a body at rest
/// @param turn     of the body in a step, radians
/// @throws SceneError  where it is not positive
double read_step(SceneTable method, Schedule const& schedule, double fastest, double turn = 0.05);

/// A step that the scheme cannot make, told where it was read, with the longest that would do, and the
/// longest of those that rows allow.
/// @param what  is wrong with it; left out: what the error says
[[noreturn]] void fail_for_long_step(SceneTable const& method, Schedule const& schedule,
                                     StepTooLong const& error, std::string what = "");

}  // namespace actio::scene
