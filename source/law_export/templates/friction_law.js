
/* The law. friction_law.evaluate(p, v, T, further) takes a pressure [Pa], a
 * velocity [m/s], a temperature [K] and, in SI and in the order of the inputs,
 * the values of the inputs beside these, or nothing: then they are held at their
 * `value`. It answers with
 *   mu              the friction coefficient
 *   deviation       its standard deviation; -1 if this file has none
 *   lower, upper    another run gives a mu between them with 95 %
 *   surface_lower, surface_upper    so does the mean over the whole surface
 *   inside          whether the point is in the box of the training data
 *   trusted         whether it is, and the deviation is small
 *   k, tau          shear limit [Pa], infinite if unknown, and min(mu p, k) [Pa]
 * Outside of the box the law is still answered, with finite numbers.
 *
 * friction_law.inputs has an entry for each input: name, symbol, lower and upper
 * end of its range in SI; unit for people with SI = factor * number + offset;
 * place: 0, 1, 2 for p, v, T, from 3 on the further ones. */
const friction_law = (function (model) {
  /* BEGIN data */
  /* A law over pressure and wetting. */
  /* the law sees of an input (g(x) - origin)/span/length, g = log or identity;
   * low_edge and high_edge: what still counts as inside of its range */
  const inputs = [
    {"name": "Load/Pressure", "symbol": "p", "unit": "MPa", "factor": 1e6,
     "offset": 0, "place": 0, "logarithmic": false, "origin": 3e8, "span": 1e9,
     "length": 0.5, "lower": 3e8, "upper": 1.3e9, "low_edge": 3e8,
     "high_edge": 1.3e9, "value": null},
    {"name": "Lubrication/Wetting", "symbol": "Wetting", "unit": "1", "factor": 1,
     "offset": 0, "place": 3, "logarithmic": false, "origin": 0, "span": 1,
     "length": 2, "lower": 0, "upper": 1, "low_edge": 0, "high_edge": 1,
     "value": 0.5}
  ];
  const law = {"output": "mu", "logarithmic": true, "has_deviation": true,
               "offset": -2, "factor": 0.25, "largest_trusted_deviation": 0.05,
               "profiles": 1, "topography_error": 0};
  const limit = {"k_0": 6e8, "softens": true, "exponent": 1, "transition": 293.15,
                 "range": 1480};
  /* k at a strain e over k_0: (1 + ratio min(e + added, limit)^exponent)/at_k_0;
   * the places among the inputs of p, T and e, where e and T may be none */
  const strength = {"is_used": false, "pressure": 0, "temperature": 2, "strain": 2,
                    "ratio": 0, "exponent": 1, "added": 0.08, "limit": 1,
                    "at_k_0": 1};
  /* END data */

  /* The inputs of the law among the arguments. */
  function gather(p, v, T, further) {
    return inputs.map((input) => input.place < 3 ? [p, v, T][input.place] :
                                 further         ? further[input.place - 3] :
                                                   input.value);
  }

  /* An input within its range. */
  function clamped(x, i) {
    const {lower, upper} = inputs[i];

    return x[i] < lower ? lower : x[i] > upper ? upper : x[i];
  }

  function shear_limit(T) {
    if (!(limit.k_0 > 0))
      return Infinity;
    const t = limit.softens ? (T - limit.transition) / limit.range : 0;
    return t <= 0 ? limit.k_0 :
           t >= 1 ? 0 :
                    limit.k_0 * (1 - Math.pow(t, limit.exponent));
  }

  /* The strength that the fit sees the pressure over. */
  function strength_at(x) {
    let k = limit.k_0;

    if (strength.temperature < inputs.length)
      k = shear_limit(clamped(x, strength.temperature));
    if (strength.strain < inputs.length) {
      const e = clamped(x, strength.strain) + strength.added;
      k *= (1 + strength.ratio *
                  Math.pow(Math.min(e, strength.limit), strength.exponent)) /
           strength.at_k_0;
    }
    return k;
  }

  /* What the fit sees of the inputs. Tiny numbers have no inverse. */
  function scaled(x) {
    return inputs.map((input, i) => {
      let q = input.logarithmic && x[i] <= 0 ? input.lower : x[i];
      if (strength.is_used && i === strength.pressure)
        q /= strength_at(x);
      return ((input.logarithmic ? Math.log(q) : q) - input.origin) / input.span /
             input.length;
    });
  }

  function evaluate(p, v, T, further) {
    const x = gather(p, v, T, further), s = scaled(x);
    const value = law.offset + law.factor * model.fitted(s);
    const mu = law.logarithmic ? Math.exp(value) : value;
    const inside = inputs.every((input, i) => x[i] >= input.low_edge &&
                                              x[i] <= input.high_edge);
    const k = shear_limit(T);
    const answer = {mu, deviation: -1, lower: NaN, upper: NaN, surface_lower: NaN,
                    surface_upper: NaN, inside, trusted: inside, k,
                    tau: mu * p < k ? mu * p : k};
    if (!law.has_deviation)
      return answer;

    const variance = model.variance(s), scale = law.logarithmic ? mu : 1;
    const of_run =
      1.96 * law.factor * Math.sqrt(variance + model.noise_variance);
    const of_surface = Math.hypot(
      of_run, law.topography_error * (law.logarithmic ? 1 : Math.abs(mu)));
    const end = (half) => law.logarithmic ? mu * Math.exp(half) : mu + half;
    answer.deviation = scale * law.factor * Math.sqrt(variance);
    answer.lower = end(-of_run);
    answer.upper = end(of_run);
    answer.surface_lower = end(-of_surface);
    answer.surface_upper = end(of_surface);
    answer.trusted = inside && answer.deviation <=
                                 law.largest_trusted_deviation * Math.abs(mu);
    return answer;
  }

  return {inputs, law, evaluate, shear_limit};
})(friction_model);

if (typeof module === "object")
  module.exports = friction_law;
