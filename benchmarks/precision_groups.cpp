// Work and precision on five more groups: a quadratic Lagrangian of one's own on a level of its momentum,
// beside GSL and odeint on the same equations, written out by the structure constants.
#include "actio/any_group/level_integrator.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "own_precision.hpp"

using namespace actio;

namespace {

/// Momentum and configuration of a left-invariant system with \f$l = \tfrac12\sum_aI_av_a^2\f$, whose group
/// has n dimensions and matrices of s rows.
template <int n, int s>
struct OnGroup {
  systems::MatrixAlgebra algebra;
  std::array<double, n> inertia, velocity;
  using Constant = systems::MatrixAlgebra::Constant;
  std::vector<Constant> constants = {};  // a < b, c

  explicit OnGroup(std::string const& name) : algebra(systems::named_algebra(name)) {
    if (algebra.dimension != n || algebra.size != s) throw std::logic_error(name + ": of another size");
    for (auto const& c : algebra.constants)
      if (c.a < c.b) constants.push_back(c);
    for (int a = 0; a < n; ++a) {
      inertia[a] = 1 + 0.3 * a;
      velocity[a] = 0.7 * std::cos(1.0 + 2.0 * a) / std::sqrt(n);
    }
  }
  /// \f$\dot\Pi = \mathrm{ad}^*_v\Pi\f$ and \f$\dot g = g\,\hat v\f$.
  template <class In, class Out>
  void operator()(In const& y, Out& out) const {
    using S = std::decay_t<decltype(y[0] + y[0])>;
    S v[n];
    for (int a = 0; a < n; ++a) v[a] = y[a] / S(inertia[a]), out[a] = S(0);
    for (auto const& c : constants) {
      S const part = y[c.c] * S(c.value);
      out[c.b] += v[c.a] * part, out[c.a] -= v[c.b] * part;
    }
    for (int k = 0; k < s * s; ++k) out[n + k] = S(0);
    for (auto const& e : algebra.entries) {
      S const x = v[e.direction] * S(e.value);
      for (int i = 0; i < s; ++i) out[n + i * s + e.column] += y[n + i * s + e.row] * x;
    }
  }
  std::shared_ptr<systems::ReducedSystem const> system() const {
    std::string l;
    for (int a = 0; a < n; ++a)
      l += (a ? " + " : "") + std::to_string(inertia[a] / 2) + "*" + algebra.components[a] + "^2";
    return std::make_shared<systems::ReducedSystem const>(algebra, systems::Side::left, 0,
                                                          parse_formula(l, algebra.components));
  }
};

struct Found {
  double own[2] = {HUGE_VAL, HUGE_VAL}, other[2] = {HUGE_VAL, HUGE_VAL};  // seconds to 1e-9 and to 1e-12
  double apart = 0;                                                       // of the reference solution
};
constexpr double errors[2] = {1e-9, 1e-12};

template <int n, int s>
Found study(std::string const& name, double longest) {
  constexpr std::size_t all = n + s * s;
  OnGroup<n, s> const rate(name);
  auto const same = [](auto const& y) { return y; };
  benchmark::System<all, all, OnGroup<n, s>, decltype(same)> system{rate, same, {}, {}, 1};
  for (int a = 0; a < n; ++a) system.start[a] = rate.inertia[a] * rate.velocity[a];
  for (int i = 0; i < s; ++i) system.start[n + i * s + i] = 1;
  Found found;
  found.apart = system.find_reference();
  std::vector<double> const p(system.start.begin(), system.start.begin() + n),
      v(rate.velocity.begin(), rate.velocity.end());
  auto const own = benchmark::own_way(
      system, "momentum level, order 8",
      [&](double h) {
        auto motion =
            std::make_shared<systems::LevelIntegrator>(rate.system(), h, systems::ReducedPoint{p, {}}, v);
        motion->follow_configuration(Eigen::MatrixXd::Identity(s, s));
        return [motion](bool) {
          motion->step();
          std::array<double, all> out;
          std::copy_n(motion->point().momentum.begin(), n, out.begin());
          for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j) out[n + i * s + j] = motion->configuration()(i, j);
          return out;
        };
      },
      2, 1.1);
  auto const keep = [&](benchmark::Way const& way, double(&best)[2]) {
    auto const line = benchmark::runs_of(way, longest);
    for (int k = 0; k < 2; ++k)
      if (auto const* const run = line.cheapest(errors[k])) best[k] = std::min(best[k], run->seconds);
  };
  keep(own, found.own);
  for (auto const& other : system.others())
    if (other.name != "Runge-Kutta, order 4") keep(other, found.other);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  gsl_set_error_handler_off();
  benchmark::Benchmark program(
      argc, argv,
      "work and precision on five more groups: a Lagrangian of one's own beside codes "
      "for differential equations");
  double const longest = program.length(0.03, 0.003);
  std::vector<std::pair<std::string, Found>> const all{{"SL(2)", study<3, 2>("SL(2)", longest)},
                                                       {"Heisenberg", study<3, 3>("Heisenberg", longest)},
                                                       {"SE(2) x R^1", study<4, 5>("SE(2) x R^1", longest)},
                                                       {"SU(3)", study<8, 6>("SU(3)", longest)},
                                                       {"Sp(4)", study<10, 4>("Sp(4)", longest)}};
  std::vector<book::Program::Row> rows;
  double worst = 0, apart = 0;
  for (auto const& [name, found] : all) {
    book::Program::Row row{name};
    for (int k = 0; k < 2; ++k)
      for (double const x : {1e6 * found.own[k], 1e6 * found.other[k], found.own[k] / found.other[k]})
        row.push_back(std::isfinite(x) ? book::number(x) : "-");
    rows.push_back(row);
    worst = std::max(worst, found.own[0] / found.other[0]), apart = std::max(apart, found.apart);
  }
  program.table("groups",
                {"group", "ours to 1e-9", "the others", "ratio", "ours to 1e-12", "the others", "ratio"},
                rows,
                "Microseconds to t = 5 on a level of the momentum, set-up and differentiation of the formula "
                "included, and of the best of GSL and odeint, whose equations are written out.");
  program.figure("worst", worst,
                 "times as long on a level of the momentum, to 1e-9, the largest of the groups");
  program.figure("apart", apart, "the reference solutions against themselves in half as many steps");
  program.claim(apart <= 64 * std::numeric_limits<double>::epsilon(),
                "the reference solutions are good to rounding");
  program.claim(std::isfinite(worst), "all reach 1e-9 on every group");
  program.headline("to 1e-9 a Lagrangian of one's own takes at most " + book::number(worst) +
                       " times as long as the best of GSL and odeint on five more groups",
                   worst);
  return program.finish();
}
