#include <algorithm>
#include <thread>

#include "actio/scene/interrupt.hpp"
#include "actio/scene/sweep_run.hpp"
#include "app/sweep_arguments.hpp"

namespace actio::app {

using namespace scene;

int sweep(SweepArguments const& arguments) {
  open_standard_streams();
  SweepPlan const plan = sweep_plan(arguments);
  long const jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1u, std::thread::hardware_concurrency());
  listen_for_interrupts();
  SweepCrew crew([&](MemberTask task, long member) { return work_on_member(plan, task, member, SweepCrew::told_to_stop); }, static_cast<int>(std::min(jobs, plan.size())));
  SweepSharing alone;
  return run_sweep(plan, crew, alone, {arguments.quiet, arguments.force});
}

}  // namespace actio::app
