// The particles at the times of their files, and how they are drawn.

async function loadMovie() {
  const description = await unpackedText("particles.json");
  const bytes = await unpackedBytes("particles.bin");
  if (!description || !bytes)
    return null;
  const movie = JSON.parse(description);
  const n = movie.particles, n_frames = movie.times.length;
  if (n === 0)
    return null;
  let at = n;
  const planes = () => {
    const values = new Uint16Array(n);
    for (let i = 0; i < n; ++i)
      values[i] = bytes[at + i] | (bytes[at + n + i] << 8);
    at += 2 * n;
    return values;
  };
  const accumulated = () => {
    const frames = [];
    for (let f = 0; f < n_frames; ++f) {
      const values = planes();
      if (f > 0)
        for (let i = 0; i < n; ++i)
          values[i] += frames[f - 1][i];
      frames.push(values);
    }
    return frames;
  };
  movie.layer = bytes.subarray(0, n);
  movie.first = planes();
  movie.end = planes();
  for (const field of ["x", "y", "speedCode", "pressureCode", "sizeCode"])
    movie[field] = accumulated();
  movie.speedOf = code => movie.speed * 10 ** (movie.speed_decades * (code / 255 - 1));
  movie.pressureOf = code => movie.pressure * code / 255;
  return movie;
}

// The last frame not after `time`, and the share of the way to the next.
function frameAt(movie, time) {
  const times = movie.times, last = times.length - 1;
  const f = Math.max(0, Math.min(last, d3.bisectRight(times, time + 1e-9) - 1));
  return [f, f < last ? Math.max(0, Math.min(1, (time - times[f]) / (times[f + 1] - times[f]))) : 0];
}

const n_layers = 16;

// Stripes that go from one hue to another, every second one lighter.
function layerColour(layer) {
  const hue = d3.interpolateRgbBasis(["#1f4e5f", "#2a8c82", "#dcae4a", "#d9772f", "#98331f"]);
  const colour = d3.lab(hue((layer - 1) / (n_layers - 1)));
  return d3.lab(colour.l + (layer % 2 ? -4 : 13), colour.a, colour.b);
}

// What particles can be coloured by: the code of each, its colour, and the scale.
function colourings(movie) {
  const decades = [];
  for (let power = Math.ceil(Math.log10(movie.speed) - movie.speed_decades); 10 ** power <= movie.speed; ++power)
    decades.push([10 ** power, 1 + (power - Math.log10(movie.speed)) / movie.speed_decades]);
  const linear = d3.scaleLinear().domain([0, movie.pressure / 1000]).ticks(5)
    .map(kilopascals => [kilopascals, kilopascals * 1000 / movie.pressure]);
  return {
    layer: {
      title: "layer", caption: "layers of the initial height", codes: () => movie.layer, colour: layerColour,
      ticks: [["top", 0], ["bottom", 1]], unit: "", steps: d3.range(1, n_layers + 1),
    },
    speed: {
      title: "speed", caption: "speed", codes: f => movie.speedCode[f],
      colour: code => d3.interpolateViridis(code / 255), ticks: decades, unit: "m/s",
    },
    pressure: {
      title: "pressure", caption: "mean pressure in the material", codes: f => movie.pressureCode[f],
      colour: code => d3.interpolatePlasma(code / 255), ticks: linear, unit: "kPa",
    },
  };
}

// The colour of each code as a pixel (red in the lowest byte).
function pixelColours(colouring) {
  return Uint32Array.from(d3.range(256), code => {
    const { r, g, b } = d3.rgb(colouring.colour(code)).rgb();
    const byte = v => Math.max(0, Math.min(255, Math.round(v)));
    return (255 << 24 | byte(b) << 16 | byte(g) << 8 | byte(r)) >>> 0;
  });
}

// A scale of colours as HTML.
function scaleHtml({ colour, ticks, unit, steps }) {
  const stops = steps ?
    steps.map((s, i) => `${d3.rgb(colour(s))} ${100 * i / steps.length}% ${100 * (i + 1) / steps.length}%`) :
    d3.range(0, 256, 15).map(code => `${colour(code)} ${100 * code / 255}%`);
  const labels = ticks.map(([value, share], i) =>
    `<span${share > .93 ? ' class="end"' : ""} style="left:${100 * share}%">${value}${i === ticks.length - 1 && unit ? " " + unit : ""}</span>`);
  return `<div class="scale"><div class="ramp" style="background:linear-gradient(to right,${stops.join(",")})"></div>` +
    `<div class="ticks">${labels.join("")}</div></div>`;
}

// Half widths of the rows of pixels of a disc, by twice its radius in pixels.
const discs = d3.range(0, 200).map(code => {
  const radius = code / 2, rows = [];
  for (let dy = -Math.floor(radius); dy <= Math.floor(radius); ++dy)
    rows.push(Math.round(Math.sqrt(Math.max(0, radius * radius - dy * dy)) - .25));
  return rows;
});

// Draw the particles at `time` as discs into an ImageData. `place` says where
// x = 0 and y = 0 are, in pixels, how many are a metre, and where the bottom of
// the computed region is; `mirrored` draws the other half as well.
function drawParticles(image, movie, time, codesOf, colours, place, mirrored) {
  const { width } = image, height = Math.min(image.height, Math.round(place.bottom)), pixels = new Uint32Array(image.data.buffer);
  pixels.fill(0);
  const [f, share] = frameAt(movie, time), { first, end } = movie, n = movie.particles;
  const next = Math.min(f + 1, movie.times.length - 1), before = Math.max(f - 1, 0);
  const x0 = movie.x[f], x1 = movie.x[next], xb = movie.x[before];
  const y0 = movie.y[f], y1 = movie.y[next], yb = movie.y[before];
  const codes = codesOf(f), sizes = movie.sizeCode[f];
  const step = movie.step * place.scale, [ox, oy] = movie.origin;
  const radii = Uint8Array.from(d3.range(256), code =>
    Math.max(1, Math.min(199, Math.round(2 * .72 * movie.size * 2 ** ((code - 128) / 64) * place.scale))));

  const stamp = (cx, cy, radius, colour) => {
    const rows = discs[radius], half = rows.length >> 1;
    for (let r = 0; r < rows.length; ++r) {
      const row = cy + r - half;
      if (row < 0 || row >= height) continue;
      const from = row * width + Math.max(0, cx - rows[r]), to = row * width + Math.min(width - 1, cx + rows[r]);
      for (let p = from; p <= to; ++p) pixels[p] = colour; // fill() takes longer for so few
    }
  };
  for (let i = 0; i < n; ++i) {
    if (first[i] > f || end[i] <= f) continue;
    let x = x0[i], y = y0[i];
    if (share > 0)
      if (end[i] > next) {
        x += (x1[i] - x) * share;
        y += (y1[i] - y) * share;
      } else if (first[i] < f) { // It leaves before the next frame: as it went.
        x += (x - xb[i]) * share;
        y += (y - yb[i]) * share;
      }
    const dx = ox * place.scale + x * step;
    const row = Math.round(place.y - oy * place.scale - y * step);
    const colour = colours[codes[i]], radius = radii[sizes[i]];
    stamp(Math.round(place.x + dx), row, radius, colour);
    if (mirrored) stamp(Math.round(place.x - dx), row, radius, colour);
  }
}
