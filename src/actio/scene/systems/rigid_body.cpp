// A free rigid body in space (thesis, chapter 5).
#include <fmt/format.h>

#include "actio/foundations/groups/unit_quaternions.hpp"
#include "actio/free_body/free_steps.hpp"
#include "actio/scene/systems/turning_body.hpp"

namespace actio::scene {
namespace {

/// A body in its principal frame, and the way from there to the frame of the scene.
class FreeBodyMotion : public TurningBody {
 public:
  FreeBodyMotion(FreeBody body, GivenInertia const& inertia) : body_(std::move(body)), inertia_(inertia), back_(quaternion(inertia.axes).cwiseProduct(Eigen::Vector4d(1, -1, -1, -1))) {}

  Eigen::Vector3d body_momentum() const override {
    Eigen::Vector3d const M = principal_momentum();
    return inertia_.turned ? Eigen::Vector3d(inertia_.axes * M) : M;
  }
  Eigen::Vector4d attitude() const override {
    Eigen::Vector4d const q = principal_attitude();
    return inertia_.turned ? compose(q, back_) : q;
  }

 protected:
  virtual Eigen::Vector3d principal_momentum() const = 0;
  virtual Eigen::Vector4d principal_attitude() const = 0;

  FreeBody body_;
  GivenInertia inertia_;
  Eigen::Vector4d back_;
};

/// To any time at once.
class ExactMotion : public FreeBodyMotion {
 public:
  ExactMotion(FreeBody body, GivenInertia const& inertia) : FreeBodyMotion(std::move(body), inertia), now_(body_.at(0)) {}
  void go_to(double time) override { now_ = body_.at(time); }

 protected:
  Eigen::Vector3d principal_momentum() const override { return now_.body_momentum.components; }
  Eigen::Vector4d principal_attitude() const override { return now_.attitude.value; }

 private:
  FreeState now_;
};

/// In steps of the Moser-Veselov scheme, or of the same with modified moments.
template <bool with_attitude>
class SteppedMotion : public FreeBodyMotion {
 public:
  SteppedMotion(FreeBody const& body, GivenInertia const& inertia, double step, int order) : FreeBodyMotion(body, inertia), steps_(body, step, body.moser_veselov_flight(step, order)) {}
  void advance(long steps) override {
    if constexpr (with_attitude) steps_.advance(steps);
    else steps_.advance_momentum(steps);
  }
  void remember(Memory& memory) override { steps_.remember(memory); }

 protected:
  Eigen::Vector3d principal_momentum() const override { return steps_.body_momentum().components; }
  Eigen::Vector4d principal_attitude() const override { return steps_.state().attitude.value; }

 private:
  FreeSteps steps_;
};

std::vector<Quantity> quantities() {
  using Kind = Quantity::Kind;
  auto all = turning_body_quantities(true);
  all.push_back({"energy", Kind::scalar, "The kinetic energy.", "H = \\tfrac12\\langle M, I^{-1}M\\rangle", "energy", "eq_5_1", {"body_momentum", "angular_velocity"}, true});
  all.push_back({"casimir", Kind::scalar, "The square of the angular momentum, which names the coadjoint orbit.", "C = |M|^2", "(energy x time)^2", "", {"body_momentum"}, true});
  return all;
}

Simulation prepare(Request const& request) {
  SceneTable system = request.file.section("system"), initial = request.file.section("initial"), method = request.file.section("method");
  system.allow({"kind", "body", "inertia"});
  initial.allow({"attitude", "angular_velocity", "angular_momentum"});
  method.allow({"name", "order", "step"});

  std::vector<std::string> remarks;
  GivenInertia const inertia = read_body_or_inertia(system);
  Eigen::Vector4d const attitude = read_attitude(initial, remarks);
  Eigen::Vector3d const momentum = read_momentum(initial, inertia);
  Eigen::Vector4d const principal_attitude = inertia.turned ? compose(attitude, quaternion(inertia.axes)) : attitude;
  FreeBody const body(inertia.principal, {SO<3>{}, inertia.axes.transpose() * momentum}, {SU2{}, principal_attitude});

  if (!method.has("name")) method.set("name", "moser_veselov");
  if (!method.has("order")) method.set("order", "exact");
  if (!method.has("step")) method.set("step", request.schedule.until() / 1000);
  std::string const name = method.choice("name", "method", {"moser_veselov", "natural_chart"}, "actio list methods");
  double const step = method.positive("step");

  Simulation simulation(quantities());
  simulation.remarks = remarks;
  simulation.step = step;
  QuantityGraph& graph = simulation.quantities;
  std::unique_ptr<TurningBody> motion;
  bool exact = method.is_text("order");
  if (exact) {
    method.choice("order", "order", {"exact"}, "2, 4, 6, 8, 10 or \"exact\"");
    motion = std::make_unique<ExactMotion>(body, inertia);
    simulation.exact = true;
  } else {
    long const order = method.integer("order", 2, 10);
    try {
      motion = std::make_unique<SteppedMotion<false>>(body, inertia, step, static_cast<int>(order));
    } catch (StepTooLong const& error) {
      throw NumericsError(method.place("step").text() + ": " + error.what());
    }
  }
  define_turning_body(graph, *motion, inertia);
  graph.define("energy", {""}, [](auto needs, double* energy) { *energy = (needs[0][0] * needs[1][0] + needs[0][1] * needs[1][1] + needs[0][2] * needs[1][2]) / 2; });
  graph.define("casimir", {""}, [](auto needs, double* casimir) { *casimir = needs[0][0] * needs[0][0] + needs[0][1] * needs[0][1] + needs[0][2] * needs[0][2]; });
  graph.ask(request.quantities);
  simulation.motion = std::move(motion);
  return simulation;
}

}  // namespace

System rigid_body_system() {
  return {"rigid_body", "Free rigid body", "A rigid body that turns freely about its centre of mass.", "chapter 5",
          {}, {}, quantities(), prepare,
          "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 3]\n[initial]\nangular_velocity = [0.1, 2, 0.1]\n[run]\nuntil = 20\nevery = 0.1\n[output]\nquantities = [\"angular_velocity\", \"energy\"]\n"};
}

}  // namespace actio::scene
