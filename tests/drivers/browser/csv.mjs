// RFC 4180 as others read it, to check what the page writes.

/** Rows of fields. */
export function parseCsv(text) {
  const rows = [[]];
  let field = "";
  let isQuoted = false;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (isQuoted && c === '"' && text[i + 1] === '"') {
      field += text[++i];
    } else if (c === '"') {
      isQuoted = !isQuoted;
    } else if (!isQuoted && (c === "," || c === "\n")) {
      rows.at(-1).push(field);
      field = "";
      if (c === "\n") rows.push([]);
    } else {
      field += c;
    }
  }
  rows.pop();
  return rows;
}
