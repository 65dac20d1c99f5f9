#include "actio/any_group/reduced_system.hpp"

namespace actio::systems {

ReducedSystem::ReducedSystem(MatrixAlgebra of, Side invariant, int carried_vectors, Tape l, Chart of_steps)
    : algebra(std::move(of)),
      side(invariant),
      chart(of_steps),
      vectors(carried_vectors),
      lagrangian(std::move(l)) {
  if (lagrangian.inputs != dimension() + carried())
    throw OutsideDomain("ReducedSystem", "the inputs of the Lagrangian are velocity and vectors; inputs",
                        lagrangian.inputs, dimension() + carried());
  std::vector<int> all(static_cast<std::size_t>(lagrangian.inputs));
  for (int i = 0; i < lagrangian.inputs; ++i) all[static_cast<std::size_t>(i)] = i;
  slopes = with_gradient(lagrangian, all);
  all.resize(static_cast<std::size_t>(dimension()));
  curvature = with_hessian(lagrangian, all);
}

}  // namespace actio::systems
