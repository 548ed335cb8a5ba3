// Puts the report together.

// What the address asks for after #, for example time=1.2&colour=speed&mesh&dark&play.
const wish = name => new URLSearchParams(location.hash.slice(1)).get(name);

let figureNumber = 0;
const nextFigure = () => ++figureNumber;
const byId = id => document.getElementById(id);

function rateFigure(run) {
  const container = byId("rate"), rows = run.flowRate;
  if (rows.length < 2) {
    container.remove();
    return () => {};
  }
  const points = column => rows.map(row => [row.time_s, row[column]]);
  const unit = run.isPlane ? "kg/s per m" : "kg/s";
  const { steady_flow_start_s: from, steady_flow_end_s: to, steady_flow_rate_kg_per_s: steady, flow_rate_plateau_kg_per_s: plateau } = run.summary;
  const level = value => [[rows[0].time_s, value], [rows[rows.length - 1].time_s, value]];
  const series = [{ name: "flow rate", colour: "var(--c1)", points: points("mass_flow_rate_kg_per_s"), width: 2.2 }];
  if (isFinite(plateau) && plateau !== null)
    series.push({ name: "mean, middle half", colour: "var(--c5)", dash: "10 4", points: level(plateau), width: 1.5 });
  if (isFinite(steady) && steady !== null && to > from)
    series.push({ name: "steady", colour: "var(--accent)", points: [[from, steady], [to, steady]], width: 3 });
  const dashes = ["7 4", "2 3", "9 3 2 3"], colours = ["var(--c2)", "var(--c3)", "var(--c4)"];
  Object.keys(rows[0]).filter(column => column.startsWith("beverloo_")).forEach((column, i) => {
    const grain = column.split("_")[1];
    if (rows.some(row => isFinite(row[column])))
      series.push({ name: grain === "0" ? "Beverloo, fine grains" : `Beverloo, grains of ${grain} outlets`, colour: colours[i % 3], dash: dashes[i % 3], points: points(column), width: 1.5 });
  });
  container.innerHTML = `<div></div><figcaption><b>Figure ${nextFigure()}.</b> Mass flow rate, the mean over ` +
    `${run.parameter("Output", "Flow rate window") || "a window of"} s.<span class="screen"> A click shows that time.</span></figcaption>`;
  const chart = plot(container.firstChild, {
    x: { label: "time", unit: "s" }, y: { label: "flow rate", unit, zero: true }, series, height: .72,
    pick: time => show(time),
  });
  return chart.mark;
}

// Work of gravity on the material in the computed region, and what of it is not
// in the material's energies and what has been dissipated: [[time, J], …] each.
// `error` is the share of that rest at checkTime, when all material was still
// there. Null where it can't be told.
function gravityWork(run) {
  const rows = run.history, [gx, gy] = run.parameter("Scene", "Gravity").split(",").map(Number);
  if (!isFinite(gy) || !("momentum_y_kg_m_per_s" in rows[0]) || run.parameter("Walls", "Velocities"))
    return null;
  const power = row => gx * row.momentum_x_kg_m_per_s + gy * row.momentum_y_kg_m_per_s;
  const held = row => row.kinetic_energy_J + row.elastic_energy_J - rows[0].elastic_energy_J + row.dissipated_energy_J;
  let sum = 0, checked = null;
  const work = [], rest = [];
  rows.forEach((row, i) => {
    if (i > 0)
      sum += (row.time_s - rows[i - 1].time_s) * (power(row) + power(rows[i - 1])) / 2;
    work.push([row.time_s, sum]);
    rest.push([row.time_s, sum - held(row)]);
    if (i > 0 && row.mass_discharged_kg - row.mass_falling_kg <= 1e-9 * row.mass_in_silo_kg)
      checked = { checkTime: row.time_s, error: Math.abs(sum - held(row)) / sum };
  });
  return checked && { work, rest, ...checked };
}

