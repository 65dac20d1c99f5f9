// Media on meshes on several ranks: the same bits as on one.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "actio/meshes/gmsh_mesh.hpp"
#include "actio/parallel/thread_ranks.hpp"
#include "caught.hpp"
#include "ranks_through.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using testing::message_of;

namespace {

template <int d>
using Spot = std::array<double, d>;

/// A medium and what is done to it.
template <int d>
struct Body {
  BodyMesh mesh;
  std::shared_ptr<StoredEnergy<d> const> law;
  BodyStart<d> start = {};
  BodyStepping stepping = {0.01};
  BodySides<d> sides = {};
  BodyLoads<d> loads = {};

  MediumOnMesh<d> medium(Ranks* ranks) const { return {mesh, law, start, stepping, sides, loads, ranks}; }
  /// Does this with media that these ranks share.
  void share(Ranks& here, std::function<void()> const& work) const {
    share_parts(
        here,
        [&](std::string const&, double) {
          return std::make_unique<BodyOnRank<d>>(here, "", mesh, law, start.density, stepping, sides, loads);
        },
        work);
  }
  /// On so many ranks.
  void on_ranks(int count, std::function<void(Ranks&)> const& work) const {
    on_thread_ranks(count, [&](Ranks& here) { share(here, [&] { work(here); }); });
  }
};

/// The state after some steps, with one that was taken on the way and gone on from, and one between steps.
template <int d>
std::vector<double> run(Body<d> const& body, Ranks* ranks) {
  auto made = body.medium(ranks);
  made.step(7);
  auto const state = made.remember();
  made.look_ahead(body.stepping.step / 3);
  auto const between = made.places();
  made.step(3);
  made.change_step(body.stepping.step / 4, body.stepping.step / 2, 20);
  auto other = body.medium(ranks);
  other.restore(state);
  other.step(20), made.step(2);
  auto out = other.remember();
  for (double const one : made.remember()) out.push_back(one);
  for (auto const& place : between) out.insert(out.end(), place.begin(), place.end());
  return out;
}

template <int d>
void check_ranks(Body<d> const& body) {
  auto const alone = run(body, nullptr);
  BOOST_TEST(std::ranges::all_of(alone, [](double one) { return is_finite(one); }));
  for (int const ranks : {1, 2, 3, 4, 7}) {
    std::vector<double> together;
    body.on_ranks(ranks, [&](Ranks& here) { together = run(body, &here); });
    BOOST_TEST((alone == together), ranks << " ranks");
  }
}

/// A square of triangles with a fan of diagonals, as a file of Gmsh has it, with nodes in no order.
BodyMesh triangles() {
  int const n = 9, nodes = (n + 1) * (n + 1);
  auto const tag = [&](int i, int j) { return (37 * (i + (n + 1) * j)) % nodes + 1; };
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n";
  char const* const names[] = {"left", "right", "bottom", "top"};
  for (int k = 0; k < 4; ++k) text += "1 " + std::to_string(k + 1) + " \"" + names[k] + "\"\n";
  text += "$EndPhysicalNames\n$Nodes\n" + std::to_string(nodes) + "\n";
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      text += std::to_string(tag(i, j)) + " " + show(i / 9.0 + 0.02 * std::sin(2.0 * j)) + " " +
              show(j / 9.0) + " 0\n";
  std::string elements;
  int count = 0;
  auto const element = [&](std::string const& what) { elements += std::to_string(++count) + what + "\n"; };
  auto const in_words = [&](std::initializer_list<int> corners) {
    std::string out;
    for (int const one : corners) out += " " + std::to_string(one);
    return out;
  };
  for (int k = 0; k < n; ++k) {
    element(" 1 2 1 1" + in_words({tag(0, k + 1), tag(0, k)}));
    element(" 1 2 2 2" + in_words({tag(n, k), tag(n, k + 1)}));
    element(" 1 2 3 3" + in_words({tag(k, 0), tag(k + 1, 0)}));
    element(" 1 2 4 4" + in_words({tag(k + 1, n), tag(k, n)}));
  }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      int const a = tag(i, j), b = tag(i + 1, j), c = tag(i + 1, j + 1), e = tag(i, j + 1);
      element(" 2 2 9 1" + in_words({a, b, (i + j) % 2 ? c : e}));
      element(" 2 2 9 1" + ((i + j) % 2 ? in_words({a, c, e}) : in_words({b, c, e})));
    }
  return gmsh_mesh_of(
      text + "$EndNodes\n$Elements\n" + std::to_string(count) + "\n" + elements + "$EndElements\n",
      "square.msh");
}
auto rubber() { return stored_energy<2>(neo_hookean(1, 0.5)); }

