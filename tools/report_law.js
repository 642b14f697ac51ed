"use strict";

/* The sliders of a law's report. friction_law (friction_law.js) evaluates the law;
 * report_choices lists the relative errors by group of choices. */
(function () {
  const law = friction_law, inputs = law.inputs;
  const by_id = (id) => document.getElementById(id);
  const shown = (input, si) => (si - input.offset) / input.factor;
  const unit = (input) => input.unit === "1" ? "" :
    " " + input.unit.replace("degC", "°C").replace("um", "µm");
  const digits = (x, n) => Number(x.toPrecision(n)).toString().replace("-", "−");
  const steps = 1000;

  /* What a slider can be set to: a part beyond the box on both sides, to show
   * where the law is not to be trusted. */
  const ranges = inputs.map((input) => {
    const width = input.upper - input.lower;
    let low = input.lower - 0.3 * width;
    if (input.lower > 0 && low <= 0)
      low = 0.3 * input.lower;
    if (input.lower === 0)
      low = 0;
    return {low, high: input.upper + 0.3 * width};
  });
  /* Not in the middle, where many designs have a run, and the law errs least. */
  const state = inputs.map((input) => input.value !== null ? input.value :
    input.lower + 0.4 * (input.upper - input.lower));

  function element(name, attributes, text) {
    const svg = ["svg", "path", "line", "rect", "circle", "text"].includes(name);
    const result = svg ?
      document.createElementNS("http://www.w3.org/2000/svg", name) :
      document.createElement(name);
    for (const [key, value] of Object.entries(attributes || {}))
      result.setAttribute(key, value);
    if (text !== undefined)
      result.textContent = text;
    return result;
  }

  /* The law at values of its inputs. */
  function at(x) {
    const point = [NaN, NaN, NaN], further = [];
    inputs.forEach((input, i) => {
      if (input.place < 3)
        point[input.place] = x[i];
      else
        further[input.place - 3] = x[i];
    });
    return law.evaluate(...point, further);
  }

  /* Why the law is not to be trusted there, in the words of `predict`. */
  function reason(x, answer) {
    const reasons = [];
    inputs.forEach((input, i) => {
      if (!(x[i] >= input.low_edge && x[i] <= input.high_edge))
        reasons.push(`${input.symbol} is outside of the data, ` +
                     `${digits(shown(input, input.lower), 6)} to ` +
                     `${digits(shown(input, input.upper), 6)}${unit(input)}`);
    });
    const relative = answer.deviation / Math.abs(answer.mu);
    const limit = law.law.largest_trusted_deviation;
    if (relative > limit)
      reasons.push(`the deviation is ${digits(100 * relative, 2)} % of the mean, ` +
                   `more than ${digits(100 * limit, 2)} %`);
    if (reasons.length > 0)
      return reasons.join("; ");
    return "inside of the data" + (answer.deviation < 0 ? "" :
      `, deviation ${digits(100 * relative, 2)} % of the mean`);
  }

  function interval(low, high) {
    return Number.isFinite(low) ? `${digits(low, 5)} to ${digits(high, 5)}` :
                                  "not known";
  }

  function error(below, above) {
    const [b, a] = [digits(below, 2), digits(above, 2)];
    return a === b ? `± ${a}` : `+${a} −${b}`;
  }

  /* mu = ... +- ... (law) +- ... (preparation) ... */
  function write_line(answer) {
    const line = by_id("law-line"), mu = Math.abs(answer.mu);
    const parts = [];
    if (answer.deviation >= 0)
      parts.push(["law and numerics", answer.mu - answer.lower,
                  answer.upper - answer.mu]);
    const topography = law.law.topography_error;
    if (topography > 0)
      parts.push(["profile for surface",
                  mu * (law.law.logarithmic ? 1 - Math.exp(-topography) :
                                              topography),
                  mu * (law.law.logarithmic ? Math.exp(topography) - 1 :
                                              topography)]);
    for (const [name, below, above] of report_choices)
      if (topography === 0 || name !== "profile for surface")
        parts.push([name, below * mu, above * mu]);
    line.replaceChildren(element("strong", {}, `µ = ${digits(answer.mu, 4)}`));
    for (const [name, below, above] of parts) {
      const part = element("span", {class: "error"}, ` ${error(below, above)} `);
      part.append(element("small", {}, `(${name})`));
      line.append(" ", part);
    }
  }

  function write_answer() {
    const answer = at(state);
    by_id("law-mu").textContent = digits(answer.mu, 5);
    by_id("law-trust").textContent = answer.trusted ? "trusted" : "not trusted";
    by_id("law-trust").className = "trust" + (answer.trusted ? " yes" : "");
    by_id("law-why").textContent = reason(state, answer);
    by_id("law-run").textContent = interval(answer.lower, answer.upper);
    by_id("law-surface").textContent = law.law.profiles > 1 ?
      interval(answer.surface_lower, answer.surface_upper) :
      "not known: all runs are on one profile";
    by_id("law-k").textContent = Number.isFinite(answer.k) ?
      digits(answer.k / 1e6, 4) + " MPa" : "not known";
    by_id("law-tau").textContent = Number.isFinite(answer.tau) ?
      digits(answer.tau / 1e6, 4) + " MPa, " +
      (answer.tau < answer.k ? "sliding" : "sticking") : "–";
    write_line(answer);
  }

  /* Numbers for the marks of an axis. */
  function marks(low, high, n) {
    const raw = (high - low) / n, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw);
    const result = [];
    for (let x = Math.ceil(low / step) * step; x <= high + 1e-9 * step; x += step)
      result.push(Math.abs(x) < 1e-9 * step ? 0 : x);
    return result;
  }

  const W = 560, H = 330, left = 58, right = 14, top = 12, bottom = 44;

  /* mu over one input, the others as the sliders say. */
  function draw() {
    const over = Number(by_id("law-over").value), input = inputs[over];
    const {low, high} = ranges[over], n = 90;
    const points = [];
    for (let i = 0; i <= n; ++i) {
      const x = [...state];
      x[over] = low + (high - low) * i / n;
      points.push({x: x[over], ...at(x)});
    }
    const surface = law.law.profiles > 1;
    const inside = points.filter((p) => p.x >= input.lower && p.x <= input.upper);
    const finite = (values) => values.filter(Number.isFinite);
    let y_low = Math.min(...finite(points.map((p) => p.mu)),
                         ...finite(inside.map((p) => surface ? p.surface_lower :
                                                               p.lower)));
    let y_high = Math.max(...finite(points.map((p) => p.mu)),
                          ...finite(inside.map((p) => surface ? p.surface_upper :
                                                                p.upper)));
    const margin = 0.06 * (y_high - y_low) || 0.1 * Math.abs(y_high) || 1;
    y_low = y_low >= 0 ? Math.max(0, y_low - margin) : y_low - margin;
    y_high += margin;
    const X = (x) => left + (W - left - right) * (x - low) / (high - low);
    const Y = (y) => top + (H - top - bottom) *
                             (1 - (Math.min(Math.max(y, y_low), y_high) - y_low) /
                                    (y_high - y_low));
    const path = (list, f) => list.map((p, i) =>
      `${i ? "L" : "M"}${X(p.x).toFixed(1)} ${Y(f(p)).toFixed(1)}`).join("");
    const svg = by_id("law-plot");
    svg.replaceChildren();
    const add = (name, attributes, text) =>
      svg.append(element(name, attributes, text));

    add("rect", {class: "box", x: X(input.lower), y: top,
                 width: X(input.upper) - X(input.lower), height: H - top - bottom});
    for (const y of marks(y_low, y_high, 6)) {
      add("line", {class: "grid", x1: left, x2: W - right, y1: Y(y), y2: Y(y)});
      add("text", {x: left - 8, y: Y(y) + 4, "text-anchor": "end"}, digits(y, 4));
    }
    for (const x of marks(shown(input, low), shown(input, high), 7)) {
      const place = X(input.offset + input.factor * x);
      add("line", {class: "axis", x1: place, x2: place, y1: H - bottom,
                   y2: H - bottom + 5});
      add("text", {x: place, y: H - bottom + 19, "text-anchor": "middle"},
          digits(x, 6));
    }
    add("line", {class: "axis", x1: left, x2: W - right, y1: H - bottom,
                 y2: H - bottom});
    add("text", {x: (left + W - right) / 2, y: H - 6, "text-anchor": "middle"},
        `${input.name}${unit(input) && ` [${unit(input).trim()}]`}`);
    if (points[0].deviation >= 0) {
      const band = (lower, upper) => path(points, (p) => p[upper]) +
        path([...points].reverse(), (p) => p[lower]).replace("M", "L") + "Z";
      if (surface)
        add("path", {class: "surface", d: band("surface_lower", "surface_upper")});
      add("path", {class: "run", d: band("lower", "upper")});
    }
    add("path", {class: "beyond", d: path(points, (p) => p.mu)});
    let piece = [];
    for (const p of [...points, {trusted: false}])
      if (p.trusted)
        piece.push(p);
      else {
        if (piece.length > 1)
          add("path", {class: "law-line", d: path(piece, (q) => q.mu)});
        piece = [];
      }
    add("circle", {class: "here", cx: X(state[over]), cy: Y(at(state).mu), r: 5});
  }

  function add_slider(input, i) {
    const {low, high} = ranges[i], box = element("div", {class: "slider"});
    const label = element("label", {for: `law-input-${i}`});
    const value = element("output", {id: `law-value-${i}`});
    const slider = element("input", {type: "range", id: `law-input-${i}`, min: 0,
                                     max: steps, step: "any"});
    const write = () => {
      value.textContent = digits(shown(input, state[i]), 5) + unit(input);
    };
    label.append(element("span", {}, `${input.name.split("/").pop()} ` +
                                     (input.symbol.length < 3 ?
                                        input.symbol : "")), value);
    slider.value = steps * (state[i] - low) / (high - low);
    slider.addEventListener("input", () => {
      state[i] = low + (high - low) * Number(slider.value) / steps;
      write();
      update();
    });
    const range = element("div", {class: "range"});
    range.append(element("span", {}, `data from ${
                   digits(shown(input, input.lower), 6)}${unit(input)}`),
                 element("span", {}, `to ${
                   digits(shown(input, input.upper), 6)}${unit(input)}`));
    box.append(label, slider, range);
    by_id("law-sliders").append(box);
    by_id("law-over").append(
      element("option", {value: i}, input.name.split("/").pop().toLowerCase()));
    write();
  }

  function update() {
    write_answer();
    draw();
  }

  inputs.forEach(add_slider);
  by_id("law-over").addEventListener("change", draw);
  update();
})();
