#include "actio/media_on_meshes/body_start.hpp"

namespace actio::media {

BodyCellInverts::BodyCellInverts(int which, std::string const& name, double jacobian, Step const& tried)
    : OutsideDomain(where(name, tried), "the Jacobian at its corners must be positive", jacobian, 0),
      cell(which),
      step(tried.number),
      time_step(tried.length),
      would_do(tried.shorter),
      largest_step(tried.longest) {}

std::string BodyCellInverts::where(std::string const& name, Step const& tried) {
  if (tried.number == 0) return "medium: " + name + " is inside out at the start";
  return "medium: step " + std::to_string(tried.number) + " of length " + show(tried.length) +
         " would turn " + name + " inside out, whose Jacobian is " + show(tried.before) + " before it (" +
         (tried.shorter > 0 ? "a step of " + show(tried.shorter) + " would not"
                            : "and so would any shorter one") +
         "; the longest stable step before it is " + show(tried.longest) + ")";
}

BodyStepUnsolved::BodyStepUnsolved(std::size_t rounds, double off, double allowed, int which,
                                   std::string const& name, BodyCellInverts::Step const& tried)
    : Error("medium: step " + std::to_string(tried.number) + " of length " + show(tried.length) +
            " that conserves energy was not found: after " + std::to_string(rounds) +
            " rounds of its iteration " +
            (off - off == 0
                 ? "positions are still off by " + show(off) + ", where " + show(allowed) + " is asked for"
                 : std::string("forces are no numbers")) +
            "; the least Jacobian before it is " + show(tried.before) + ", that of " + name + " (" +
            (tried.shorter > 0 ? "a step of " + show(tried.shorter) + " is found"
                               : "nor is a step of a thousandth of it") +
            "; the longest stable step before it is " + show(tried.longest) + ")"),
      residual(off),
      bound(allowed),
      cell(which),
      jacobian(tried.before),
      would_do(tried.shorter) {}

void BodyStepping::examine() const {
  if (!is_finite(step)) throw NotFinite("medium: time step");
  if (!(step > 0)) throw OutsideDomain("medium", "a positive time step is needed", step, 0);
  if (order != 2 && order != 4)
    throw OutsideDomain("medium", "the order of a step is 2 or 4", order, order < 3 ? 2 : 4);
  if (viscosity.any() && (order != 2 || conserve != Conserve::form))
    throw OutsideDomain("medium", "viscosity has steps of order 2 that keep the form without it; order",
                        order, 2);
}

}  // namespace actio::media
