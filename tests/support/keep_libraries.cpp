// Loaded before the tests that run under the address sanitizer: no library is unloaded. The sanitizer looks for leaks when
// the program ends, and could not name a driver that is gone by then; tests/lsan_suppressions.txt does.
extern "C" int dlclose(void *)
{
    return 0;
}
