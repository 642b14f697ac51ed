# Copyright (c) the authors of Asperity
#
# Permission is hereby granted, free of charge, to any person obtaining a copy
# of this software and associated documentation files (the "Software"), to deal
# in the Software without restriction, including without limitation the rights
# to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
# copies of the Software, and to permit persons to whom the Software is
# furnished to do so, subject to the following conditions:
#
# The above copyright notice and this permission notice shall be included in
# all copies or substantial portions of the Software.
#
# THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
# IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
# FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
# AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
# LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
# OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
# SOFTWARE.
"""Friction laws of Asperity in Python: mu(p, v, T) at contact points.

This is the interface through which a simulation of chip formation asks at each
Gauss point. It needs Python 3 and libasperity_friction.so, which is built with
Asperity; numpy is used if it is there.

    from asperity_friction import FrictionLaw

    law = FrictionLaw("friction_law.json")
    answer = law.predict(450e6, 1.5, 573.15)      # Pa, m/s, K
    answer.mu, answer.deviation, answer.trusted
    answer.derivatives                            # by p, v and T
    law.topography.error                          # of the surface's mean
    law.mechanisms                                # what makes mu, a sentence

    law.predict(pressures, velocities, 573.15)    # lists or arrays, too
    law.shear_stress(450e6, 1.5, 573.15)          # min(mu p, k) in Pa

Everything is SI. A law may be shared by threads.
"""

import ctypes
import ctypes.util
import os
from collections import namedtuple

try:
    import numpy
except ImportError:  # lists do as well
    numpy = None

Input = namedtuple("Input", "name symbol unit lower upper")
Input.__doc__ = """An input of a law and the box of its training data, in SI;
`unit` is for people."""

Topography = namedtuple("Topography", "profiles scatter error")
Topography.__doc__ = """How far the profiles of the surface tell its mean, which
is part of neither deviation nor trusted.

profiles: over how many of them mu is a mean
scatter: standard deviation between them, relative to mu; 0 for one
error: half width of the 95 % interval of the mean over the whole surface, from
    their scatter alone, relative to mu (a factor exp(error) for a law of ln(mu));
    0, that is unknown, for one"""

Prediction = namedtuple("Prediction", "mu derivatives deviation trusted")
Prediction.__doc__ = """What a law says at one point or at many.

mu: friction coefficient
derivatives: of mu by p, v and T
deviation: standard deviation of mu
trusted: in the box of the training data, and with a small deviation"""

_VERSION = 1
_POINT = ("p", "v", "T")
_double_pointer = ctypes.POINTER(ctypes.c_double)
_byte_pointer = ctypes.POINTER(ctypes.c_ubyte)


class FrictionError(Exception):
    """The law cannot be read or evaluated; the sentence says why."""


class _CInput(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("symbol", ctypes.c_char_p),
                ("unit", ctypes.c_char_p), ("lower", ctypes.c_double),
                ("upper", ctypes.c_double)]


def _find_library():
    """The library of ASPERITY_FRICTION_LIBRARY, of the build folder beside this
    file's folder, or of the system."""
    given = os.environ.get("ASPERITY_FRICTION_LIBRARY")
    if given:
        return given
    name = "libasperity_friction.so"
    here = os.path.dirname(os.path.abspath(__file__))
    for folder in (here, os.path.join(here, "..", "build")):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            return path
    return ctypes.util.find_library("asperity_friction") or name


