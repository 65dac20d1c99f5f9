// What others do with the files of a run while it goes on: they look at them, lock them, take them away, and
// change those that its scene reads.
#include <boost/test/unit_test.hpp>

#include <sys/file.h>
#include <sys/stat.h>

#include <atomic>
#include <fstream>
#include <set>

#include "process.hpp"
#include "sphere_scene.hpp"

BOOST_AUTO_TEST_SUITE(other_hands)

namespace {

using namespace command;
namespace fs = std::filesystem;

/// A flow with a snapshot of every format now and then.
Sphere flow(std::string const& until) {
  Sphere out;
  out.n = "24", out.until = until, out.every = "0.5";
  out.more = "formats = [\"csv\", \"hdf5\", \"netcdf\"]\nsnapshots = [\"u\"]\nsnapshot_every = 0.5\n";
  return out;
}
/// A fluid with frames, tables and grids.
std::string const fluid =
    "[system]\nkind = \"barotropic_fluid\"\n"
    "mesh = { shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [9, 8], periodic = [true, true] }\n"
    "material = { name = \"polytropic_gas\", K = 1, gamma = 1.4 }\n[initial]\n"
    "placement = [\"X + 0.02*sin(2*pi*X)\", \"Y\"]\n[method]\nstep = 0.01\n[run]\nuntil = 1e5\n"
    "every = 0.1\n[output]\nquantities = [\"energy\"]\nformats = [\"csv\", \"hdf5\", \"vtu\"]\n"
    "snapshots = [\"pressure\"]\nsnapshot_at = [0, 0.1, 0.2]\n";

/// Keeps a lock on every file of a folder, as readers of HDF5 do, and takes one of those that come, until it
/// is gone.
class Locks {
 public:
  Locks(std::string folder, int kind)
      : folder_(std::move(folder)), keeper_([this, kind] {
          while (!done_) lock_all(kind), sleep_for(0.002);
        }) {}
  ~Locks() {
    done_ = true;
    keeper_.join();
    for (int const file : files_) ::close(file);
  }

 private:
  void lock_all(int kind) {
    std::error_code none;
    for (fs::recursive_directory_iterator it(folder_, none), end; !none && it != end; it.increment(none)) {
      if (!it->is_regular_file(none)) continue;
      int const file = ::open(it->path().c_str(), O_RDONLY | O_CLOEXEC);
      if (file < 0) continue;
      // One of another name or another file each: the lock of before stays where it is.
      struct stat now;
      bool const ours = ::fstat(file, &now) == 0 && !known_.insert({now.st_ino, now.st_ctim.tv_nsec}).second;
      if (ours || ::flock(file, kind | LOCK_NB) != 0 || files_.size() > 500)
        ::close(file);
      else
        files_.push_back(file);
    }
  }
  std::string folder_;
  std::set<std::pair<ino_t, long>> known_;
  std::vector<int> files_;
  std::atomic<bool> done_ = false;
  std::thread keeper_;
};

void check_same(std::string const& one, std::string const& other) {
  auto const same = shell("diff -r -x summary.json -x checkpoint -x .actio " + one + " " + other);
  BOOST_TEST(same.status == 0, same.out);
}
/// Times of all snapshots, as NetCDF has them; read past the locks, which are the test's own.
std::size_t times_in(std::string const& file) {
  auto const told = shell("HDF5_USE_FILE_LOCKING=FALSE h5dump -H -d /time " + file);
  BOOST_TEST(told.status == 0, told.err);
  auto const at = told.out.find("SIMPLE { ( ");
  return at == std::string::npos ? 0 : std::stoul(told.out.substr(at + 11));
}

/// Two triangles.
std::string mesh(std::string const& corner) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 " + corner +
         " 0\n4 0 1 0\n$EndNodes\n$Elements\n2\n1 2 2 0 1 1 2 3\n2 2 2 0 1 1 3 4\n$EndElements\n";
}
std::string const on_mesh =
    "[system]\nkind = \"elastic_body\"\nmesh = { file = \"m.msh\" }\n"
    "material = { name = \"neo_hookean\", mu = 1, kappa = 2 }\n[initial]\n"
    "velocity = [\"0.1*X\", \"-0.1*Y\"]\n[method]\nstep = 0.05\n[run]\nuntil = 200000\nevery = 100\n"
    "[output]\nquantities = [\"energy\", \"momentum\"]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(who_keeps_every_file_open_and_locked_leaves_run_and_resume_as_they_are) {
  Folder const folder;
  std::string const scene = folder.write("sphere.toml", flow("40").text()), alone = folder / "alone",
                    watched = folder / "watched";
  BOOST_REQUIRE(actio({"run", scene, "--out", alone}).status == 0);
  for (int const kind : {LOCK_SH, LOCK_EX}) {
    Process run({"run", scene, "--out", watched, "--force", "--quiet"});
    Locks const locks(watched, kind);
    BOOST_REQUIRE(appears(watched + "/snapshots/000005.csv"));
    run.send(SIGINT);
    auto const interrupted = run.wait();
    BOOST_TEST(interrupted.status == 130, interrupted.err);
    auto const resumed = actio({"resume", watched, "--quiet"});
    BOOST_TEST(resumed.status == 0, resumed.err);
    check_same(alone, watched);
    BOOST_TEST(times_in(watched + "/snapshots/fields.nc") == 81u);
  }
}

