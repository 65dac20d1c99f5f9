// What a run remembers, as a list of numbers: for tests that read it back.
#pragma once

#include <type_traits>
#include <vector>

namespace actio::testing {

/// Saves numbers, and reads them back.
struct Saved {
  std::vector<double> numbers;
  std::size_t at = 0;
  bool reading = false;

  template <class... All>
  void operator()(All&... all) { (each(all), ...); }

 private:
  template <class T>
  void each(T& x) {
    if constexpr (std::is_arithmetic_v<T>) {
      if (reading)
        x = static_cast<T>(numbers[at++]);
      else
        numbers.push_back(static_cast<double>(x));
    } else {
      for (auto& entry : x) each(entry);
    }
  }
};

}  // namespace actio::testing
