#include "actio/linear_algebra/compiled_doubles.hpp"

namespace actio::detail {

#define ACTIO_TEMPLATE template
ACTIO_COMPILED_DOUBLES

}  // namespace actio::detail