BOOST_AUTO_TEST_CASE(who_looks_while_the_run_goes_on_finds_whole_files_with_ever_more_snapshots) {
  Folder const folder;
  std::string const scene = folder.write("sphere.toml", flow("3000").text()), out = folder / "out",
                    fields = out + "/snapshots/fields.nc";
  ::setenv("ACTIO_CHECKPOINT_SECONDS", "0.001", 1);  // files are made anew thirty checkpoints apart
  Process run({"run", scene, "--out", out, "--quiet"});
  ::unsetenv("ACTIO_CHECKPOINT_SECONDS");
  BOOST_REQUIRE(appears(fields));
  std::size_t last = 0, looks = 0;
  // A file that takes long to make is made less often.
  for (; looks < 25 || (last < 2 && looks < 3000); ++looks) {
    sleep_for(0.01);
    std::size_t const now = times_in(fields);
    BOOST_TEST(now >= last);
    last = now;
  }
  BOOST_TEST(last > 1u);
  // A look that began before sees what there was then, however long it lasts.
  std::ifstream held(fields, std::ios::binary);
  std::string const before = contents(fields);
  sleep_for(0.5);
  std::string const then{std::istreambuf_iterator<char>(held), {}};
  BOOST_TEST((before.size() == then.size() || contents(fields).size() > then.size()));
  // Files that were made are made again when they are taken away.
  fs::remove(fields), fs::remove(out + "/series.h5");
  run.send(SIGINT);
  BOOST_TEST(run.wait().status == 130);
  std::string const times = contents(out + "/snapshots/times.csv");
  BOOST_TEST(times_in(fields) + 1 == static_cast<std::size_t>(std::count(times.begin(), times.end(), '\n')));
}

BOOST_AUTO_TEST_CASE(a_file_that_is_taken_away_ends_the_run_which_says_which_and_what_is_lost) {
  struct Taken {
    std::string scene, file, says;
    int resumes;  // the status of `resume` afterwards
    std::string then;
  };
  std::string const sphere = flow("3000").text();
  for (auto const& [text, file, says, resumes, then] :
       std::vector<Taken>{{sphere, "series.csv", "was removed", 4, "is not there any more"},
                          {sphere, "snapshots/times.csv", "was removed", 4, "is not there any more"},
                          {sphere, "snapshots/000001.harmonics.csv", "not in", 4, "cannot be read"},
                          {sphere, "snapshots/000001.csv", "not in", 130, ""},
                          {fluid, "snapshots/000001.csv", "not in", 4, "cannot be read"}}) {
    Folder const folder;
    std::string const scene = folder.write("scene.toml", text), out = folder / "out";
    Process run({"run", scene, "--out", out, "--quiet"});
    BOOST_REQUIRE(appears(out + "/snapshots/000002.csv"));
    sleep_for(0.1);
    fs::remove(out + "/" + file);
    auto const ended = run.wait();
    BOOST_TEST(ended.status == 4, file);
    BOOST_TEST(has(ended.err, file), ended.err);
    BOOST_TEST(has(ended.err, says), ended.err);
    BOOST_TEST(has(contents(out + "/summary.json"), "\"status\": \"failed\""));
    Process again({"resume", out, "--quiet"});
    sleep_for(1);
    again.send(SIGINT);
    auto const resumed = again.wait();
    BOOST_TEST(resumed.status == resumes, file << ": " << resumed.err);
    BOOST_TEST(has(resumed.err, then), resumed.err);
  }
}

