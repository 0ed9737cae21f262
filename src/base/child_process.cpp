// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/error.h"

extern char** environ;

namespace mq {

namespace {

/// Milliseconds between two checks for cancellation.
constexpr int kLookMilliseconds = 20;

/// Writing to a program that has ended must be an error, not a signal to the whole process.
class NoBrokenPipeSignal {
  public:
    NoBrokenPipeSignal() {
        sigset_t pipe_only;
        sigemptyset(&pipe_only);
        sigaddset(&pipe_only, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_only, &before_);
    }
    ~NoBrokenPipeSignal() {
        // A signal that came meanwhile is removed before the old mask is restored.
        sigset_t pipe_only;
        sigemptyset(&pipe_only);
        sigaddset(&pipe_only, SIGPIPE);
        const timespec now{0, 0};
        while (sigtimedwait(&pipe_only, nullptr, &now) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
    NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;

  private:
    sigset_t before_{};
};

}  // namespace

ChildProcess::ChildProcess(const std::string& program) {
    std::array<int, 2> in{-1, -1};
    std::array<int, 2> out{-1, -1};
    if (pipe2(in.data(), O_CLOEXEC) != 0) {
        throw IoError("no pipe to '" + program + "': " + std::strerror(errno));
    }
    if (pipe2(out.data(), O_CLOEXEC) != 0) {
        close(in[0]);
        close(in[1]);
        throw IoError("no pipe from '" + program + "': " + std::strerror(errno));
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    std::string name = program;
    std::array<char*, 2> arguments{name.data(), nullptr};
    const int failed = posix_spawn(&pid_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(in[0]);
    close(out[1]);
    to_ = in[1];
    from_ = out[0];
    if (failed != 0) {
        pid_ = -1;
        close_end(to_);
        close_end(from_);
        throw IoError("cannot start '" + program + "': " + std::strerror(failed) + "; build the project again");
    }
    fcntl(to_, F_SETFL, O_NONBLOCK);
    fcntl(from_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
    close_end(to_);
    close_end(from_);
    if (pid_ > 0) {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
}

void ChildProcess::close_end(int& end) {
    if (end >= 0) {
        close(end);
        end = -1;
    }
}

std::string ChildProcess::exchange(const std::string& input, const Progress& progress) {
    const NoBrokenPipeSignal guard;
    std::string output;
    std::size_t sent = 0;
    std::array<char, 65536> buffer;
    while (from_ >= 0) {
        progress.check();
        std::array<pollfd, 2> ends{{{from_, POLLIN, 0}, {to_, POLLOUT, 0}}};
        poll(ends.data(), to_ >= 0 ? 2 : 1, kLookMilliseconds);
        if (to_ >= 0 && ends[1].revents != 0) {
            const ssize_t n = ::write(to_, input.data() + sent, input.size() - sent);
            sent += n > 0 ? static_cast<std::size_t>(n) : 0;
            if ((n < 0 && errno != EAGAIN) || sent == input.size()) {
                close_end(to_);
            }
        }
        if (ends[0].revents != 0) {
            const ssize_t n = ::read(from_, buffer.data(), buffer.size());
            if (n > 0) {
                output.append(buffer.data(), static_cast<std::size_t>(n));
            } else if (n == 0 || errno != EAGAIN) {
                close_end(from_);
            }
        }
    }
    return output;
}

ChildProcess::End ChildProcess::end() {
    close_end(to_);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    if (WIFSIGNALED(status)) {
        const bool too_long = WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL;
        return {too_long ? "it did not come to an end" : "it crashed", too_long};
    }
    return {WEXITSTATUS(status) == 0 ? "" : "it ended with status " + std::to_string(WEXITSTATUS(status)), false};
}

}  // namespace mq
