"""Under the address sanitizer, a test run ends with a search for leaks."""

import ctypes
import gc
import importlib
import os

import pytest

try:
    _sanitizer = ctypes.CDLL(None)
    _found_leaks = _sanitizer.__lsan_do_recoverable_leak_check
except (AttributeError, OSError):
    _found_leaks = None
else:
    # Other packages' modules keep memory that is allocated once. What is allocated here is no leak.
    _sanitizer.__lsan_disable()
    for _name in ("matplotlib.pyplot", "dask.array", "distributed"):
        try:
            importlib.import_module(_name)
        except ImportError:
            pass
    _sanitizer.__lsan_enable()


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    """Looks for leaks while Python still holds what it keeps until the process ends."""
    if _found_leaks:
        gc.collect()
        if _found_leaks():
            session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.fixture
def unproject_command():
    """The command whose digits the module has."""
    command = os.environ.get("UNPROJECT_COMMAND")
    if not command:
        pytest.skip("UNPROJECT_COMMAND does not name the command")
    return command
