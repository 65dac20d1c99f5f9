#include "actio/rods/rod_ends.hpp"

#include "actio/numbers/errors.hpp"

namespace actio::rods {

void RodLoads::examine(bool closed) const {
  for (auto const* const at : {&start, &end}) {
    std::string const name = at == &start ? "start" : "end";
    if (closed && (at->held != RodEnd::Held::free || at->force || at->moment))
      throw OutsideDomain(
          "rod", "a ring has no ends; at its " + name + " there are loads or supports, number", 1, 0);
    if (at->force && at->held != RodEnd::Held::free)
      throw OutsideDomain("rod", "the place of the " + name + " is given, and no force acts there; forces", 1,
                          0);
    if (at->moment && at->held == RodEnd::Held::clamped)
      throw OutsideDomain(
          "rod", "the attitude of the " + name + " is given, and no moment acts there; moments", 1, 0);
  }
}

}  // namespace actio::rods
