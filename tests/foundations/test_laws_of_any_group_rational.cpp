// The laws themselves at one scalar; the groups are in the files beside this one.
#include "laws_of_the_groups.hpp"

namespace actio::laws {

template std::vector<Finding> check_any<rational>(AnyGroup<rational> const&, std::uint64_t, std::vector<Edge<rational>> const&);

}  // namespace actio::laws
