// What the run has written, out of the elements of the page that hold it.

// The bytes of a file, or null if the run has not written it.
async function unpackedBytes(name) {
  const element = document.querySelector(`script[data-file="${name}"]`);
  if (!element)
    return null;
  const packed = Uint8Array.from(atob(element.textContent), c => c.charCodeAt(0));
  const { writable, readable } = new DecompressionStream("deflate");
  const writer = writable.getWriter();
  writer.write(packed);
  writer.close();
  return new Uint8Array(await new Response(readable).arrayBuffer());
}

async function unpackedText(name) {
  const bytes = await unpackedBytes(name);
  return bytes ? new TextDecoder().decode(bytes) : null;
}

// Rows of a CSV file as objects by the columns' names, numbers where they are
// numbers; empty if there is no such file.
async function table(name) {
  const text = await unpackedText(name);
  const isText = new Set(["wall", "side", "gauge"]);
  return text === null ? [] : d3.csvParse(text, row => {
    for (const column in row)
      if (!isText.has(column))
        row[column] = row[column] === "nan" ? NaN : +row[column];
    return row;
  });
}

// What D3 calls differently in its versions 5 to 7.

// [[key, rows], …] in the order of their first rows.
function grouped(rows, keyOf) {
  const groups = new Map();
  for (const row of rows) {
    const key = keyOf(row);
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(row);
  }
  return [...groups];
}

// Where the pointer is, from the corner of an element.
function pointerIn(element, event) {
  const box = element.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

// Sections of a parameter file: {section: {name: {value, isDefault, meaning}}}.
function parseParameters(text) {
  const sections = {};
  let section = {}, comment = [];
  for (const line of text.split("\n").map(l => l.trim())) {
    const begin = line.match(/^subsection\s+(.*)$/);
    const set = line.match(/^set\s+(.+?)\s*=\s*(.*?)\s*(?:#\s*default:\s*(.*))?$/);
    if (begin)
      section = sections[begin[1]] = {};
    else if (set)
      section[set[1]] = { value: set[2], standard: set[3], meaning: comment.join(" ") };
    if (line.startsWith("#"))
      comment.push(line.slice(1).trim());
    else
      comment = [];
  }
  return sections;
}

async function loadRun() {
  if (typeof DecompressionStream === "undefined")
    throw new Error("This browser is too old to unpack the report (it has no DecompressionStream).");
  const [summary, parameters, log, history, flowRate, walls, wallEnvelope, flowProfile, residence, gauges, residenceMap, mesh, wallCut, movie] = await Promise.all([
    unpackedText("summary.json"), unpackedText("parameters.prm"), unpackedText("sandglass.log"),
    table("history.csv"), table("flow_rate.csv"), table("wall_traction.csv"),
    table("wall_envelope.csv"), table("flow_profile.csv"), table("residence.csv"), table("gauges.csv"), unpackedText("residence.json"),
    unpackedText("mesh.json"), unpackedText("walls.json"), loadMovie()]);
  const sections = parseParameters(parameters || "");
  const parameter = (section, name) => ((sections[section] || {})[name] || { value: "" }).value;
  return {
    summary: summary ? JSON.parse(summary) : { status: "running" },
    sections, parameter, log: log || "", history, flowRate, walls, wallEnvelope, flowProfile, residence, gauges,
    residenceMap: residenceMap ? JSON.parse(residenceMap) : null,
    mesh: mesh ? JSON.parse(mesh) : null, movie,
    // Of a body, where the plane of the cut meets its walls.
    wallCut: wallCut ? JSON.parse(wallCut) : null,
    // Quantities are per metre of depth in a plane silo.
    isPlane: parameter("Scene", "Formulation") === "plane strain",
    isBody: parameter("Scene", "Formulation") === "three dimensions",
  };
}
