// The flow to play and to scrub.

function boundsOf(run) {
  const xs = [], ys = [];
  if (run.mesh) {
    xs.push(...d3.extent(run.mesh.x));
    ys.push(...d3.extent(run.mesh.y));
  } else {
    const { movie } = run;
    for (const f of movie.x.keys())
      for (const [codes, list, o] of [[movie.x[f], xs, 0], [movie.y[f], ys, 1]])
        list.push(...d3.extent(codes).map(code => movie.origin[o] + code * movie.step));
  }
  if (run.isBody)
    for (const [x, y] of (run.wallCut || []).flat()) { xs.push(x); ys.push(y); }
  else
    for (const line of run.walls.lines)
      for (const row of line.frames[0]) { xs.push(row.x_m); ys.push(row.y_m); }
  const [x0, x1] = d3.extent(xs), [y0, y1] = d3.extent(ys);
  // A section that begins at the axis stands for both of its sides.
  const mirrored = x0 > -1e-6 * (x1 - x0) && x0 < 0.02 * (x1 - x0);
  return { x0: mirrored ? -x1 : x0, x1, y0, y1, mirrored };
}

// Walls as polylines of places, both sides where the section is a half.
function wallPaths(run, mirrored) {
  // An outlet with a row at rest only has opened.
  const paths = run.isBody ? run.wallCut || [] :
    run.walls.lines.filter(line => !line.isOutlet || line.frames.length > 1).map(line => line.frames[0].map(row => [row.x_m, row.y_m]));
  return mirrored ? paths.flatMap(points => [points, points.map(([x, y]) => [-x, y])]) : paths;
}

// The largest pressure as drawn, over the section's width.
const pressureReach = .2;

