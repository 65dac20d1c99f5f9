#include <Eigen/Core>

#include "program/systems/bodies/formula_torque.hpp"

#include <fmt/format.h>

#include "actio/formula/tape_derivatives.hpp"

namespace actio::scene {

FormulaTorque::FormulaTorque(SceneTable const& torque) {
  auto const& keys = formula_torque_keys;
  std::vector<std::string> names{"w1",  "w2",  "w3",  "r11", "r12", "r13", "r21",
                                 "r22", "r23", "r31", "r32", "r33", "t"};
  SharedNames shared(torque, names, {});
  HeldInputs inputs;
  if (keys.inputs.given(torque)) inputs = read_held_inputs(keys.inputs.table(torque), names, shared);
  names.insert(names.end(), inputs.names.begin(), inputs.names.end());
  auto const texts = torque.formulas("body");
  if (texts.size() != 3)
    keys.body.fail(torque,
                   fmt::format("three formulas are expected, one for each axis; found {}", texts.size()));
  std::vector<Tape> tapes;
  SharedNames::Names used;
  for (std::size_t i = 0; i < 3; ++i) {
    auto formula = shared.read(texts[i], names, torque.text_place("body", i), "body", for_values);
    used.merge(formula.used);
    tapes.push_back(std::move(formula.value));
  }
  if (!inputs.names.empty()) inputs.require_used(keys.inputs.table(torque), used, "torque");
  shared.require_used("torque");
  components_ = joined(tapes), held_ = std::move(inputs.values);
  inputs_.resize(names.size());
}

FormulaTorque FormulaTorque::with(std::optional<TorqueOfPotential> beside) const {
  FormulaTorque out = *this;
  out.beside_ = std::move(beside);
  return out;
}

void FormulaTorque::set_inputs(bodies::Four<double> const& q, double time, bodies::Three<double> const& w,
                               double middle) const {
  auto next = std::copy(w.begin(), w.end(), inputs_.begin());
  bodies::NineEntries const rotation = bodies::rotation_entries(q);
  next = std::copy(rotation.begin(), rotation.end(), next);
  *next++ = time;
  for (auto const& input : held_) *next++ = input(middle);
}

bodies::Three<double> FormulaTorque::operator()(bodies::Four<double> const& q, double time,
                                                bodies::Three<double> const& w, double middle) const {
  set_inputs(q, time, w, middle);
  double own[3];
  components_(inputs_.data(), own, work_);
  bodies::Three<double> sum{own[0], own[1], own[2]};
  if (!beside_) return sum;
  auto const other = std::visit([&](auto const& torque) { return torque(q, time); }, *beside_);
  for (std::size_t i = 0; i < 3; ++i) sum[i] += other[i];
  return sum;
}

Eigen::Matrix3d FormulaTorque::slope(bodies::Four<double> const& q, double time,
                                     bodies::Three<double> const& w) const {
  using D = Dual<double, 3>;
  set_inputs(q, time, w, time);
  std::vector<D> inputs(inputs_.begin(), inputs_.end()), work;
  for (std::size_t k = 0; k < 3; ++k) inputs[k].part[k] = 1;
  D own[3];
  components_(inputs.data(), own, work);
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) out(i, k) = own[i].part[static_cast<std::size_t>(k)];
  return out;
}

}  // namespace actio::scene
