// The laws themselves over numbers whose arithmetic is chosen when the program runs; the groups are in the
// files beside this one.
#include "laws_of_the_groups.hpp"

namespace actio::laws {

template std::vector<Finding> check_any<Number>(AnyGroup<Number> const&, std::uint64_t,
                                                std::vector<Edge<Number>> const&);

}  // namespace actio::laws