// Draws into `view`, a <div> with a <canvas> and an <svg>.
function stage(view, run, bounds) {
  const canvas = view.querySelector("canvas"), context = canvas.getContext("2d");
  const svg = d3.select(view.querySelector("svg")), movie = run.movie;
  const colourOf = colourings(movie);
  const state = { time: movie.times[0], field: "layer", mesh: false, tractions: false };
  let colours = pixelColours(colourOf.layer), image = null, zoomed = d3.zoomIdentity, paper = null, framed = "";
  let size = [view.clientWidth, view.clientHeight]; // To ask each time would cost a layout.
  const largest = d3.max(run.walls.lines, line => d3.max(line.frames, frame => d3.max(frame, row => row.normal_Pa))) || 1;
  const { x0, x1, y0, y1, mirrored } = bounds;

  const place = () => { // in CSS pixels
    const [w, h] = paper || size;
    const left = 40, right = 14, top = 10, bottom = 26;
    const reach = state.tractions ? pressureReach * (x1 - x0) : 0;
    const y2 = Math.min(y0, -reach); // Those on a floor need room as well.
    const scale = Math.min((w - left - right) / (x1 - x0 + 2 * reach), (h - top - bottom) / (y1 - y2));
    const x = left + (w - left - right) / 2 - scale * (x0 + x1) / 2;
    const y = top + (h - top - bottom) / 2 + scale * (y2 + y1) / 2;
    return { scale: scale * zoomed.k, x: zoomed.applyX(x), y: zoomed.applyY(y), w, h };
  };

  function drawMesh(at, ratio) {
    const ink = getComputedStyle(view).getPropertyValue("--muted");
    const { x, y, edges, boundary } = run.mesh;
    const sides = mirrored ? [1, -1] : [1];
    const stroke = (list, alpha) => {
      context.globalAlpha = alpha;
      context.beginPath();
      for (const side of sides)
        for (let e = 0; e < list.length; e += 2) {
          const [a, b] = [list[e], list[e + 1]];
          if (mirrored && x[a] + x[b] < 1e-9) continue; // the axis
          context.moveTo((at.x + side * x[a] * at.scale) * ratio, (at.y - y[a] * at.scale) * ratio);
          context.lineTo((at.x + side * x[b] * at.scale) * ratio, (at.y - y[b] * at.scale) * ratio);
        }
      context.stroke();
    };
    context.strokeStyle = ink;
    context.lineWidth = ratio * .6;
    if (state.mesh) stroke(edges, .6);
    stroke(boundary, .35);
    context.globalAlpha = 1;
  }

  function drawTractions(at) {
    const lines = state.tractions ? run.walls.lines.filter(l => !l.isOutlet || l.frames.length > 1) : [];
    const reach = pressureReach * (x1 - x0) * at.scale / largest;
    const shapes = [];
    for (const line of lines)
      for (const side of mirrored ? [1, -1] : [1]) {
        const frame = wallFrame(line, state.time), normals = outwardNormals(frame, line.side);
        const inner = frame.map(row => [at.x + side * row.x_m * at.scale, at.y - row.y_m * at.scale]);
        const outer = frame.map((row, i) => {
          const value = isFinite(row.normal_Pa) ? Math.max(0, row.normal_Pa) : 0;
          return [inner[i][0] + side * normals[i][0] * value * reach, inner[i][1] - normals[i][1] * value * reach];
        });
        shapes.push(d3.line()([...inner, ...outer.reverse()]) + "Z");
      }
    svg.selectAll("path.traction").data(shapes) // below the walls
      .join(enter => enter.insert("path", ":first-child")).attr("class", "traction").attr("d", d => d);
    const nice = d3.tickStep(0, largest / 1000, 2) * 1000;
    svg.selectAll("g.bar-of-scale").data(lines.length ? [nice] : []).join("g").attr("class", "bar-of-scale note")
      .attr("transform", `translate(${at.w - 16 - nice * reach},${at.h - 44})`)
      .html(value => `<line x2="${value * reach}" stroke="var(--c1)" stroke-width="3"/><text x="${value * reach}" y="-6" text-anchor="end">${shown(value / 1000)} kPa</text>`);
  }

  function drawFrame(at) {
    const line = d3.line().x(p => at.x + p[0] * at.scale).y(p => at.y - p[1] * at.scale);
    svg.selectAll("path.walls").data(wallPaths(run, mirrored)).join("path").attr("class", "walls").attr("d", line);
    svg.selectAll("line.outlet").data([0]).join("line").attr("class", "outlet")
      .attr("x1", at.x + x0 * at.scale).attr("x2", at.x + x1 * at.scale).attr("y1", at.y).attr("y2", at.y);
    const across = d3.scaleLinear().domain([-at.x / at.scale, (at.w - at.x) / at.scale]).range([0, at.w]);
    const up = d3.scaleLinear().domain([at.y / at.scale, (at.y - at.h) / at.scale]).range([0, at.h]);
    const axes = [["x", d3.axisBottom(across).ticks(5).tickSize(4), `translate(0,${at.h - 24})`],
      ["y", d3.axisLeft(up).ticks(6).tickSize(4), "translate(34,0)"]];
    for (const [name, axis, shift] of axes)
      svg.selectAll("g.axis." + name).data([0]).join("g").attr("class", "axis " + name).attr("transform", shift).call(axis);
    svg.selectAll("text.unit").data(["m"]).join("text").attr("class", "note unit").attr("x", 8).attr("y", at.h - 8).text(d => d);
    // Labels of the two axes would meet in the corner.
    svg.selectAll("g.axis.y .tick").attr("visibility", d => up(d) > at.h - 34 || up(d) < 8 ? "hidden" : null);
    svg.selectAll("g.axis.x .tick").attr("visibility", d => across(d) < 34 ? "hidden" : null);
  }

  function draw() {
    const at = place(), ratio = paper ? 3 : Math.min(2, window.devicePixelRatio || 1);
    const width = Math.max(1, Math.round(at.w * ratio)), height = Math.max(1, Math.round(at.h * ratio));
    if (canvas.width !== width || canvas.height !== height || !image) {
      canvas.width = width;
      canvas.height = height;
      image = context.createImageData(width, height);
    }
    svg.attr("viewBox", `0 0 ${at.w} ${at.h}`);
    drawParticles(image, movie, state.time, colourOf[state.field].codes, colours,
      { x: at.x * ratio, y: at.y * ratio, scale: at.scale * ratio, bottom: (at.y - y0 * at.scale) * ratio }, mirrored);
    context.putImageData(image, 0, 0);
    if (run.mesh) drawMesh(at, ratio);
    if (framed !== (framed = JSON.stringify(at))) drawFrame(at);
    drawTractions(at);
    view.dataset.frame = frameAt(movie, state.time)[0];
    view.dataset.draws = +(view.dataset.draws || 0) + 1;
  }

  // The particle under the pointer, if there is one.
  function hover(px, py) {
    const at = place(), [f] = frameAt(movie, state.time), hint = view.querySelector(".hint");
    const x = (px - at.x) / at.scale, y = (at.y - py) / at.scale;
    let best = -1, nearest = (2 * movie.size) ** 2;
    for (let i = 0; i < movie.particles; ++i) {
      if (movie.first[i] > f || movie.end[i] <= f) continue;
      const dx = (mirrored ? Math.abs(x) : x) - movie.origin[0] - movie.x[f][i] * movie.step;
      const dy = y - movie.origin[1] - movie.y[f][i] * movie.step;
      if (dx * dx + dy * dy < nearest) [best, nearest] = [i, dx * dx + dy * dy];
    }
    hint.hidden = best < 0;
    if (best < 0) return;
    const speed = movie.speedCode[f][best], pressure = movie.pressureCode[f][best];
    const bound = (code, lowest) => code === 255 ? "≥ " : code === lowest ? "< " : "";
    hint.textContent = `x ${x.toFixed(2)} m, y ${y.toFixed(2)} m · layer ${movie.layer[best]} · ` +
      `${bound(speed, 0)}${shown(movie.speedOf(speed), 2)} m/s · ${bound(pressure)}${shown(movie.pressureOf(pressure) / 1000, 2)} kPa`;
    hint.style.left = Math.max(4, Math.min(px + 14, at.w - hint.offsetWidth - 4)) + "px";
    hint.style.top = Math.max(4, py - 36) + "px";
  }

  const zoom = d3.zoom().scaleExtent([1, 12])
    .filter(event => (d3.event || event).type !== "wheel" || (d3.event || event).ctrlKey || zoomed.k > 1)
    .on("zoom", event => {
      const { transform } = d3.event || event;
      zoomed = transform.k === 1 ? d3.zoomIdentity : transform;
      draw();
    });
  d3.select(canvas).call(zoom).on("dblclick.zoom", null)
    .on("dblclick", () => d3.select(canvas).call(zoom.transform, d3.zoomIdentity))
    .on("mousemove", event => hover(...pointerIn(canvas, d3.event || event)))
    .on("mouseleave", () => { view.querySelector(".hint").hidden = true; });
  // No higher than what there is to show at this width.
  const needed = width => 46 + (y1 - y0) / (x1 - x0) * (width - 54);
  // In the next frame: an observer must not change what it observes.
  new ResizeObserver(() => requestAnimationFrame(() => {
    view.style.maxHeight = needed(view.clientWidth) + "px";
    size = [view.clientWidth, view.clientHeight];
    if (!paper) draw();
  })).observe(view);
  addEventListener("beforeprint", () => {
    paper = [330, Math.min(420, needed(330))];
    view.style.setProperty("--paper-ratio", paper[0] / paper[1]);
    draw();
  });
  addEventListener("afterprint", () => { paper = null; draw(); });

  return {
    state, draw, colourOf,
    set(change) {
      Object.assign(state, change);
      if (change.field) colours = pixelColours(colourOf[state.field]);
      draw();
    },
  };
}

