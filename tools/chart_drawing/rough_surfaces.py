"""Periodic windows of rough surfaces: heights on a grid, in which patches and
profiles meet the same surface."""

import io
import os
import re
import zipfile

import numpy as np

SAMPLES = 64  # of a window, along and across
SLOPE = 0.12  # rms along the motion, of synthetic and scaled surfaces
DECAY = 0.18  # correlation length of synthetic surfaces over the window
SHORTEST = 2.  # waves in a window
TYPES = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}
GAUSS = 0.4697  # of ISO 16610-21: half of a wave of the cut-off passes


def slope(heights, length):
    """Root of the mean square along the motion of a periodic map."""
    k = np.fft.fftfreq(heights.shape[1]) * heights.shape[1]
    terms = np.fft.fft(heights, axis=1) * 2j * np.pi * k / length
    return np.sqrt(np.mean(np.fft.ifft(terms, axis=1).real ** 2))


def synthetic(seed, length):
    """A Gaussian field [um] of Str = 1 without waves longer than a window or
    shorter than half of one, whose spectrum is a Gaussian."""
    # RandomState promises the same stream in every version of numpy.
    random = np.random.RandomState(1000 + seed)
    k = np.fft.fftfreq(SAMPLES) * SAMPLES
    k_squared = k ** 2 + k[:, None] ** 2
    terms = np.fft.fft2(random.normal(size=(SAMPLES, SAMPLES)))
    terms *= np.exp(-(2 * np.pi * DECAY) ** 2 * k_squared / 4)
    terms[(k_squared < 1 - 1e-9) | (k_squared > SHORTEST ** 2 + 1e-9)] = 0.
    heights = np.fft.ifft2(terms).real
    return heights * SLOPE / slope(heights, length)


def read_x3p(path):
    """Heights and spacing [um] of an X3P file; missing points are NaN."""
    with zipfile.ZipFile(path) as archive:
        main = archive.read("main.xml").decode()
        data = archive.read("bindata/data.bin")
        valid = (archive.read("bindata/valid.bin")
                 if "bindata/valid.bin" in archive.namelist() else None)
    n_x, n_y = (int(re.search(rf"<Size{axis}>(\d+)", main)[1]) for axis in "XY")
    kind = re.findall(r"<DataType>(\w)", main)[2]
    heights = np.frombuffer(data, TYPES[kind]).astype(float)
    increments = [float(text) for text in
                  re.findall(r"<Increment>([^<]+)", main)]
    if kind in "IL":
        heights *= increments[2]
    if valid is not None:
        bits = np.unpackbits(np.frombuffer(valid, np.uint8), bitorder="little")
        heights = np.where(bits[:len(heights)] == 1, heights, np.nan)
    return 1e6 * heights.reshape(n_y, n_x), 1e6 * increments[0]


def without_form(heights, degree):
    """Heights minus their least-squares polynomial."""
    y, x = np.mgrid[-1:1:heights.shape[0] * 1j, -1:1:heights.shape[1] * 1j]
    terms = np.stack([x ** i * y ** j for i in range(degree + 1)
                      for j in range(degree + 1 - i)], axis=-1)
    valid = np.isfinite(heights)
    factors = np.linalg.lstsq(terms[valid], heights[valid], rcond=None)[0]
    return heights - terms @ factors


def smooth(heights, cutoff):
    """Gaussian filter of ISO 16610-61 (cut-off in points), whose weights are
    normalised at the edges and where points are missing."""
    def convolve(values):
        padded = np.zeros([n + 2 * int(cutoff) for n in values.shape])
        padded[:values.shape[0], :values.shape[1]] = values
        l, k = (np.fft.fftfreq(n) for n in padded.shape)
        weight = np.exp(-np.pi * (GAUSS * cutoff) ** 2 *
                        (k ** 2 + l[:, None] ** 2))
        values_of = np.fft.ifft2(np.fft.fft2(padded) * weight).real
        return values_of[:values.shape[0], :values.shape[1]]

    valid = np.isfinite(heights)
    return convolve(np.where(valid, heights, 0.)) / convolve(valid.astype(float))


def wrapped(heights, n, axis):
    """The first n points along an axis, made periodic: the points that follow
    fade into the first ones."""
    heights = np.moveaxis(heights, axis, 0)
    n_faded = len(heights) - n
    result = heights[:n].copy()
    share = (0.5 - 0.5 * np.cos(np.pi * (np.arange(n_faded) + 0.5) / n_faded)
             ).reshape(-1, *[1] * (heights.ndim - 1))
    result[:n_faded] = share * result[:n_faded] + (1. - share) * heights[n:]
    return np.moveaxis(result, 0, axis)


def resampled(heights, n, axis):
    """A periodic map on n points along an axis, by its Fourier terms."""
    terms = np.fft.rfft(heights, axis=axis)
    n_terms = min(n, heights.shape[axis]) // 2
    terms = np.take(terms, range(n_terms), axis=axis)
    return np.fft.irfft(terms, n, axis=axis) * n / heights.shape[axis]


def window(heights, start, n_points):
    """n_points (along, across) of a map from a start on, periodic, without its
    mean, on SAMPLES points along and across."""
    (i, j), (n_x, n_y) = start, n_points
    part = heights[j:j + n_y + n_y // 3, i:i + n_x + n_x // 3]
    part = resampled(wrapped(part, n_x, 1), SAMPLES, 1)
    part = resampled(wrapped(part, n_y, 0), SAMPLES, 0)
    return part - part.mean()


def write_map(path, heights):
    """Heights [um] as text, half as many points again in both directions, from
    whose middle the program cuts a window. Nothing is written twice."""
    n_y, n_x = heights.shape
    tiled = np.pad(heights, ((0, n_y // 2), (0, SAMPLES // 2)), mode="wrap")
    text = io.StringIO()
    np.savetxt(text, tiled, fmt="%.6f")
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.getvalue())
