// actio-mpi: `actio run`, `actio resume` and `actio sweep` on many machines.
//
//     mpirun -n 16 actio-mpi run neo_hookean_block
//     mpirun -n 16 actio-mpi resume neo_hookean_block
//     mpirun -n 16 actio-mpi apophis.toml --over method.step=0.1,0.2,0.5
//     mpirun -n 16 actio-mpi --resume apophis
//
// A run is that of rank 0, which writes its files and speaks; the others step their parts of its medium, or
// multiply their parts of its matrices. Of a
// sweep, each rank takes the next member from one counter, in a window of memory on rank 0, as soon as it has
// finished another, so that none waits for slow ones. What a member tells goes to rank 0, which writes the
// table. Members run in other processes (SweepCrew) that were made before MPI began and know nothing of it.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "app/commands.hpp"
#include "app/mpi_agreement.hpp"
#include "app/mpi_ranks.hpp"
#include "app/sweep_arguments.hpp"
#include "program/base/interrupt.hpp"
#include "program/base/progress.hpp"
#include "program/base/ranks.hpp"
#include "program/registry/system.hpp"
#include "program/sweep/run.hpp"
#include "program/systems/sphere/products_on_ranks.hpp"

using namespace actio;
using namespace actio::scene;

namespace {

/// What the ranks share: the counter, results on their way to rank 0, and what rank 0 says. Nothing here
/// waits without a pause, so that a rank that is idle leaves its core to others.
class Ranks : public SweepSharing {
 public:
  Ranks() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_), MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Win_allocate(rank_ == 0 ? sizeof(long) : 0, sizeof(long), MPI_INFO_NULL, MPI_COMM_WORLD, &counter_,
                     &window_);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
    set_counter();
  }
  ~Ranks() override { MPI_Win_unlock_all(window_), MPI_Win_free(&window_); }

  bool speaks() const override { return rank_ == 0; }

  long next() override {
    long const one = 1;
    long taken = 0;
    MPI_Fetch_and_op(&one, &taken, MPI_LONG, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return taken;
  }

  void deliver(MemberResult const& result) override { send(result.packed()); }
  void leave() override {
    if (rank_ != 0) send("");
  }
  bool all_left() override { return rank_ != 0 || left_ == size_ - 1; }
  int patience() const override { return 2; }

  std::vector<MemberResult> delivered() override {
    std::vector<MemberResult> out;
    MPI_Status status;
    for (int there = 1;;) {
      // this also lets the counter be read by others
      MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
      if (!there) return out;
      int bytes = 0;
      MPI_Get_count(&status, MPI_BYTE, &bytes);
      std::string text(static_cast<std::size_t>(bytes), '\0');
      MPI_Recv(text.data(), bytes, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      if (text.empty())
        ++left_;
      else
        out.push_back(MemberResult::unpacked(text));
    }
  }

  std::string agree(std::string const& said) override {
    std::string out = said;
    long size = static_cast<long>(said.size());
    broadcast(&size, sizeof size);
    out.resize(static_cast<std::size_t>(size));
    broadcast(out.data(), size);
    left_ = 0;
    set_counter();
    return out;
  }

 private:
  void set_counter() {
    if (rank_ == 0) {
      long const zero = 0;
      long before = 0;
      MPI_Fetch_and_op(&zero, &before, MPI_LONG, 0, 0, MPI_REPLACE, window_);
      MPI_Win_flush(0, window_);
    }
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    wait(request);
  }
  void broadcast(void* data, long bytes) {
    MPI_Request request;
    MPI_Ibcast(data, static_cast<int>(bytes), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
    wait(request);
  }
  void send(std::string const& text) {
    MPI_Request request;
    MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_BYTE, 0, 0, MPI_COMM_WORLD, &request);
    wait(request);
  }
  static void wait(MPI_Request& request) {
    for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done;)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  int rank_ = 0, size_ = 1, left_ = 0;
  long* counter_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

/// The sweep on this rank.
int sweep(SweepPlan const& plan, SweepCrew& crew, app::SweepArguments const& arguments) {
  int status = 0;
  Ranks ranks;
  try {
    status = run_sweep(plan, crew, ranks,
                       {.quiet = arguments.quiet,
                        .force = arguments.force,
                        .resume = !arguments.resume.empty(),
                        .dry_run = arguments.dry_run});
  } catch (SceneError const& error) {
    say(stderr, error.what() + std::string("\n"));
    status = 2;
  } catch (FileError const& error) {
    say(stderr, error.what() + std::string("\n"));
    status = 4;
  }
  // Others may have been ended and will never answer: to take leave of them would wait for ever. The table is
  // written.
  if (interrupted() && ranks.speaks()) MPI_Abort(MPI_COMM_WORLD, status);
  return status;
}

/// A run, or what goes on with one, on all ranks.
int run_on_ranks(int argc, char** argv) {
  // Where ranks share a core, Open MPI must give it away while it waits, also inside ScaLAPACK.
  ::setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
  // Threads beside the one that speaks to other ranks make no calls of MPI.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  int status = 0;
  {
    app::MpiRanks ranks;
    shared_ranks() = &ranks;
    // Rank 0 says when to end; where it is gone, mpirun ends the others.
    if (ranks.rank() > 0) listen_for_interrupts();
    try {
      auto const part = [](std::string const& told, double number) {
        return told == name_of_products ? part_of_products() : part_of_motion(told, number);
      };
      if (app::agree_on_run(ranks))
        share_parts(ranks, part, [&] { status = app::command(argc, argv); });
      else
        status = 2;
    } catch (std::exception const& error) {
      say(stderr, "rank " + std::to_string(ranks.rank()) + ": " + error.what() + "\n");
      MPI_Abort(MPI_COMM_WORLD, 3);
    }
    shared_ranks() = nullptr;
  }
  MPI_Finalize();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  if (std::string const part = argc > 1 ? argv[1] : ""; part == "run" || part == "resume")
    return run_on_ranks(argc, argv);
  open_standard_streams();
  app::SweepArguments arguments;
  if (auto const status = app::read_sweep_arguments(
          argc, argv, "actio-mpi",
          "Run a scene for each of many values, into one table, on all ranks of mpirun.", arguments))
    return *status;
  try {
    SweepPlan const plan = app::sweep_plan(arguments);
    listen_for_interrupts();
    SweepCrew crew([&](MemberTask task,
                       long member) { return work_on_member(plan, task, member, SweepCrew::told_to_stop); },
                   std::max(1, arguments.jobs));
    MPI_Init(&argc, &argv);
    int const status = sweep(plan, crew, arguments);
    MPI_Finalize();
    return status;
  } catch (Error const& error) {
    say(stderr, error.what() + std::string("\n"));
    return 2;
  }
}
