#include "actio/any_group/tape_lagrangian.hpp"

namespace actio::systems {
namespace {

void require_numbers(std::vector<double> const& values) {
  for (double const x : values)
    if (!std::isfinite(x)) throw NotFinite("the Lagrangian or one of its derivatives");
}

}  // namespace

std::vector<double> const& HeldTape::values(Tape const& tape,
                                            Coordinates<SpanOfMatrices, double> const& v) const {
  thread_local std::vector<double> inputs, out, work;
  inputs.assign(v.data(), v.data() + v.size());
  inputs.insert(inputs.end(), held.data(), held.data() + held.size());
  out.resize(tape.outputs.size());
  tape(inputs.data(), out.data(), work);
  require_numbers(out);
  return out;
}

Momentum<SpanOfMatrices, double> gradient(HeldTape const& l, Velocity<SpanOfMatrices, double> const& v) {
  auto const& values = l.values(l.system.slopes, v.coordinates);
  Momentum<SpanOfMatrices, double> p{v.group, v.coordinates};
  std::copy_n(values.begin() + 1, p.components.size(), p.components.data());
  return p;
}

Matrix<double> hessian(HeldTape const& l, Velocity<SpanOfMatrices, double> const& v) {
  auto const& values = l.values(l.system.curvature, v.coordinates);
  Index const n = v.coordinates.size();
  Matrix<double> out(n, n);
  auto at = values.begin() + 1 + n;
  for (Index i = 0; i < n; ++i)
    for (Index j = i; j < n; ++j) out(i, j) = out(j, i) = *at++;
  return out;
}

Matrix<double, Dynamic, 1> slope_in_vector(TapeLagrangian const& l, Velocity<SpanOfMatrices, double> const& v,
                                           Matrix<double, Dynamic, 1> const& a) {
  auto slope = a;
  if (a.size() == 0) return slope;
  auto const& values = HeldTape{*l.system, a}.values(l.system->slopes, v.coordinates);
  std::copy_n(values.begin() + 1 + v.coordinates.size(), slope.size(), slope.data());
  return slope;
}

}  // namespace actio::systems
