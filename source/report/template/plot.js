// A chart of lines in SVG.

// Numbers as a reader wants them: `digits` significant ones.
function shown(value, digits = 3) {
  if (value === null || value === undefined || !isFinite(value))
    return "–";
  if (value === 0)
    return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e7)
    return value.toExponential(digits - 1).replace(/e([+-])(\d+)$/, (_, sign, power) =>
      "\u202f·\u202f10" + (sign === "-" ? "⁻" : "") + [...power].map(d => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]).join(""));
  return size >= 10 ** digits ? Math.round(value).toLocaleString("en-US") :
    (+value.toPrecision(digits)).toLocaleString("en-US", { maximumFractionDigits: 6 }).replace("-", "−");
}

// options: x, y        {label, unit, zero: whether the axis holds 0}
//          series      [{name, points: [[x, y], …], colour, dash, width}]
//          bands       [{name, points: [[x, from, to], …] or, where the curves go
//                      upwards, [[from, to, y], …], colour}]
//          upright     whether y, not x, is what the curves depend on
//          height      over width
//          pick        called with x where the reader clicks
// Returns {update(series, bands), mark(x)}.
function plot(container, options) {
  const margin = { top: 8, right: 14, bottom: 40, left: 58 };
  const { x, y, upright = false, height = 0.56 } = options;
  let { series, bands = [] } = options, marked = null, width = 0;

  const root = d3.select(container);
  const legend = root.append("ul").attr("class", "legend");
  const frame = root.append("div").attr("class", "plot");
  const svg = frame.append("svg").attr("role", "img");
  const tip = frame.append("div").attr("class", "tip").attr("hidden", "");
  const across = d3.scaleLinear(), up = d3.scaleLinear();
  const finite = point => point.every(isFinite);
  let cursor, probe;

  function domain(axis, index) {
    const values = [];
    for (const s of series)
      for (const p of s.points)
        if (finite(p)) values.push(p[index]);
    for (const b of bands)
      for (const p of b.points)
        if (finite(p))
          values.push(...(upright ? (index === 0 ? [p[0], p[1]] : [p[2]])
            : (index === 0 ? [p[0]] : [p[1], p[2]])));
    let [low, high] = values.length ? d3.extent(values) : [0, 1];
    if (axis.zero) [low, high] = [low > -.02 * high ? 0 : low, Math.max(high, 0)];
    return low === high ? [low, low + 1] : [low, high];
  }

  function drawLegend() {
    const entries = [...series.filter(s => s.name), ...bands.filter(b => b.name)];
    const items = legend.selectAll("li").data(entries).join("li");
    items.html("").append("svg").attr("viewBox", "0 0 24 10").each(function (entry) {
      if (entry.dash === undefined && bands.includes(entry))
        d3.select(this).append("rect").attr("width", 24).attr("height", 10)
          .style("fill", entry.colour).attr("fill-opacity", entry.opacity || .2);
      else
        d3.select(this).append("line").attr("x2", 24).attr("y1", 5).attr("y2", 5)
          .style("stroke", entry.colour).attr("stroke-width", 2.2).attr("stroke-dasharray", entry.dash || null);
    });
    items.append("span").text(entry => entry.name);
  }

  function drawCurves(g) {
    const area = upright ?
      d3.area().defined(finite).x0(p => across(p[0])).x1(p => across(p[1])).y(p => up(p[2])) :
      d3.area().defined(finite).x(p => across(p[0])).y0(p => up(p[1])).y1(p => up(p[2]));
    g.selectAll("path.band").data(bands).join("path").attr("class", "band")
      .style("fill", b => b.colour).attr("fill-opacity", b => b.opacity || .2).attr("d", b => area(b.points));
    const line = d3.line().defined(finite).x(p => across(p[0])).y(p => up(p[1]));
    g.selectAll("path.line").data(series).join("path").attr("class", "line")
      .style("stroke", s => s.colour).style("stroke-width", s => s.width || null)
      .attr("stroke-dasharray", s => s.dash || null).attr("d", s => line(s.points));
  }

  // On paper a chart is half as wide as the page.
  function draw(paperWidth) {
    width = paperWidth || frame.node().clientWidth || 520;
    const full = paperWidth ? paperWidth * (upright ? .75 : .5) : Math.max(190, Math.min(width * height, 460));
    const right = width - margin.right, bottom = full - margin.bottom;
    svg.attr("viewBox", `0 0 ${width} ${full}`).html("");
    across.domain(domain(x, 0)).nice(7).range([margin.left, right]);
    up.domain(domain(y, 1)).nice(7).range([bottom, margin.top]);
    const ticks = width < 380 ? 4 : 7;
    svg.append("g").attr("class", "axis").attr("transform", `translate(0,${bottom})`)
      .call(d3.axisBottom(across).ticks(ticks).tickSize(-(bottom - margin.top)).tickPadding(7));
    svg.append("g").attr("class", "axis").attr("transform", `translate(${margin.left},0)`)
      .call(d3.axisLeft(up).ticks(5).tickSize(-(right - margin.left)).tickPadding(7));
    const name = axis => axis.label + (axis.unit ? ` (${axis.unit})` : "");
    svg.append("text").attr("class", "label").attr("x", (margin.left + right) / 2).attr("y", full - 5)
      .attr("text-anchor", "middle").text(name(x));
    svg.append("text").attr("class", "label").attr("transform", `translate(13,${(margin.top + bottom) / 2}) rotate(-90)`)
      .attr("text-anchor", "middle").text(name(y));
    drawCurves(svg.append("g").attr("class", "curves"));
    probe = svg.append("line").attr("class", "probe").attr("visibility", "hidden");
    cursor = svg.append("line").attr("class", "cursor").attr("y1", margin.top).attr("y2", bottom);
    mark(marked);
    svg.append("rect").attr("x", margin.left).attr("y", margin.top).attr("width", Math.max(0, right - margin.left))
      .attr("height", bottom - margin.top).attr("fill", "transparent")
      .style("cursor", options.pick ? "pointer" : null)
      .on("mousemove", event => hover(pointerIn(svg.node(), d3.event || event), right, bottom))
      .on("mouseleave", () => { tip.attr("hidden", ""); probe.attr("visibility", "hidden"); })
      .on("click", event => {
        if (options.pick) options.pick(across.invert(pointerIn(svg.node(), d3.event || event)[0]));
      });
  }

  // Values of all curves beside the pointer.
  function hover([px, py], right, bottom) {
    const index = upright ? 1 : 0, at = upright ? up.invert(py) : across.invert(px);
    const rows = [];
    for (const s of series) {
      if (!s.name) continue;
      const nearest = d3.scan(s.points, (a, b) => Math.abs(a[index] - at) - Math.abs(b[index] - at));
      if (nearest !== undefined && isFinite(s.points[nearest][1 - index]))
        rows.push(`<i style="background:${s.colour}"></i>${s.name} <b>${shown(s.points[nearest][1 - index], 4)}</b>`);
    }
    const own = upright ? y : x, other = upright ? x : y;
    tip.attr("hidden", null).html(`${own.label} <b>${shown(at)}</b> ${own.unit || ""}<br>${rows.join("<br>")}` +
      (other.unit ? `<br><span class="muted">${other.unit}</span>` : ""));
    const box = tip.node();
    tip.style("left", Math.max(0, px + (px > width / 2 ? -box.offsetWidth - 14 : 14)) + "px")
      .style("top", Math.max(0, Math.min(py - 20, bottom - box.offsetHeight + 30)) + "px");
    probe.attr("visibility", null).attr("x1", upright ? margin.left : px).attr("x2", upright ? right : px)
      .attr("y1", upright ? py : margin.top).attr("y2", upright ? py : bottom);
  }

  function mark(value) {
    marked = value;
    if (cursor)
      cursor.attr("visibility", value === null || upright ? "hidden" : null)
        .attr("x1", across(value || 0)).attr("x2", across(value || 0));
  }

  function update(newSeries, newBands = bands) {
    [series, bands] = [newSeries, newBands];
    drawCurves(svg.select("g.curves"));
  }

  drawLegend();
  draw();
  addEventListener("beforeprint", () => draw(330));
  addEventListener("afterprint", () => draw());
  // In the next frame: an observer must not change what it observes.
  new ResizeObserver(() => requestAnimationFrame(() => {
    if (frame.node().clientWidth !== width && frame.node().clientWidth) draw();
  })).observe(frame.node());
  return { update, mark };
}
