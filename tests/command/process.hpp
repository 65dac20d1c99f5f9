// The built command on its way: started, sent signals, waited for.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <thread>

#include "command.hpp"

namespace command {

/// `actio` with these arguments, as a process of its own with a checkpoint every few hundredths of a second,
/// or as often as ACTIO_CHECKPOINT_SECONDS says.
class Process {
 public:
  /// @param disk  the most bytes that a file of it may have, which is a disk that is full then
  explicit Process(std::vector<std::string> const& arguments, rlim_t disk = RLIM_INFINITY) {
    id_ = ::fork();
    if (id_ < 0) throw std::runtime_error("no process for the test");
    if (id_ == 0) become(arguments, disk);
  }
  ~Process() {
    if (id_ > 0) ::kill(id_, SIGKILL), ::waitpid(id_, nullptr, 0);
  }
  Process(Process const&) = delete;
  Process& operator=(Process const&) = delete;

  void send(int signal) const { ::kill(id_, signal); }
  /// Waits for the end.
  Outcome wait() {
    int status = 0;
    ::waitpid(id_, &status, 0);
    id_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(folder_ / "out"),
            contents(folder_ / "err")};
  }

 private:
  [[noreturn]] void become(std::vector<std::string> const& arguments, rlim_t disk) const {
    std::vector<char*> words{const_cast<char*>(ACTIO_COMMAND)};
    for (auto const& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
    words.push_back(nullptr);
    ::setenv("ACTIO_CHECKPOINT_SECONDS", "0.03", 0);
    rlimit const most{disk, disk};
    if (disk != RLIM_INFINITY) ::setrlimit(RLIMIT_FSIZE, &most);
    ::dup2(::open((folder_ / "out").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600), STDOUT_FILENO);
    ::dup2(::open((folder_ / "err").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600), STDERR_FILENO);
    ::execv(ACTIO_COMMAND, words.data());
    ::_exit(127);
  }

  Folder folder_;
  pid_t id_;
};

inline void sleep_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// What a run of the command took. The pages of memory that it touched, those of processes that it started
/// included, are counted: the same on a machine that has much else to do.
struct Cost {
  int status;
  long pages;
  double work;  ///< seconds of the processor
  double peak_megabytes;
};
inline Cost cost(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), ACTIO_COMMAND);
  std::vector<char*> words;
  for (auto& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  pid_t const child = ::fork();
  if (child == 0) {
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  auto const seconds = [](timeval const& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, usage.ru_minflt,
          seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024};
}

/// Waits until a file is there; false where that takes too long.
inline bool appears(std::string const& path, double seconds = 20) {
  for (; seconds > 0 && !std::filesystem::exists(path); seconds -= 0.005) sleep_for(0.005);
  return std::filesystem::exists(path);
}

/// summary.json without what differs from run to run.
inline std::string summary_without_times(std::string const& folder) {
  std::string const text = contents(folder + "/summary.json");
  std::string out;
  for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    std::string const line = text.substr(at, end - at);
    if (line.find("\"wall_seconds\"") == std::string::npos) out += line + "\n";
  }
  return out;
}

/// ACTIO_SEED, or another one every time.
inline unsigned seed() {
  char const* const given = std::getenv("ACTIO_SEED");
  return given ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
}

/// What came of a run that was killed again and again.
struct Killed {
  int in_the_middle = 0;  ///< how many kills met it running
  int status = -1;        ///< of the last resumption, which nobody killed
  std::string err;
};

/// Runs a scene into `out`, kills it that often at random instants, and resumes it each time; then lets it
/// end.
/// @param seconds  that the unbroken run takes: the kills are spread over them
inline Killed run_with_kills(std::string const& scene, std::string const& out, int kills, double seconds,
                             std::mt19937& random) {
  Killed killed;
  std::uniform_real_distribution<double> instant(0, 1.5 * seconds / kills);
  bool begun = false;
  for (int k = 0; k < kills; ++k) {
    Process process(begun ? std::vector<std::string>{"resume", out, "--quiet"}
                          : std::vector<std::string>{"run", scene, "--out", out, "--quiet", "--force"});
    sleep_for(instant(random));
    process.send(SIGKILL);
    if (process.wait().status == 128 + SIGKILL) ++killed.in_the_middle;
    begun = std::filesystem::exists(out + "/scene.toml");
  }
  Process last(begun ? std::vector<std::string>{"resume", out, "--quiet"}
                     : std::vector<std::string>{"run", scene, "--out", out, "--quiet", "--force"});
  Outcome const outcome = last.wait();
  killed.status = outcome.status, killed.err = outcome.err;
  return killed;
}

}  // namespace command