// Buttons and the loop that plays. `onTime` is told each time shown.
function player(run, scene, onTime) {
  const times = run.movie.times, begin = times[0], finish = times[times.length - 1];
  const slider = document.getElementById("time"), button = document.getElementById("play");
  const view = document.getElementById("view"), pace = document.getElementById("pace");
  const icon = { play: "M3 1.5v13l11-6.5z", pause: "M3 2h3.6v12H3zM9.4 2H13v12H9.4z" };
  let isPlaying = false, last = 0, count = 0, since = 0, ticket = 0;
  slider.min = begin;
  slider.max = finish;

  const paces = [8, 4, 2, 1, 1 / 2, 1 / 4, 1 / 8, 1 / 16];
  const wanted = paces[d3.scan(paces, (a, b) =>
    Math.abs(Math.log((finish - begin) / a / 9)) - Math.abs(Math.log((finish - begin) / b / 9)))] || 1;
  for (const p of paces)
    pace.add(new Option(p === 1 ? "real time" : p > 1 ? `${p}× as fast` : `1/${1 / p} of real time`, p, p === wanted, p === wanted));

  function show(time) {
    slider.value = time;
    document.getElementById("clock").textContent = time.toFixed(2) + " s";
    document.getElementById("caption-time").textContent = time.toFixed(2);
    scene.set({ time });
    onTime(time);
  }
  function setPlaying(value) {
    isPlaying = value;
    button.innerHTML = `<svg viewBox="0 0 16 16"><path d="${value ? icon.pause : icon.play}"/></svg>`;
    view.dataset.playing = value;
    if (value) {
      if (scene.state.time >= finish) show(begin);
      last = since = performance.now();
      count = 0;
      advanceSoon();
    }
  }
  // With the next picture, or without where the browser draws none, as of a
  // hidden page: time goes on there too.
  function advanceSoon() {
    const own = ++ticket;
    const once = () => {
      if (own !== ticket) return; // The other way has been faster.
      ++ticket;
      advance(performance.now());
    };
    requestAnimationFrame(once);
    setTimeout(once, 200);
  }
  function advance(now) {
    if (!isPlaying) return;
    const time = Math.min(finish, scene.state.time + Math.max(0, now - last) / 1000 * pace.value);
    last = now;
    show(time);
    ++count;
    if (now - since > 1000) {
      view.dataset.fps = (1000 * count / (now - since)).toFixed(1);
      [since, count] = [now, 0];
    }
    if (time >= finish) setPlaying(false);
    else advanceSoon();
  }

  button.addEventListener("click", () => setPlaying(!isPlaying));
  view.addEventListener("keydown", event => {
    if (event.key !== " ") return;
    event.preventDefault();
    setPlaying(!isPlaying);
  });
  slider.addEventListener("input", () => { setPlaying(false); show(+slider.value); });
  setPlaying(false);
  return { show, setPlaying };
}
