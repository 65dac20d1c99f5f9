// What is compared: methods that take a free body on, step by step.
//
// The state of all is the same, body momentum and attitude (unit quaternion, scalar first, body to space), in
// the axes of the body.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

namespace peers {

/// Momentum, three numbers, and quaternion, four.
using Seven = std::array<double, 7>;

/// A free body to be followed.
struct Task {
  std::array<double, 3> I;  ///< principal moments of inertia
  std::array<double, 3> M;  ///< body momentum at the start; the attitude is the identity

  Seven start() const { return {M[0], M[1], M[2], 1, 0, 0, 0}; }
};

/// A method at work with one step length.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Takes so many steps on.
  virtual void advance(long steps) = 0;
  /// Where the body is.
  virtual Seven state() const = 0;
};

/// A method.
struct Method {
  std::string name;
  /// may throw where the step is too long for it
  std::function<std::unique_ptr<Stepper>(Task const&, double h)> make;
};

/// A stepper from its state, one step, and a way to read the state.
template <class State, class Step, class Read>
std::unique_ptr<Stepper> stepper(State state, Step step, Read read) {
  class Made final : public Stepper {
   public:
    Made(State s, Step step, Read read)
        : state_(std::move(s)), step_(std::move(step)), read_(std::move(read)) {}
    void advance(long steps) override {
      // The state in a local variable, where the compiler may keep it in registers.
      State s = state_;
      for (; steps > 0; --steps) step_(s);
      state_ = s;
    }
    Seven state() const override { return read_(state_); }

   private:
    State state_;
    Step step_;
    Read read_;
  };
  return std::make_unique<Made>(std::move(state), std::move(step), std::move(read));
}
/// The same where the state is the seven numbers.
template <class Step>
std::unique_ptr<Stepper> stepper(Seven const& start, Step step) {
  return stepper(start, std::move(step), [](Seven const& y) { return y; });
}

}  // namespace peers
