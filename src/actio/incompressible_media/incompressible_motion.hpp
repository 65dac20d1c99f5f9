// How an incompressible medium goes on in time: the state, its steps, and what can be read off it (chapter
// 10C of the book). Media in the plane and in space, and the fluid on the sphere, say what acts on them.
#pragma once

#include "actio/incompressible_media/volume_examination.hpp"
#include "actio/parallel/parts_on_ranks.hpp"

namespace actio::media {

/// Steps of an incompressible medium.
///
/// Where ranks share it, each has such an object, made in the same way. That of rank 0 is asked, and asks the
/// others to do what they have to do with it (\ref PartsOnRanks): what cells and nodes are is known to all,
/// places and velocities of rows of others are copied when they are asked for.
template <class Cell>
class IncompressibleMotion {
 public:
  static constexpr int N = Cell::space;  ///< components of a place
  using Place = std::array<double, N>;   ///< a place, or a velocity

  /// Held by who owns it.
  virtual ~IncompressibleMotion() = default;
  IncompressibleMotion(IncompressibleMotion const&) = delete;             ///< Its parts refer to it.
  IncompressibleMotion& operator=(IncompressibleMotion const&) = delete;  ///< \copydoc IncompressibleMotion

  /// So many steps on.
  /// @throws CellFolds, VolumesUnsolved  where there is no such step; the state is that before it
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) {
    if (count < 0)
      throw OutsideDomain("medium", "the number of steps must not be negative", static_cast<double>(count),
                          0);
    auto const asked = parts_.ask({.what = Call::step, .count = count});
    look_ahead(0);
    for (; count > 0; --count) {
      prepare();
      std::swap(state_, next_), prepared_ = whole_ = false;
      std::swap(pressures_[2], pressures_[1]), std::swap(pressures_[1], pressures_[0]);
      std::swap(pressures_[0], pressure_), ++known_, ++steps_;
      // A matrix that is old, or no longer near: to build one takes as long as some twenty rounds.
      if (age_ == 0) first_rounds_ = volumes_.rounds;
      bool const many = volumes_.rounds > std::max<double>(solving_.many_rounds, 1.5 * first_rounds_);
      age_ = many ? solving_.rebuilt_after : age_ + 1;
    }
  }
  /// Until the next step the state is that so long after the last one; zero: that of the last step again.
  /// \copydetails step
  void look_ahead(double time) {
    if (!(time > 0) && ahead_ == 0) return;
    auto const asked = parts_.ask({.what = Call::look_ahead, .numbers = {time, 0}});
    if (ahead_ > 0) {
      state_ = std::move(kept_), ahead_ = 0, prepared_ = whole_ = false, age_ = kept_age_;
      if (volumes_.share.cell_rows.any(volumes_.built.y != kept_built_.y)) {
        SharpPlaces const built = kept_built_;
        volumes_.rebuild(built);
      }
    }
    if (!(time > 0)) return;
    State const from{state_.at, velocities_now(), 0};
    kept_built_ = volumes_.built, prepared_ = false;
    auto const age = age_;
    auto const pressure = pressure_;
    make(from, time, this->time() + time);
    pressure_ = pressure;
    kept_ = std::move(state_), state_ = std::move(next_), ahead_ = time, prepared_ = whole_ = false;
    kept_age_ = age;
  }
  /// One step of another length, and from then on steps of a third one.
  /// @param first  of the one step; zero: there is none
  /// @param step   of those that follow
  /// @param made   how many of these are counted as made: the product is the time
  void change_step(double first, double step, long made) {
    auto const asked = parts_.ask({.what = Call::change_step, .count = made, .numbers = {first, step}});
    look_ahead(first);
    state_.v = velocities_now(), state_.lag = 0;
    whole_ = false, ahead_ = 0, prepared_ = false, known_ = 0, step_ = step, steps_ = made;
    for (auto& one : pressures_) one.clear();
  }
  /// The time of the last step.
  double time() const { return static_cast<double>(steps_) * step_; }
  /// How many steps have been made.
  long steps() const { return steps_; }
  /// The time step.
  double time_step() const { return step_; }

