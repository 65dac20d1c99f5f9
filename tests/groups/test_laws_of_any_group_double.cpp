// The laws themselves at one scalar; the groups are in the files beside this one.
#include "laws_of_the_groups.hpp"

namespace actio::laws {

template std::vector<Finding> check_any<double>(AnyGroup<double> const&, std::uint64_t,
                                                std::vector<Edge<double>> const&);

}  // namespace actio::laws
