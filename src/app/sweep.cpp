#include <algorithm>
#include <thread>

#include "app/sweep_arguments.hpp"
#include "program/base/interrupt.hpp"
#include "program/sweep/folder.hpp"
#include "program/sweep/run.hpp"

namespace actio::app {

using namespace scene;

namespace {

int run_alone(SweepPlan const& plan, int jobs, SweepOptions const& options) {
  checkpoint_interval();  // what is wrong with it is wrong before any member
  long const places = jobs > 0 ? jobs : std::max(1u, std::thread::hardware_concurrency());
  listen_for_interrupts();
  SweepCrew crew([&](MemberTask task,
                     long member) { return work_on_member(plan, task, member, SweepCrew::told_to_stop); },
                 static_cast<int>(std::min(places, plan.size())));
  SweepSharing alone;
  return run_sweep(plan, crew, alone, options);
}

}  // namespace

int sweep(SweepArguments const& arguments) {
  open_standard_streams();
  return run_alone(sweep_plan(arguments), arguments.jobs,
                   {.quiet = arguments.quiet, .force = arguments.force, .dry_run = arguments.dry_run});
}

bool is_sweep(std::string const& folder) { return SweepFolder::is_one(folder); }

int resume_sweep(ResumeArguments const& arguments) {
  return run_alone(SweepPlan::resumed(arguments.folder), arguments.jobs,
                   {.quiet = arguments.quiet, .resume = true});
}

}  // namespace actio::app
