// Light, dark or as the system has it. On paper always light.

const kThemeKey = "anisofront-theme";
const kDarkSystem = window.matchMedia("(prefers-color-scheme: dark)");

/** "light", "dark" or "automatic"; storage may be closed to pages from files. */
function themeChoice() {
  try {
    return localStorage.getItem(kThemeKey) || "automatic";
  } catch {
    return document.documentElement.dataset.themeChoice || "automatic";
  }
}

function chooseTheme(choice) {
  document.documentElement.dataset.themeChoice = choice;
  try {
    localStorage.setItem(kThemeKey, choice);
  } catch {
    // The choice lasts as long as the page.
  }
  applyTheme(resolvedTheme(choice));
}

function resolvedTheme(choice) {
  if (choice !== "automatic") return choice;
  return kDarkSystem.matches ? "dark" : "light";
}

/** What draws by script listens to "themechange" on the document. */
function applyTheme(theme) {
  if (document.documentElement.dataset.theme === theme) return;
  document.documentElement.dataset.theme = theme;
  document.dispatchEvent(new Event("themechange"));
}

function startTheme() {
  applyTheme(resolvedTheme(themeChoice()));
  kDarkSystem.addEventListener("change", () => applyTheme(resolvedTheme(themeChoice())));
  window.addEventListener("beforeprint", () => applyTheme("light"));
  window.addEventListener("afterprint", () => applyTheme(resolvedTheme(themeChoice())));
}

function themeControl() {
  const choices = ["automatic", "light", "dark"].map((value) => ({value, label: value}));
  choices[0].label = "auto";
  return segmentedButtons("Theme", choices, themeChoice(), chooseTheme);
}

// Before anything is drawn.
startTheme();