/// A square of triangles with everything on its sides and around it.
Body<2> loaded() {
  Body<2> body{triangles(), rubber()};
  body.start.velocity = [](Spot<2> const& X) { return Spot<2>{0.2 * X[1] * X[1], -0.1 * X[0]}; };
  body.start.density = [](Spot<2> const& X) { return 1 + 0.3 * X[0] * X[1]; };
  body.sides["left"] = {Side::moved, prescribed_motion<2>([](Spot<2> const& X, auto t) {
                          using std::sin;
                          return std::array<decltype(t), 2>{X[0] + 0.05 * sin(3.0 * t), X[1] + 0.02 * t};
                        })};
  body.sides["bottom"] = {Side::sliding, {}};
  body.loads.pressures["top"] = [](double t) { return 0.2 * std::sin(5 * t); };
  body.loads.tractions["right"] = {0.1, -0.03};
  body.loads.potentials.push_back(space_potential<2>([](auto const& x) {
    using std::exp;
    return x[1] * 0.5 + exp(-x[0] * x[0]);
  }));
  body.loads.outside_pressure = 0.1;
  return body;
}

/// Ranks of which one hears nothing of its neighbours in one exchange.
class Deaf final : public testing::RanksThrough {
 public:
  using RanksThrough::RanksThrough;
  void exchange(int to, std::span<std::byte const> mine, int from, std::span<std::byte> theirs) override {
    RanksThrough::exchange(to, mine, from, theirs);
    if (rank() == 1 && ++heard_ == 21) std::ranges::fill(theirs, std::byte{0});
  }

