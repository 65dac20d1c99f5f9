#include "actio/any_group/chart_solver.hpp"

namespace actio::systems {

std::vector<double> force_at(ReducedSystem const& system, std::vector<double> const& v,
                             ReducedPoint const& at) {
  std::vector<double> inputs = v, work, out(v.size());
  inputs.insert(inputs.end(), at.vectors.begin(), at.vectors.end());
  inputs.insert(inputs.end(), at.momentum.begin(), at.momentum.end());
  inputs.push_back(at.time);
  for (auto const& held : system.force->held) inputs.push_back(held(at.time));
  system.force->components(inputs.data(), out.data(), work);
  auto const& across = system.force->across;
  if (!across) return out;
  auto const d = out.size();
  if (at.frame.size() != d * d)
    throw OutsideDomain("force_at",
                        "a force in components of the other side needs the frame of the point; its numbers",
                        int(at.frame.size()), int(d * d));
  std::vector<double> other(d);
  (*across)(inputs.data(), other.data(), work);
  for (std::size_t c = 0; c < d; ++c)
    for (std::size_t i = 0; i < d; ++i) out[i] += other[c] * at.frame[c * d + i];
  return out;
}

void require_in_chart(ReducedSystem const& system, ChartStep<double> const& step, double h,
                      std::vector<double> const& v) {
  if (system.chart == Chart::cayley || !(step.square_of_ad() > std::numbers::pi * std::numbers::pi)) return;
  Vector<double> const moved = h * Eigen::Map<Eigen::VectorXd const>(v.data(), static_cast<Index>(v.size()));
  double const turn = eigenvalues_of(system.algebra.ad(moved)).imag().cwiseAbs().maxCoeff();
  if (!(turn < std::numbers::pi))
    throw OutsideDomain("natural chart", "a step must turn by less than half a turn; radians", turn,
                        std::numbers::pi);
}

ChartSolver::ChartSolver(ReducedSystem const& system, double h)
    : system_(system),
      h_(h),
      step_(system),
      moved_(system),
      legendre_(system),
      iteration_(static_cast<std::size_t>(system.dimension())) {}

void ChartSolver::operator()(ReducedPoint& point) {
  step_.begin_at(point.time, point.frame), moved_.begin_at(Moved<double>(point.time), point.frame);
  auto const look = [&] { return evaluate(point); };
  auto const differentiate_there = [&] { return differentiate(point); };
  if (!history_.empty()) history_.predict(iteration_.unknowns);
  if (history_.empty() || !iteration_.chord(look, differentiate_there)) newton(point);
  require_in_chart(system_, step_, h_, velocity());
  history_.remember(velocity());
  // What the last residual leaves of the momentum goes with the step as the momentum does.
  auto& residual = iteration_.residual;
  step_.transport(residual);
  for (std::size_t i = 0; i < residual.size(); ++i) point.momentum[i] = step_.after[i] - residual[i];
  point.vectors = step_.vectors;
  point.time += h_;
  for (std::size_t c = 0; c < point.frame.size(); c += residual.size())
    step_.carry_covector(h_, velocity(), &point.frame[c]);
}

double ChartSolver::evaluate(ReducedPoint const& start) {
  ++evaluations_;
  auto const& v = velocity();
  if (!step_(h_, v, start.vectors)) return HUGE_VAL;
  auto const d = v.size();
  double largest = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double const r = iteration_.residual[i] = step_.before[i] - start.momentum[i];
    if (!(r - r == 0)) return HUGE_VAL;
    double scale = std::abs(start.momentum[i]) + std::abs(step_.before[i]) + step_.sizes[i];
    for (std::size_t j = 0; j < d; ++j) scale += iteration_.moduli[i * d + j] * std::abs(v[j]);
    if (r != 0) largest = std::max(largest, std::abs(r) / scale);
  }
  return largest;
}

bool ChartSolver::differentiate(ReducedPoint const& start) {
  int const d = system_.dimension();
  Eigen::MatrixXd derivative(d, d);
  std::vector<Moved<double>> v(velocity().begin(), velocity().end()),
      a(start.vectors.begin(), start.vectors.end());
  for (int first = 0; first < d; first += batch) {
    auto const each = [&](auto const& visit) {
      for (int k = 0; k < batch && first + k < d; ++k) visit(k, static_cast<std::size_t>(first + k));
    };
    each([&](int k, std::size_t i) { v[i].part[static_cast<std::size_t>(k)] = 1; });
    ++evaluations_;
    if (!moved_(Moved<double>(h_), v, a)) return false;
    each([&](int k, std::size_t i) {
      v[i].part[static_cast<std::size_t>(k)] = 0;
      for (int r = 0; r < d; ++r)
        derivative(r, static_cast<Eigen::Index>(i)) =
            moved_.before[static_cast<std::size_t>(r)].part[static_cast<std::size_t>(k)];
    });
  }
  Eigen::VectorXd const units = units_of(derivative);
  InverseInUnits const inverse(derivative, units);
  iteration_.set_derivative(derivative, inverse.matrix, units);
  regular_ = inverse.condition;
  return regular_ > 0x1p-50;
}

void ChartSolver::newton(ReducedPoint const& start) {
  iteration_.forget();
  if (!history_.empty()) iteration_.unknowns = history_.last();
  legendre_.solve(start.momentum, start.vectors, iteration_.unknowns);
  std::vector<double> sizes;
  if (iteration_.newton([&] { return evaluate(start); }, [&] { return differentiate(start); }, sizes)) return;
  if (regular_ <= 0x1p-50)
    throw Singular("natural chart", "the Lagrangian must be regular for this step; condition", regular_,
                   0x1p-50);
  throw NotConverged("natural chart", sizes, StepIteration::tolerance);
}

}  // namespace actio::systems
