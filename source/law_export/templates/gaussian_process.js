"use strict";

/* A Gaussian process that was trained on runs, as a part of friction_law.js. */
const friction_model = (function () {
  /* BEGIN runs */
  /* Three runs over pressure and wetting. */
  const kernel = 3; /* 1: RBF, 3: Matern 3/2, 5: Matern 5/2 */
  const points = [0, 0, 1, 0.25, 2, 0.5];
  const weights = [0.5, -0.25, 0.125];
  /* inverse triangular factor of the covariance, row by row */
  const B = [1, -0.5, 1.25, 0.25, -0.5, 1.5];
  const sum_of_weights = 0.375;
  const signal_variance = 1;
  const noise_variance = 0.0001;
  /* END runs */
  const N = weights.length;

  /* (exp(-a) - 1 + a)/a^2 by its Taylor series, for small a */
  function rest(a) {
    let sum = 0, factorial = 1307674368000; /* 15! */

    for (let n = 15; n >= 2; factorial /= n, --n)
      sum = 1 / factorial - a * sum;
    return sum;
  }

  /* correlation with run j minus 1, which is accurate also for small distances */
  function deficit(s, j) {
    let r2 = 0;

    for (let i = 0; i < s.length; ++i)
      r2 += (points[j * s.length + i] - s[i]) ** 2;
    const a = kernel === 1 ? 0.5 * r2 : Math.sqrt(kernel * r2);
    if (a >= 700) /* too far away to matter */
      return -1;
    const polynomial = kernel === 1 ? 1 :
                       kernel === 3 ? 1 + a :
                                      1 + a + a * a / 3;
    if (!(a < 0.5))
      return polynomial * Math.exp(-a) - 1;
    return kernel === 1 ? a * (a * rest(a) - 1) :
           kernel === 3 ? a * a * (polynomial * rest(a) - 1) :
                          a * a * (polynomial * rest(a) - (2 + a) / 3);
  }

  /* The fitted function. */
  function fitted(s) {
    let m = sum_of_weights;

    for (let j = 0; j < N; ++j)
      m += weights[j] * deficit(s, j);
    return m;
  }

  /* Its variance, if B is there. */
  function variance(s) {
    const f = weights.map((weight, j) => 1 + deficit(s, j));
    let norm = 0, k = 0;

    for (let i = 0; i < N; ++i) {
      let product = 0;

      for (let j = 0; j <= i; ++j)
        product += B[k++] * f[j];
      norm += product * product;
    }
    return norm >= 1 ? 0 : signal_variance * (1 - norm);
  }

  return {fitted, variance, noise_variance};
})();
