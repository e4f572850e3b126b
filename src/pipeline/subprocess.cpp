#include "pipeline/subprocess.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

namespace shatterpave::pipeline {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds patience{150};  // between asking a program to end and ending it: whoever stops this one waits meanwhile
constexpr milliseconds pause{10};

[[noreturn]] void throw_errno(int error, const char* what) { throw std::system_error(error, std::generic_category(), what); }

// A pipe whose ends are closed when they are no longer needed.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw_errno(errno, "cannot make a pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_write_end() { close_end(1); }

 private:
  void close_end(std::size_t i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

// What posix_spawn wants to know, with an end to its life.
class SpawnSettings {
 public:
  SpawnSettings(const Subprocess& subprocess, const Pipe& pipe) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, pipe.write_end(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, pipe.write_end(), STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions_, subprocess.folder.c_str());
    posix_spawnattr_init(&attributes_);
    // A group of its own: Ctrl-C reaches this program alone, which then ends the other and tidies up.
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

std::vector<std::string> environment_of(const Subprocess& subprocess) {
  const auto name = [](std::string_view variable) { return variable.substr(0, variable.find('=')); };
  std::vector<std::string> result = subprocess.environment;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const auto same = [&](std::string_view other) { return name(other) == name(*variable); };
    if (std::ranges::none_of(subprocess.environment, same) && std::ranges::none_of(subprocess.without, same)) {
      result.emplace_back(*variable);
    }
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

// Reads what is there, waiting a little; false at the end.
bool read_some(int descriptor, const std::function<void(std::string_view)>& output) {
  pollfd waiting{descriptor, POLLIN, 0};
  const int ready = ::poll(&waiting, 1, 50);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return true;
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return true;
  if (count <= 0) return false;
  output(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  return true;
}

int waited(pid_t process, rusage* used = nullptr) {
  int status = 0;
  while (::wait4(process, &status, 0, used) < 0 && errno == EINTR) continue;
  return status;
}

double seconds_of(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

// The program, and what is in its group: it may be a script that has started the real one.
void end_process(pid_t process) {
  ::kill(-process, SIGTERM);
  bool ended = false;
  for (milliseconds spent{0}; spent < patience && !ended; spent += pause) {
    std::this_thread::sleep_for(pause);
    siginfo_t gone{};  // not waited for yet, so that the group's number is not given to another
    ended = ::waitid(P_PID, static_cast<id_t>(process), &gone, WEXITED | WNOHANG | WNOWAIT) == 0 && gone.si_pid == process;
  }
  ::kill(-process, SIGKILL);
  waited(process);
}

}  // namespace

Ending run(const Subprocess& subprocess, const std::function<void(std::string_view)>& output, const Cancelled& cancelled) {
  std::vector<std::string> arguments = subprocess.arguments;
  std::vector<std::string> environment = environment_of(subprocess);
  Pipe pipe;
  pid_t process = 0;
  {
    const SpawnSettings settings(subprocess, pipe);
    const int error = ::posix_spawnp(&process, arguments.front().c_str(), settings.actions(), settings.attributes(),
                                     pointers(arguments).data(), pointers(environment).data());
    if (error == ENOENT || error == EACCES) return {.found = false};
    if (error != 0) throw_errno(error, "cannot start another program");
  }
  pipe.close_write_end();
  try {
    while (read_some(pipe.read_end(), output)) {
      if (cancelled && cancelled()) throw Interrupted();
    }
  } catch (...) {
    end_process(process);
    throw;
  }
  rusage used{};
  const int status = waited(process, &used);
  if (cancelled && cancelled()) throw Interrupted();
  Ending ending;
  ending.processor_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  ending.most_memory_kib = used.ru_maxrss;
  if (WIFSIGNALED(status)) {
    ending.signal = WTERMSIG(status);
  } else {
    ending.status = WEXITSTATUS(status);
  }
  return ending;
}

}  // namespace shatterpave::pipeline
