// Sections in the order of the report. What lies far below is built when it is scrolled near.

/**
 * Adds a numbered section; `build(host)` fills it when it comes near the view, or before printing.
 * `height`: what it will take, so that nothing jumps.
 */
function addSection(report, {id, title, lead, build, height = 200, host}) {
  const number = String(report.sections.length + 1);
  const content = htmlElement("div", {class: "section-content", style: `min-height:${height}px`});
  const section = htmlElement("section", {id, "aria-labelledby": `${id}-title`},
    htmlElement("h2", {id: `${id}-title`}, htmlElement("span", {class: "number"}, number), title),
    lead ? htmlElement("p", {class: "lead"}, lead) : null, content);
  (host || report.main).append(section);
  report.sections.push({id, title, number, element: section, build: () => build(content),
    isBuilt: false, content});
}

function buildSection(section) {
  if (section.isBuilt) return;
  section.isBuilt = true;
  section.build();
  section.content.style.minHeight = "";
}

/** Unpacking meshes takes its time: they are to be there when the page is printed. */
function buildWhenIdle(report, id) {
  const build = () => report.sections.filter((s) => s.id === id).forEach(buildSection);
  if (window.requestIdleCallback) window.requestIdleCallback(build, {timeout: 2000});
  else setTimeout(build, 300);
}

/** Builds what is seen at once, the rest when it comes near. */
function watchSections(report) {
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      observer.unobserve(entry.target);
      buildSection(report.sections.find((s) => s.element === entry.target));
    }
  }, {rootMargin: "900px 0px"});
  for (const section of report.sections) observer.observe(section.element);
  window.addEventListener("beforeprint", () => {
    report.sections.forEach(buildSection);
    drawChartsForPrint();
  });
  window.addEventListener("afterprint", drawChartsForScreen);
}

/** Links to the sections; following one builds those above first, so that it stays in place. */
function tableOfContents(report) {
  const follow = (index) => report.sections.slice(0, index + 1).forEach(buildSection);
  return htmlElement("nav", {class: "contents", "aria-label": "Contents"},
    htmlElement("ol", {}, report.sections.map((section, index) => htmlElement("li", {},
      htmlElement("a", {href: `#${section.id}`, onclick: () => follow(index)},
        htmlElement("span", {class: "number"}, section.number), section.title)))));
}
