#include "actio/nonholonomic/velocity_constraints.hpp"

namespace actio::systems {
namespace {

/// The derivatives of a constraint in the velocity, which it must not occur in.
Tape row_of(Tape const& constraint, int number, int dimension) {
  std::string const where = "velocity constraint " + std::to_string(number);
  std::vector<int> velocity(static_cast<std::size_t>(dimension));
  for (int i = 0; i < dimension; ++i) velocity[static_cast<std::size_t>(i)] = i;
  Tape row = with_gradient(constraint, velocity);
  row.outputs.erase(row.outputs.begin());
  row = joined({row});  // without what the value alone needs
  int present = 0, left = 0;
  for (int i = 0; i < dimension; ++i) {
    auto const place = row.outputs[static_cast<std::size_t>(i)];
    present += !(row.is_constant(i) && row.constants[place] == 0);
    left += row.depends_on(i);
  }
  if (left > 0)
    throw OutsideDomain(
        where, "it must be linear in the velocity as it is written; components left in its row", left, 0);
  if (present == 0) throw OutsideDomain(where, "the velocity must occur in it; components that do", 0, 1);
  return row;
}

}  // namespace

VelocityConstraints::VelocityConstraints(ReducedSystem const& system, std::vector<Tape> const& each)
    : dimension(system.dimension()), carried(system.carried()), count(static_cast<int>(each.size())) {
  constexpr char const* where = "velocity constraints";
  if (count == 0) throw OutsideDomain(where, "at least one is needed; constraints", 0, 1);
  if (count >= dimension)
    throw OutsideDomain(
        where, "fewer than the dimension of the group are needed, for a motion to be left; constraints",
        count, dimension - 1);
  std::vector<Tape> all_rows;
  int const inputs = dimension + carried + 1;
  for (int k = 0; k < count; ++k) {
    Tape const& one = each[static_cast<std::size_t>(k)];
    if (one.inputs != inputs)
      throw OutsideDomain(where, "the inputs are velocity, vectors and time; inputs", one.inputs, inputs);
    all_rows.push_back(row_of(one, k + 1, dimension));
  }
  values = joined(each), rows = joined(all_rows);
}

}  // namespace actio::systems
