// Sortable tables with their numbers as CSV.

/**
 * A table in its own scroll box. `spec`: {name (of the CSV), caption, columns, isPicked?, onPick?};
 * a column: {label, title?, text: row => shown, value: row => sorted and in the CSV, isText?}.
 * Rows are any objects; `row.attached` rows stay below theirs, set apart. Returns
 * {element, update(rows)}.
 */
function createTable(spec) {
  const table = {spec, rows: [], order: null, body: htmlElement("tbody")};
  table.heads = spec.columns.map((column, i) => headCell(table, column, i));
  const grid = htmlElement("table", {"aria-label": spec.caption},
    htmlElement("thead", {}, htmlElement("tr", {}, table.heads)), table.body);
  const tools = htmlElement("span", {class: "tools"},
    smallButton("CSV", `${spec.caption} as CSV`, () => downloadCsv(spec.name, tableCsv(table))));
  table.element = htmlElement("figure", {class: "table-figure", "data-name": spec.name},
    htmlElement("figcaption", {}, htmlElement("span", {class: "caption"}, spec.caption), tools),
    htmlElement("div", {class: "table-box", tabindex: "0", role: "region",
      "aria-label": `${spec.caption}, scrolls`}, grid));
  table.update = (rows) => {
    table.rows = rows;
    drawRows(table);
  };
  return table;
}

function headCell(table, column, index) {
  const button = htmlElement("button",
    {type: "button", title: column.title || "Sort", onclick: () => sortBy(table, index)},
    column.label);
  return htmlElement("th", {scope: "col", class: column.isText ? "text" : null}, button);
}

/** Ascending, descending, as it was. */
function sortBy(table, index) {
  const {order} = table;
  if (!order || order.index !== index) table.order = {index, sign: 1};
  else table.order = order.sign === 1 ? {index, sign: -1} : null;
  table.heads.forEach((head, i) => {
    const sign = table.order && table.order.index === i ? table.order.sign : 0;
    if (sign === 0) head.removeAttribute("aria-sort");
    else head.setAttribute("aria-sort", sign === 1 ? "ascending" : "descending");
  });
  drawRows(table);
}

/** Unknown values come last either way. */
function compareValues(a, b, sign) {
  const isKnown = [a, b].map((v) => v !== null && v !== undefined && !Number.isNaN(v));
  if (!isKnown[0] || !isKnown[1]) return isKnown[1] - isKnown[0];
  if (typeof a === "string" || typeof b === "string") {
    return sign * String(a).localeCompare(String(b), "en", {numeric: true});
  }
  return sign * (a - b);
}

function sortedRows(table) {
  if (!table.order) return table.rows;
  const {index, sign} = table.order;
  const {value} = table.spec.columns[index];
  return [...table.rows].sort((a, b) => compareValues(value(a), value(b), sign));
}

function drawRows(table) {
  table.body.replaceChildren(...sortedRows(table).flatMap((row) =>
    [bodyRow(table, row, false), ...(row.attached || []).map((r) => bodyRow(table, r, true))]));
}

function bodyRow(table, row, isAttached) {
  const {columns, isPicked, onPick} = table.spec;
  const cells = columns.map((column, i) => {
    const isName = i === 0 && onPick && !isAttached;
    const text = isAttached && column.value(row) === null ? "" : column.text(row);
    const content = isName ? htmlElement("button", {type: "button", class: "pick"}, text) : text;
    return htmlElement(i === 0 ? "th" : "td",
      {scope: i === 0 ? "row" : null, class: column.isText ? "text" : null}, content);
  });
  return htmlElement("tr", {
    class: isAttached ? "attached" : null,
    "aria-current": isPicked && !isAttached && isPicked(row) ? "true" : null,
    onclick: onPick && !isAttached ? () => onPick(row) : null,
  }, cells);
}

function tableCsv(table) {
  const {columns} = table.spec;
  const rows = sortedRows(table).flatMap((row) => [row, ...(row.attached || [])]);
  return csvText(columns.map((c) => c.label), rows.map((row) => columns.map((c) => c.value(row))));
}

function textColumn(label, value, title) {
  return {label, title, isText: true, value, text: (row) => value(row) ?? kUnknown};
}

/** `format` turns the number into what is shown. */
function numberColumn(label, value, format = (v) => (isNumber(v) ? String(v) : kUnknown), title) {
  return {label, title, value, text: (row) => format(value(row))};
}
