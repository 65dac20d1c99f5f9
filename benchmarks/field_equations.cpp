// What the field equations of an elastic medium in space cost at a point, in hand-written ones: St Venant and
// Kirchhoff's solid, Euclidean metrics, homogeneous.
//
// Two things are measured. From given second jets of a section: the equation alone. And with the section
// evaluated too: its second jet by truncated polynomials from a callable, beside one that is differentiated
// by hand. All contestants run in turns over the same 250 points, to a million evaluations each in a full
// run. How many hand-written equations one costs is judged by the instructions that valgrind counts, since
// the ratio of the times depends on the processor; the times stand beside them. Started with the word
// `--count` the program goes over the points once with each contestant and does no more, for valgrind to
// count.
#include <array>

#include "actio/continuum/materials.hpp"
#include "actio/jets/field_equations.hpp"
#include "benchmark.hpp"
#include "callgrind.hpp"
#include "timing.hpp"
#include "witness/draw.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Vector4d = actio::Vector<double, 4>;
using SecondJet3 = SecondJet<double, 3, 3>;

namespace {

constexpr double density = 1.3, lambda = 2.0, mu = 0.7;
constexpr int block = 250;

/// The hand-written equation, rho (Div P - acceleration), in the fewest operations we know; T counts them
/// where it is not double.
template <class T>
std::array<T, 3> by_hand(SecondJet3 const& jet) {
  T const rho(density), half_lambda(lambda / 2), both(lambda + mu), shear(mu);
  auto const F = [&](int a, int i) { return T(jet.v(a, i + 1)); };
  auto const w = [&](int a, int i, int k) { return T(jet.w[i + 1](a, k + 1)); };
  T const C00 = F(0, 0) * F(0, 0) + F(1, 0) * F(1, 0) + F(2, 0) * F(2, 0),
          C11 = F(0, 1) * F(0, 1) + F(1, 1) * F(1, 1) + F(2, 1) * F(2, 1),
          C22 = F(0, 2) * F(0, 2) + F(1, 2) * F(1, 2) + F(2, 2) * F(2, 2),
          C01 = F(0, 0) * F(0, 1) + F(1, 0) * F(1, 1) + F(2, 0) * F(2, 1),
          C02 = F(0, 0) * F(0, 2) + F(1, 0) * F(1, 2) + F(2, 0) * F(2, 2),
          C12 = F(0, 1) * F(0, 2) + F(1, 1) * F(1, 2) + F(2, 1) * F(2, 2);
  T const stretch = half_lambda * (C00 + C11 + C22 - T(3)) - shear;
  std::array<T, 3> d, r;
  T const l0 = w(0, 0, 0) + w(0, 1, 1) + w(0, 2, 2), l1 = w(1, 0, 0) + w(1, 1, 1) + w(1, 2, 2),
          l2 = w(2, 0, 0) + w(2, 1, 1) + w(2, 2, 2);
  for (int i = 0; i < 3; ++i)
    d[i] = both * (F(0, 0) * w(0, 0, i) + F(0, 1) * w(0, 1, i) + F(0, 2) * w(0, 2, i) + F(1, 0) * w(1, 0, i) +
                   F(1, 1) * w(1, 1, i) + F(1, 2) * w(1, 2, i) + F(2, 0) * w(2, 0, i) + F(2, 1) * w(2, 1, i) +
                   F(2, 2) * w(2, 2, i)) +
           shear * (F(0, i) * l0 + F(1, i) * l1 + F(2, i) * l2);
  for (int a = 0; a < 3; ++a) {
    T const crossed = C01 * w(a, 0, 1) + C02 * w(a, 0, 2) + C12 * w(a, 1, 2), laplacian = a == 0   ? l0
                                                                                          : a == 1 ? l1
                                                                                                   : l2;
    T const force = stretch * laplacian +
                    shear * (C00 * w(a, 0, 0) + C11 * w(a, 1, 1) + C22 * w(a, 2, 2) + crossed + crossed);
    r[a] = rho * (force + F(a, 0) * d[0] + F(a, 1) * d[1] + F(a, 2) * d[2] - T(jet.w[0](a, 0)));
  }
  return r;
}
Vector3d hand_written(SecondJet3 const& jet) {
  auto const r = by_hand<double>(jet);
  return {r[0], r[1], r[2]};
}

/// A number that counts what is done to it.
struct Counted {
  static inline long sums = 0, products = 0;
  double x = 0;
  Counted() = default;
  explicit Counted(double v) : x(v) {}
  friend Counted operator+(Counted a, Counted b) { return ++sums, Counted(a.x + b.x); }
  friend Counted operator-(Counted a, Counted b) { return ++sums, Counted(a.x - b.x); }
  friend Counted operator*(Counted a, Counted b) { return ++products, Counted(a.x * b.x); }
};

/// A bar that is twisted to and fro while waves run along it.
constexpr double twist = 0.4, turn = 0.9, wave = 0.05, number = 2.0, frequency = 1.1;
struct TwistedBar {
  template <class T>
  Matrix<T, 3, 1> operator()(Matrix<T, 4, 1> const& x) const {
    using std::cos, std::sin;
    T const angle = x[3] * cos(x[0] * turn) * twist, c = cos(angle), s = sin(angle);
    return {x[1] * c - x[2] * s, x[1] * s + x[2] * c, x[3] + sin(x[3] * number - x[0] * frequency) * wave};
  }
};
/// The same with its derivatives, by hand.
SecondJet3 twisted_bar_by_hand(Vector4d const& x) {
  double const beat = std::cos(turn * x[0]) * twist, slide = -turn * twist * std::sin(turn * x[0]),
               angle = x[3] * beat, c = std::cos(angle), s = std::sin(angle);
  double const phase = number * x[3] - frequency * x[0], up = wave * std::sin(phase),
               slope = wave * std::cos(phase);
  // The angle has derivatives in t and z alone.
  std::array<double, 4> const rate{x[3] * slide, 0, 0, beat};
  SecondJet3 j;
  j.x = x;
  j.y = {x[1] * c - x[2] * s, x[1] * s + x[2] * c, x[3] + up};
  j.v << -j.y[1] * rate[0], c, -s, -j.y[1] * rate[3], j.y[0] * rate[0], s, c, j.y[0] * rate[3],
      -frequency * slope, 0, 0, 1 + number * slope;
  for (int m : {0, 3}) {
    for (int k : {0, 3}) {
      double const second = m == 3 && k == 3 ? 0.0 : m == k ? -turn * turn * angle : slide;
      j.w[m].col(k) << -j.y[1] * second - j.y[0] * rate[m] * rate[k],
          j.y[0] * second - j.y[1] * rate[m] * rate[k],
          -up * (m == 0 ? -frequency : number) * (k == 0 ? -frequency : number);
    }
    j.w[m].col(1) << -s * rate[m], c * rate[m], 0;
    j.w[m].col(2) << -c * rate[m], -s * rate[m], 0;
    j.w[1].col(m) = j.w[m].col(1);
    j.w[2].col(m) = j.w[m].col(2);
  }
  for (int m : {1, 2}) j.w[m].middleCols<2>(1).setZero();
  return j;
}

/// A density of one's own: a callable on jets that nothing is known of. It is that of the same solid.
struct OwnDensity {
  template <class T>
  T operator()(Jet<T, 3, 3> const& j) const {
    T twice_kinetic(0), trace(0), square(0);
    for (int a = 0; a < 3; ++a) twice_kinetic += j.v(a, 0) * j.v(a, 0);
    for (int i = 1; i <= 3; ++i)
      for (int k = 1; k <= i; ++k) {
        T const C = j.v(0, i) * j.v(0, k) + j.v(1, i) * j.v(1, k) + j.v(2, i) * j.v(2, k),
                strain = i == k ? C - 1.0 : C;
        if (i == k) trace += strain;
        square += strain * strain * (i == k ? 1.0 : 2.0);
      }
    return (twice_kinetic / 2.0 - trace * trace * (lambda / 8) - square * (mu / 4)) * density;
  }
};

Continuum const solid{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{density},
                      OfGreenTensor{StVenantKirchhoff<double>{lambda, mu}}};
TwistedBar const bar;

struct Points {
  std::vector<Vector4d> events;
  std::vector<SecondJet3> jets;
};
Points points() {
  Draw draw(6);
  Points p;
  for (int i = 0; i < block; ++i) {
    p.events.push_back(draw.vector<double, Vector4d>(4));
    p.jets.push_back(second_jet(bar, p.events.back()));
  }
  return p;
}

// So that no compiler leaves out what is computed.
double volatile sink;
template <class At, class F>
void over(std::vector<At> const& at, long times, F const& f) {
  Vector3d sum = Vector3d::Zero();
  for (long k = 0; k < times; ++k)
    for (At const& x : at) sum += f(x);
  sink = sum.sum();
}

struct Kind {
  char const* key;
  char const* name;
  void (*run)(Points const&, long);
  bool section;  ///< with the section evaluated
};
using P = Points;
Kind const kinds[] = {
    {"hand", "by hand", [](P const& p, long n) { over(p.jets, n, hand_written); }, false},
    {"general", "St Venant-Kirchhoff",
     [](P const& p, long n) { over(p.jets, n, [](auto const& j) { return euler_lagrange(solid, j); }); },
     false},
    {"own_density", "a density of one's own",
     [](P const& p, long n) {
       over(p.jets, n, [](auto const& j) { return euler_lagrange(OwnDensity{}, j); });
     },
     false},
    {"section_hand", "by hand",
     [](P const& p, long n) {
       over(p.events, n, [](auto const& x) { return hand_written(twisted_bar_by_hand(x)); });
     },
     true},
    {"section_general", "St Venant-Kirchhoff",
     [](P const& p, long n) {
       over(p.events, n, [](auto const& x) { return euler_lagrange(solid, bar, x); });
     },
     true},
    {"section_own_density", "a density of one's own",
     [](P const& p, long n) {
       over(p.events, n, [](auto const& x) { return euler_lagrange(OwnDensity{}, bar, x); });
     },
     true}};
constexpr std::size_t section_from = 3;

/// Largest difference of the ways over the points, in roundings of the largest value.
double apart(Points const& p) {
  double gap = 0, size = 0;
  for (int i = 0; i < block; ++i) {
    Vector3d const reference = hand_written(twisted_bar_by_hand(p.events[i]));
    size = std::max(size, magnitude(reference));
    for (Vector3d const& other : {euler_lagrange(solid, p.jets[i]), euler_lagrange(OwnDensity{}, p.jets[i])})
      gap = std::max(gap, magnitude(Vector3d(other - reference)));
  }
  return gap / (size * epsilon<double>());
}

}  // namespace

