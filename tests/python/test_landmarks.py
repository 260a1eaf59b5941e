import subprocess
import warnings

import numpy as np
import pytest
import unprojector as up

NAMES = ["nasion", "bregma ä 前囟", "left, eye"]
POINTS = np.array([[1.25, -2.5, 0.1], [np.nan] * 3, [1e-5, 12345.678, -3]])
FORMATS = ["csv", "pp", "mrk.json", "fcsv", "pts", "tps", "nts"]


def write(path, *arguments):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return up.write_landmarks(path, *arguments)


@pytest.mark.parametrize("suffix", FORMATS)
def test_points_come_back_from_every_format(suffix, tmp_path):
    file = tmp_path / f"skull.{suffix}"
    notes = write(file, NAMES, POINTS)
    read = up.read_landmarks(file)
    assert np.allclose(read.points, POINTS, rtol=1e-15, atol=0, equal_nan=True)
    if suffix in ("csv", "pp", "mrk.json"):
        assert read.names == NAMES
    else:
        assert suffix in ("pts", "tps", "nts", "fcsv")
    assert all(str(note).startswith(file.as_posix()) for note in notes)


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("source", ["csv", "mrk.json"])
def test_files_are_those_of_the_command(source, suffix, tmp_path, unproject_command):
    given = tmp_path / f"skull.{source}"
    write(given, NAMES, POINTS)
    notes = write(tmp_path / f"module.{suffix}", up.read_landmarks(given))
    result = subprocess.run(
        [unproject_command, "landmarks", str(given), str(tmp_path / f"command.{suffix}")], capture_output=True, text=True, encoding="utf-8"
    )
    assert (tmp_path / f"module.{suffix}").read_bytes() == (tmp_path / f"command.{suffix}").read_bytes()
    said = [line.replace("command.", "module.") for line in result.stderr.splitlines() if "command." in line]
    assert sorted(notes) == sorted(said)


def test_what_a_format_cannot_hold_is_a_warning(tmp_path):
    file = tmp_path / "skull.tps"
    with pytest.warns(UserWarning, match="name") as caught:
        notes = up.write_landmarks(file, NAMES, POINTS)
    assert [str(w.message) for w in caught] == notes and notes


def test_names_find_points(tmp_path):
    file = tmp_path / "ä 标志.csv"
    write(file, NAMES, POINTS)
    read = up.read_landmarks(str(file))
    assert np.array_equal(read["nasion"], POINTS[0]) and np.isnan(read[NAMES[1]]).all()
    assert len(read) == 3 and read.absence == ["", "not placed", ""]
    assert list(read) == NAMES and "nasion" in read and "lambda" not in read.specimens[0]
    assert repr(read) == "<Landmarks: 3 landmarks, 1 without a position>"
    with pytest.raises(KeyError, match="no landmark"):
        read["lambda"]


def test_several_specimens_are_not_mistaken_for_one(tmp_path):
    file = tmp_path / "all.tps"
    file.write_text("LM=2\n1 2\n3 4\nID=a\nLM=2\n5 6\n7 8\nID=b\n")
    read = up.read_landmarks(file)
    assert [s.name for s in read.specimens] == ["a", "b"]
    assert np.array_equal(read.specimens[1].points, [[5, 6, 0], [7, 8, 0]])
    assert any("z" in note for note in read.notes)
    with pytest.raises(ValueError, match="there are 2 specimens; take one from specimens"):
        read.points
    write(tmp_path / "one.csv", read.specimens[0])
    assert np.array_equal(up.read_landmarks(tmp_path / "one.csv").points, [[1, 2, 0], [3, 4, 0]])


def test_specimens_make_a_table(tmp_path):
    write(tmp_path / "a.csv", ["nasion", "bregma"], [[1, 2, 3], [4, 5, 6]])
    write(tmp_path / "b.csv", ["lambda", "nasion"], [[7, 8, 9], [np.nan] * 3])
    read = [up.read_landmarks(tmp_path / f"{name}.csv") for name in "ab"]
    specimens, names, points = up.landmark_table(read)
    assert len(specimens) == 2 and names == ["nasion", "bregma", "lambda"]
    nothing = [np.nan] * 3
    assert np.array_equal(points, [[[1, 2, 3], [4, 5, 6], nothing], [nothing, nothing, [7, 8, 9]]], equal_nan=True)
    write(tmp_path / "both.tps", read)
    again = up.read_landmarks(tmp_path / "both.tps")
    assert [len(s) for s in again.specimens] == [3, 3]
    assert np.array_equal(again.specimens[1].points[2], [7, 8, 9])
    assert up.landmark_table(read[0])[2].shape == (1, 2, 3)
    write(tmp_path / "c.csv", ["a", "a"], [[1, 2, 3], [4, 5, 6]])
    with pytest.raises(ValueError, match='specimen 1.* has the name "a" twice'):
        up.landmark_table([read[0], up.read_landmarks(tmp_path / "c.csv")])
    with pytest.raises(TypeError, match="'a.csv' is no Landmarks"):
        up.landmark_table("a.csv")


def test_wrong_files_and_arguments_are_named(tmp_path, unproject_command):
    with pytest.raises(FileNotFoundError, match="none.csv"):
        up.read_landmarks(tmp_path / "none.csv")
    with pytest.raises(ValueError, match="skull.doc"):
        (tmp_path / "skull.doc").write_text("")
        up.read_landmarks(tmp_path / "skull.doc")
    file = tmp_path / "bad.csv"
    file.write_text("name,x,y,z\na,1,2,3\nb,1,two,3\n")
    with pytest.raises(ValueError, match=r"bad.csv:3") as caught:
        up.read_landmarks(file)
    said = subprocess.run([unproject_command, "landmarks", str(file), str(tmp_path / "x.csv")], capture_output=True, text=True).stderr
    assert said.strip().endswith(str(caught.value).split("bad.csv", 1)[1])
    for arguments, kind, message in [
        ((["a"], POINTS), ValueError, "there are 1 names and 3 points"),
        ((NAMES, POINTS[:, :2]), ValueError, r"points has the shape \(3, 2\)"),
        ((["a"], [[1, np.nan, 2]]), ValueError, r"point 0 \(a\) has a coordinate that is not finite"),
        ((NAMES,), TypeError, "needs Landmarks"),
    ]:
        with pytest.raises(kind, match=message):
            up.write_landmarks(tmp_path / "out.csv", *arguments)
    with pytest.raises(ValueError, match="out.ljson"):
        up.write_landmarks(tmp_path / "out.ljson", NAMES, POINTS)
    with pytest.raises(OSError, match="nowhere"):
        up.write_landmarks(tmp_path / "nowhere" / "out.csv", NAMES, POINTS)