function balanceFigures(run) {
  const rows = run.history, unit = run.isPlane ? "per m" : "";
  if (rows.length < 2) {
    byId("balance").remove();
    return () => {};
  }
  const energy = d3.max(rows, row => row.dissipated_energy_J || row.elastic_energy_J || 0);
  const [by, joule] = energy > 2000 ? [1000, "kJ"] : [1, "J"];
  const curve = (name, column, colour, factor = 1) => column in rows[0] &&
    { name, colour, points: rows.map(row => [row.time_s, row[column] / factor]), width: 2 };
  const gravity = gravityWork(run);
  const figures = [
    ["Mass", { label: "mass", unit: `kg ${unit}`.trim(), zero: true }, [
      curve("in the silo", "mass_in_silo_kg", "var(--c1)"), curve("discharged", "mass_discharged_kg", "var(--c2)"),
      curve("of it falling", "mass_falling_kg", "var(--c3)"), curve("has not moved", "stagnant_mass_kg", "var(--rest)"),
      d3.max(rows, row => row.mass_lost_kg) > 0 && curve("lost", "mass_lost_kg", "var(--bad)")],
    `Masses in the silo, discharged and lost add up to the initial one${run.summary.mass_balance_error > 0 ? ` to ${shown(run.summary.mass_balance_error, 1)} of it` : ""}.`],
    ["Energy", { label: "energy", unit: `${joule} ${unit}`.trim(), zero: true }, [
      ...gravity ? [{ name: "work of gravity", colour: "var(--ink)", dash: "7 4", width: 1.6, points: gravity.work.map(([t, w]) => [t, w / by]) },
        { name: "taken along by what left", colour: "var(--c4)", width: 2, points: gravity.rest.map(([t, w]) => [t, w / by]) }] : [],
      curve("dissipated", "dissipated_energy_J", "var(--c2)", by), curve("kinetic", "kinetic_energy_J", "var(--c1)", by),
      curve("elastic", "elastic_energy_J", "var(--c3)", by)],
    "Dissipated means by plastic flow and wall friction since the start." + (gravity ? ` Gravity’s work, the integral of the momentum, is what the others and the material that has left the computed region have got; ` +
      `before any left (t = ${shown(gravity.checkTime, 2)} s) the two sides differ by ${shown(100 * gravity.error, 1)} %.` : "")],
  ];
  const marks = figures.map(([title, y, series, caption]) => {
    series = series.filter(Boolean);
    if (series.length === 0) return () => {};
    const panel = document.createElement("figure");
    panel.className = "panel";
    panel.innerHTML = `<h3>${title}</h3><div></div><figcaption><b>Figure ${nextFigure()}.</b> ${caption}</figcaption>`;
    byId("balance-panels").append(panel);
    return plot(panel.children[1], { x: { label: "time", unit: "s" }, y, series, height: .6, pick: time => show(time) }).mark;
  });
  return time => marks.forEach(mark => mark(time));
}

// Six times side by side, for each way to colour the particles.
function mapRows(run, bounds) {
  if (!run.movie) {
    byId("maps").remove();
    return;
  }
  const { movie } = run, last = movie.times.length - 1, n = Math.min(6, last + 1);
  const times = d3.range(n).map(i => movie.times[Math.round(i * last / Math.max(1, n - 1))]);
  const { x0, x1, y0, y1, mirrored } = bounds, width = 360, pad = 6;
  const scale = (width - 2 * pad) / (x1 - x0), height = Math.round((y1 - y0) * scale + 2 * pad);
  const place = { scale, x: pad - x0 * scale, y: pad + y1 * scale, bottom: height - pad };
  const ink = { draw: [] };
  for (const [name, colouring] of Object.entries(colourings(movie))) {
    const row = document.createElement("div");
    row.className = "map-row";
    row.innerHTML = `<div class="map-head"><h3>${colouring.title[0].toUpperCase() + colouring.title.slice(1)}</h3>${scaleHtml(colouring)}</div><div class="map-strip"></div>` +
      `<figcaption style="padding-left:0"><b>Figure ${nextFigure()}.</b> ${({ layer: "Layers of the initial height", speed: "Speed, on a logarithmic scale", pressure: "Mean pressure in the material" })[name]} at ${n} times.<span class="screen"> A click shows that time above.</span></figcaption>`;
    byId("map-rows").append(row);
    const colours = pixelColours(colouring);
    for (const time of times) {
      const figure = document.createElement("figure");
      figure.innerHTML = `<canvas width="${width}" height="${height}"></canvas><figcaption>${time.toFixed(2)} s</figcaption>`;
      figure.addEventListener("click", () => show(time));
      row.children[1].append(figure);
      const context = figure.firstChild.getContext("2d");
      const image = context.createImageData(width, height);
      drawParticles(image, movie, time, colouring.codes, colours, place, mirrored);
      ink.draw.push(() => {
        context.putImageData(image, 0, 0);
        context.strokeStyle = getComputedStyle(document.body).getPropertyValue("--wall");
        context.lineWidth = 4;
        context.lineCap = context.lineJoin = "round";
        for (const points of wallPaths(run, mirrored)) {
          context.beginPath();
          for (const [x, y] of points) context.lineTo(place.x + x * scale, place.y - y * scale);
          context.stroke();
        }
      });
    }
  }
  return () => ink.draw.forEach(draw => draw());
}

// What the tables hold of the time shown.
function readout(run) {
  const row = (rows, time) => rows[Math.min(rows.length - 1, d3.bisector(r => r.time_s).left(rows, time - 1e-9))];
  const mass = run.isPlane ? "kg/m" : "kg";
  return time => {
    const history = row(run.history, time) || {}, flow = row(run.flowRate, time) || {};
    const pressures = run.walls.lines.filter(l => !l.isOutlet).map(line => d3.max(wallFrame(line, time), r => r.normal_Pa));
    const lines = [["Flow rate", flow.mass_flow_rate_kg_per_s, run.isPlane ? "kg/(s m)" : "kg/s"], ["Discharged", history.mass_discharged_kg, mass],
      ["In the silo", history.mass_in_silo_kg, mass], ["Has not moved", history.stagnant_mass_kg, mass],
      ["Largest speed", history.largest_speed_m_per_s, "m/s"], ["Largest wall pressure", d3.max(pressures) / 1000, "kPa"]];
    const cells = lines.filter(([, value]) => isFinite(value))
      .map(([name, value, unit]) => `<tr><th>${name}</th><td>${shown(value, 4)} ${unit}</td></tr>`);
    byId("readout").innerHTML = cells.length ? `<tbody>${cells.join("")}</tbody>` : "";
  };
}