int main(int argc, char** argv) {
  Points const p = points();
  if (argc == 2 && std::string(argv[1]) == "--count") {
    for (Kind const& kind : kinds) benchmark::counted(kind.key, [&] { kind.run(p, 1); });
    return 0;
  }
  benchmark::Benchmark program(argc, argv,
                               "the field equations of an elastic medium at a point, in hand-written ones");

  double const gap = apart(p);
  program.figure("gap", gap, "largest difference from the hand-written equation, in roundings");
  program.claim(gap < 100, "all ways give the same equation");
  by_hand<Counted>(p.jets[0]);
  program.figure("floor", static_cast<double>(Counted::sums + Counted::products),
                 "operations of the hand-written equation at a point");
  program.figure("floor_products", static_cast<double>(Counted::products), "products among them");

  // A full run evaluates each way 41 x 100 x 250 times, a million.
  long const repeats = program.length(100L, 20L);
  std::vector<benchmark::Contestant> contestants;
  for (Kind const& kind : kinds)
    contestants.push_back(
        {kind.name, [&] { kind.run(p, repeats); }, 1.0 * block * static_cast<double>(repeats)});
  auto const seconds = benchmark::in_turns(program.rounds(41), contestants);
  bool const counted = benchmark::pieces_can_be_counted();
  std::string const self = std::filesystem::canonical("/proc/self/exe").string();
  std::array<double, std::size(kinds)> instructions{};
  auto const counts =
      counted ? benchmark::counted_pieces("'" + self + "' --count") : std::map<std::string, double>();
  for (std::size_t i = 0; counted && i < std::size(kinds); ++i) {
    auto const found = counts.find(kinds[i].key);
    if (found != counts.end()) instructions[i] = found->second / block;
    program.claim(instructions[i] > 0, std::string("valgrind counts the instructions of: ") + kinds[i].name);
  }

  std::vector<book::Program::Row> rows[2];
  std::array<double, std::size(kinds)> ratio;
  for (std::size_t i = 0; i < std::size(kinds); ++i) {
    std::size_t const unit = kinds[i].section ? section_from : 0;
    double const in_time = benchmark::ratio_of_best(seconds[i], seconds[unit]);
    ratio[i] = counted ? instructions[i] / instructions[unit] : in_time;
    auto const all = benchmark::ratios(seconds[i], seconds[unit]);
    rows[kinds[i].section].push_back(
        {kinds[i].name, counted ? book::number(instructions[i], 4) : "not counted",
         counted ? book::number(ratio[i], 3) : "not counted",
         book::number(1e9 * benchmark::best_tenth(seconds[i]), 3), book::number(in_time, 3),
         book::number(benchmark::quantile(all, 0.1), 3) + " to " +
             book::number(benchmark::quantile(all, 0.9), 3)});
    std::string const what = std::string(kinds[i].name) + (kinds[i].section ? ", with the section" : "") +
                             ", in hand-written ones";
    program.figure(kinds[i].key, ratio[i], book::number(ratio[i], 3), what);
    program.figure(kinds[i].key + std::string("_time"), in_time, book::number(in_time, 3),
                   what + ", by time");
  }
  book::Program::Row const header{"the equation at a point",       "instructions",
                                  "in hand-written ones",          "ns",
                                  "in hand-written ones, by time", "eight rounds of ten"};
  program.table("equation", header, rows[0], "From given second jets of a section.");
  program.table("section", header, rows[1], "With the second jet of the section.");

  double const general = std::max(ratio[1], ratio[2]);
  program.figure("general_worst", general, book::number(general, 3),
                 "the dearer of the two, in hand-written ones");
  // Counts are the same on every machine; where only times are known, a short run cannot judge.
  auto const claim = [&](bool holds, std::string const& what) {
    counted ? program.claim(holds, what) : program.claim_of_time(holds, what);
  };
  std::string const by = counted ? ", by instructions; measured " : ", by time; measured ";
  claim(general <= 60,
        "a density of which nothing is known costs at most sixty" + by + book::number(general));
  program.headline("the Euler-Lagrange derivative takes " + book::number(general, 3) +
                       " hand-written equations" + (counted ? ", by instructions" : ", by time"),
                   general);
  return program.finish();
}
