#!/usr/bin/python3
"""A Gaussian process computed by scikit-learn, for comparison.

Usage: reference_gaussian_process.py

Reads problems from standard input, one a line: the kernel (rbf, matern_3_2,
matern_5_2), the number of training points, of inputs and of test points, signal
variance, noise variance, length scales, then x (point by point), y and the test
points. Writes for each problem the log likelihood, its gradient (log signal
variance, log length scales, log noise variance), and mean and deviation of each
test point, one number a line.
"""

import sys

import numpy as np
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import (RBF, ConstantKernel, Matern,
                                              WhiteKernel)


def read(line):
    words = line.split()
    kernel, (n, d, m) = words[0], map(int, words[1:4])
    numbers = np.array(words[4:], dtype=float)
    signal, noise, numbers = numbers[0], numbers[1], numbers[2:]
    scales, x, y, tests = np.split(numbers, np.cumsum([d, n * d, n]))
    return kernel, signal, noise, scales, x.reshape(n, d), y, tests.reshape(m, d)


def solve(line):
    kernel, signal, noise, scales, x, y, tests = read(line)
    shape = {"rbf": RBF(scales), "matern_3_2": Matern(scales, nu=1.5),
             "matern_5_2": Matern(scales, nu=2.5)}[kernel]
    latent = ConstantKernel(signal) * shape
    process = GaussianProcessRegressor(latent + WhiteKernel(noise), alpha=0.,
                                       optimizer=None).fit(x, y)
    likelihood, gradient = process.log_marginal_likelihood(
        process.kernel_.theta, eval_gradient=True)
    # the noise as a part of alpha: the deviation is that of the function
    process = GaussianProcessRegressor(latent, alpha=noise,
                                       optimizer=None).fit(x, y)
    mean, deviation = process.predict(tests, return_std=True)
    for value in (likelihood, *gradient, *np.column_stack(
            (mean, deviation)).ravel()):
        print(repr(float(value)))


if __name__ == "__main__":
    for problem in sys.stdin:
        solve(problem)
