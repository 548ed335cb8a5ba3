// Pressures on the walls, from wall_traction.csv.

// Lines of walls: [{name, side, label, isUpright, isOutlet, times, frames}], frames
// being the rows of each time in the order of arc length.
function wallLines(rows) {
  const lines = grouped(rows, row => row.wall + "|" + (row.side || "")).map(([key, values]) => {
    const [name, side] = key.split("|");
    const frames = grouped(values, row => row.time_s)
      .map(([, ofTime]) => ofTime.sort((a, b) => a.arc_length_m - b.arc_length_m));
    const span = column => { const [low, high] = d3.extent(frames[0], row => row[column]); return high - low; };
    return {
      name, side, isOutlet: name === "outlet", isUpright: span("y_m") > 0.5 * span("x_m"),
      times: frames.map(frame => frame[0].time_s), frames,
    };
  });
  const title = { wall: "Vertical wall", floor: "Floor", hopper: "Hopper", outlet: "Closed outlet" };
  const isBothSided = new Set(lines.map(line => line.side).filter(side => side !== "middle")).size > 1;
  for (const line of lines)
    line.label = (title[line.name] || line.name) + (isBothSided && line.side !== "middle" ? ", " + line.side : "");
  const order = ["wall", "hopper", "floor", "outlet"];
  return lines.sort((a, b) => (order.indexOf(a.name) + 9) % 9 - (order.indexOf(b.name) + 9) % 9 ||
    d3.ascending(a.side, b.side));
}

// The rows of the time next to `time`.
function wallFrame(line, time) {
  return line.frames[d3.scan(line.times, (a, b) => Math.abs(a - time) - Math.abs(b - time))];
}

// Smallest and largest pressure at each node after the start, where they are
// over the run: [{row, low, high, time}].
function envelope(line) {
  const later = line.frames.slice(1);
  return line.frames[0].map((row, i) => {
    const ofNode = later.map(frame => frame[i]).filter(r => r && isFinite(r.normal_Pa));
    const highest = d3.scan(ofNode, (a, b) => b.normal_Pa - a.normal_Pa);
    return ofNode.length === 0 ? { row, low: NaN, high: NaN, time: NaN } : {
      row, low: d3.min(ofNode, r => r.normal_Pa), high: ofNode[highest].normal_Pa, time: ofNode[highest].time_s,
    };
  });
}

// Rows of wall_envelope.csv on a line, by arc length; empty without the file.
function envelopeRows(run, line) {
  return run.wallEnvelope.filter(row => row.wall === line.name && row.side === line.side).sort((a, b) => a.arc_length_m - b.arc_length_m);
}

// Patch loads of EN 1991-4 on top of its symmetrical pressures.
const patchReferences = [
  ["en_1991_4_filling_normal_Pa", "en_1991_4_filling_patch_Pa", "filling and patch", "var(--c3)"],
  ["en_1991_4_discharge_normal_Pa", "en_1991_4_discharge_patch_Pa", "discharge and patch", "var(--c4)"],
];

// The outward normals at the nodes of a line that goes away from the outlet.
function outwardNormals(frame, side) {
  return frame.map((row, i) => {
    const a = frame[Math.max(0, i - 1)], b = frame[Math.min(frame.length - 1, i + 1)];
    const dx = b.x_m - a.x_m, dy = b.y_m - a.y_m, length = Math.hypot(dx, dy) || 1;
    const sign = side === "left" ? -1 : 1;
    return [sign * dy / length, -sign * dx / length];
  });
}

const wallReferences = [
  ["janssen_normal_Pa", "Janssen", "var(--c2)", "7 4"],
  ["en_1991_4_filling_normal_Pa", "EN 1991-4, filling", "var(--c3)", "2 3"],
  ["en_1991_4_discharge_normal_Pa", "EN 1991-4, discharge", "var(--c4)", "9 3 2 3"],
];

