// What was computed, in words and tables.

function escapeHtml(text) {
  return String(text).replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", "\"": "&quot;" })[c]);
}

function leadSentences(run) {
  const { summary, parameter, isPlane } = run;
  const number = (section, name) => parseFloat(parameter(section, name));
  if (!parameter("Scene", "Formulation"))
    return "";
  const isSquareCut = run.isBody && parameter("Scene", "Cross section") === "rectangle";
  const kind = isPlane ? "plane" : isSquareCut ? "rectangular" : "round", sentences = [];
  if (parameter("Scene", "Shape") === "mesh file")
    sentences.push(`A ${kind} silo from the mesh file ${escapeHtml(parameter("Scene", "Mesh file"))}.`);
  else {
    const width = 2 * number("Scene", "Half width"), outlet = 2 * number("Scene", "Outlet half width");
    const hopper = number("Scene", "Hopper height"), wall = number("Scene", "Wall height");
    const slope = Math.atan((width - outlet) / 2 / hopper) * 180 / Math.PI;
    const aside = number("Scene", "Outlet eccentricity");
    const bottom = hopper > 0 ? `a hopper ${shown(hopper)} m high, whose walls are ${shown(slope)}° from the vertical,` : "a flat bottom";
    const isClosed = parameter("Scene", "Outlet") === "closed";
    sentences.push(`A ${kind} silo ${shown(width)} m ${isPlane || isSquareCut ? "wide" : "in diameter"}${wall > 0 ? `, with a wall ${shown(wall)} m high` : ""}, ${bottom} and ` +
      `${isClosed ? "a closed outlet" : isPlane || (run.isBody && parameter("Scene", "Outlet shape") === "slot") ? "a slot" : run.isBody && parameter("Scene", "Outlet shape") === "rectangle" ? "a rectangular outlet" : "a round outlet"} of ${shown(outlet)} m${aside ? `, ${shown(aside)} m off the middle` : ""}.`);
  }
  const model = parameter("Material", "Model");
  sentences.push(`The material (${escapeHtml(model)}) has a bulk density of ${shown(number("Material", "Density"), 4)} kg/m³ and an angle of internal friction of ` +
    `${shown(number("Material", "Internal friction angle"))}°; the walls’ friction is ${shown(number("Walls", "Friction angle"))}°.`);
  if (summary.mass_initial_kg !== undefined)
    sentences.push(`${shown(summary.mass_initial_kg, 4)} kg${isPlane ? " per metre of depth" : ""}, as ` +
      `${shown(summary.particles, 7)} particles on ${shown(summary.cells, 7)} cells, were followed for ${shown(summary.end_time_s)} s.`);
  return sentences.join(" ");
}

function notices(run) {
  const { summary, parameter } = run, list = [];
  const until = isFinite(summary.end_time_s) ? `up to t = ${shown(summary.end_time_s)} s of ${parameter("Particle stage", "End time")} s` : "";
  if (summary.status === "running")
    list.push(["", `The run is still going on, or was killed. This is what it has written so far${until && ", " + until}.`]);
  else if (summary.status !== "finished")
    list.push(["bad", `The run has ${escapeHtml(summary.status)}. ${until && `This is what it had written, ${until}. `}${escapeHtml(summary.message || "")}`]);
  for (const line of run.log.split("\n"))
    if (line.startsWith("Warning: "))
      list.push(["warn", escapeHtml(line.slice(9))]);
  if (run.movie && run.movie.times.length < run.movie.of_frames)
    list.push(["", `Of ${run.movie.of_frames} times of output ${run.movie.times.length} are shown, evenly chosen, to keep this page small.`]);
  if (run.movie && run.movie.in_cut < run.movie.of_particles)
    list.push(["", `The silo was computed in three dimensions: the pictures show the ${shown(run.movie.in_cut, 9)} of ${shown(run.movie.of_particles, 9)} particles that lay next to the plane z = 0 at the start; particles.pvd has all.`]);
  if (run.movie && run.movie.particles < 0.99 * run.movie.in_cut)
    list.push(["", `Of ${shown(run.movie.in_cut, 9)} particles ${shown(run.movie.particles, 9)} are shown, to keep this page small.`]);
  return list.map(([kind, text]) => `<p class="notice ${kind}">${text}</p>`).join("");
}