  /// Places of the nodes, length.
  std::vector<Place> places() const { return points(y()); }
  /// Velocities of the nodes now, length/time, which change no volume: the second multiplier of RATTLE.
  std::vector<Place> velocities() { return points(whole_velocities()); }
  /// The masses of the nodes.
  std::vector<double> const& masses() const { return volumes_.masses; }
  /// The pressure in each cell now, by the multiplier of the step that begins here; its mean by volume is
  /// zero where it is known up to a constant.
  /// \copydetails step
  std::vector<double> pressures() {
    auto const asked = parts_.ask({.what = Call::pressures});
    bring();
    prepare();
    auto out = pressure_;
    volumes_.share.cell_rows.whole(std::span(out));
    if (!parts_.here()) return out;
    take_weight(out);
    if (!volumes_.pinned) return out;
    double sum = 0, volume = 0;
    for (std::size_t k = 0; k < out.size(); ++k) sum += out[k] * volumes_.kept[k], volume += volumes_.kept[k];
    for (double& one : out) one -= sum / volume;
    return out;
  }
  /// \f$\tfrac12\sum m|v|^2\f$ of \ref velocities.
  double kinetic_energy() {
    double sum = 0;
    auto const v = whole_velocities();
    for (std::size_t k = 0; k < v.size(); ++k) sum += 0.5 * masses()[k / N] * v[k] * v[k];
    return sum;
  }
  /// \f$\sum mv\f$, mass x length/time: kept to rounding where nothing is held and no load acts.
  Place momentum() { return body_now().template momentum<N>(masses()); }
  /// \f$\sum m\,y\times v\f$, mass x area/time; in the plane the third component.
  std::array<double, 3> angular_momentum() { return body_now().template angular_momentum<N>(masses()); }
  /// The largest modulus of A/A^0 - 1 over all cells.
  double volume_defect() const {
    auto const asked = parts_.ask({.what = Call::volume_defect});
    std::vector<double> r;
    return volumes_.defects(state_.at, r);
  }
  /// For each cell the least Jacobian at its corners, over that of the reference.
  std::vector<double> jacobians() const {
    auto const J = volumes_.volumes.corner_jacobians(y());
    std::vector<double> out(volumes_.kept.size(), HUGE_VAL);
    for (std::size_t k = 0; k < J.size(); ++k)
      out[k / Cell::corners] = std::min(out[k / Cell::corners], J[k] / reference_jacobians_[k]);
    return out;
  }
  /// How many rounds the last step took.
  int rounds() const { return volumes_.rounds; }
  /// Whether pressures are known up to a constant: nothing changes the volume of the whole.
  bool is_closed() const { return volumes_.pinned; }
  /// By how much the projection of the start changed the velocity of a node, at most.
  double projected() const { return projected_; }
  /// The whole state.
  std::vector<double> remember() {
    auto const asked = parts_.ask({.what = Call::remember});
    bring_all();
    State const& last = ahead_ > 0 ? kept_ : state_;
    std::vector<double> out{
        static_cast<double>(steps_),    static_cast<double>(ahead_ > 0 ? kept_age_ : age_),
        static_cast<double>(known_),    last.lag,
        volumes_.fell_back ? 1.0 : 0.0, static_cast<double>(first_rounds_)};
    SharpPlaces const& built = ahead_ > 0 ? kept_built_ : volumes_.built;
    std::array<std::vector<double> const*, 8> const parts{&last.at.y,     &last.at.rest, &last.v,
                                                          &built.y,       &built.rest,   &pressures_[0],
                                                          &pressures_[1], &pressures_[2]};
    for (auto const* part : parts) out.insert(out.end(), part->begin(), part->end());
    return out;
  }
  /// Goes on from a state that was remembered, bit for bit.
  /// @throws OutsideDomain  where it is of another size
  void restore(std::vector<double> const& from) {
    std::size_t const n = state_.at.y.size(), cells = volumes_.kept.size();
    std::size_t const known = from.size() < 6 ? 0 : std::min(3.0, from[2]);
    if (from.size() != 6 + 5 * n + known * cells)
      throw OutsideDomain("incompressible medium", "a remembered state is that of the same mesh; numbers",
                          static_cast<double>(from.size()), static_cast<double>(6 + 5 * n + known * cells));
    auto const asked = parts_.ask({.what = Call::restore, .count = static_cast<long>(from.size())}, from);
    steps_ = static_cast<long>(from[0]), age_ = static_cast<long>(from[1]),
    known_ = static_cast<long>(from[2]);
    auto at = from.begin() + 6;
    first_rounds_ = static_cast<long>(from[5]);
    auto const take = [&](std::vector<double>& part, std::size_t count) {
      part.assign(at, at + static_cast<long>(count)), at += static_cast<long>(count);
    };
    state_.lag = from[3], ahead_ = 0, prepared_ = false, whole_ = true;
    SharpPlaces built;
    take(state_.at.y, n), take(state_.at.rest, n), take(state_.v, n), take(built.y, n), take(built.rest, n);
    for (std::size_t k = 0; k < 3; ++k) take(pressures_[k], k < known ? cells : 0);
    if (from[4] != 0 && !volumes_.fell_back) volumes_.fall_back();
    volumes_.rebuild(built);
  }
  /// Does what rank 0 asks, on another one. What it throws is thrown on rank 0 too.
  void answer(PartCall const& call) {
    switch (call.what) {
      case Call::step:
        return step(call.count);
      case Call::look_ahead:
        return look_ahead(call.numbers[0]);
      case Call::change_step:
        return change_step(call.numbers[0], call.numbers[1], call.count);
      case Call::bring:
        return bring();
      case Call::velocities:
        return void(whole_velocities());
      case Call::pressures:
        return void(pressures());
      case Call::volume_defect:
        return void(volume_defect());
      case Call::remember:
        return void(remember());
      case Call::restore: {
        std::vector<double> from(static_cast<std::size_t>(call.count));
        solving_.ranks->broadcast(bytes_of(from));
        return restore(from);
      }
      default:
        return;
    }
  }

