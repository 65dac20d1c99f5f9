#include "actio/fast_body/any_dimension/natural_chart_n.hpp"

namespace actio::bodies {

FastNaturalChart::FastNaturalChart(Inertia<Eigen::Dynamic> inertia, double step, Machine machine)
    : inertia_(std::move(inertia)),
      step_(checked(step)),
      unit_(unit(inertia_)),
      algebra_(inertia_.group.n, machine),
      equation_(inertia_, unit_, algebra_),
      p_(algebra_.size()),
      z_(algebra_.size()),
      e_(algebra_.size()),
      room_(algebra_.size()),
      product_(algebra_.size()) {}

ChartedBody FastNaturalChart::release(Rotation const& g, BodyMomentum const& pi) const {
  detail::require_rotation(g.value, inertia_.group.n, "natural chart: attitude");
  if (pi.components.size() != inertia_.moments.size())
    throw OutsideDomain(
        "natural chart", "a momentum with a component for each moment of inertia is needed; components",
        static_cast<double>(pi.components.size()), static_cast<double>(inertia_.moments.size()));
  if (!is_finite(pi.components)) throw NotFinite("natural chart: body momentum");
  ChartedBody body(inertia_.group.n);
  body.set(ChartedBody::attitude_, g.value);
  body.set(ChartedBody::momentum_, inertia_.group.hat(pi.components));
  return body;
}

FastNaturalChart::Rotation FastNaturalChart::last_relative_motion(ChartedBody& body) {
  Rotation f = identity<double>(inertia_.group);
  if (body.past_ == 0) return f;
  equation_.subgroup().relative_motion(body.past(0), e_.data());
  for (int j = 0; j < body.size(); ++j)
    for (int i = 0; i < body.size(); ++i)
      f.value(i, j) += e_.data()[detail::full_entry(algebra_.shape(), i, j)];
  return f;
}

void FastNaturalChart::advance(ChartedBody& body, bool with_attitude) {
  if (body.size() != inertia_.group.n)
    throw OutsideDomain("natural chart",
                        "a body in as many dimensions as there are Lambda is needed; dimensions", body.size(),
                        inertia_.group.n);
  if (body.step_ != step_) body.past_ = 0, body.contraction_ = 1, body.step_ = step_;
  std::copy(body.array(ChartedBody::momentum_), body.array(ChartedBody::momentum_rest_), p_.data());
  algebra_.scale(1 / unit_, p_.data()), algebra_.scale(step_, p_.data());
  if (!is_finite(algebra_.norm(p_.data())))
    throw NotFinite("natural chart: step times body momentum over inertia");
  solve(body);
  equation_.subgroup().relative_motion(z_.data(), e_.data());
  transport_momentum(body);
  if (with_attitude) {
    double* const attitude = body.array(ChartedBody::attitude_);
    algebra_.times_transposed(attitude, e_.data(), product_.data());
    detail::turn(algebra_.shape(), attitude, body.array(ChartedBody::attitude_rest_), product_.data());
  }
  remember(body);
}

void FastNaturalChart::solve(ChartedBody& body) {
  guess(body);
  if (equation_.by_sweeps(p_.data(), z_.data(), body.contraction_, slowest()) &&
      equation_.in_chart(z_.data())) {
    body.contraction_ = equation_.contraction(), body.sweeps_ = equation_.sweeps();
    return;
  }
  body.contraction_ = 1, body.sweeps_ = 0;
  if (inertia_.group.n <= largest_for_newton) {
    double const reached = detail::StepContinuation(equation_, p_.data()).follow(z_.data());
    if (reached < 1)
      throw StepTooLong("natural chart", std::abs(step_), std::abs(step_) * reached * (1 - 1e-6));
  } else {
    by_sweeps_from_rest();
  }
}

void FastNaturalChart::by_sweeps_from_rest() {
  if (takes(1)) return;
  // Between a part that is taken and one that is not.
  equation_.guess(p_.data(), z_.data());
  double taken = 0, refused = std::min(1.0, 0.5 / algebra_.norm(z_.data()));
  while (refused < 1 && takes(refused)) taken = refused, refused = std::min(1.0, 2 * refused);
  for (int k = 0; k < halvings(); ++k) {
    double const middle = (taken + refused) / 2;
    (takes(middle) ? taken : refused) = middle;
  }
  // A little less, where rounding cannot decide.
  throw StepTooLong("natural chart", std::abs(step_), std::abs(step_) * taken * 0.98);
}

bool FastNaturalChart::takes(double part) {
  std::copy(p_.data(), p_.data() + algebra_.size(), room_.data());
  algebra_.scale(part, room_.data());
  equation_.guess(room_.data(), z_.data());
  return equation_.by_sweeps(room_.data(), z_.data(), 1, slowest()) && equation_.in_chart(z_.data());
}

void FastNaturalChart::guess(ChartedBody& body) {
  if (body.past_ == 0) return equation_.guess(p_.data(), z_.data());
  detail::Weights const& w = detail::all_extrapolations()[body.continuation_];
  std::fill(z_.data(), z_.data() + algebra_.size(), 0.0);
  for (int k = 0; k < w.length; ++k)
    algebra_.add(w.weight[static_cast<std::size_t>(k)], body.past(k), z_.data());
}

void FastNaturalChart::transport_momentum(ChartedBody& body) {
  double *const m = body.array(ChartedBody::momentum_), *const e = e_.data(), *const em = room_.data(),
                *const eme = product_.data();
  // -e M0, and -e M0 e^T.
  algebra_.times_transposed(e, m, em);
  algebra_.times_transposed(em, e, eme);
  algebra_.subtract_transposed(em), algebra_.make_skew(eme);
  algebra_.add(1, eme, em), algebra_.scale(-1, em);
  detail::turn(algebra_.shape(), m, body.array(ChartedBody::momentum_rest_), em);
}

void FastNaturalChart::remember(ChartedBody& body) {
  body.latest_ = body.latest_ == 0 ? ChartedBody::longest - 1 : body.latest_ - 1;
  std::copy(z_.data(), z_.data() + algebra_.size(), body.past(0));
  ++body.steps_;
  bool const growing = body.past_ < ChartedBody::longest;
  if (growing) ++body.past_;
  if (growing || body.steps_ % 256 == 0) choose_extrapolation(body);
}

void FastNaturalChart::choose_extrapolation(ChartedBody& body) {
  std::vector<double> missed;
  double best = HUGE_VAL;
  for (detail::Weights const& w : detail::all_extrapolations()) {
    if (w.length >= body.past_) break;
    std::copy(body.past(0), body.past(0) + algebra_.size(), room_.data());
    for (int k = 0; k < w.length; ++k)
      algebra_.add(-w.weight[static_cast<std::size_t>(k)], body.past(k + 1), room_.data());
    missed.push_back(algebra_.norm(room_.data()));
    best = std::min(best, missed.back());
  }
  body.continuation_ = 0;
  while (body.continuation_ < missed.size() && missed[body.continuation_] > 2 * best) ++body.continuation_;
  if (missed.empty()) body.continuation_ = 0;
}

}  // namespace actio::bodies
