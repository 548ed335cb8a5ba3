// What a designer asks: the kind of flow, residence, and gauges.

// How fast material sinks beside the walls, over height; the shares below 0.3
// stand, see flow_profile.csv.
function flowProfilePanel(container, run, number) {
  const sides = grouped(run.flowProfile, row => row.side);
  const indexed = run.flowProfile.filter(row => isFinite(row.mass_flow_index));
  if (indexed.length < 2)
    return;
  const colours = { left: "var(--c2)", right: "var(--c1)" }, { kind_of_flow: kind, transition_height_m: height } = run.summary;
  const series = sides.map(([side, rows]) => ({
    name: sides.length > 1 ? `beside the ${side} wall` : "beside the wall", colour: colours[side] || "var(--c1)", width: 2,
    points: rows.map(row => [row.mass_flow_index, row.y_m]),
  }));
  const [low, high] = d3.extent(run.flowProfile, row => row.y_m);
  series.push({ name: "limit of mass flow, 0.3", colour: "var(--rest)", dash: "4 3", width: 1.4, points: [[.3, low], [.3, high]] });
  const right = Math.max(1, d3.max(indexed, row => row.mass_flow_index));
  if (isFinite(height) && height !== null)
    series.push({ name: "material stands up to here", colour: "var(--accent)", dash: "9 3", width: 1.6, points: [[0, height], [right, height]] });
  const panel = document.createElement("figure");
  panel.className = "panel";
  panel.innerHTML = `<h3>${escapeHtml(kind ? kind[0].toUpperCase() + kind.slice(1) : "Kind of flow")}</h3><div></div><figcaption><b>Figure ${number()}.</b> ` +
    `Mass flow index: downward speed beside the wall over that in the middle, mean while the middle half of the discharged mass flowed.</figcaption>`;
  container.append(panel);
  plot(panel.children[1], {
    x: { label: "mass flow index", unit: "", zero: true }, y: { label: "height above the outlet", unit: "m" },
    series, upright: true, height: .82,
  });
}

// The first places of the material, coloured by when it has left: one canvas,
// the left half mirrored where half a section was computed.
function residenceMap(container, run, bounds, number) {
  const map = run.residenceMap;
  if (!map || map.time.every(time => time === null))
    return () => {};
  const mirrored = bounds ? bounds.mirrored : false, last = d3.max(map.time);
  const x0 = d3.min(map.x) - map.width / 2, x1 = d3.max(map.x) + map.width / 2;
  const y0 = d3.min(map.y) - map.height / 2, y1 = d3.max(map.y) + map.height / 2;
  const left = mirrored ? -x1 : x0, scale = Math.min(520 / (x1 - left), 560 / (y1 - y0)), pad = 6;
  const colour = share => d3.interpolateYlGnBu(1 - .92 * share);
  const panel = document.createElement("figure");
  panel.className = "panel";
  panel.innerHTML = `<h3>When material leaves, by its first place</h3>` +
    scaleHtml({ colour: code => colour(code / 255), ticks: d3.scaleLinear().domain([0, last]).ticks(5).map(t => [t, t / last]), unit: "s" }) +
    `<canvas class="residence" width="${Math.round((x1 - left) * scale + 2 * pad)}" height="${Math.round((y1 - y0) * scale + 2 * pad)}"></canvas>` +
    `<figcaption><b>Figure ${number()}.</b> Mean time when the material that was here at the start passed the outlet level. Grey: less than half of it had left by the end of the run.</figcaption>`;
  container.append(panel);
  const canvas = panel.querySelector("canvas"), context = canvas.getContext("2d");
  return () => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    const stays = getComputedStyle(document.body).getPropertyValue("--rest");
    map.x.forEach((x, i) => {
      context.fillStyle = map.share[i] < .5 ? stays : colour(map.time[i] / last);
      const width = map.width * scale, height = map.height * scale;
      for (const place of mirrored ? [x, -x] : [x])
        // Half a pixel more, so that nothing shines through between cells.
        context.fillRect(pad + (place - left) * scale - width / 2, pad + (y1 - map.y[i]) * scale - height / 2, width + .5, height + .5);
    });
  };
}