 protected:
  /// @param mesh, reference, density, held, solving  as for \ref VolumeSteps
  IncompressibleMotion(BodyMesh const& mesh, SharpPlaces const& reference, std::vector<double> const& density,
                       std::vector<typename VolumeSteps<Cell>::Allowance> const& held, double step,
                       VolumeSolving const& solving)
      : parts_(solving.ranks, solving.told),
        volumes_(mesh, reference, density, held, solving),
        reference_jacobians_(volumes_.volumes.corner_jacobians(reference.y)),
        mesh_(mesh),
        solving_(solving),
        step_(step) {
    if (!is_finite(step)) throw NotFinite("incompressible medium: time step");
    if (!(step > 0)) throw OutsideDomain("incompressible medium", "a time step is positive", step, 0);
  }

  /// Places and velocities at the start.
  /// @param project  whether what changes volumes is taken from them; if not it is refused
  /// @throws StartChangesVolumes
  void start(std::vector<double> y, std::vector<double> v, bool project) {
    std::vector<double> r, none(y.size(), 0);
    SharpPlaces at{std::move(y), none};
    double const off = volumes_.defects(at, r);
    double const bound = 1e-6;
    if (!(off <= bound) && !project) {
      volumes_.share.cell_rows.whole(std::span(r));
      refuse_placement(mesh_, volumes_, r, bound);
    }
    if (off > solving_.tolerance) {
      std::vector<double> P(volumes_.kept.size(), 0), way = none;
      SharpPlaces const from = at;
      volumes_.rebuild(at);
      volumes_.solve([&](std::vector<double>& now, SharpPlaces& to) { move(from, 1, 0, now, to); }, 1, 1,
                     from, P, way, at);
      gather(at.y), gather(at.rest);
    }
    state_ = {std::move(at), std::move(v), 0};
    volumes_.rebuild(state_.at);
    tangent(state_.at.y, 0, state_.v);
    auto const given = state_.v;
    volumes_.volumes.slopes(state_.at, whole_slopes_, volumes_.volumes.all());
    if (!project) require_volumes_kept(volumes_, whole_slopes_, state_.v, bound);
    volumes_.project(whole_slopes_, state_.v);
    volumes_.share.node_rows.whole(std::span(state_.v));
    for (std::size_t k = 0; k < given.size(); k += N) {
      double square = 0;
      for (int a = 0; a < N; ++a) square += std::pow(state_.v[k + a] - given[k + a], 2);
      projected_ = std::max(projected_, std::sqrt(square));
    }
    whole_ = true;
    refuse_folds(mesh_, volumes_.volumes, reference_jacobians_, {state_.at.y, state_.at.y, 0, 0});
  }

