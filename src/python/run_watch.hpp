// How Python looks after a run: Ctrl-C ten times a second, and a function of the user four times a second.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>

#include "python/memory_run.hpp"

namespace actio::python {

/// Called without the lock of the interpreter, which it takes when it needs it. What Python raises waits in
/// the thread.
class RunWatch {
 public:
  /// @param told  called with the fraction and the time; a result that is true ends the run. May be None.
  explicit RunWatch(pybind11::handle told) : told_(told) {}

  /// Both of its functions, for a run that it outlives.
  Watch functions() {
    auto const see = [this](double fraction, double time) { fraction_ = fraction, time_ = time; };
    return {[this] { return stop(); }, see};
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool stop() {
    auto const now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return false;
    last_ = now;
    pybind11::gil_scoped_acquire const hold;
    if (PyErr_CheckSignals() != 0) return true;
    if (told_.is_none() || now - last_told_ < std::chrono::milliseconds(250)) return false;
    last_told_ = now;
    return tell();
  }
  bool tell() {
    try {
      pybind11::object const answer = told_(fraction_, time_);
      int const truth = PyObject_IsTrue(answer.ptr());
      return truth != 0;  // negative: it raised
    } catch (pybind11::error_already_set& error) {
      error.restore();
      return true;
    }
  }

  pybind11::handle told_;
  double fraction_ = 0, time_ = 0;
  Clock::time_point last_ = Clock::now(), last_told_ = last_;
};

}  // namespace actio::python
