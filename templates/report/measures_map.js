// Draws the maps of templates/report/measures_pavement.html on canvases: 75,000 stones would be slow as elements. Stones of one colour
// are one path, made once for each way of colouring, so that moving and zooming only fill some thirty paths.
"use strict";
(() => {
  const pavements = JSON.parse(document.getElementById("data").textContent).pavements;
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const light_ramp = [[216, 222, 214], [240, 205, 120], [214, 110, 40], [130, 15, 30]];
  const dark_ramp = [[62, 74, 80], [158, 128, 58], [226, 118, 52], [255, 196, 178]];
  const steps = 32;

  // What stones are coloured by: from the numbers of a stone, the value that is full colour, and words.
  const ways = {
    alignment: { value: (s) => s.alignment, full: 5, unit: "°", word: "off the rows, mean of a stone’s sides" },
    joint: { value: (s) => s.joint, full: 10, unit: " %", word: "worst joint off the asked width" },
    area: { value: (s) => (s.area === null ? null : Math.abs(s.area - 100)), full: 25, unit: " %", word: "area off the asked one" },
  };

  const ramp_colour = (share) => {
    const ramp = dark.matches ? dark_ramp : light_ramp;
    const at = Math.min(share, 0.9999) * (ramp.length - 1);
    const i = Math.floor(at);
    const mixed = ramp[i].map((c, k) => Math.round(c + (at - i) * (ramp[i + 1][k] - c)));
    return `rgb(${mixed.join(",")})`;
  };

  // Each stone in `map.stones` is: id less the one before, flags (1 cut, 2 irregular, 4 missing), angle in 1/100°, worst joint in
  // 1/10 %, area in 1/10 % (−1: not measured), corners, then the first corner and steps to the others.
  const read = (map) => {
    const stones = [];
    const n = map.stones;
    const told = (number, scale) => (number < 0 ? null : number / scale);
    let id = -1;
    for (let i = 0; i < n.length;) {
      id += n[i];
      const stone = { id, cut: (n[i + 1] & 1) > 0, irregular: (n[i + 1] & 2) > 0, missing: (n[i + 1] & 4) > 0,
        alignment: told(n[i + 2], 100), joint: told(n[i + 3], 10), area: told(n[i + 4], 10), points: [] };
      const corners = n[i + 5];
      i += 6;
      let [x, y] = [0, 0];
      for (let k = 0; k < corners; ++k, i += 2) {
        [x, y] = [x + n[i], y + n[i + 1]];
        stone.points.push([x, y]);
      }
      stones.push(stone);
    }
    return stones;
  };

  const trace = (path, points) => {
    points.forEach(([x, y], k) => (k === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    path.closePath();
  };

  const middle = (points) => [0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);

  const contains = (points, [x, y]) => {
    let inside = false;
    points.forEach(([ax, ay], k) => {
      const [bx, by] = points[(k + 1) % points.length];
      if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
    });
    return inside;
  };

  const show = (figure, map) => {
    const canvas = figure.querySelector("canvas");
    const context = canvas.getContext("2d");
    const stones = read(map);
    const [width, height] = map.size;
    canvas.style.aspectRatio = `${width} / ${Math.min(height, width)}`;
    const rings = new Path2D();
    for (const ring of map.rings) trace(rings, ring);
    let by = null;
    let paths = [];
    let view = { scale: 1, x: 0, y: 0 };

    const make_paths = () => {
      paths = Array.from({ length: steps + 1 }, () => new Path2D());
      for (const stone of stones) {
        if (stone.missing) continue;
        const value = ways[by].value(stone);
        const step = value === null ? steps : Math.min(steps - 1, Math.floor((value / ways[by].full) * steps));
        trace(paths[step], stone.points);
      }
    };

    const marks = (places, radius, fill) => {
      for (const [x, y] of places) {
        context.beginPath();
        context.arc(x, y, radius, 0, 2 * Math.PI);
        if (fill) context.fill(); else context.stroke();
      }
    };
    const irregular = stones.filter((stone) => stone.irregular).map((stone) => middle(stone.points));
    const spacing = Math.sqrt((width * height) / Math.max(stones.length, 1));

    const draw = () => {
      const style = getComputedStyle(document.documentElement);
      const pixels = canvas.width / width;
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, canvas.width, canvas.height);
      context.setTransform(pixels * view.scale, 0, 0, -pixels * view.scale, view.x, view.y);
      context.fillStyle = style.getPropertyValue("--grid");
      context.fill(rings, "evenodd");
      paths.forEach((path, step) => {
        context.fillStyle = step === steps ? style.getPropertyValue("--rule") : ramp_colour((step + 0.5) / steps);
        context.fill(path);
      });
      const unit = 1 / (pixels * view.scale);
      context.fillStyle = context.strokeStyle = style.getPropertyValue("--ink");
      marks(irregular, Math.max(0.13 * spacing, 1.2 * unit), true);
      context.strokeStyle = style.getPropertyValue("--bad");
      context.lineWidth = 2.5 * unit;
      marks(map.holes, Math.max(0.8 * spacing, 9 * unit), false);
      canvas.dataset.stones = stones.length;
    };

    const fit = () => {
      canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
      canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
      const scale = Math.min(1, canvas.height / ((canvas.width / width) * height));
      view = { scale, x: 0.5 * (1 - scale) * canvas.width, y: canvas.height - 0.5 * (canvas.height - (canvas.width / width) * height * scale) };
      draw();
    };

    const colour_by = (name) => {
      by = name;
      make_paths();
      for (const button of figure.querySelectorAll("button")) button.setAttribute("aria-pressed", button.dataset.by === name);
      const colours = Array.from({ length: 9 }, (_, k) => ramp_colour(k / 8));
      figure.querySelector(".legend i").style.background = `linear-gradient(90deg, ${colours.join(",")})`;
      figure.querySelector(".low").textContent = `0${ways[name].unit}`;
      figure.querySelector(".high").textContent = `${ways[name].full}${ways[name].unit} and more`;
      figure.querySelector(".word").textContent = ways[name].word;
    };

    for (const button of figure.querySelectorAll("button")) {
      button.disabled = !stones.some((stone) => ways[button.dataset.by].value(stone) !== null);
      button.addEventListener("click", () => { colour_by(button.dataset.by); draw(); });
    }
    const first = [...figure.querySelectorAll("button")].find((button) => !button.disabled);
    colour_by(first ? first.dataset.by : "area");

    const at_pointer = (event) => [event.offsetX * devicePixelRatio, event.offsetY * devicePixelRatio];
    const on_map = ([x, y]) => {
      const scale = (canvas.width / width) * view.scale;
      return [(x - view.x) / scale, -(y - view.y) / scale];
    };
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      const [x, y] = at_pointer(event);
      const factor = Math.min(200 / view.scale, Math.max(0.5 / view.scale, Math.exp(-0.0015 * event.deltaY)));
      view = { scale: view.scale * factor, x: x + factor * (view.x - x), y: y + factor * (view.y - y) };
      draw();
    }, { passive: false });
    canvas.addEventListener("dblclick", fit);
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons > 0) {
        view.x += event.movementX * devicePixelRatio;
        view.y += event.movementY * devicePixelRatio;
        draw();
        return;
      }
      const place = on_map(at_pointer(event));
      const stone = stones.find((s) => Math.abs(s.points[0][0] - place[0]) < 4 * spacing && contains(s.points, place));
      if (!stone) return;
      const told = (value, unit) => (value === null ? "–" : `${value}${unit}`);
      figure.querySelector(".tip").textContent = `Stone ${stone.id}, ${stone.cut ? "cut" : "whole"}${stone.missing ? ", left out" : ""}` +
        `${stone.irregular ? ", irregular" : ""}: off the rows ${told(stone.alignment, "°")}, worst joint off ${told(stone.joint, " %")}, area ${told(stone.area, " %")}`;
    });
    dark.addEventListener("change", () => { colour_by(by); draw(); });
    addEventListener("resize", fit);
    fit();
  };

  pavements.forEach((pavement, index) => {
    const figure = document.getElementById(`map-${index}`);
    try {
      show(figure, pavement.map);
    } catch (error) {
      figure.classList.add("failed");
      console.error(error);
    }
  });
})();
