// The numbers of what was made, as tables.
const whole = new Intl.NumberFormat("en");
const figure = (value, digits = 3) => new Intl.NumberFormat("en", { maximumSignificantDigits: digits }).format(value);

function table(rows) {
  const made = document.createElement("table");
  for (const [what, ...values] of rows) {
    const row = made.insertRow();
    const head = document.createElement("th");
    head.scope = "row";
    head.textContent = what;
    row.append(head);
    for (const value of values) row.insertCell().textContent = value;
  }
  return made;
}

function heading(text) {
  const made = document.createElement("h2");
  made.textContent = text;
  return made;
}

function pane_rows(pane) {
  const rows = [];
  const cracks = Object.entries(pane.cracks);
  rows.push(["cracks", whole.format(cracks.reduce((sum, [, count]) => sum + count, 0))]);
  for (const [kind, count] of cracks) rows.push([`– ${kind}`, whole.format(count)]);
  rows.push(["length of all cracks", `${figure(pane.length_m)} m`]);
  if (pane.pieces !== undefined) rows.push(["pieces", whole.format(pane.pieces)], ["median piece", `${figure(pane.median_piece_mm2)} mm²`]);
  pane.impacts.slice(0, 8).forEach((impact, i) => {
    rows.push([pane.impacts.length > 1 ? `impact ${i + 1}: radials` : "radials", `${impact.radials}, ${impact.reaching} to the edge`]);
    rows.push([pane.impacts.length > 1 ? `impact ${i + 1}: rings` : "rings", whole.format(impact.rings)]);
  });
  return rows;
}

function pavement_rows(pavement) {
  const rows = Object.entries(pavement.stones).map(([kind, count]) => [kind, whole.format(count)]);
  rows.push(["faces of stones", `${figure(pavement.area_m2, 4)} m²`]);
  for (const { item, count, area_m2, length_m } of pavement.quantities) {
    if (/_(whole|cut)$/.test(item)) continue;
    const values = [count && whole.format(Number(count)), area_m2 && `${figure(Number(area_m2), 4)} m²`, length_m && `${figure(Number(length_m), 4)} m`];
    rows.push([item.replaceAll("_", " "), values.filter(Boolean).join(" · ")]);
  }
  return rows;
}

export function show_numbers(place, statistics) {
  const parts = [];
  for (const pane of statistics.panes) parts.push(heading(`Pane ${pane.name}`), table(pane_rows(pane)));
  for (const pavement of statistics.pavements) parts.push(heading(`Pavement ${pavement.name}`), table(pavement_rows(pavement)));
  place.replaceChildren(...parts);
}

export function show_plan(place, statistics, version) {
  place.replaceChildren(...statistics.drawings.map((name, i) => {
    const drawing = document.createElement("figure");
    const picture = document.createElement("img");
    picture.src = `/plan/${i}.svg?${version}`;
    picture.alt = `Drawing of ${name}`;
    const title = document.createElement("figcaption");
    title.textContent = name;
    drawing.append(picture, title);
    return drawing;
  }));
}
