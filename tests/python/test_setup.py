import pytest
import unprojector as up


def test_a_wrong_value_is_named():
    with pytest.raises(ValueError, match="near is 0; it must be"):
        up.Setup.perspective(fovy=45, near=0, far=100, eye=(3, 2, 5), center=(0, 0, 0), size=(800, 600))