// What of each layer leaves when, one above the other.
function residencePanel(container, run, number) {
  const times = grouped(run.residence, row => row.time_s).filter(([, rows]) => rows.length === n_layers);
  if (times.length < 3)
    return () => {};
  const bands = d3.range(n_layers).map(i => ({ name: i === 0 ? "top layer" : i === n_layers - 1 ? "bottom layer" : "", colour: layerColour(i + 1), opacity: 1, points: [] }));
  times.slice(1).forEach(([time, rows], i) => {
    const duration = time - times[i][0];
    let below = 0;
    for (let layer = n_layers; layer >= 1; --layer) {
      const rate = rows[layer - 1].mass_left_kg / duration;
      bands[layer - 1].points.push([(time + times[i][0]) / 2, below, below + rate]);
      below += rate;
    }
  });
  const panel = document.createElement("figure");
  panel.className = "panel";
  panel.innerHTML = `<h3>Which layers leave when</h3><div></div><figcaption><b>Figure ${number()}.</b> The flow rate, divided into the 16 layers of the initial height that it comes from.<span class="screen"> A click shows that time.</span></figcaption>`;
  container.append(panel);
  return plot(panel.children[1], {
    x: { label: "time", unit: "s" }, y: { label: "flow rate", unit: run.isPlane ? "kg/s per m" : "kg/s", zero: true },
    series: [], bands, height: .6, pick: time => show(time),
  }).mark;
}

// A panel for each quantity, with a curve for each gauge.
function gaugePanels(container, run, number) {
  const gauges = grouped(run.gauges, row => row.gauge);
  if (gauges.length === 0) {
    byId("gauges").remove();
    return () => {};
  }
  const colours = d3.range(5).map(i => `var(--c${i + 1})`), dashes = [null, "7 4", "2 3", "9 3 2 3"];
  const pressure = row => -(row.stress_xx_Pa + row.stress_yy_Pa + row.stress_zz_Pa) / 3000;
  const quantities = [
    ["Normal pressure on walls", "kPa", row => row.normal_Pa / 1000],
    ["Friction on walls", "kPa", row => row.tangential_Pa / 1000],
    ["Mean pressure in the material", "kPa", pressure],
    ["Downward speed", "m/s", row => -row.velocity_y_m_per_s],
    ["Density", "kg/m³", row => row.density_kg_per_m3]];
  const marks = [];
  for (const [title, unit, value] of quantities) {
    const series = gauges.map(([name, rows], i) => ({
      name: escapeHtml(name), colour: colours[i % 5], dash: dashes[Math.floor(i / 5) % 4], width: 1.7,
      points: rows.map(row => [row.time_s, value(row)]),
    })).filter(s => s.points.some(point => isFinite(point[1])));
    if (series.length === 0)
      continue;
    const panel = document.createElement("figure");
    panel.className = "panel";
    panel.innerHTML = `<h3>${title}</h3><div></div><figcaption><b>Figure ${number()}.</b> ${title} at the gauges.</figcaption>`;
    container.append(panel);
    marks.push(plot(panel.children[1], { x: { label: "time", unit: "s" }, y: { label: title.toLowerCase(), unit, zero: title !== "Density" }, series, height: .6, pick: time => show(time) }).mark);
  }
  const places = gauges.map(([name, [row]]) => `${escapeHtml(name)} (x = ${shown(row.x_m)} m, y = ${shown(row.y_m)} m)`);
  byId("gauge-places").innerHTML = `Gauges: ${places.join(", ")}.`;
  return time => marks.forEach(mark => mark(time));
}

// Returns {follow(time), ink()}: the latter draws what depends on the theme.
function designSections(run, bounds, number) {
  const container = byId("pattern-panels");
  flowProfilePanel(container, run, number);
  const ink = residenceMap(container, run, bounds, number), mark = residencePanel(container, run, number);
  if (container.children.length === 0)
    byId("pattern").remove();
  const gauges = gaugePanels(byId("gauge-panels"), run, number);
  return { ink, follow: time => { mark(time); gauges(time); } };
}
