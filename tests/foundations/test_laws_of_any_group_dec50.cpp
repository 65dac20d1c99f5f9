// The laws themselves at one scalar; the groups are in the files beside this one.
#include "laws_of_the_groups.hpp"

namespace actio::laws {

template std::vector<Finding> check_any<dec50>(AnyGroup<dec50> const&, std::uint64_t, std::vector<Edge<dec50>> const&);

}  // namespace actio::laws
