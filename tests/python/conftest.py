import os

import pytest


@pytest.fixture
def unproject_command():
    """The command whose digits the module has."""
    command = os.environ.get("UNPROJECT_COMMAND")
    if not command:
        pytest.skip("UNPROJECT_COMMAND does not name the command")
    return command
