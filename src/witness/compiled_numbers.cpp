// What all checks compute with, compiled at -O2: the sections are compiled at -Og, where a call stays a call.
// They gain a seventh of their time over the prime field, a sixth in double, little in 50 digits.
#include "witness/number.hpp"

#define ACTIO_TEMPLATE template
ACTIO_COMPILED_NUMBERS