  /// Forces on the nodes that this rank moves, at places y and time t, without pressures; those of held nodes
  /// projected.
  /// @return whether there are any
  virtual bool forces(std::vector<double> const& y, double t, std::vector<double>& f) const = 0;
  /// Places at time t, of the nodes that this rank moves, from those a time h before and velocities between;
  /// on a curved target it corrects the velocities.
  virtual void move(SharpPlaces const& from, double h, double t, std::vector<double>& v,
                    SharpPlaces& to) const = 0;
  /// Makes velocities such as nodes at y may have at time t.
  virtual void tangent(std::vector<double> const& y, double t, std::vector<double>& v) const = 0;

  /// Takes from multipliers the part that carries what is not pressure of the medium: its weight.
  virtual void take_weight(std::vector<double>& pressure) const = 0;

  /// The volumes and the kind of the cells.
  MeshVolumes<Cell> const& cells() const { return volumes_.volumes; }
  /// What of the mesh this rank steps.
  MeshShare const& share() const { return volumes_.share; }
  /// Places of all nodes now.
  std::vector<double> const& y() const {
    bring();
    return state_.at.y;
  }
  /// The time of the state: that of the last step, or of what was looked ahead to.
  double time_of_state() const { return time() + ahead_; }

 private:
  /// What rank 0 asks of the others.
  struct Call {
    enum : int {
      step,
      look_ahead,
      change_step,
      bring,
      velocities,
      pressures,
      volume_defect,
      remember,
      restore
    };
  };
  struct State {
    SharpPlaces at;
    std::vector<double> v;
    double lag = 0;  // velocities are those so long before the places: half a step, or zero
  };
  PartsOnRanks parts_;
  VolumeSteps<Cell> volumes_;
  std::vector<double> reference_jacobians_;
  BodyMesh const& mesh_;
  VolumeSolving solving_;
  double step_;
  mutable State state_, next_, kept_;                    // rows of others are copied when they are asked for
  mutable bool whole_ = false;                           // whether state_ has them
  SharpPlaces kept_built_;                               // places of the matrix when it was looked ahead
  std::vector<double> forces_, whole_slopes_;            // room
  mutable std::vector<double> pressure_, pressures_[3];  // of the step from the state, of the last three
  long steps_ = 0, known_ = 0, age_ = 0, kept_age_ = 0;  // age: steps with one matrix
  long first_rounds_ = 0;                                // of the first of these
  bool prepared_ = false;                                // next_ and pressure_ are those of the next step
  double ahead_ = 0, projected_ = 0;

