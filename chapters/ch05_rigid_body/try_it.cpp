// Lines to try with rigid bodies: moments, a step, a step that is too long, half turns, integrals, a top.
//
// What is shown. Nine snippets of a few lines each, which the pages of chapter 5 show beside the notions.
// Read first. Chapter 5.
//
//   book   the inertia of the running example      Pi   body momentum, J s
//   Omega  body velocity, rad/s                    f    relative motion g1^T g0 of a step
#include <random>

#include "actio/fast_body/space/free_steps.hpp"
#include "actio/numbers/print.hpp"
#include "actio/rigid_body/heavy_top.hpp"
#include "actio/rigid_body/isospectral.hpp"
#include "book/try_it.hpp"
#include "running_examples.hpp"

using namespace actio;
using namespace actio::bodies;

TRY_IT(moments_of_the_book) {
  auto const book = inertia_from_moments<double>(book_inertia);
  // It turns about its middle axis, at two turns a second.
  auto const Omega = velocity(SO<3>{}, Vector<double, 3>(0.3, 12.5, 0));
  print("moments of inertia", book.moments);
  print("second moments Lambda", book.lambda);
  print("body momentum", body_momentum(book, Omega));
  print("(5.1)", kinetic_energy(book, Omega));
  print("the Lagrangian of the running example", thrown_book()(Omega));
  try {
    inertia_from_moments(1, 1, 2.1);
  } catch (UnphysicalInertia const& e) {
    print(e.what());
  }
}

TRY_IT(one_step) {
  MoserVeselov<3> const scheme(inertia_from_moments<double>(book_inertia), 0.05);
  auto const Omega = velocity(SO<3>{}, Vector<double, 3>(0.3, 12.5, 0));
  auto const Pi = body_momentum(scheme.inertia(), Omega);
  auto const f10 = scheme.relative_motion(Pi).value;  // solves f^T Lambda - Lambda f = h Pi
  auto const f21 = scheme.step_euler_poincare(f10).value;
  auto const Pi1 = scheme.momentum_before(f21);
  print("residual of (5.7)", scheme.residual(f10, f21));
  print("momentum at the end of the second step", scheme.momentum_after(f21));
  print("the same by (5.8)", MoserVeselov<3>::transport(f21, Pi1));
  print("with the step before, as (5.9) is printed", MoserVeselov<3>::transport(f10, Pi1));
}

TRY_IT(too_long_a_step) {
  auto const book = inertia_from_moments<double>(book_inertia);
  auto const Pi = body_momentum(book, velocity(SO<3>{}, Vector<double, 3>(0, 12.5, 0)));
  double const longest = MoserVeselov<3>(book, 0.01).longest_step(Pi);
  print("angle of the longest step, radians of the true motion", 12.5 * longest);
  auto const f = [&](double part) { return MoserVeselov<3>(book, part * longest).relative_motion(Pi).value; };
  print("cosine of the angle that the scheme makes of 0.9999 of it", f(0.9999).value(0, 0));
  try {
    f(1.001);
  } catch (StepTooLong const& e) {
    print(e.what());
  }
}

TRY_IT(half_turn_against_newton) {
  auto const book = inertia_from_moments<double>(book_inertia);
  auto const Pi = body_momentum(book, velocity(SO<3>{}, Vector<double, 3>(0.3, 12.5, 0)));
  FreeBody const body(book, Pi);
  FreeSteps half_turns(body, 0.05, body.moser_veselov_parameters(0.05, 2));  // no iteration
  half_turns.advance();
  print("as a half turn", half_turns.state().body_momentum);
  print("by Newton's method", MoserVeselov<3>(book, 0.05).step_lie_poisson(Pi));
}

TRY_IT(one_step_anywhere) {
  auto const book = inertia_from_moments<double>(book_inertia);
  auto const Pi = body_momentum(book, velocity(SO<3>{}, Vector<double, 3>(0.3, 12.5, 0)));
  FreeBody const body(book, Pi);
  FreeSteps fine(body, 0.01), coarse(body, 0.25);
  FreeSteps moser_veselov(body, 0.01, body.moser_veselov_parameters(0.01, 2));
  fine.advance(100), coarse.advance(4), moser_veselov.advance(100);
  print("one evaluation at t = 1 s", body.at(1.0).body_momentum);
  print("a hundred exact steps", fine.state().body_momentum);
  print("four exact steps of three radians", coarse.state().body_momentum);
  print("a hundred steps of Moser and Veselov", moser_veselov.state().body_momentum);
}

TRY_IT(never_below_one_radian) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  double least = 10;
  for (int trial = 0; trial < 300; ++trial) {
    Vector<double, 4> Lambda(0, uniform(random), uniform(random), uniform(random));  // flat
    Vector<double, 6> xi;
    for (double& x : xi) x = 2 * uniform(random) - 1;
    auto const body = inertia_from_lambda<4, double>(Lambda);
    auto const velocity_of_body = velocity(SO<4>{}, xi);
    least = std::min(least, xi.norm() * largest_step(body, body_momentum(body, velocity_of_body)));
  }
  print("least h_max |xi| among 300 flat bodies in four dimensions", least);
}

TRY_IT(integrals_in_four_dimensions) {
  // A flat body: Lambda_1 = 0.
  auto const body = inertia_from_lambda<4, double>(Vector<double, 4>(0, 1, 2, 3));
  MoserVeselov<4> const scheme(body, 0.2);
  Momentum<SO<4>, double> const M{{}, Vector<double, 6>(0.5, 0.3, -0.4, 0.2, 0.7, -0.1)};
  auto const after = scheme.step_lie_poisson(M);
  Matrix<double> const Lambda = body.lambda.asDiagonal();
  print("integrals before", isospectral_integrals(Lambda, M));
  print("          after", isospectral_integrals(Lambda, after));
  print("energy before", kinetic_energy(body, M));
  print("       after", kinetic_energy(body, after));
  print("longest step", scheme.longest_step(M));
}

TRY_IT(a_top_and_its_casimirs) {
  auto const [top, spin] = bruls_cardona_top<double>();
  HeavyTopScheme<> const scheme(top, 1e-3);
  auto state = release(top, identity<double>(SO<3>{}), spin);
  auto const shown = [&] {
    double const about_the_vertical = state.momentum.components.dot(state.vector);
    return Vector<double, 3>(about_the_vertical, state.vector.norm(), top.energy(state));
  };
  print("Pi.Gamma, |Gamma|, energy", shown());
  for (int k = 0; k < 1000; ++k) scheme.advance(state);
  print("after one second", shown());
}

TRY_IT(symmetric_or_not) {
  Vector<double, 3> const centre(0, 0, 0.1), gravity(0, 0, -9.81);
  for (double const second : {0.02, 0.024}) {
    auto const inertia = inertia_from_moments(0.02, second, 0.005);  // about the fixed point
    auto const top = heavy_top<double>(0.5, inertia, centre, gravity);
    auto state = release(top, exp(velocity(SO<3>{}, Vector<double, 3>(0.5, 0, 0))),
                         velocity(SO<3>{}, Vector<double, 3>(0, 0, 30)));
    HeavyTopScheme<> const scheme(top, 1e-3);
    double const before = state.momentum.components[2];
    for (int k = 0; k < 2000; ++k) scheme.advance(state);
    print("change of Pi_3 in two seconds", state.momentum.components[2] - before);
  }
}

TRY_IT_MAIN("the lines to try of chapter 5")
