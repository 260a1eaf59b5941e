#!/usr/bin/env python3
"""Turn many depth images into points, on one machine or on many, with Dask.

    python3 cluster.py depth.npy --setups scene.json --depth-is z --out points
    python3 cluster.py 'depth/*.png' --setups 'scenes/*.json' --depth-is z --scale 1000 --out points
    python3 cluster.py depth.npy --cameras cameras.npz --near 0.1 --far 50 --depth-is z --out points.zarr
    python3 cluster.py depth.npy --setups scene.json --depth-is z --out points --scheduler tcp://10.0.0.1:8786

The images are an .npy file of shape (N, H, W), or files that a pattern matches, in the order of
their names. Each has a setup of its own, or all share one. Each image is a chunk and becomes a part,
points of shape (H, W, 3) with nan where a pixel has none: OUT/000000.npy, or a chunk of OUT.zarr.

A part is written under another name and then renamed: a killed worker leaves no half part. Run the
same command again to make what is missing. On several machines, the images and OUT lie in a folder
that all of them see.
"""

import argparse
import glob
import hashlib
import os
import pathlib
import socket
import sys
import warnings

import numpy as np
import unprojector as up


def files_of(words):
    """The files of names and patterns, those of a pattern in the order of their names."""
    files = []
    for word in words:
        found = sorted(glob.glob(word)) if glob.has_magic(word) else [word]
        if not found:
            raise ValueError(f"{word}: no file matches")
        files += found
    return files


def image_sources(words):
    """What each image is read from: (file, index in it, or None)."""
    sources = []
    for file in files_of(words):
        if file.endswith(".npy") and len(shape := np.load(file, mmap_mode="r").shape) == 3:
            sources += [(os.path.abspath(file), i) for i in range(shape[0])]
        else:
            sources.append((os.path.abspath(file), None))
    return sources


def read_image(source):
    """One depth image; of a stack only its own bytes are read."""
    file, index = source
    return up.read_depth(file) if index is None else np.load(file, mmap_mode="r")[index]


def read_setups(arguments, sources):
    """One setup for each image."""
    count = len(sources)
    if not arguments.cameras:
        setups = [up.Setup.from_scene(pathlib.Path(file).read_text(encoding="utf-8")) for file in files_of(arguments.setups)]
        if len(setups) not in (1, count):
            raise ValueError(f"there are {count} images and {len(setups)} setups; give one setup, or one an image")
        return setups * count if len(setups) == 1 else setups
    if arguments.near is None or arguments.far is None:
        raise ValueError("--cameras needs --near and --far")
    cameras = np.load(arguments.cameras)
    for name in ("K", "R", "t"):
        if name not in getattr(cameras, "files", ()):
            raise ValueError(f"{arguments.cameras}: there is no array {name}; give an .npz file with K, R and t")
    K = cameras["K"] if cameras["K"].ndim == 3 else np.repeat(cameras["K"][None], count, axis=0)
    for name, array in (("K", K), ("R", cameras["R"]), ("t", cameras["t"])):
        if len(array) != count:
            raise ValueError(f"{arguments.cameras}: there are {count} images and {len(array)} of {name}; give one an image")
    size = read_image(sources[0]).shape[::-1]
    return [
        up.Setup.from_opencv(*camera, size=size, near=arguments.near, far=arguments.far)
        for camera in zip(K, cameras["R"], cameras["t"])
    ]


def check_same_run(folder, jobs, options):
    """Refuses a folder whose parts were made from other images, setups or options."""
    run = hashlib.sha256(repr([(source, setup.to_scene()) for source, setup in jobs] + [options]).encode()).hexdigest()
    note = pathlib.Path(folder, ".cluster-run")
    if note.exists() and note.read_text() != run:
        raise ValueError(f"{folder}: its parts were made from other images, setups or options; give another --out")
    note.write_text(run)


class Parts:
    """A folder with one .npy file an image."""

    def __init__(self, folder, dtype):
        self.folder, self.dtype = os.path.abspath(folder), np.dtype(dtype)
        os.makedirs(self.folder, exist_ok=True)

    def remove_partial(self):
        """Removes what killed workers left."""
        for partial in glob.glob(os.path.join(glob.escape(self.folder), "*.partial")):
            os.unlink(partial)

    def file(self, i):
        return os.path.join(self.folder, f"{i:06}.npy")

    def has(self, i, size):
        """Whether a part is complete."""
        try:
            part = np.load(self.file(i), mmap_mode="r")
        except (OSError, ValueError):
            return False
        return part.dtype == self.dtype and part.shape == (size[1], size[0], 3)

    def write(self, i, points):
        partial = f"{self.file(i)}.{socket.gethostname()}-{os.getpid()}.partial"
        with open(partial, "wb") as file:
            np.save(file, points)
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, self.file(i))


class ZarrParts:
    """A Zarr array of shape (N, H, W, 3), one chunk an image. Zarr renames whole chunks itself."""

    def __init__(self, folder, count, dtype, size):
        import zarr

        shape = (count, size[1], size[0], 3)
        self.array = zarr.open(folder, mode="a", shape=shape, chunks=(1, *shape[1:]), dtype=dtype, fill_value=np.nan)
        if self.array.shape != shape or self.array.dtype != np.dtype(dtype):
            raise ValueError(f"{folder}: holds {self.array.dtype}{self.array.shape}, not {np.dtype(dtype)}{shape}; give another --out")

    def remove_partial(self):
        pass

    def has(self, i, size):
        return f"{i}.0.0.0" in self.array.store or f"{self.array.path}/{i}.0.0.0".lstrip("/") in self.array.store

    def write(self, i, points):
        self.array[i] = points


