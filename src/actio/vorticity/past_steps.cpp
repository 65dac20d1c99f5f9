#include <Eigen/Core>

#include "actio/vorticity/past_steps.hpp"

namespace actio::sphere {

void LowerHalf::take(SkewHermitian<> const& m) {
  resize(m.size());
  over_columns(m.size(), [&](Eigen::Index c, Eigen::Index at) {
    auto const rows = m.size() - c;
    real.segment(at, rows) = m.real.col(c).tail(rows);
    imaginary.segment(at, rows) = m.imaginary.col(c).tail(rows);
  });
}

void LowerHalf::take_difference(SkewHermitian<> const& a, SkewHermitian<> const& b) {
  resize(a.size());
  over_columns(a.size(), [&](Eigen::Index c, Eigen::Index at) {
    auto const rows = a.size() - c;
    real.segment(at, rows) = a.real.col(c).tail(rows) - b.real.col(c).tail(rows);
    imaginary.segment(at, rows) = a.imaginary.col(c).tail(rows) - b.imaginary.col(c).tail(rows);
  });
}

void LowerHalf::put(Eigen::Index n, SkewHermitian<>& m) const {
  if (m.size() != n) m = SkewHermitian<>(n);
  over_columns(n, [&](Eigen::Index c, Eigen::Index at) {
    m.real.col(c).tail(n - c) = real.segment(at, n - c);
    m.imaginary.col(c).tail(n - c) = imaginary.segment(at, n - c);
  });
  mirror_lower(m);
}

void LowerHalf::put_sum(SkewHermitian<> const& other, SkewHermitian<>& m) const {
  auto const n = other.size();
  if (m.size() != n) m = SkewHermitian<>(n);
  over_columns(n, [&](Eigen::Index c, Eigen::Index at) {
    m.real.col(c).tail(n - c) = other.real.col(c).tail(n - c) + real.segment(at, n - c);
    m.imaginary.col(c).tail(n - c) = other.imaginary.col(c).tail(n - c) + imaginary.segment(at, n - c);
  });
  mirror_lower(m);
}

PastStep make_room(std::deque<PastStep>& past, int most) {
  if (static_cast<int>(past.size()) < most) return {};
  PastStep oldest = std::move(past.back());
  past.pop_back();
  return oldest;
}

void extrapolate(std::deque<PastStep> const& past, LowerHalf PastStep::*which, int most, LowerHalf& out) {
  auto const each = [&](Eigen::VectorXd LowerHalf::*part) {
    Eigen::VectorXd& sum = out.*part;
    sum.resize((past.front().*which.*part).size());
    // A piece of the sum stays near while the steps are added.
    constexpr Eigen::Index piece = 1024;
    for (Eigen::Index at = 0; at < sum.size(); at += piece) {
      auto to = sum.segment(at, std::min(piece, sum.size() - at));
      to.setZero();
      extrapolate(
          past,
          [&](PastStep const& step, double weight) {
            to += weight * (step.*which.*part).segment(at, to.size());
          },
          most);
    }
  };
  each(&LowerHalf::real), each(&LowerHalf::imaginary);
}

double error_of_guess(std::deque<PastStep> const& past, int most, SkewHermitian<> const& b) {
  auto const n = b.size();
  double apart = 0, size = 0;
  Eigen::VectorXd difference;
  LowerHalf::over_columns(n, [&](Eigen::Index c, Eigen::Index at) {
    // Sixteen columns or so, evenly spread.
    if (n > 16 && c % (n / 16) != 0) return;
    auto const rows = n - c;
    auto const add = [&](auto const& column, Eigen::VectorXd LowerHalf::*part) {
      difference = -column;
      extrapolate(
          past,
          [&](PastStep const& step, double weight) {
            difference += weight * (step.displacement.*part).segment(at, rows);
          },
          most);
      apart += difference.squaredNorm(), size += column.squaredNorm();
    };
    add(b.real.col(c).tail(rows), &LowerHalf::real),
        add(b.imaginary.col(c).tail(rows), &LowerHalf::imaginary);
  });
  return size == 0 ? std::sqrt(apart) : std::sqrt(apart / size);
}

}  // namespace actio::sphere
