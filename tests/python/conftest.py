"""Under the address sanitizer, a test run ends with a search for leaks."""

import ctypes
import gc

import pytest


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    try:
        found_leaks = ctypes.CDLL(None).__lsan_do_recoverable_leak_check
    except (AttributeError, OSError):
        return
    gc.collect()
    if found_leaks():
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