def _load_library(path):
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise FrictionError(
            f"The library '{path}' cannot be loaded ({error}); build the target "
            "asperity_friction, or set ASPERITY_FRICTION_LIBRARY.") from None
    library.asperity_friction_load.restype = ctypes.c_void_p
    library.asperity_friction_load.argtypes = [ctypes.c_char_p]
    library.asperity_friction_free.restype = None
    library.asperity_friction_free.argtypes = [ctypes.c_void_p]
    library.asperity_friction_last_error.restype = ctypes.c_char_p
    library.asperity_friction_n_inputs.restype = ctypes.c_size_t
    library.asperity_friction_n_inputs.argtypes = [ctypes.c_void_p]
    library.asperity_friction_get_input.argtypes = [
        ctypes.c_void_p, ctypes.c_size_t, ctypes.POINTER(_CInput)]
    library.asperity_friction_eval_inputs.argtypes = [
        ctypes.c_void_p, ctypes.c_size_t, _double_pointer, _double_pointer,
        _double_pointer, _double_pointer, _byte_pointer]
    library.asperity_friction_shear_limit.argtypes = [
        ctypes.c_void_p, ctypes.c_size_t, _double_pointer, _double_pointer]
    library.asperity_friction_mechanisms.restype = ctypes.c_char_p
    library.asperity_friction_mechanisms.argtypes = [ctypes.c_void_p]
    library.asperity_friction_topography.argtypes = [
        ctypes.c_void_p, ctypes.POINTER(ctypes.c_size_t), _double_pointer,
        _double_pointer]
    found = library.asperity_friction_version()
    if found != _VERSION:
        raise FrictionError(f"The library '{path}' has the version {found}; "
                            f"version {_VERSION} is expected.")
    return library


def _is_array(value):
    return numpy is not None and isinstance(value, numpy.ndarray) and value.ndim


def _is_sequence(value):
    return hasattr(value, "__len__") and not (
        numpy is not None and isinstance(value, numpy.ndarray)
        and value.ndim == 0)


class _Points:
    """Several arguments as points of equal number, and results in their shape:
    numbers, lists, or arrays if one of the arguments is an array."""

    def __init__(self, arguments):
        self.arrays = any(_is_array(value) for value in arguments)
        self.shape = ()
        if self.arrays:
            try:
                columns = numpy.broadcast_arrays(
                    *[numpy.asarray(value, dtype=float) for value in arguments])
            except ValueError as error:
                raise FrictionError(str(error)) from None
            self.shape = columns[0].shape
            self.n = columns[0].size
            self.columns = [column.ravel() for column in columns]
            return
        lengths = {len(value) for value in arguments if _is_sequence(value)}
        if len(lengths) > 1:
            raise FrictionError("The points have different numbers of values: "
                                + ", ".join(map(str, sorted(lengths))) + ".")
        self.scalar = not lengths
        self.n = lengths.pop() if lengths else 1
        self.columns = [[float(entry) for entry in value]
                        if _is_sequence(value) else [float(value)] * self.n
                        for value in arguments]

    def buffer(self):
        """The points, their columns side by side, for the library."""
        if self.arrays:
            return numpy.ascontiguousarray(numpy.stack(self.columns, axis=1))
        values = [value for point in zip(*self.columns) for value in point]
        return (ctypes.c_double * len(values))(*values)

    def empty(self, width=1):
        if self.arrays:
            return numpy.empty(self.n * width)
        return (ctypes.c_double * (self.n * width))()

    def empty_flags(self):
        if self.arrays:
            return numpy.empty(self.n, dtype=numpy.ubyte)
        return (ctypes.c_ubyte * self.n)()

    def result(self, values, convert=float):
        if self.arrays:
            kind = bool if convert is bool else float
            return numpy.asarray(values).astype(kind).reshape(self.shape)
        values = [convert(value) for value in values]
        return values[0] if self.scalar else values

    def rows(self, values, width, places):
        """Of rows of a width, the entries at these places (None: zero)."""
        if self.arrays:
            rows = numpy.asarray(values).reshape(self.n, width)
            zero = numpy.zeros(self.n)
            picked = [zero if place is None else rows[:, place]
                      for place in places]
            return numpy.stack(picked, axis=1).reshape(
                self.shape + (len(places),))
        rows = [tuple(0. if place is None else values[i * width + place]
                      for place in places) for i in range(self.n)]
        return rows[0] if self.scalar else rows


def _address(buffer, kind=_double_pointer):
    if numpy is not None and isinstance(buffer, numpy.ndarray):
        return buffer.ctypes.data_as(kind)
    return ctypes.cast(buffer, kind)


