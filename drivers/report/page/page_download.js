// Files made by the page; works from file:// too.

function downloadText(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], {type}));
  const link = htmlElement("a", {href: url, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

function downloadCsv(stem, text) {
  downloadText(fileStem(stem) + ".csv", text, "text/csv;charset=utf-8");
}

/** Letters, digits, dots and hyphens. */
function fileStem(text) {
  return text.replace(/[^\p{L}\p{N}.]+/gu, "-").replace(/^-+|-+$/g, "") || "anisofront";
}

/** RFC 4180: texts in quotes, quotes doubled; unknown values stay empty. */
function csvField(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "";
  return typeof value === "string" ? `"${value.replaceAll('"', '""')}"` : String(value);
}

/** Rows of texts and numbers under a line of names. */
function csvText(header, rows) {
  return [header, ...rows].map((row) => row.map(csvField).join(",") + "\n").join("");
}
