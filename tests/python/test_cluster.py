"""The example for many machines: in processes of its own, as a user runs it."""

import os
import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import unprojector as up

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "resources" / "examples" / "cluster.py"
SIZE = (160, 120)
COUNT = 60


@pytest.fixture
def folder(tmp_path):
    """A stack of depth images and their setup."""
    setup = up.Setup.perspective(fovy=45, near=0.1, far=100, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)
    (tmp_path / "scene.json").write_text(setup.to_scene())
    depths = np.random.default_rng(1).uniform(0.5, 110, (COUNT, *SIZE[::-1])).astype(np.float32)
    np.save(tmp_path / "depth.npy", depths)
    return tmp_path


def command(folder, *words):
    return [sys.executable, str(EXAMPLE), "depth.npy", "--setups", "scene.json", "--depth-is", "z", *words]


def run(folder, *words, check=True, arguments=None):
    return subprocess.run(arguments or command(folder, *words), cwd=folder, check=check, capture_output=True, text=True, timeout=600)


def parts_of(folder):
    return {file.name: file.read_bytes() for file in sorted(folder.glob("*.npy"))}


@pytest.fixture
def distributed():
    return pytest.importorskip("distributed", reason="dask.distributed is not installed")


def children_of(process):
    """The processes that a process started, and theirs."""
    import psutil

    try:
        return psutil.Process(process.pid).children(recursive=True)
    except psutil.NoSuchProcess:
        return []


def test_a_single_run_gives_the_points_of_cloud(folder):
    printed = run(folder, "--out", "single", "--single").stdout
    assert printed.startswith(f"single: {COUNT} parts made, 0 were there;")
    setup = up.Setup.from_scene((folder / "scene.json").read_text())
    depths = np.load(folder / "depth.npy")
    for i in (0, 17, COUNT - 1):
        part = np.load(folder / "single" / f"{i:06}.npy")
        assert np.array_equal(part, setup.cloud(depths[i], depth_is="z", dtype=np.float32), equal_nan=True)