class FrictionLaw:
    """A trained friction law.

    path: the law's file, as `asperity characterize` writes it
    library: libasperity_friction.so; looked for if it is not given
    """

    def __init__(self, path, library=None):
        self._handle = None
        self._library = _load_library(library or _find_library())
        handle = self._library.asperity_friction_load(os.fsencode(path))
        if not handle:
            self._fail()
        self._handle = ctypes.c_void_p(handle)
        self.inputs = [self._input(index) for index in range(
            self._library.asperity_friction_n_inputs(self._handle))]
        self.topography = self._topography()
        self.mechanisms = self._library.asperity_friction_mechanisms(
            self._handle).decode()

    def __del__(self):
        if self._handle:
            self._library.asperity_friction_free(self._handle)
            self._handle = None

    def predict(self, p, v, T, others=None):
        """mu with derivatives, deviation and trusted: a Prediction.

        p: pressure [Pa], v: sliding velocity [m/s], T: temperature [K]; each a
            number, a list or an array; numbers go with every entry of a list
        others: values of further inputs of the law by name or symbol, for
            example {"Lubrication/Wetting": 0.5}

        The results are numbers if all arguments are, arrays (derivatives with
        one more axis) if one argument is an array, and lists otherwise. What the
        law does not depend on has the derivative 0.
        """
        points = self._points(p, v, T, others)
        mu, sigma = points.empty(), points.empty()
        dmu = points.empty(len(self.inputs))
        trusted = points.empty_flags()
        self._evaluate(points, mu, dmu, sigma, trusted)
        symbols = [entry.symbol for entry in self.inputs]
        places = [symbols.index(symbol) if symbol in symbols else None
                  for symbol in _POINT]
        return Prediction(points.result(mu),
                          points.rows(dmu, len(self.inputs), places),
                          points.result(sigma), points.result(trusted, bool))

    def mean(self, p, v, T, others=None):
        """mu alone, which is several times faster; arguments as predict()."""
        points = self._points(p, v, T, others)
        mu = points.empty()
        self._evaluate(points, mu, None, None, None)
        return points.result(mu)

    def shear_limit(self, T):
        """The shear limit k [Pa] of the chip; infinite if it is unknown."""
        points = _Points([T])
        k, temperatures = points.empty(), points.buffer()
        self._check(self._library.asperity_friction_shear_limit(
            self._handle, points.n, _address(temperatures), _address(k)))
        return points.result(k)

    def shear_stress(self, p, v, T, others=None):
        """min(mu p, k) [Pa]: sliding or sticking (Zorev)."""
        mu, k = self.mean(p, v, T, others), self.shear_limit(T)
        points = _Points([mu, p, k])
        return points.result([min(m * q, limit)
                              for m, q, limit in zip(*points.columns)])

    def _points(self, p, v, T, others):
        given = dict(zip(_POINT, (p, v, T)))
        others = dict(others or {})
        arguments = []
        for entry in self.inputs:
            if entry.symbol in given:
                arguments.append(given[entry.symbol])
            elif entry.name in others or entry.symbol in others:
                key = entry.name if entry.name in others else entry.symbol
                arguments.append(others.pop(key))
            else:
                raise FrictionError(
                    f"The law also depends on '{entry.name}' [{entry.unit}]; "
                    "give its SI value in `others`.")
        if others:
            raise FrictionError("The law has no input "
                                + ", ".join(f"'{key}'" for key in others) + ".")
        return _Points(arguments)

    def _evaluate(self, points, mu, dmu, sigma, trusted):
        x = points.buffer()
        self._check(self._library.asperity_friction_eval_inputs(
            self._handle, points.n, _address(x), _address(mu),
            None if dmu is None else _address(dmu),
            None if sigma is None else _address(sigma),
            None if trusted is None else _address(trusted, _byte_pointer)))

    def _input(self, index):
        found = _CInput()
        self._check(self._library.asperity_friction_get_input(
            self._handle, index, ctypes.byref(found)))
        return Input(found.name.decode(), found.symbol.decode(),
                     found.unit.decode(), found.lower, found.upper)

    def _topography(self):
        profiles, scatter = ctypes.c_size_t(), ctypes.c_double()
        error = ctypes.c_double()
        self._check(self._library.asperity_friction_topography(
            self._handle, ctypes.byref(profiles), ctypes.byref(scatter),
            ctypes.byref(error)))
        return Topography(profiles.value, scatter.value, error.value)

    def _check(self, status):
        if status != 0:
            self._fail()

    def _fail(self):
        raise FrictionError(
            self._library.asperity_friction_last_error().decode())
