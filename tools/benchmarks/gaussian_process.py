#!/usr/bin/python3
"""The Gaussian process and scikit-learn's on the same data, side by side.

Usage: tools/benchmarks/gaussian_process.py BUILD_DIRECTORY [POINTS ...]

Makes POINTS (default 150 900) pseudo-random points of three inputs with one per
cent of noise, trains both on them from the same start without restarts, and
times predictions: a table in Markdown for each kernel. Training is measured in
processor time, predictions by the shortest of many measurements, all with one
thread; compare within one run only.
"""

import os
import subprocess
import sys
import tempfile
import time

# must be set before numpy is loaded
os.environ["OPENBLAS_NUM_THREADS"] = "1"
import numpy as np  # noqa: E402
from sklearn.gaussian_process import GaussianProcessRegressor  # noqa: E402
from sklearn.gaussian_process.kernels import (RBF, ConstantKernel,  # noqa: E402
                                              Matern, WhiteKernel)

N_INPUTS = 3
ROWS = [("training [s]", "training", 1.), ("one mean [us]", "mean", 1e6),
        ("mean and deviation [us]", "deviation", 1e6),
        ("the same and the gradient [us]", "gradient", 1e6),
        ("a mean of a batch [us]", "batch", 1e6)]


def sample(n):
    random = np.random.default_rng(0)
    x = random.random((n, N_INPUTS))
    y = (np.sin(3. * x[:, 0]) + 0.5 * np.abs(x[:, 1] - 0.4) * x[:, 2]
         + 0.01 * random.standard_normal(n))
    return x, (y - y.mean()) / y.std()


def seconds(call, n_calls):
    """Of one call, the least of several measurements."""
    least = np.inf
    for _ in range(15):
        start = time.perf_counter()
        for i in range(n_calls):
            call(i)
        least = min(least, (time.perf_counter() - start) / n_calls)
    return least


def measure_scikit_learn(kernel, x, y):
    scales = [0.5] * N_INPUTS
    shape = {"rbf": RBF(scales), "matern_3_2": Matern(scales, nu=1.5),
             "matern_5_2": Matern(scales, nu=2.5)}[kernel]
    process = GaussianProcessRegressor(
        ConstantKernel(1.) * shape + WhiteKernel(1e-4, (1e-10, 1.)), alpha=0.)
    training = np.inf
    for _ in range(3):
        start = time.process_time()
        process.fit(x, y)
        training = min(training, time.process_time() - start)
    points = np.vstack([0.5 * (x[1:] + x[:-1]), x[-1:]])
    one = [points[i:i + 1] for i in range(20)]
    return {
        "log_likelihood": process.log_marginal_likelihood_value_,
        "training": training,
        "mean": seconds(lambda i: process.predict(one[i]), 20),
        "deviation": seconds(
            lambda i: process.predict(one[i], return_std=True), 20),
        "batch": seconds(lambda i: process.predict(points), 2) / len(points)}


def measure_asperity(program, kernel, x, y):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "data.txt")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"{len(y)} {N_INPUTS}\n")
            for row in np.column_stack((x, y)):
                file.write(" ".join(repr(float(value)) for value in row) + "\n")
        lines = subprocess.run([program, kernel, path], capture_output=True,
                               text=True, check=True).stdout.splitlines()
    return {name: float(value) for name, value in map(str.split, lines)}


def print_table(kernel, n, ours, theirs):
    print(f"\n{n} points, {kernel}: log likelihood "
          f"{ours['log_likelihood']:.4f}, scikit-learn "
          f"{theirs['log_likelihood']:.4f}; {ours['evaluations']:.0f} "
          "evaluations\n")
    print("| | here | scikit-learn | ratio |\n| --- | --- | --- | --- |")
    for label, name, unit in ROWS:
        here = f"{ours[name] * unit:.3g}"
        if name in theirs:
            print(f"| {label} | {here} | {theirs[name] * unit:.3g} "
                  f"| {theirs[name] / ours[name]:.0f} |")
        else:
            print(f"| {label} | {here} | | |")
    megabytes = n * (n + 1) * 4e-6
    print(f"| reading the triangular factor, {megabytes:.2g} MB [us] "
          f"| {ours['reading'] * 1e6:.3g} | | |")


def main(build, sizes):
    program = os.path.join(build, "tools", "benchmarks",
                           "gaussian_process_benchmark")
    if not os.path.exists(program):
        sys.exit(f"{program} is not built: ninja gaussian_process_benchmark")
    for n in sizes:
        x, y = sample(n)
        for kernel in ("rbf", "matern_3_2", "matern_5_2"):
            print_table(kernel, n, measure_asperity(program, kernel, x, y),
                        measure_scikit_learn(kernel, x, y))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], [int(word) for word in sys.argv[2:]] or [150, 900])
