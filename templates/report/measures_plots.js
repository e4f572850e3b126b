// Draws the plots of templates/report/measures.html. Colours are the page's own, by name, so that light, dark and print need no redrawing.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const made = "var(--made)";
  const real = "var(--real)";

  const config = {
    background: "transparent",
    font: "system-ui, sans-serif",
    view: { stroke: null },
    axis: {
      domainColor: "var(--rule)", tickColor: "var(--rule)", gridColor: "var(--grid)", labelColor: "var(--soft)",
      titleColor: "var(--soft)", labelFontSize: 11, titleFontSize: 11.5, titleFontWeight: 400, titlePadding: 8, tickSize: 4,
      labelPadding: 4, labelFlush: false,
    },
  };

  const wide = { width: 400, height: 225 };
  const narrow = { width: 250, height: 165 };
  const base = (layer, size = wide) => ({
    ...size, autosize: { type: "pad" }, padding: 4, config, layer,
  });

  const axis = (field, title, more = {}) => ({ field, type: "quantitative", title, ...more });
  const x_axis = (title, more = {}) => axis("x", title, { axis: { grid: false, tickCount: 7, zindex: 0 }, ...more });
  const y_axis = (title, more = {}) => axis("y", title, { axis: { domain: false, ticks: false, tickCount: 5, zindex: 0 }, ...more });

  const points = (values) => ({ values: values.map(([x, y]) => ({ x, y })) });

  // Points and line of the measured panes over those generated here.
  const against_count = (part, title) => {
    const x = x_axis("M, radial cracks", { scale: { zero: true, nice: true } });
    const y = y_axis(title, { scale: { zero: true, nice: true } });
    const cloud = Math.max(0.25, Math.min(0.7, 8 / Math.sqrt(part.points.length + 1)));
    return base([
      { data: points(part.points), mark: { type: "circle", size: 22, color: made, opacity: cloud }, encoding: { x, y } },
      { data: points(part.line), mark: { type: "line", color: made, strokeWidth: 1.75 }, encoding: { x, y } },
      { data: points(part.panes_line), mark: { type: "line", color: real, strokeWidth: 1.75, strokeDash: [6, 3] }, encoding: { x, y } },
      { data: points(part.panes), mark: { type: "circle", size: 46, color: real, opacity: 1 }, encoding: { x, y } },
    ]);
  };

  const bars = (cells, x, y) => ({
    data: { values: cells.map(([low, high, share]) => ({ low, high, share })) },
    mark: { type: "rect", clip: true, color: "var(--bar)", stroke: "var(--card)", strokeWidth: 0.75 },
    encoding: { x: { ...x, field: "low" }, x2: { field: "high" }, y: { ...y, field: "share" }, y2: { datum: 0 } },
  });

  const share_axis = y_axis("share, %", { scale: { zero: true, nice: true } });

  // Bars over the band of the published range.
  const histogram = (part, title, least, greatest, size = wide) => {
    const seen = part.cells.flatMap(([low, high]) => [low, high]);
    const domain = [Math.min(least, ...seen), Math.max(greatest, ...seen)];
    const x = x_axis(title, { scale: { domain, nice: false, zero: false } });
    const [low, high] = part.range;
    return base([
      { data: { values: [{ low, high }] }, mark: { type: "rect", color: "var(--band)" },
        encoding: { x: { ...x, field: "low" }, x2: { field: "high" } } },
      bars(part.cells, x, share_axis),
      { data: { values: [{ x: low }, { x: high }] }, mark: { type: "rule", color: made, strokeDash: [2, 3] }, encoding: { x } },
    ], size);
  };

  const counts = (part) => {
    const highest = Math.max(...part.cells.map((cell) => cell[1]), ...part.panes);
    const x = x_axis("M, radial cracks", { scale: { domain: [0, highest], nice: false } });
    const line = (values, mark) => ({
      data: points(values), mark: { type: "line", strokeWidth: 1.5, ...mark }, encoding: { x, y: share_axis },
    });
    return base([
      bars(part.cells, x, share_axis),
      line(part.poisson, { color: "var(--ink)" }),
      line(part.dispersed, { color: real, strokeDash: [6, 3] }),
      { data: { values: part.panes.map((count) => ({ x: count })) }, mark: { type: "tick", color: real, thickness: 1.5, size: 9, opacity: 0.9 },
        encoding: { x, y: { value: 225 } } },
    ]);
  };

  const specifications = {};
  if (data.panes) {
    const panes = data.panes;
    Object.assign(specifications, {
      large: () => against_count(panes.large, "N, reaching the edge"),
      ring: () => against_count(panes.ring, "mean radius, mm"),
      turns: () => histogram(panes.turns, "turn θ, degrees", -32.5, 32.5),
      ratios: () => histogram(panes.ratios, "d / (0.470 M + 13.90 mm)", 0.4, 1.6),
      counts: () => counts(panes.counts),
      edge_angles: () => histogram(panes.edge_angles, "angle, degrees", 45, 90),
    });
  }
  data.pavements.forEach((pavement, index) => {
    specifications[`alignment-${index}`] = () => histogram(pavement.alignment, "angle, degrees", 0, 6, narrow);
    specifications[`joints-${index}`] = () => histogram(pavement.joints, "width / asked width, %", 85, 115, narrow);
    specifications[`areas-${index}`] = () => histogram(pavement.areas, "area / asked area, %", 75, 125, narrow);
  });

  const draw = async (name) => {
    const place = document.getElementById(`plot-${name}`);
    try {
      const view = new vega.View(vega.parse(vegaLite.compile(specifications[name]()).spec), { renderer: "svg", hover: false });
      await view.initialize(place).runAsync();
      const label = place.closest("figure").querySelector("h3").textContent;
      const svg = place.querySelector("svg");
      svg.setAttribute("role", "img");
      svg.setAttribute("aria-label", label);
    } catch (error) {
      place.classList.add("failed");
      place.textContent = `This plot could not be drawn: ${error.message}`;
    }
  };

  for (const name of Object.keys(specifications)) draw(name);
})();
