"use strict";

/* ln(mu) over the logarithm of the velocity, a part of friction_law.js: constant
 * up to a knee, a line beyond it, and constant again from the end on. */
const friction_model = (function () {
  /* BEGIN constants */
  /* mu = 0.5 up to 1 m/s, and 0.5 v^-0.4 beyond. */
  const level = -0.6931471805599453;
  const knee = 0;
  const slope = -0.4;
  const end = 9;
  /* of level, knee and slope, row by row */
  const covariance = [0.01, 0, 0, 0, 0.04, 0, 0, 0, 0.01];
  const noise_variance = 0.0001;
  /* END constants */

  /* How far s lies beyond the knee; what is no number stays none. */
  function beyond_knee(s) {
    return s[0] <= knee ? 0 : (s[0] > end ? end : s[0]) - knee;
  }

  /* The fitted function. */
  function fitted(s) {
    return level + slope * beyond_knee(s);
  }

  function variance(s) {
    const by = [1, s[0] <= knee ? 0 : -slope, beyond_knee(s)];
    let sum = 0;

    for (let i = 0; i < 3; ++i)
      for (let j = 0; j < 3; ++j)
        sum += by[i] * covariance[3 * i + j] * by[j];
    return sum < 0 ? 0 : sum;
  }

  return {fitted, variance, noise_variance};
})();