def test_a_killed_worker_changes_no_byte(folder, distributed):
    run(folder, "--out", "single", "--single")
    # A worker that waits before each part leaves time to kill one in the middle.
    slow = folder / "slow"
    slow.mkdir()
    (slow / "sitecustomize.py").write_text(
        "import os, time\n"
        "replace = os.replace\n"
        "def slowly(source, target):\n"
        "    if str(target).endswith('.npy'):\n"
        "        time.sleep(0.1)\n"
        "    replace(source, target)\n"
        "os.replace = slowly\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(slow), os.environ.get("PYTHONPATH", "")])}
    process = subprocess.Popen(
        command(folder, "--out", "two", "--workers", "2"), cwd=folder, env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )
    try:
        while len(parts_of(folder / "two")) < 5:
            assert process.poll() is None, process.communicate()
            time.sleep(0.02)
        workers = [child for child in children_of(process) if "spawn_main" in " ".join(child.cmdline())]
        assert len(workers) >= 2
        before = len(parts_of(folder / "two"))
        os.kill(workers[0].pid, signal.SIGKILL)
        assert before < COUNT // 2
        printed, errors = process.communicate(timeout=600)
    finally:
        process.kill()
    assert process.returncode == 0, errors
    assert f"two: {COUNT} parts made" in printed
    assert parts_of(folder / "two") == parts_of(folder / "single")


def test_what_is_missing_is_made_again(folder, distributed):
    run(folder, "--out", "parts", "--workers", "2")
    whole = parts_of(folder / "parts")
    times = {file.name: file.stat().st_mtime_ns for file in (folder / "parts").iterdir()}
    (folder / "parts" / "000003.npy").unlink()
    (folder / "parts" / "000007.npy").write_bytes(whole["000007.npy"][:1000])
    printed = run(folder, "--out", "parts", "--workers", "2").stdout
    assert f"parts: 2 parts made, {COUNT - 2} were there" in printed
    assert parts_of(folder / "parts") == whole
    changed = {file.name for file in (folder / "parts").glob("*.npy") if file.stat().st_mtime_ns != times[file.name]}
    assert changed == {"000003.npy", "000007.npy"}


def test_zarr_holds_the_same(folder, distributed):
    zarr = pytest.importorskip("zarr")
    run(folder, "--out", "single", "--single")
    run(folder, "--out", "points.zarr", "--workers", "2")
    array = zarr.open(str(folder / "points.zarr"), mode="r")
    assert array.shape == (COUNT, *SIZE[::-1], 3)
    for i in range(0, COUNT, 7):
        assert np.array_equal(array[i], np.load(folder / "single" / f"{i:06}.npy"), equal_nan=True)
    assert "0 parts made" in run(folder, "--out", "points.zarr", "--workers", "2").stdout


def test_files_and_cameras_are_taken_in_order(folder):
    depths = np.load(folder / "depth.npy")
    for i in range(3):
        millimetres = (1000 * depths[i]).clip(0, 65535).astype(">u2")
        (folder / f"ä {i}.pgm").write_bytes(b"P5 %d %d 65535\n" % SIZE + millimetres.tobytes())
    K, R, t = np.array([[150, 0, 79.5], [0, 150, 59.5], [0, 0, 1]]), np.stack([np.eye(3)] * 3), np.arange(9.0).reshape(3, 3)
    np.savez(folder / "cameras.npz", K=K, R=R, t=t)
    words = ["ä*.pgm", "--cameras", "cameras.npz", "--near", "0.1", "--far", "80", "--depth-is", "z",
             "--scale", "1000", "--out", "files", "--single", "--dtype", "float64"]
    run(folder, arguments=[sys.executable, str(EXAMPLE), *words])
    for i in range(3):
        setup = up.Setup.from_opencv(K, R[i], t[i], size=SIZE, near=0.1, far=80)
        expected = setup.cloud((1000 * depths[i]).clip(0, 65535).astype(np.uint16), depth_is="z", scale=1000)
        assert np.array_equal(np.load(folder / "files" / f"00000{i}.npy"), expected, equal_nan=True)


@pytest.mark.parametrize(
    "words, message",
    [
        (["none*.png", "--setups", "scene.json"], "none*.png: no file matches"),
        (["none.npy", "--setups", "scene.json"], "none.npy"),
        (["depth.npy", "--setups", "none.json"], "none.json"),
        (["depth.npy", "--setups", "scene.json", "scene.json"], f"there are {COUNT} images and 2 setups"),
        (["depth.npy", "--setups", "none*.json"], "none*.json: no file matches"),
        (["depth.npy", "--cameras", "depth.npy"], "--cameras needs --near and --far"),
        (["depth.npy", "--cameras", "depth.npy", "--near", "1", "--far", "2"], "depth.npy: there is no array K"),
    ],
)
def test_wrong_arguments_are_named(folder, words, message):
    arguments = [sys.executable, str(EXAMPLE), *words, "--depth-is", "z", "--out", "parts", "--single"]
    result = run(folder, check=False, arguments=arguments)
    assert result.returncode != 0
    assert message in result.stderr and "Traceback" not in result.stderr


def test_a_running_scheduler_is_used(folder, distributed):
    scheduler = subprocess.Popen(
        [sys.executable, "-c", "from distributed import LocalCluster; import sys\n"
         "if __name__ == '__main__':\n"
         "    cluster = LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None, processes=False, protocol='tcp')\n"
         "    print(cluster.scheduler_address, flush=True); sys.stdin.read()"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=folder,
    )
    try:
        address = scheduler.stdout.readline().strip()
        assert "parts made" in run(folder, "--out", "there", "--scheduler", address).stdout
    finally:
        scheduler.communicate("", timeout=60)
    run(folder, "--out", "single", "--single")
    assert parts_of(folder / "there") == parts_of(folder / "single")


def test_cameras_of_another_number_are_named(folder):
    np.savez(folder / "cameras.npz", K=np.eye(3), R=np.stack([np.eye(3)] * 5), t=np.zeros((1, 3)))
    words = ["depth.npy", "--cameras", "cameras.npz", "--near", "1", "--far", "2", "--depth-is", "z", "--out", "p", "--single"]
    result = run(folder, check=False, arguments=[sys.executable, str(EXAMPLE), *words])
    assert f"cameras.npz: there are {COUNT} images and 5 of R; give one an image" in result.stderr


def test_parts_of_other_options_are_not_taken(folder):
    run(folder, "--out", "parts", "--single")
    (folder / "parts" / "000001.npy.host-1.partial").write_text("left behind")
    result = run(folder, "--out", "parts", "--single", "--scale", "2", check=False)
    assert result.returncode != 0 and "parts: its parts were made from other images, setups or options" in result.stderr
    assert "0 parts made" in run(folder, "--out", "parts", "--single").stdout
    assert not list((folder / "parts").glob("*.partial"))


def test_an_image_of_another_size_is_named(folder):
    np.save(folder / "small.npy", np.ones((4, 5), np.float32))
    result = run(folder, check=False, arguments=[sys.executable, str(EXAMPLE), "small.npy", "--setups", "scene.json", "--depth-is", "z", "--out", "p", "--single"])
    assert "small.npy: image 0 has 5x4 pixels, its setup 160x120" in result.stderr