// Draw a panel for each line; returns a function of the time shown.
function wallPanels(container, run, number) {
  const updates = run.walls.lines.filter(line => line.frames[0].length > 1 && !(line.isOutlet && line.frames.length === 1)).map(line => {
    const start = line.frames[0], extremes = envelope(line);
    const along = row => line.isUpright ? row.y_m : row.x_m;
    const point = (value, row) => line.isUpright ? [value / 1000, along(row)] : [along(row), value / 1000];
    const curve = (rows, column) => rows.map(row => point(row[column], row));
    const fixed = wallReferences.filter(([column]) => start.some(row => isFinite(row[column]) && row[column] > 0))
      .map(([column, name, colour, dash]) => ({ name, colour, dash, points: curve(start, column), width: 1.6 }));
    const rows = envelopeRows(run, line);
    for (const [column, patch, name, colour] of patchReferences)
      if (rows.some(row => row[patch] > 0))
        fixed.push({ name: `EN 1991-4, ${name}`, colour, dash: "1 3", points: rows.map(row => point(row[column] + row[patch], row)), width: 1.4 });
    const hasFlow = line.frames.length > 1;
    const seriesAt = time => [
      { name: "at rest", colour: "var(--rest)", points: curve(start, "normal_Pa"), width: 2.2 },
      ...(hasFlow ? [{ name: "largest", colour: "var(--c1)", points: extremes.map(e => point(e.high, e.row)), width: 1.1 }] : []),
      ...(hasFlow ? [{ name: "at the time shown", colour: "var(--accent)", points: curve(wallFrame(line, time), "normal_Pa"), width: 2.2 }] : []),
      ...fixed];
    const bands = hasFlow ? [{
      name: "range over the run", colour: "var(--c1)", opacity: .16,
      points: extremes.map(e => line.isUpright ? [e.low / 1000, e.high / 1000, along(e.row)] : [along(e.row), e.low / 1000, e.high / 1000]),
    }] : [];

    const panel = document.createElement("figure");
    panel.className = "panel";
    panel.innerHTML = `<h3>${escapeHtml(line.label)}</h3><div></div><figcaption><b>Figure ${number()}.</b> Normal pressure on the ${escapeHtml(line.label.toLowerCase())}. ` +
      `${hasFlow ? "After the start each value is the mean over the interval of output before it." : ""}</figcaption>`;
    container.append(panel);
    const pressure = { label: "normal pressure", unit: "kPa", zero: true };
    const place = line.isUpright ? { label: "height above the outlet", unit: "m" } : { label: "distance from the middle", unit: "m" };
    const chart = plot(panel.children[1], {
      x: line.isUpright ? pressure : place, y: line.isUpright ? place : pressure,
      series: seriesAt(0), bands, upright: line.isUpright, height: line.isUpright ? .82 : .62,
    });
    let shownFrame = null;
    return time => {
      const frame = wallFrame(line, time);
      if (frame !== shownFrame)
        chart.update(seriesAt(time));
      shownFrame = frame;
    };
  });
  return time => updates.forEach(update => update(time));
}

// The largest pressure after the start or at rest: {line, row, value, time}, or
// null. That of an outlet before it opens is none.
function largestPressure(lines) {
  let found = null;
  for (const line of lines.filter(l => !l.isOutlet || l.frames.length > 1))
    for (const frame of line.frames)
      for (const row of frame)
        if (isFinite(row.normal_Pa) && (!found || row.normal_Pa > found.value))
          found = { line, row, value: row.normal_Pa, time: row.time_s };
  return found;
}

// The force of a traction on a wall: per metre of depth in a plane silo, round
// the whole circumference in a round one, on the part that was computed in a
// body (N).
function wallForce(frame, column, run) {
  if (run.isBody)
    return d3.sum(frame, row => row.area_m2 * (isFinite(row[column]) ? row[column] : 0));
  return d3.sum(d3.pairs(frame), ([a, b]) => {
    const length = Math.hypot(b.x_m - a.x_m, b.y_m - a.y_m);
    const weight = row => (run.isPlane ? 1 : 2 * Math.PI * Math.abs(row.x_m)) * (isFinite(row[column]) ? row[column] : 0);
    return length * (weight(a) + weight(b)) / 2;
  });
}