// Tiles: [key of summary.json, title, value, unit, what stands below].
function keyFigures(run) {
  const { summary, flowRate, isPlane } = run, perDepth = isPlane ? " per m" : "";
  const tiles = [], share = mass => shown(100 * mass / summary.mass_initial_kg) + " % of all";
  const add = (key, title, value, unit, below = "") => {
    if (value !== undefined) tiles.push([key, title, value, unit, below]);
  };
  const beverloo = flowRate.length ? Object.keys(flowRate[0]).filter(c => c.startsWith("beverloo")).map(c => flowRate[0][c]) : [];
  add("flow_rate_plateau_kg_per_s", "Flow rate", summary.flow_rate_plateau_kg_per_s, "kg/s" + perDepth,
    beverloo.some(isFinite) ? `Beverloo: ${shown(d3.min(beverloo), 4)} – ${shown(d3.max(beverloo), 4)}` : "mean over the middle half");
  add("mass_discharged_kg", "Discharged", summary.mass_discharged_kg, "kg" + perDepth, share(summary.mass_discharged_kg));
  if (summary.flow_rate_plateau_kg_per_s !== undefined)
    if (summary.discharge_time_s === null)
      add("mass_in_silo_kg", "Left in the silo", summary.mass_in_silo_kg, "kg" + perDepth, share(summary.mass_in_silo_kg) + "; still flowing at the end");
    else {
      add("discharge_time_s", "Emptied in", summary.discharge_time_s, "s", "99.9 % of what has left");
      add("residual_mass_kg", "Left for good", summary.residual_mass_kg, "kg" + perDepth, share(summary.residual_mass_kg));
    }
  if (summary.kind_of_flow)
    add("kind_of_flow", "Kind of flow", summary.kind_of_flow, "", summary.transition_height_m === null ? "all material moves" :
      `material stands beside the wall up to ${shown(summary.transition_height_m)} m; ${shown(100 * summary.slipping_wall_share, 2)} % of the walls’ area slips`);
  add("first_in_first_out_share", "Leaves in order", summary.first_in_first_out_share && 100 * summary.first_in_first_out_share, "%",
    `of places above each other the lower one first; residence ${shown(summary.mean_residence_time_s)} ± ${shown(summary.residence_time_spread_s)} s`);
  const largest = largestPressure(run.walls.lines);
  if (largest)
    add("largest_wall_pressure_Pa", "Largest wall pressure", largest.value / 1000, "kPa",
      `${escapeHtml(largest.line.label.toLowerCase())}, ${largest.line.isUpright ? `${shown(largest.row.y_m)} m high` : `x = ${shown(largest.row.x_m)} m`}, ${largest.time === 0 ? "at rest" : `t\u00a0=\u00a0${shown(largest.time)}\u00a0s`}`);
  if (summary.stagnant_mass_kg !== undefined && summary.discharge_time_s === null)
    add("stagnant_mass_kg", "Has not moved", summary.stagnant_mass_kg, "kg" + perDepth, share(summary.stagnant_mass_kg));
  add("mass_balance_error", "Mass balance", summary.mass_balance_error, "", "difference over the initial mass");
  return tiles.map(([key, title, value, unit, below]) =>
    `<div><dt>${title}</dt><dd data-key="${key}" data-value="${value}">${typeof value === "string" ? escapeHtml(value) : shown(value, Math.abs(value) < 1e-3 ? 1 : 4)}<small>${unit}</small></dd><p>${below}</p></div>`).join("");
}

function plainTable(title, rows) {
  return rows.length === 0 ? "" : `<div>${title ? `<h3>${title}</h3>` : ""}<table class="data plain"><tbody>` +
    rows.map(cells => `<tr>${cells.map(cell => `<td>${cell}</td>`).join("")}</tr>`).join("") + "</tbody></table></div>";
}

const unitOf = meaning => { const unit = meaning.match(/Units?: ([^.]+?)\.?(?=$| )/); return unit && unit[1] !== "1" ? unit[1].replace(/\^2/g, "²").replace(/\^3/g, "³") : ""; };

// The parameters that say what was computed, section by section.
function sceneTables(run) {
  const wanted = {
    "Scene": ["Formulation", "Mesh file", "Half width", "Wall height", "Hopper height", "Outlet half width", "Outlet eccentricity", "Outlet", "Fill height", "Gravity"],
    "Material": ["Model", "Density", "Young modulus", "Poisson ratio", "Internal friction angle", "Yield cone", "Cohesion", "Law constants"],
    "Walls": ["Friction angle", "Floor friction angle", "Hopper friction angle", "Friction angles", "Box depth", "Velocities"],
    "Particle stage": ["End time", "Time step", "Volumetric strain", "Force integration", "Density update"],
  };
  const quiet = { "Outlet eccentricity": "0", "Hopper height": "0", "Cohesion": "0", "Box depth": "0" };
  const titles = { "Scene": "Silo", "Particle stage": "Computation" };
  return Object.entries(wanted).map(([section, names]) => {
    const rows = names.filter(name => (run.sections[section] || {})[name])
      .map(name => [name, run.sections[section][name]])
      .filter(([name, p]) => p.value !== "" && p.value !== quiet[name])
      .map(([name, p]) => [name, `${escapeHtml(p.value)} ${unitOf(p.meaning)}`]);
    const { summary } = run;
    if (section === "Particle stage" && summary.particles !== undefined)
      rows.push(["Particles at the start", shown(summary.particles, 9)], ["Cells", shown(summary.cells, 9)], ["Steps", shown(summary.steps, 9)],
        ["Computing time", `${shown((summary.setup_seconds || 0) + (summary.static_seconds || 0) + (summary.loop_seconds || 0) + (summary.output_seconds || 0))} s on ${summary.ranks} rank${summary.ranks > 1 ? "s" : ""}`]);
    return plainTable(titles[section] || section, rows);
  }).join("");
}

function allParameters(run) {
  return Object.entries(run.sections).map(([section, entries]) => plainTable(section, Object.entries(entries).map(([name, p]) =>
    [escapeHtml(name), escapeHtml(p.value) + (p.standard ? ` <span class="muted">(default ${escapeHtml(p.standard)})</span>` : ""), escapeHtml(p.meaning)]))).join("<br>");
}
