// What the installed library has compiled: an algebra by its name, and a formula.
#include <actio/any_group/named_algebra.hpp>
#include <actio/formula/parse_formula.hpp>

#include <cstdio>
using namespace actio;
using namespace actio::systems;

int main() {
  int const dimension = static_cast<int>(named_algebra("SE(3)").basis.size());
  Tape const energy = parse_formula("(w^2 + 6*v^2)/2", {"w", "v"});
  double const motion[] = {2, 1};
  double value = 0;
  std::vector<double> work;
  energy(motion, &value, work);
  std::printf("SE(3) has dimension %d, the energy is %g\n", dimension, value);
  return dimension == 6 && value == 5 ? 0 : 1;
}