// How much more than at rest walls bear in discharge, node by node.
function ratioPanel(container, run, number) {
  const lines = run.walls.lines.filter(line => !line.isOutlet)
    .map(line => [line, envelopeRows(run, line).filter(row => isFinite(row.largest_over_filling))]).filter(([, rows]) => rows.length > 1);
  if (lines.length === 0)
    return;
  const colours = d3.range(5).map(i => `var(--c${i + 1})`);
  const panel = document.createElement("figure");
  panel.className = "panel";
  panel.innerHTML = `<h3>Largest over filling pressure</h3><div></div><figcaption><b>Figure ${number()}.</b> The largest pressure in discharge over that at rest, at each node. ` +
    `EN 1991-4 has 1.15 on the walls of slender silos. Ratios are large where little is borne at rest.</figcaption>`;
  container.append(panel);
  plot(panel.children[1], {
    x: { label: "distance along the wall from the outlet", unit: "m" }, y: { label: "ratio", unit: "", zero: true }, height: .62,
    series: [...lines.map(([line, rows], i) => ({ name: line.label, colour: colours[i % 5], width: 1.8, points: rows.map(row => [row.arc_length_m, Math.min(row.largest_over_filling, 10)]) })),
      { name: "1.15", colour: "var(--rest)", dash: "4 3", width: 1.3, points: d3.extent(lines.flatMap(([, rows]) => rows), row => row.arc_length_m).map(s => [s, 1.15]) }],
  });
}

function wallTable(container, run) {
  const force = run.isPlane ? "kN/m" : "kN";
  const rows = run.walls.lines.map(line => {
    const start = line.frames[0], largest = largestPressure([{ ...line, isOutlet: false }]);
    const rest = d3.max(start, row => row.normal_Pa);
    const reference = column => {
      const value = d3.max(start, row => row[column]);
      return value > 0 ? shown(value / 1000) : "–";
    };
    const place = line.isUpright ? `${shown(largest.row.y_m)} m high` : `x = ${shown(largest.row.x_m)} m`;
    return `<tr><td>${escapeHtml(line.label)}</td><td data-largest="${largest.value}">${shown(largest.value / 1000)}<small>${place}, ${shown(largest.time)} s</small></td>` +
      `<td>${shown(rest / 1000)}</td><td>${shown(largest.value / rest)}</td><td>${reference("janssen_normal_Pa")}</td>` +
      `<td>${reference("en_1991_4_filling_normal_Pa")}</td><td>${reference("en_1991_4_discharge_normal_Pa")}</td>` +
      `<td>${shown(wallForce(start, "normal_Pa", run) / 1000)}</td><td>${shown(wallForce(start, "tangential_Pa", run) / 1000)}</td></tr>`;
  });
  container.innerHTML = `<div class="wide"><table class="data"><thead><tr><th>Wall</th><th>Largest pressure<br>kPa</th><th>Largest at rest<br>kPa</th>` +
    `<th>Ratio</th><th>Janssen<br>kPa</th><th>EN 1991-4 filling<br>kPa</th><th>EN 1991-4 discharge<br>kPa</th><th>Normal force at rest<br>${force}</th><th>Friction at rest<br>${force}</th></tr></thead>` +
    `<tbody>${rows.join("")}</tbody></table></div>` +
    `<p class="muted small">Largest pressures over the run and over the wall; forces are those ${run.isBody ? "on the part of each wall that was computed; rows are means over bands of a wall" : run.isPlane ? "on each wall named, on one side where half of the silo was computed" : "round the whole circumference"}.</p>`;
}
