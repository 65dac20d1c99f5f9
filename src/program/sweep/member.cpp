#include "program/sweep/member.hpp"

#include <optional>

#include "program/pictures/pictures.hpp"
#include "program/run/run_folder.hpp"
#include "program/sweep/folder.hpp"

namespace actio::scene {
namespace {

template <class T, class RememberOne>
void remember(CheckpointStream& stream, std::vector<T>& list, RememberOne const& one) {
  std::size_t size = list.size();
  stream(size);
  if (stream.reading() && size > stream.bytes().size()) throw Error("the result of a member is damaged");
  list.resize(size);
  for (T& item : list) one(item);
}
void remember(CheckpointStream& stream, MemberResult& result) {
  stream(result.member, result.status, result.rows, result.bytes, result.steps, result.seconds,
         result.last_row);
  remember(stream, result.message);
  remember(stream, result.drift,
           [&](Drift::Entry& entry) { remember(stream, entry.name), stream(entry.relative); });
  remember(stream, result.error, [&](ErrorEstimate::Entry& entry) {
    remember(stream, entry.name), remember(stream, entry.said), stream(entry.error);
  });
  remember(stream, result.columns, [&](std::string& name) { remember(stream, name); });
  remember(stream, result.inputs), stream(result.input_changed);
}

/// What a run would refuse only after it has begun.
void check_member(Scene const& scene) {
  if (!scene.simulation.exact)
    StepsToRows(scene.schedule, scene.simulation.step, scene.file.section("method"));
  refuse_without_step(scene);
}

/// What the files of the rows will take: a number has 8 bytes, and about 20 where it is written with its
/// digits.
double bytes_of(Scene const& scene) {
  double each = 0;
  for (auto const& format : scene.formats) each += format == "csv" ? 20 : 8;
  return each * static_cast<double>(scene.schedule.rows()) *
         static_cast<double>(1 + scene.simulation.quantities.row_size());
}

/// Goes on from the checkpoint in the folder; where that cannot be, the member starts anew.
std::optional<RunReport> go_on(SweepPlan const& plan, Scene& scene, RunFolder const& folder, long member,
                               RunOptions const& options) {
  if (!folder.begun()) return {};
  try {
    return run_scene(scene, folder.path(), true, options);
  } catch (FileError const&) {
    scene = plan.read(member, {true, options.stop});
    return {};
  }
}

void run_member(SweepPlan const& plan, Scene& scene, std::function<bool()> const& stop,
                MemberResult& result) {
  RunFolder const folder = RunFolder::of_member(plan.folder(result.member));
  RunOptions options;
  // The sweep sees to it that all is on the disk, from time to time and at its end.
  options.quiet = true, options.durable = false, options.checkpoint_interval = checkpoint_interval(),
  options.stop = stop;
  std::optional<RunReport> before = go_on(plan, scene, folder, result.member, options);
  if (!before) folder.begin_member(files_of_run(scene));
  RunReport const report = before ? *before : run_scene(scene, folder.path(), false, options);
  if (scene.plots && report.ending == Ending::done) draw_pictures(scene, folder.path(), true);
  result.status = static_cast<int>(report.ending), result.message = report.message;
  result.steps = report.steps, result.seconds = report.seconds;
  result.drift = report.drift, result.error = report.error, result.last_row = report.last_row;
  result.columns = {"t"};
  for (auto const& name : scene.simulation.quantities.columns()) result.columns.push_back(name);
}

}  // namespace

std::string MemberResult::packed() const {
  CheckpointStream stream;
  MemberResult copy = *this;
  remember(stream, copy);
  return stream.bytes();
}
MemberResult MemberResult::unpacked(std::string const& bytes) {
  MemberResult out;
  CheckpointStream stream(bytes);
  remember(stream, out);
  stream.end();
  return out;
}

MemberResult work_on_member(SweepPlan const& plan, MemberTask task, long member,
                            std::function<bool()> const& stop) {
  MemberResult result;
  result.member = member;
  auto const failed = [&](Ending ending, std::exception const& error) {
    result.status = static_cast<int>(ending), result.message = error.what();
  };
  try {
    Scene scene = plan.read(member, {task == MemberTask::run, stop});
    check_member(scene);
    if (task == MemberTask::check)
      result.inputs = scene.file.inputs();
    else if (!scene.file.inputs().empty())
      refuse_changed(SweepFolder::inputs(plan.folder()), scene.file.inputs());
    result.rows = scene.schedule.rows(), result.bytes = bytes_of(scene);
    if (task == MemberTask::run) run_member(plan, scene, stop, result);
  } catch (SceneError const& error) {
    failed(Ending::scene_wrong, error);
    result.input_changed = dynamic_cast<InputChanged const*>(&error) != nullptr;
  } catch (FileError const& error) {
    failed(Ending::file_failed, error);
  } catch (Stopped const& error) {
    failed(Ending::interrupted, error);
  } catch (std::exception const& error) {
    failed(Ending::numerics_failed, error);
  }
  return result;
}

}  // namespace actio::scene
