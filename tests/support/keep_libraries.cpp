// Preloaded for tests under the address sanitizer, for its leak search at the end of a program. It
// keeps all libraries loaded: the sanitizer could not name an unloaded driver, which
// tests/lsan_suppressions.txt does. It also waits for ending threads, with which the search itself
// crashes: QThread::wait returns a little before the thread is gone.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>

#include <dlfcn.h>

namespace {

using Main = int (*)(int, char **, char **);
Main mainOfProgram = nullptr;

/// Returns whether all other threads sleep.
bool doOthersSleep()
{
    int awake = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator task("/proc/self/task", error), end; !error && task != end;
         task.increment(error)) {
        std::ifstream file(task->path() / "stat");
        std::string line;
        std::getline(file, line); // "12 (name) S …"
        const std::size_t name = line.rfind(')');
        awake += name != std::string::npos && line.compare(name, 3, ") S") != 0 ? 1 : 0;
    }
    return awake <= 1;
}

void waitForQuiet()
{
    constexpr int kInARow = 5, kMost = 1000;
    int quiet = 0;
    for (int i = 0; i < kMost && quiet < kInARow; ++i) {
        quiet = doOthersSleep() ? quiet + 1 : 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Registers the wait first, so that exit handlers registered later, such as Qt's for its threads,
/// run before it. The search runs after it.
int quietMain(int count, char **arguments, char **environment)
{
    std::atexit(waitForQuiet);
    return mainOfProgram(count, arguments, environment);
}

} // namespace

extern "C" int dlclose(void *)
{
    return 0;
}

// Called by a program's first instructions.
extern "C" int __libc_start_main(Main main, int count, char **arguments, void (*initialize)(), void (*finalize)(),
                                 void (*finalizeLoader)(), void *stackEnd)
{
    using Start = int (*)(Main, int, char **, void (*)(), void (*)(), void (*)(), void *);
    mainOfProgram = main;
    const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(quietMain, count, arguments, initialize, finalize, finalizeLoader, stackEnd);
}