 private:
  int heard_ = 0;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(meshes_on_ranks)

BOOST_AUTO_TEST_CASE(triangles_of_a_file_with_loads_and_moved_sides) { check_ranks(loaded()); }

BOOST_AUTO_TEST_CASE(a_disc_with_steps_of_order_four) {
  Body<2> body{disc_mesh(1, {4, 3}), rubber()};
  body.start.placement = [](Spot<2> const& X) { return Spot<2>{1.1 * X[0] + 0.1 * X[1] * X[1], X[1]}; };
  body.stepping.order = 4;
  check_ranks(body);
}

BOOST_AUTO_TEST_CASE(a_ball_whose_cells_need_a_correction) {
  Body<3> body{ball_mesh(1, {3, 2}), stored_energy<3>(neo_hookean(1, 1))};
  body.start.velocity = [](Spot<3> const& X) { return Spot<3>{0.3 * X[1] * X[2], -0.2 * X[0], 0.1}; };
  body.sides["outer"] = {Side::free, {}};
  body.loads.pressures["outer"] = [](double t) { return 0.3 * t; };
  check_ranks(body);
}

BOOST_AUTO_TEST_CASE(a_gas_around_a_seam_with_viscosity_in_parts) {
  Body<2> body{box_mesh({0, 0}, {1, 0.8}, {16, 5}, {true, false}), stored_energy<2>(isentropic_gas(1, 1.4))};
  body.start.velocity = [](Spot<2> const& X) {
    return Spot<2>{1.5 * std::sin(2 * 3.14159265358979323846 * X[0]), 0};
  };
  body.stepping = {.step = 0.02, .viscosity = {0.5, 2}};
  body.sides = {{"bottom", {Side::sliding, {}}}, {"top", {Side::sliding, {}}}};
  BOOST_TEST(body.medium(nullptr).largest_step_of_viscosity() < body.stepping.step);
  check_ranks(body);
}

BOOST_AUTO_TEST_CASE(a_line) {
  Body<1> body{box_mesh({0}, {1}, {20}), stored_energy<1>(isentropic_gas(1, 1.4))};
  body.start.velocity = [](Spot<1> const& X) { return Spot<1>{0.2 * X[0] * X[0]}; };
  body.sides["left"] = {Side::fixed, {}};
  check_ranks(body);
}

// A state that was taken on some ranks is gone on from on others.
BOOST_AUTO_TEST_CASE(a_run_goes_on_with_another_number_of_ranks) {
  Body<2> const body = loaded();
  auto alone = body.medium(nullptr);
  alone.step(30);
  std::vector<double> state;
  for (int const ranks : {3, 1, 2})
    body.on_ranks(ranks, [&](Ranks& here) {
      auto medium = body.medium(&here);
      if (!state.empty()) medium.restore(state);
      medium.step(10), state = medium.remember();
    });
  BOOST_TEST((state == alone.remember()));
}

BOOST_AUTO_TEST_CASE(ranks_with_different_meshes_are_refused) {
  Body<2> const body = loaded();
  on_thread_ranks(3, [&](Ranks& here) {
    Body<2> mine = body;
    if (here.rank() == 2) mine.mesh.nodes[40][0] += 1e-9;
    mine.share(here, [&] { CHECK_REFUSED(mine.medium(&here), Error); });
  });
}

// What ends steps on one rank ends them on all, with the words and the state of one.
BOOST_AUTO_TEST_CASE(what_fails_on_a_rank_is_told_as_on_one) {
  Body<2> crushed = loaded();
  crushed.loads.tractions["right"] = {-6, 0};
  Body<2> holed = loaded();
  holed.loads.potentials.push_back({[](Spot<2> const&) { return 0.0; },
                                    [](Spot<2> const& x) {
                                      return Spot<2>{x[0] > 1.1 ? std::nan("") : 0.0, 0};
                                    },
                                    nullptr});
  holed.loads.tractions["right"] = {1, 0};
  Body<2> lost = loaded();
  lost.sides["right"] = {Side::moved,
                         {[](Spot<2> const& X, double) { return X; },
                          [](Spot<2> const&, double t) {
                            return Spot<2>{t > 0.1 ? std::nan("") : 0.0, 0};
                          }}};
  for (Body<2> const& body : {crushed, holed, lost}) {
    auto alone = body.medium(nullptr);
    std::string const told = message_of([&] { alone.step(1000); });
    BOOST_TEST(told != "");
    BOOST_TEST(alone.steps() > 3);
    for (int const ranks : {2, 3, 7})
      body.on_ranks(ranks, [&](Ranks& here) {
        auto together = body.medium(&here);
        BOOST_TEST(message_of([&] { together.step(1000); }) == told);
        BOOST_TEST((together.remember() == alone.remember()));
      });
  }
}

// The controls: an exchange that is left out, and sums over cells in another order, have other bits.
BOOST_AUTO_TEST_CASE(controls) {
  Body<2> const body = loaded();
  auto const steps = [](Body<2> const& of, Ranks* ranks) {
    auto made = of.medium(ranks);
    made.step(30);
    return made.remember();
  };
  auto const alone = steps(body, nullptr);
  for (bool const hear : {true, false}) {
    std::vector<double> together;
    on_thread_ranks(3, [&](Ranks& ranks) {
      Deaf deaf(ranks);
      Ranks& here = hear ? ranks : deaf;
      body.share(here, [&] { together = steps(body, &here); });
    });
    BOOST_TEST((alone == together) == hear);
  }

  Body<2> turned = body;
  std::ranges::rotate(turned.mesh.cells, turned.mesh.cells.begin() + 60);
  auto const otherwise = steps(turned, nullptr);
  BOOST_TEST((alone != otherwise));
  for (std::size_t k = 0; k < alone.size(); ++k) BOOST_TEST(std::abs(alone[k] - otherwise[k]) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
