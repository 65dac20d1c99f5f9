#include "actio/fast_body/space/torqued_batch.hpp"

namespace actio::bodies {

namespace detail {

void drift_apart(TorquedLanes const& c, double part, Three<Pack<4>>& p, Four<Pack<4>>& q) {
  for (int l = 0; l < 4; ++l) {
    InverseMoments<double> body;
    for (int i = 0; i < 3; ++i) body.J[i] = c.body.J[i][l];
    body.d12 = c.body.d12[l], body.d23 = c.body.d23[l], body.d13 = c.body.d13[l];
    TorquedState state{lane_of(p, l), lane_of(q, l)};
    if (!is_finite(dot(state.p, state.p))) continue;
    int terms = 8;
    state = drift(body, scaled(body, part), part, state, terms);
    set_lane(p, l, state.p), set_lane(q, l, state.q);
  }
}

}  // namespace detail

TorquedBatch::TorquedBatch(double h, Splitting method, Machine machine)
    : h_(h), method_(std::move(method)), machine_(machine) {
  if (!is_finite(h)) throw NotFinite("batch: step");
  if (h == 0) throw OutsideDomain("batch", "the step must differ from zero", 0, 0);
  if (method_.drifts.empty() || method_.kicks.size() != method_.drifts.size() + 1)
    throw OutsideDomain("batch", "one kick more than drifts is needed; kicks",
                        static_cast<double>(method_.kicks.size()),
                        static_cast<double>(method_.drifts.size() + 1));
}

TorquedBatch::TorquedBatch(std::vector<Inertia<3>> const& inertias,
                           std::vector<Momentum<SO<3>, double>> const& momenta,
                           std::vector<Element<SU2, double>> const& attitudes,
                           std::vector<GravityGradient> const& torques, double h, Splitting method,
                           Machine machine)
    : TorquedBatch(h, std::move(method), machine) {
  for (std::size_t const size : {momenta.size(), attitudes.size(), torques.size()})
    if (size != inertias.size())
      throw OutsideDomain(
          "batch", "as many momenta, attitudes and torques as bodies are needed; the length that is off",
          static_cast<double>(size), static_cast<double>(inertias.size()));
  for (std::size_t i = 0; i < inertias.size(); ++i) try {
      add(inertias[i], momenta[i], attitudes[i], torques[i]);
    } catch (BodyRefused const& why) {
      refused_.push_back(why);
      leave_out();
    }
}

std::size_t TorquedBatch::add(Inertia<3> const& inertia, Momentum<SO<3>, double> const& momentum,
                              Element<SU2, double> const& attitude, GravityGradient const& torque) {
  try {
    detail::TorquedFrame const frame(inertia, h_);
    auto const state = frame.enter(momentum, attitude);
    GravityGradient const turned = torque.in(frame.axes());
    Three<double> coefficients = turned.coefficients();
    for (double& c : coefficients) c *= frame.kick();
    if (!std::isfinite(dot(coefficients, coefficients) + dot(turned.towards, turned.towards) +
                       dot(turned.ahead, turned.ahead) + turned.rate * h_))
      throw NotFinite("torqued body: torque");
    leave_out();
    put(frame, state, turned, coefficients);
  } catch (Error const& error) {
    throw BodyRefused(size(), error.what());
  }
  return size() - 1;
}

void TorquedBatch::step(long count) {
  if (count < 0)
    throw OutsideDomain("batch", "the number of steps must not be negative", static_cast<double>(count), 0);
  if (count == 0) return;
  for (auto& lanes : lanes_) lanes.orbits ? run<true>(lanes, count) : run<false>(lanes, count);
  steps_ += count;
  for (std::size_t i = 0; i < size(); ++i) {
    auto const p = detail::lane_of(lanes_[i / 4].p, static_cast<int>(i % 4));
    if (std::isfinite(dot(p, p))) continue;
    refused_.emplace_back(i, "torqued body: the momentum has become no number");
    empty(i);
  }
}

FreeState TorquedBatch::state(std::size_t i) const {
  if (i >= size())
    throw OutsideDomain("batch", "no such body; index", static_cast<double>(i), static_cast<double>(size()));
  if (!frames_[i])
    for (auto const& why : refused_)
      if (why.index == i) throw why;
  int const l = static_cast<int>(i % 4);
  return frames_[i]->leave({detail::lane_of(lanes_[i / 4].p, l), detail::lane_of(lanes_[i / 4].q, l)});
}

void TorquedBatch::empty(std::size_t i) {
  auto& lanes = lanes_[i / 4];
  int const l = static_cast<int>(i % 4);
  frames_[i] = nullptr;
  detail::set_lane<3>(lanes.p, l, {0, 0, 0}), detail::set_lane<4>(lanes.q, l, {1, 0, 0, 0}),
      detail::set_lane<3>(lanes.body.J, l, {1, 1, 1});
  lanes.body.d12.set(l, 0), lanes.body.d23.set(l, 0), lanes.body.d13.set(l, 0);
  detail::set_lane<3>(lanes.coefficients, l, {0, 0, 0}), detail::set_lane<3>(lanes.towards, l, {1, 0, 0}),
      detail::set_lane<3>(lanes.ahead, l, {0, 1, 0});
  lanes.rate.set(l, 0), lanes.cosine.set(l, 1), lanes.sine.set(l, 0);
}

void TorquedBatch::leave_out() {
  std::size_t const i = size();
  bool const opens = i % 4 == 0;
  if (opens) lanes_.emplace_back();
  frames_.resize(opens ? i + 4 : i + 1);
  for (std::size_t k = i; opens && k < i + 4; ++k) empty(k);
  frames_.resize(i + 1);
}

void TorquedBatch::put(detail::TorquedFrame const& frame, detail::TorquedState const& state,
                       GravityGradient const& torque, Three<double> const& coefficients) {
  std::size_t const i = size() - 1;
  auto& lanes = lanes_[i / 4];
  int const l = static_cast<int>(i % 4);
  frames_[i] = std::make_shared<detail::TorquedFrame const>(frame);
  auto const& body = frame.body();
  detail::set_lane(lanes.p, l, state.p), detail::set_lane(lanes.q, l, state.q),
      detail::set_lane(lanes.body.J, l, body.J);
  lanes.body.d12.set(l, body.d12), lanes.body.d23.set(l, body.d23), lanes.body.d13.set(l, body.d13);
  detail::set_lane(lanes.coefficients, l, coefficients), detail::set_lane(lanes.towards, l, torque.towards),
      detail::set_lane(lanes.ahead, l, torque.ahead);
  lanes.rate.set(l, torque.rate * h_);
  lanes.orbits = lanes.orbits || torque.rate != 0;
}

}  // namespace actio::bodies
