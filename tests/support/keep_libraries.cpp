// Loaded before the tests that run under the address sanitizer, whose search for leaks at the end of a program needs two
// things. No library is unloaded: the sanitizer could not name a driver that is gone, and tests/lsan_suppressions.txt does.
// And no thread is just ending, where the search itself crashes: QThread::wait returns a little before the thread is gone.
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

/// Whether all threads but this one sleep.
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

/// What a program registers for its end after this, as Qt does to end its threads, comes before the wait; the search after it.
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

// What a program's first instructions call.
extern "C" int __libc_start_main(Main main, int count, char **arguments, void (*initialize)(), void (*finalize)(),
                                 void (*finalizeLoader)(), void *stackEnd)
{
    using Start = int (*)(Main, int, char **, void (*)(), void (*)(), void (*)(), void *);
    mainOfProgram = main;
    const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(quietMain, count, arguments, initialize, finalize, finalizeLoader, stackEnd);
}