let show = () => {};

function flowSection(run, bounds, onTime) {
  if (!run.movie) {
    document.querySelector("#flow .stage").innerHTML = "<figcaption>The run has written no particles to show.</figcaption>";
    document.querySelector("#flow .choices").remove();
    return null;
  }
  const scene = stage(byId("view"), run, bounds);
  const describe = () => {
    byId("scale").innerHTML = scaleHtml(scene.colourOf[scene.state.field]);
    byId("flow-caption").innerHTML = `<b>Figure 1.</b> The material, coloured by ${scene.colourOf[scene.state.field].caption}` +
      `${bounds.mirrored ? "; the left half mirrors the right one, which was computed" : ""}, at t = <span id="caption-time"></span> s.<span class="screen"> Ctrl and the wheel enlarge, a double click goes back.</span>`;
    byId("caption-time").textContent = scene.state.time.toFixed(2);
    for (const button of byId("colour").children)
      button.setAttribute("aria-checked", button.dataset.field === scene.state.field);
  };
  for (const [field, { title }] of Object.entries(scene.colourOf)) {
    const button = document.createElement("button");
    Object.assign(button, { type: "button", textContent: title, onclick: () => { scene.set({ field }); describe(); } });
    button.setAttribute("role", "radio");
    button.dataset.field = field;
    byId("colour").append(button);
  }
  if (wish("colour") in scene.colourOf)
    scene.set({ field: wish("colour") });
  describe();
  if (!run.mesh) byId("show-mesh").parentNode.remove();
  // A body's are means over bands, which no cut shows.
  if (run.walls.lines.length === 0 || run.isBody) byId("show-tractions").parentNode.remove();
  for (const [id, what] of [["show-mesh", "mesh"], ["show-tractions", "tractions"]].filter(([id]) => byId(id))) {
    byId(id).onchange = event => scene.set({ [what]: event.target.checked });
    if (wish(what) !== null) {
      byId(id).checked = true;
      scene.set({ [what]: true });
    }
  }
  const controls = player(run, scene, onTime);
  return { scene, controls };
}

function themes(redraw) {
  const root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)");
  let chosen = wish("dark") !== null ? "dark" : wish("light") !== null ? "light" : null;
  const set = theme => { root.dataset.theme = theme; redraw(); };
  const current = () => chosen || (dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => set(current()));
  byId("theme").onclick = () => { chosen = current() === "dark" ? "light" : "dark"; set(chosen); };
  byId("print").onclick = () => window.print();
  // Paper is white.
  addEventListener("beforeprint", () => set("light"));
  addEventListener("afterprint", () => set(current()));
  set(current());
}

async function main() {
  const run = await loadRun();
  run.walls = { lines: wallLines(run.walls) };
  const bounds = run.movie ? boundsOf(run) : null;
  byId("lead").innerHTML = leadSentences(run);
  byId("notices").innerHTML = notices(run);
  byId("key-figures").innerHTML = run.summary.mass_initial_kg === undefined ? "" : keyFigures(run);
  if (run.movie) nextFigure();

  const followers = [rateFigure(run), readout(run)];
  if (run.walls.lines.length > 0) {
    followers.push(wallPanels(byId("wall-panels"), run, nextFigure));
    ratioPanel(byId("wall-panels"), run, nextFigure);
    wallTable(byId("wall-table"), run);
  } else
    byId("walls").remove();
  const design = designSections(run, bounds, nextFigure);
  followers.push(design.follow);
  const inkMaps = mapRows(run, bounds) || (() => {});
  followers.push(balanceFigures(run));

  byId("scene-tables").innerHTML = sceneTables(run);
  byId("all-results").innerHTML += plainTable("", Object.entries(run.summary).map(([key, value]) => [key, escapeHtml(value)]));
  byId("all-parameters").innerHTML += allParameters(run);
  byId("log").innerHTML += `<pre>${escapeHtml(run.log)}</pre>`;
  byId("version").textContent = run.summary.version ? ` from a run of Sandglass ${run.summary.version} (${run.summary.git_hash})` : "";

  const follow = time => followers.forEach(follower => follower(time));
  const flow = flowSection(run, bounds, follow);
  show = flow ? flow.controls.show : follow;
  themes(() => { if (flow) flow.scene.draw(); design.ink(); inkMaps(); });
  show(+wish("time") || (run.movie ? run.movie.times[0] : run.summary.end_time_s || 0));
  document.body.dataset.ready = "yes";
  if (flow && wish("play") !== null)
    flow.controls.setPlaying(true);
}

main().catch(error => {
  byId("notices").innerHTML = `<p class="notice bad">${escapeHtml(error.message)}</p>`;
  throw error;
});