  void prepare() {
    if (prepared_) return;
    if (age_ >= solving_.rebuilt_after) volumes_.rebuild(state_.at), age_ = 0;
    make(state_, step_, time_of_state() + step_);
    prepared_ = true;
  }
  /// next_ and pressure_: a step of length h from a state to time t.
  void make(State const& from, double h, double t) {
    guess();
    double const scale = from.lag + h / 2;
    next_.v.resize(from.v.size()), next_.lag = h / 2;
    bool const any = forces(from.at.y, t - h, forces_);
    for_each(share().moved, [&](std::size_t node) {
      for (std::size_t k = N * node; k < N * (node + 1); ++k)
        next_.v[k] = any ? from.v[k] + scale * forces_[k] / masses()[node] : from.v[k];
    });
    volumes_.set_slopes(from.at);
    volumes_.solve([&](std::vector<double>& v, SharpPlaces& to) { move(from.at, h, t, v, to); }, scale, h,
                   from.at, pressure_, next_.v, next_.at);
    if (share().cell_rows.any(!(volumes_.volumes.least_jacobian(next_.at.y, share().cells) > 0))) {
      auto before = from.at.y;
      share().node_rows.whole(std::span(before)), share().node_rows.whole(std::span(next_.at.y));
      refuse_folds(mesh_, volumes_.volumes, reference_jacobians_, {before, next_.at.y, t - h, h});
    }
    share_rows(next_.at);
  }
  /// The rows of neighbours that the next step looks at.
  void share_rows(SharpPlaces& at) const {
    for (auto* part : {&at.y, &at.rest}) share().node_rows.exchange(std::span(*part), MeshShare::copied);
  }
  /// Places and velocities of all nodes on all ranks.
  void bring() const {
    if (share().alone() || whole_) return;
    auto const asked = parts_.ask({.what = Call::bring});
    gather(state_), whole_ = true;
  }
  /// That, and what else is remembered.
  void bring_all() {
    gather(state_), gather(kept_), whole_ = true;
    for (auto* of : {&volumes_.built, &kept_built_})
      for (auto* part : {&of->y, &of->rest}) gather(*part);
    for (auto& one : pressures_)
      if (!one.empty()) share().cell_rows.whole(std::span(one));
  }
  void gather(State& state) const { gather(state.at.y), gather(state.at.rest), gather(state.v); }
  void gather(std::vector<double>& of_nodes) const {
    if (!of_nodes.empty()) share().node_rows.whole(std::span(of_nodes));
  }
  /// The parabola through the last three pressures, or what is known of it.
  void guess() {
    pressure_.resize(volumes_.kept.size());
    for_each(share().near, [&](std::size_t k) {
      if (known_ == 0) return void(pressure_[k] = 0);
      double const p = pressures_[0][k];
      if (known_ == 1) return void(pressure_[k] = p);
      double const q = pressures_[1][k];
      pressure_[k] = known_ == 2 ? 2 * p - q : 3 * (p - q) + pressures_[2][k];
    });
  }
  /// Velocities at the time of the places.
  std::vector<double> velocities_now() {
    auto v = state_.v;
    if (state_.lag == 0) return v;
    if (forces(state_.at.y, time_of_state(), forces_))
      for_each(share().moved, [&](std::size_t node) {
        for (std::size_t k = N * node; k < N * (node + 1); ++k)
          v[k] += state_.lag * forces_[k] / masses()[node];
      });
    tangent(state_.at.y, time_of_state(), v);
    volumes_.set_slopes(state_.at);
    volumes_.volumes.slopes(state_.at, whole_slopes_, share().cells);
    volumes_.project(whole_slopes_, v);
    return v;
  }
  /// Those of all nodes, where they are asked for.
  std::vector<double> whole_velocities() {
    auto const asked = parts_.ask({.what = Call::velocities});
    auto v = velocities_now();
    gather(v);
    return v;
  }
  /// Places and velocities as sums over a body need them.
  BodyState body_now() {
    BodyState out;
    out.x = y(), out.v = whole_velocities();
    return out;
  }
  static std::vector<Place> points(std::vector<double> const& in) {
    std::vector<Place> out(in.size() / N);
    for (std::size_t k = 0; k < in.size(); ++k) out[k / N][k % N] = in[k];
    return out;
  }
};

}  // namespace actio::media