def make_part(i, source, setup, parts, options):
    """Computes and writes one part; returns its number of points."""
    image = read_image(source)
    if image.shape != setup.size[::-1]:
        raise ValueError(f"{source[0]}: image {i} has {image.shape[1]}x{image.shape[0]} pixels, its setup {setup.size[0]}x{setup.size[1]}")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # an image without a point is counted at the end
        points = setup.cloud(image, threads=1, **options)
    parts.write(i, points)
    return int(np.count_nonzero(~np.isnan(points[..., 0])))


def part_of_block(block, parts, options):
    """Makes the part of the one job of a block; returns its count of points, not the points."""
    (job,) = block
    return np.array([make_part(*job, parts, options)])


def on_cluster(arguments, jobs, parts, options):
    """The counts of points, computed by the workers of a cluster."""
    import dask.array
    from distributed import Client, LocalCluster, progress

    # Dask has workers give memory back after each part, and the system clear it again for the next.
    keep = {"MALLOC_TRIM_THRESHOLD_": 2**30, "MALLOC_MMAP_THRESHOLD_": 2**30, "OMP_NUM_THREADS": 1}
    dask.config.set({"distributed.nanny.pre-spawn-environ": keep})
    address = arguments.scheduler
    cluster = None if address else LocalCluster(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None)
    with Client(address or cluster) as client:
        # Each task holds its own job, so that any worker can take it over.
        blocks = np.empty(len(jobs), object)
        blocks[:] = [(i, *job) for i, job in jobs.items()]
        chunks = dask.array.from_array(blocks, chunks=1)
        counts = chunks.map_blocks(part_of_block, parts, options, dtype=np.int64, meta=np.empty(0, np.int64))
        future = client.compute(counts, retries=arguments.retries)
        if sys.stderr.isatty():
            progress(future)
        result = future.result()
    if cluster:
        cluster.close()
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", nargs="+", help="an .npy file of shape (N, H, W), or files; a pattern in quotes")
    cameras = parser.add_mutually_exclusive_group(required=True)
    cameras.add_argument("--setups", nargs="+", help="scene files, one an image or one for all; a pattern in quotes")
    cameras.add_argument("--cameras", help="an .npz file with K, R (N, 3, 3) and t (N, 3), as OpenCV has them")
    parser.add_argument("--near", type=float, help="the near plane of --cameras")
    parser.add_argument("--far", type=float, help="the far plane of --cameras")
    parser.add_argument("--depth-is", required=True, choices=["buffer", "range", "z", "distance", "disparity"], help="the meaning of the numbers")
    parser.add_argument("--scale", type=float, help="the numbers are divided by it: 1000 for millimetres")
    parser.add_argument("--baseline", type=float, help="the distance of the two cameras of a disparity")
    parser.add_argument("--dtype", default="float32", choices=["float32", "float64"], help="of the points (default: float32)")
    parser.add_argument("--out", required=True, help="a folder for .npy parts, or NAME.zarr")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="of the cluster on this machine (default: its cores)")
    parser.add_argument("--scheduler", help="the address of a running cluster instead: tcp://HOST:8786")
    parser.add_argument("--retries", type=int, default=3, help="of a part that fails (default: 3)")
    parser.add_argument("--single", action="store_true", help="no cluster: one part after the other")
    arguments = parser.parse_args()
    try:
        sources = image_sources(arguments.images)
        setups = read_setups(arguments, sources)
        options = {"depth_is": arguments.depth_is, "scale": arguments.scale, "baseline": arguments.baseline, "dtype": arguments.dtype}
        if arguments.out.endswith(".zarr"):
            if len({setup.size for setup in setups}) > 1:
                raise ValueError("the setups have several sizes, which a Zarr array cannot hold; give a folder as --out")
            parts = ZarrParts(arguments.out, len(sources), arguments.dtype, setups[0].size)
        else:
            parts = Parts(arguments.out, arguments.dtype)
        check_same_run(arguments.out, list(zip(sources, setups)), options)
        parts.remove_partial()
        jobs = {i: job for i, job in enumerate(zip(sources, setups)) if not parts.has(i, job[1].size)}
        if jobs and arguments.single:
            counts = [make_part(i, *job, parts, options) for i, job in jobs.items()]
        else:
            counts = on_cluster(arguments, jobs, parts, options) if jobs else []
    except Exception as error:  # also Dask's own, of a part that keeps killing its worker
        sys.exit(f"cluster.py: {error}")
    print(f"{arguments.out}: {len(counts)} parts made, {len(sources) - len(counts)} were there; {int(np.sum(counts))} new points")
    if len(counts) and not np.all(counts):
        empty = [i for i, count in zip(jobs, counts) if count == 0]
        print(f"cluster.py: no pixel has a point in image {', '.join(map(str, empty[:10]))}; check --depth-is and --scale", file=sys.stderr)


if __name__ == "__main__":
    main()