BOOST_AUTO_TEST_CASE(a_table_that_is_gone_after_the_end_is_missed) {
  Folder const folder;
  std::string const scene = folder.write("apophis.toml", apophis()), out = folder / "apophis";
  BOOST_REQUIRE(actio({"run", scene}).status == 0);
  fs::remove(out + "/series.csv");
  auto const outcome = actio({"resume", out});
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(outcome.err == out +
                                "/series.csv: is not there any more, and the run is finished; a run of its "
                                "scene.toml into another folder writes it again\n");
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_taken_away_is_written_again) {
  Folder const folder;
  std::string const scene = folder.write("long.toml", apophis({{"order", "2"}, {"until", "10000000.0"}})),
                    out = folder / "long";
  Process run({"run", scene, "--quiet"});
  BOOST_REQUIRE(appears(out + "/checkpoint"));
  std::string const written = contents(out + "/scene.toml");
  fs::remove(out + "/scene.toml");
  BOOST_TEST(appears(out + "/scene.toml"));
  run.send(SIGINT);
  BOOST_TEST(run.wait().status == 130);
  BOOST_TEST(contents(out + "/scene.toml") == written);
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_with_the_mesh_that_it_began_with_or_not_at_all) {
  Folder const folder;
  folder.write("m.msh", mesh("1 1"));
  std::string const scene = folder.write("body.toml", on_mesh), out = folder / "body";
  BOOST_REQUIRE(actio({"run", scene, "--out", folder / "whole"}).status == 0);
  Process run({"run", scene, "--quiet"});
  BOOST_REQUIRE(appears(out + "/checkpoint"));
  run.send(SIGINT);
  BOOST_REQUIRE(run.wait().status == 130);
  for (std::string const& changed : {mesh("1.05 1"), std::string("no mesh at all")}) {
    folder.write("m.msh", changed);
    auto const refused = actio({"resume", out});
    BOOST_TEST(refused.status == 2);
    BOOST_TEST(refused.err.starts_with(folder / "m.msh" + ": has changed since the scene was read with it"),
               refused.err);
  }
  fs::remove(folder / "m.msh");
  auto const gone = actio({"resume", out});
  BOOST_TEST(gone.status == 2);
  BOOST_TEST(gone.err.starts_with(folder / "m.msh" + ": cannot be read any more"), gone.err);
  folder.write("m.msh", mesh("1 1"));
  BOOST_TEST(actio({"resume", out}).status == 0);
  BOOST_TEST((contents(out + "/series.csv") == contents(folder / "whole/series.csv")));
}

BOOST_AUTO_TEST_CASE(members_of_a_sweep_have_the_same_mesh_or_are_not_run) {
  Folder const folder;
  folder.write("m.msh", mesh("1 1"));
  std::string const scene = folder.write("body.toml", on_mesh), out = folder / "sweep";
  std::vector<std::string> const arguments{"sweep",  scene, "--over", "system.material.mu=1,1.5",
                                           "--jobs", "1"};
  auto with_out = [&](std::string const& name) {
    auto all = arguments;
    all.insert(all.end(), {"--out", folder / name});
    return all;
  };
  BOOST_REQUIRE(actio(with_out("whole")).status == 0);
  Process sweep(with_out("sweep"));
  BOOST_REQUIRE(appears(out + "/000000/checkpoint"));
  folder.write("m.msh", mesh("1.05 1"));
  auto const ended = sweep.wait();
  BOOST_TEST(ended.status == 2, ended.err);
  BOOST_TEST(has(ended.err, folder / "m.msh" + ": has changed since the scene was read with it"), ended.err);
  auto const refused = actio({"resume", out});
  BOOST_TEST(refused.status == 2);
  BOOST_TEST(refused.err.starts_with(folder / "m.msh" + ": has changed"), refused.err);
  folder.write("m.msh", mesh("1 1"));
  auto const resumed = actio({"resume", out});
  BOOST_TEST(resumed.status == 0, resumed.err);
  for (char const* member : {"/000000/series.csv", "/000001/series.csv"})
    BOOST_TEST((contents(out + member) == contents(folder / "whole" + member)), member);
}

BOOST_AUTO_TEST_SUITE_END()
