import { useSettings, type Settings } from "./settings.ts";

const dark = () => matchMedia("(prefers-color-scheme: dark)");
const still = () => matchMedia("(prefers-reduced-motion: reduce)");

/** True if nothing should move by itself, by the setting of the system or of the app. */
export const reducedMotion = (settings: Pick<Settings, "motion">): boolean =>
  settings.motion === "reduced" || (typeof matchMedia === "function" && still().matches);

function apply(settings: Settings): void {
  const root = document.documentElement;
  root.lang = settings.language;
  root.dataset["theme"] = settings.theme === "system" ? (dark().matches ? "dark" : "light") : settings.theme;
  root.dataset["size"] = settings.presentation ? "presentation" : "usual";
  root.dataset["motion"] = reducedMotion(settings) ? "reduced" : "full";
  // The manifest in the language of the page, for the home screen; absent during development.
  const manifest = document.querySelector("link[rel=manifest]");
  const name = `./manifest.${settings.language}.webmanifest`;
  if (manifest && manifest.getAttribute("href") !== name) manifest.setAttribute("href", name);
}

/** Keeps language, theme and motion of the document in step with the settings and the system. */
export function followAppearance(): void {
  const now = () => apply(useSettings.getState());
  now();
  useSettings.subscribe(now);
  dark().addEventListener("change", now);
  still().addEventListener("change", now);
}
